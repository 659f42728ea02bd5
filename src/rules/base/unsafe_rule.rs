//! `random.rules` is handed to Python: nothing but harmless arithmetic may be in it.

use super::super::{Check, Rule, RuleCx};
use crate::diag::{Application, Finding, Level, Place, RuleInfo};
use crate::formats::expression::FaultKind;
use crate::repo::makehuman2::{Base, View};

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        cannot_be_ignored: true,
        breaks: &[(
            Application::Makehuman2,
            "evaluates it as Python with all rights of the user when a random character is made",
        )],
        docs: "The conditions in `random.rules` are handed to Python's `eval` with the other slider as `x`.\n\nThat can run any program, read \
            and delete files, or never come to an end. Safe are numbers, `x`, arithmetic, comparisons, `and`, `or`, `not`, conditional \
            expressions, `round`, `str`, texts in quotes and `+` between them; powers with a fixed small exponent. \
            Everything else is reported, and also what Python refuses, because then the random character view stops; so is a division by `x`, \
            which can be 0, unless a condition stands before it. This finding \
            cannot be muted.\n\nRewrite the condition as a comparison, such as `0.2 < x < 0.75`.",
        ..RuleInfo::new("base-unsafe-rule", Level::Error, "`random.rules` holds more than harmless arithmetic")
    },
    check: Check::Makehuman2(run),
};

fn run(_: &View<'_>, base: &Base<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some((file, settings)) = base.settings() else { return };
    for (key, conditions) in settings.random.iter().flat_map(|random| &random.rules) {
        for condition in conditions {
            let Some(fault) = &condition.fault else { continue };
            let effect = match fault.kind {
                FaultKind::Foreign => {
                    "evaluates it as Python: a data file runs foreign code with all rights of the user"
                }
                FaultKind::Endless => "may hang or run out of memory when a random character is made",
                FaultKind::Syntax => "stops with a SyntaxError when a random character is made",
                FaultKind::Mistyped => "stops with a TypeError when a random character is made",
                FaultKind::Pair => "makes a pair of it, which is never exactly False: the rule has no effect",
                FaultKind::Raises | FaultKind::Layout => "stops with an exception when a random character is made",
            };
            let help = match fault.kind {
                FaultKind::Pair => "write a point in a number, such as `x < 0.5`",
                _ => "write a comparison of `x` with numbers, such as `0.2 < x < 0.75`",
            };
            let message = format!("the rule of `{key}` on `{}` {}", condition.slider, fault.what);
            out.push(
                RULE.at(file, Place::Span(fault.span.clone()), message)
                    .key(format!("{key} {}", condition.slider))
                    .effect(effect)
                    .help(help),
            );
        }
    }
}
