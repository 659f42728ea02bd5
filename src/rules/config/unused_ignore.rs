//! An ignore without effect.

use super::{FIX_FIRST, on, where_of};
use crate::diag::{Finding, IgnoreState, Level, RuleInfo, Upkeep};
use crate::rules::{Check, Rule, RuleCx};

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        docs: "An `[[ignore]]` of mhlint.toml, or a comment `# mhlint: ignore RULE reason` in an asset, hides \
               nothing: the fault is mended, the file is gone, or the rule is off. Left where it is, it will hide \
               the next fault of the kind without a word.\n\nRemove it. It is reported only where the run looked at \
               everything that the mute is for: not with `--only`, `--skip` or `--base`, and not when PATH is \
            narrower than the mute. Where errors are found, mend them first: a file that cannot be read hides what else was found in \
            it. A rule that is a matter of safety cannot be muted, so a mute for it has no effect either, nor has a comment that \
            speaks to mhlint in other words.",
        ..RuleInfo::new("config-unused-ignore", Level::Warning, "a mute that hides nothing")
    },
    check: Check::Upkeep(run),
};

fn run(upkeep: &Upkeep, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for ignore in &upkeep.ignores {
        if let IgnoreState::Malformed { words } = &ignore.state {
            let message = format!("the comment `{words}` is no mute");
            out.push(on(&RULE, ignore, message).key(words).help("write `mhlint: ignore RULE reason` behind the `#`"));
            continue;
        }
        let (message, help) = match ignore.state {
            IgnoreState::Unused => (
                format!(
                    "the mute of `{}` hides nothing: nothing of the kind is found{}",
                    ignore.rule,
                    where_of(ignore)
                ),
                if upkeep.errors { FIX_FIRST } else { "remove the mute" },
            ),
            IgnoreState::CannotBeIgnored => (
                format!("`{}` is a matter of safety and cannot be muted; the mute has no effect", ignore.rule),
                "remove the mute, and mend what the rule finds",
            ),
            _ => continue,
        };
        out.push(on(&RULE, ignore, message).help(help));
    }
}
