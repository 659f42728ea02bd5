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
            "evaluates it as Python with all rights of the user, as soon as its window is made",
        )],
        docs: "`display.formula` is handed to Python's `eval`, and its result to `display.text` with `str.format`.\n\nThat can run any program, \
            read and delete files, or never come to an end, and it happens at every start, when the window prints its slots, and whenever \
            a slider moves. Safe are numbers, \
            `val` (the slider, 0 to 1), arithmetic, comparisons, `and`, `or`, `not`, conditional expressions, `round`, `str`, \
            texts in quotes and `+` between them; powers with a fixed small exponent. In `text` safe are `{}` and `{0}` \
            with a layout. Everything else is reported: \
            names, attributes, elements, other calls, and also what Python refuses, because then the program stops before its window is \
            up; a formula that divides by `val` stops where the slider is 0. This finding cannot be muted.\n\nRewrite the formula with what is safe.",
        ..RuleInfo::new("modelling-unsafe-formula", Level::Error, "`display.formula` is more than harmless arithmetic")
    },
    check: Check::Makehuman2(run),
};

fn run(_: &View<'_>, base: &Base<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for bound in &base.sliders {
        let Some(display) = &bound.slider.display else { continue };
        for (member, fault) in [("formula", &display.formula_fault), ("text", &display.text_fault)] {
            let is_of_layout = |fault: &&Fault| member == "text" && fault.kind.is_of_layout();
            let fault = fault.as_ref().filter(|fault| !is_of_layout(fault));
            out.extend(fault.map(|fault| finding(bound, member, fault)));
        }
    }
}

fn finding(bound: &BoundSlider<'_>, member: &str, fault: &Fault) -> Finding {
    let key = bound.slider.key.as_str();
    let message = format!("the {member} of `{key}` {}", fault.what);
    let effect = match fault.kind {
        FaultKind::Foreign => {
            "evaluates it as Python at start: a data file runs foreign code with all rights of the user, or stops the \
             program with a NameError"
        }
        FaultKind::Endless => "may hang at start or run out of memory",
        FaultKind::Syntax => "stops at start with a SyntaxError",
        FaultKind::Mistyped => "stops at start with a TypeError",
        FaultKind::Pair => "shows a pair of values",
        FaultKind::Raises | FaultKind::Layout => {
            "stops with an exception: at start, or where the slider has such a value"
        }
    };
    let help = match member {
        _ if fault.kind == FaultKind::Mistyped => "write `**` for a power, `and` and `or` between conditions",
        _ if fault.kind == FaultKind::Pair => "write a point in a number: `0.5`",
        "text" => "use `{}` for the result, with a layout such as `{:.1f}` if need be",
        _ => "use numbers, `val`, arithmetic, comparisons, `if`/`else`, `round`, `str` and texts joined with `+`",
    };
    RULE.at(bound.file, Place::Span(fault.span.clone()), message)
        .key(format!("{key} {member}"))
        .effect(effect)
        .help(help)
}
