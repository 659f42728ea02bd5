//! `display` of a slider is handed to Python: nothing but harmless arithmetic may be in it.

use super::super::{Check, Rule, RuleCx};
use mhlint_diag::{Application::Makehuman2, Finding, Level, Place, RuleInfo};
use mhlint_formats::expression::{Fault, FaultKind};
use mhlint_repo::makehuman2::{Base, BoundSlider, View};

pub(crate) static RULE: Rule = Check::Makehuman2(run).rule(RuleInfo {
    cannot_be_ignored: true,
    breaks: &[(
        Makehuman2,
        "runs it as Python code with all the user's rights as soon as its window opens",
    )],
    docs: include_str!("unsafe_formula.md").trim_ascii_end(),
    ..RuleInfo::new(
        "modelling-unsafe-formula",
        Level::Error,
        "`display.formula` is more than harmless arithmetic",
    )
});

fn run(_: &View<'_>, base: &Base<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for bound in &base.sliders {
        let Some(display) = &bound.slider.display else {
            continue;
        };
        for (member, fault) in [
            ("formula", &display.formula_fault),
            ("text", &display.text_fault),
        ] {
            let is_of_layout = |fault: &&Fault| member == "text" && fault.kind.is_of_layout();
            let fault = fault.as_ref().filter(|fault| !is_of_layout(fault));
            out.extend(fault.map(|fault| finding(bound, member, fault)));
        }
    }
}

fn finding(bound: &BoundSlider<'_>, member: &str, fault: &Fault) -> Finding {
    let key = bound.slider.key.as_str();
    let message = format!("`display.{member}` of `{key}` {}", fault.what);
    let effect = match fault.kind {
        FaultKind::Foreign => {
            "runs it as Python code with all the user's rights at start, or crashes with \
                `NameError`"
        }
        FaultKind::Endless => "may hang at start or run out of memory",
        FaultKind::Syntax => "crashes at start with `SyntaxError`",
        FaultKind::Mistyped => "crashes at start with `TypeError`",
        FaultKind::Pair => "shows a pair of values instead of one number",
        FaultKind::Raises | FaultKind::Layout => {
            "crashes at start, or when the slider has such a value"
        }
    };
    let help = match member {
        _ if fault.kind == FaultKind::Mistyped => {
            "write `**` for a power, `and` and `or` between conditions"
        }
        _ if fault.kind == FaultKind::Pair => "write numbers with a decimal point, such as `0.5`",
        "text" => "use `{}` for the result, or a format such as `{:.1f}`",
        _ => {
            "use numbers, `val`, arithmetic, comparisons, `if`/`else`, `round`, `str` and strings \
                joined with `+`"
        }
    };
    RULE.at(bound.file, Place::Span(fault.span.clone()), message)
        .key(format!("{key} {member}"))
        .effect(effect)
        .help(help)
}
