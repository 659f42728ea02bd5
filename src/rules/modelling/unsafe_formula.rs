//! `display` of a slider is handed to Python: nothing but harmless arithmetic may be in it.

use super::super::{Check, Rule, RuleCx};
use crate::diag::{Application, Finding, Level, Place, RuleInfo};
use crate::formats::expression::{Fault, FaultKind};
use crate::repo::makehuman2::{Base, BoundSlider, View};

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        cannot_be_ignored: true,
        breaks: &[(
            Application::Makehuman2,
            "evaluates it as Python with all rights of the user, at every move of a slider",
        )],
        docs: "`display.formula` is handed to Python's `eval`, and its result to `display.text` with `str.format`.\n\nThat can run any program, \
            read and delete files, or never come to an end, and it happens when somebody merely moves a slider. Safe are numbers, \
            `val` (the slider, 0 to 1), arithmetic, comparisons, `and`, `or`, `not`, conditional expressions, `round`, `str`, \
            texts in quotes and `+` between them; powers with a fixed small exponent. In `text` safe are `{}` and `{0}` \
            with a layout. Everything else is reported: names, attributes, elements, other calls, and also what Python refuses, because then \
            every move of the slider raises an exception. This finding cannot be muted.\n\nRewrite the formula with what is safe.",
        ..RuleInfo::new("modelling-unsafe-formula", Level::Error, "`display.formula` is more than harmless arithmetic")
    },
    check: Check::Makehuman2(run),
};

fn run(_: &View<'_>, base: &Base<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for bound in &base.sliders {
        let Some(display) = &bound.slider.display else { continue };
        for (member, fault) in [("formula", &display.formula_fault), ("text", &display.text_fault)] {
            out.extend(fault.as_ref().map(|fault| finding(bound, member, fault)));
        }
    }
}

fn finding(bound: &BoundSlider<'_>, member: &str, fault: &Fault) -> Finding {
    let key = bound.slider.key.as_str();
    let message = format!("the {member} of `{key}` {}", fault.what);
    let effect = match fault.kind {
        FaultKind::Foreign => "evaluates it as Python: a data file runs foreign code with all rights of the user",
        FaultKind::Endless => "may hang or run out of memory as soon as a slider moves",
        FaultKind::Syntax => "refuses it as Python: every move of a slider raises a SyntaxError",
        FaultKind::Raises => "raises an exception at every move of a slider",
    };
    let help = match member {
        "text" => "use `{}` for the result, with a layout such as `{:.1f}` if need be",
        _ => "use numbers, `val`, arithmetic, comparisons, `if`/`else`, `round`, `str` and texts joined with `+`",
    };
    RULE.at(bound.file, Place::Span(fault.span.clone()), message)
        .key(format!("{key} {member}"))
        .effect(effect)
        .help(help)
}
