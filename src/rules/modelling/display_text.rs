//! The layout in `display.text` is for what the formula gives.

use super::super::{Check, Rule, RuleCx};
use crate::diag::{Application, Finding, Level, Place, RuleInfo};
use crate::repo::makehuman2::{Base, View};

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        breaks: &[(Application::Makehuman2, "stops at start with a ValueError, when the window prints its slots")],
        docs: "`display.text` is a text for Python's `str.format`, and `{}` in it stands for the result of `display.formula`. A layout \
            behind a colon is for one type of value: `{:d}` for whole numbers, `{:.1f}` for numbers, `{:>8}` for all. `val` has \
            decimals, and so has everything that is calculated with it; `round(…)` without a second value gives a whole number, \
            `str(…)` a text.\n\nMakeHuman 2 prints these texts when its window is made, and stops with a ValueError where the layout is for \
            another type, or unknown.\n\nChange the layout, or round the result.",
        ..RuleInfo::new("modelling-display-text", Level::Error, "a layout in `display.text` that is not for its value")
    },
    check: Check::Makehuman2(run),
};

fn run(_: &View<'_>, base: &Base<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for bound in &base.sliders {
        let fault = bound.slider.display.as_ref().and_then(|display| display.text_fault.as_ref());
        let Some(fault) = fault.filter(|fault| fault.kind.is_of_layout()) else { continue };
        let key = bound.slider.key.as_str();
        let message = format!("the text of `{key}` {}", fault.what);
        let help =
            "use `{}`, or a layout for what the formula gives: `{:.1f}` for `val * 100`, `{:d}` for `round(val * 100)`";
        out.push(RULE.at(bound.file, Place::Span(fault.span.clone()), message).key(key).help(help));
    }
}
