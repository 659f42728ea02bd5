//! An ignore without a reason.

use super::on;
use crate::diag::{Finding, IgnoreState, Level, RuleInfo, Upkeep};
use crate::rules::{Check, Rule, RuleCx};

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        docs: "A mute without a reason does not count: what it was meant to hide is reported. Who finds a mute \
               years later must be able to tell whether it still holds.\n\nWrite the reason: `reason = \"…\"` in \
               the `[[ignore]]` of mhlint.toml, or behind the rule in the comment: `# mhlint: ignore RULE reason`.",
        ..RuleInfo::new("config-missing-reason", Level::Warning, "a mute without a reason")
    },
    check: Check::Upkeep(run),
};

fn run(upkeep: &Upkeep, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for ignore in upkeep.ignores.iter().filter(|ignore| ignore.state == IgnoreState::NoReason) {
        let message = format!("the mute of `{}` has no reason and does not count", ignore.rule);
        let help = match ignore.covers {
            Some(_) => "add `reason = \"…\"`: why is this finding fine?",
            None => "write the reason behind the name of the rule",
        };
        out.push(on(&RULE, ignore, message).help(help));
    }
}
