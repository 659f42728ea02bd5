//! A mute that has ended.

use super::on;
use crate::diag::{Finding, Level, MuteState, RuleInfo, Upkeep};
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
    for mute in &upkeep.mutes {
        if let MuteState::Expired { until } = &mute.state {
            let message = format!("the mute of `{}` ended on {until} and does not count any more", mute.rule);
            out.push(on(&RULE, mute, message).help("mend what it hid and remove it, or set a later day"));
        }
    }
}
