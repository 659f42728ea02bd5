//! An ignore without effect.

use super::{FIX_FIRST, called, on, where_of};
use crate::{Check, Rule, RuleCx};
use mhlint_diag::{Finding, IgnoreState, Level, RuleInfo, Upkeep};

pub(crate) static RULE: Rule = Check::Upkeep(run).rule(RuleInfo {
    docs: "An `[[ignore]]` of mhlint.toml, or a comment `# mhlint: ignore RULE reason` in an asset, hides \
        nothing: the finding is fixed, the file is gone, or the rule is off. If it stays, it silently hides the \
        next finding of this rule.\n\nRemove it. It is reported only if the run checked everything that it is \
        for: not with `--only`, `--skip` or `--base`, and not if PATH is narrower. If there are errors, fix them \
        first: a file that cannot be read hides the findings in it.\n\nSome rules guard the user's safety and \
        cannot be ignored, so an ignore for them has no effect either. Neither has a comment to mhlint in any \
        other form.",
    ..RuleInfo::new("config-unused-ignore", Level::Warning, "an `[[ignore]]` or ignore comment that hides nothing")
});

fn run(upkeep: &Upkeep, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for ignore in &upkeep.ignores {
        if let IgnoreState::Malformed { words } = &ignore.state {
            let message = format!("the comment `{words}` is not a valid ignore");
            out.push(on(&RULE, ignore, message).key(words).help("write `mhlint: ignore RULE reason` after the `#`"));
            continue;
        }
        let (message, help) = match ignore.state {
            IgnoreState::Unused => (
                format!("the {} for `{}` hides nothing{}", called(ignore), ignore.rule, where_of(ignore)),
                if upkeep.errors { FIX_FIRST } else { "remove the unused ignore" },
            ),
            IgnoreState::CannotBeIgnored => (
                format!("`{}` cannot be ignored, so the {} has no effect", ignore.rule, called(ignore)),
                "remove the ignore, and fix what the rule reports",
            ),
            _ => continue,
        };
        out.push(on(&RULE, ignore, message).help(help));
    }
}
