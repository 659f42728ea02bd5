//! `random.rules` is handed to Python: nothing but harmless arithmetic may be in it.

use super::super::{Check, Rule, RuleCx};
use mhlint_diag::{Application::Makehuman2, Finding, Level, Place, RuleInfo};
use mhlint_formats::expression::FaultKind;
use mhlint_repo::makehuman2::{Base, View};

pub(crate) static RULE: Rule = Check::Makehuman2(run).rule(RuleInfo {
    cannot_be_ignored: true,
    breaks: &[(
        Makehuman2,
        "runs it as Python code with the rights of the user when it makes a random character",
    )],
    docs: include_str!("unsafe_rule.md").trim_ascii_end(),
    ..RuleInfo::new(
        "base-unsafe-rule",
        Level::Error,
        "`random.rules` contains more than harmless arithmetic",
    )
});

fn run(_: &View<'_>, base: &Base<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some((file, settings)) = base.settings() else {
        return;
    };
    for (key, conditions) in settings.random.iter().flat_map(|random| &random.rules) {
        for condition in conditions {
            let Some(fault) = &condition.fault else {
                continue;
            };
            let effect = match fault.kind {
                FaultKind::Foreign => {
                    "runs it as Python code: the data file can do anything that the user may do"
                }
                FaultKind::Endless => {
                    "may hang or run out of memory when it makes a random character"
                }
                FaultKind::Syntax => "crashes with `SyntaxError` when it makes a random character",
                FaultKind::Mistyped => "crashes with `TypeError` when it makes a random character",
                FaultKind::Pair => {
                    "reads it as two values, which are never `False`: the condition has no effect"
                }
                FaultKind::Raises | FaultKind::Layout => "crashes when it makes a random character",
            };
            let help = match fault.kind {
                FaultKind::Pair => "write numbers with a decimal point, such as `x < 0.5`",
                _ => "compare `x` with numbers, such as `0.2 < x < 0.75`",
            };
            let message = format!(
                "the condition of `{key}` on `{}` {}",
                condition.slider, fault.what
            );
            out.push(
                RULE.at(file, Place::Span(fault.span.clone()), message)
                    .key(format!("{key} {}", condition.slider))
                    .effect(effect)
                    .help(help),
            );
        }
    }
}
