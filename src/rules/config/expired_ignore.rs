//! An ignore that has ended.

use super::on;
use crate::diag::{Finding, IgnoreState, Level, RuleInfo, Upkeep};
use crate::rules::{Check, Rule, RuleCx};

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        docs: "The day `until` of an `[[ignore]]` is over. The mute does not count any more, so what it hid is \
               reported again. Days are those of UTC; the mute counts on the day itself.\n\nMend the fault and \
               remove the mute, or set a later day.",
        ..RuleInfo::new("config-expired-ignore", Level::Warning, "a mute whose last day is over")
    },
    check: Check::Upkeep(run),
};

fn run(upkeep: &Upkeep, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for ignore in &upkeep.ignores {
        if let IgnoreState::Expired { until } = &ignore.state {
            let message = format!("the mute of `{}` ended on {until} and does not count any more", ignore.rule);
            out.push(on(&RULE, ignore, message).help("mend what it hid and remove it, or set a later day"));
        }
    }
}
