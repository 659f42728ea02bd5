//! An ignore that has ended.

use super::{called, on};
use crate::{Check, Rule, RuleCx};
use mhlint_diag::{Finding, IgnoreState, Level, RuleInfo, Upkeep};

pub(crate) static RULE: Rule = Check::Upkeep(run).rule(RuleInfo {
    docs: include_str!("expired_ignore.md").trim_ascii_end(),
    ..RuleInfo::new(
        "config-expired-ignore",
        Level::Warning,
        "an `[[ignore]]` whose last day is over",
    )
});

fn run(upkeep: &Upkeep, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for ignore in &upkeep.ignores {
        if let IgnoreState::Expired { until } = &ignore.state {
            let message = format!(
                "the {} for `{}` expired on {until} and no longer applies",
                called(ignore),
                ignore.rule
            );
            out.push(
                on(&RULE, ignore, message)
                    .help("fix the finding and remove the entry, or set a later date"),
            );
        }
    }
}
