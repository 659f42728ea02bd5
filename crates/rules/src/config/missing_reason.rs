//! An ignore without a reason.

use super::{called, on};
use crate::{Check, Rule, RuleCx};
use mhlint_diag::{Finding, IgnoreState, Level, RuleInfo, Upkeep};

pub(crate) static RULE: Rule = Check::Upkeep(run).rule(RuleInfo {
    docs: include_str!("missing_reason.md").trim_ascii_end(),
    ..RuleInfo::new(
        "config-missing-reason",
        Level::Warning,
        "an `[[ignore]]` or ignore comment without a reason",
    )
});

fn run(upkeep: &Upkeep, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for ignore in upkeep
        .ignores
        .iter()
        .filter(|ignore| ignore.state == IgnoreState::NoReason)
    {
        let message = format!(
            "the {} for `{}` has no reason, so it has no effect",
            called(ignore),
            ignore.rule
        );
        let help = match ignore.covers {
            Some(_) => "add `reason = \"…\"` to say why the finding is acceptable",
            None => "write the reason after the name of the rule",
        };
        out.push(on(&RULE, ignore, message).help(help));
    }
}
