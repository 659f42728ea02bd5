//! An ignore without effect.

use super::{FIX_FIRST, called, on, where_of};
use crate::{Check, Rule, RuleCx};
use mhlint_diag::{Finding, IgnoreState, Level, RuleInfo, Upkeep};

pub(crate) static RULE: Rule = Check::Upkeep(run).rule(RuleInfo {
    docs: include_str!("unused_ignore.md").trim_ascii_end(),
    ..RuleInfo::new(
        "config-unused-ignore",
        Level::Warning,
        "an `[[ignore]]` or ignore comment that hides nothing",
    )
});

fn run(upkeep: &Upkeep, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for ignore in &upkeep.ignores {
        if let IgnoreState::Malformed { words } = &ignore.state {
            let message = format!("the comment `{words}` is not a valid ignore");
            out.push(
                on(&RULE, ignore, message)
                    .key(words)
                    .help("write `mhlint: ignore RULE reason` after the `#`"),
            );
            continue;
        }
        let (message, help) = match ignore.state {
            IgnoreState::Unused => (
                format!(
                    "the {} for `{}` hides nothing{}",
                    called(ignore),
                    ignore.rule,
                    where_of(ignore)
                ),
                if upkeep.errors {
                    FIX_FIRST
                } else {
                    "remove the unused ignore"
                },
            ),
            IgnoreState::CannotBeIgnored => (
                format!(
                    "`{}` cannot be ignored, so the {} has no effect",
                    ignore.rule,
                    called(ignore)
                ),
                "remove the ignore, and fix what the rule reports",
            ),
            _ => continue,
        };
        out.push(on(&RULE, ignore, message).help(help));
    }
}
