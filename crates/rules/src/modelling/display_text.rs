//! The layout in `display.text` is for what the formula gives.

use super::super::{Check, Rule, RuleCx};
use mhlint_diag::{Application::Makehuman2, Finding, Level, Place, RuleInfo};
use mhlint_repo::makehuman2::{Base, View};

pub(crate) static RULE: Rule = Check::Makehuman2(run).rule(RuleInfo {
    breaks: &[(Makehuman2, "crashes at start when it prints the status texts")],
    docs: "`display.text` has a format that does not fit its value. It is a text for Python's `str.format`: `{}` \
        stands for the result of `display.formula`, and the format after a colon is for one type of \
        value.\n\n`{:d}` is for whole numbers, `{:.1f}` for all numbers, `{:>8}` for everything. `val` is a \
        decimal number, and so is everything calculated with it. `round(…)` without a second argument returns a \
        whole number, `str(…)` a string.\n\nMakeHuman 2 prints these texts when it opens its window. It crashes \
        with `ValueError` if a format is unknown or for another type, with `IndexError` if the text asks for a \
        second value, and with `KeyError` if it asks for a named one.\n\nChange the format, or round the result.",
    ..RuleInfo::new("modelling-display-text", Level::Error, "a format in `display.text` does not fit its value")
});

fn run(_: &View<'_>, base: &Base<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for bound in &base.sliders {
        let fault = bound.slider.display.as_ref().and_then(|display| display.text_fault.as_ref());
        let Some(fault) = fault.filter(|fault| fault.kind.is_of_layout()) else { continue };
        let key = bound.slider.key.as_str();
        let message = format!("`display.text` of `{key}` {}", fault.what);
        let help = "use `{}`, or a format for the result: `{:.1f}` for `val * 100`, `{:d}` for `round(val * 100)`";
        out.push(RULE.at(bound.file, Place::Span(fault.span.clone()), message).key(key).help(help));
    }
}
