//! A setting or ignore for a rule that does not exist.

use super::{called, on};
use crate::{Check, Rule, RuleCx, did_you_mean};
use mhlint_diag::{Finding, IgnoreState, Level, RuleInfo, Upkeep};

pub(crate) static RULE: Rule = Check::Upkeep(run).rule(RuleInfo {
    docs: include_str!("unknown_rule.md").trim_ascii_end(),
    ..RuleInfo::new(
        "config-unknown-rule",
        Level::Warning,
        "a setting or ignore for a rule that does not exist",
    )
});

fn run(upkeep: &Upkeep, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for unknown in &upkeep.unknown {
        let message = format!(
            "`{}` in `{}` matches no rule",
            unknown.rule, unknown.setting
        );
        let finding = Finding::new(
            &RULE.info,
            unknown.path.clone(),
            unknown.place.clone(),
            message,
        );
        out.push(
            finding
                .key(format!("{} {}", unknown.setting, unknown.rule))
                .help(help(unknown.nearest)),
        );
    }
    for ignore in &upkeep.ignores {
        if let IgnoreState::UnknownRule { nearest } = ignore.state {
            let message = format!(
                "`{}` in the {} matches no rule",
                ignore.rule,
                called(ignore)
            );
            out.push(on(&RULE, ignore, message).help(help(nearest)));
        }
    }
}

fn help(nearest: Option<&str>) -> String {
    did_you_mean(nearest, "run `mhlint rules` to list all rules")
}
