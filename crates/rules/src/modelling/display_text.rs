//! The layout in `display.text` is for what the formula gives.

use super::super::{Check, Rule, RuleCx};
use mhlint_diag::{Application::Makehuman2, Finding, Level, Place, RuleInfo};
use mhlint_repo::makehuman2::{Base, View};

pub(crate) static RULE: Rule = Check::Makehuman2(run).rule(RuleInfo {
    breaks: &[(
        Makehuman2,
        "crashes at start when it prints the status texts",
    )],
    docs: include_str!("display_text.md").trim_ascii_end(),
    ..RuleInfo::new(
        "modelling-display-text",
        Level::Error,
        "a format in `display.text` does not fit its value",
    )
});

fn run(_: &View<'_>, base: &Base<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for bound in &base.sliders {
        let fault = bound
            .slider
            .display
            .as_ref()
            .and_then(|display| display.text_fault.as_ref());
        let Some(fault) = fault.filter(|fault| fault.kind.is_of_layout()) else {
            continue;
        };
        let key = bound.slider.key.as_str();
        let message = format!("`display.text` of `{key}` {}", fault.what);
        let help = "use `{}`, or a format for the result: `{:.1f}` for `val * 100`, `{:d}` for \
            `round(val * 100)`";
        out.push(
            RULE.at(bound.file, Place::Span(fault.span.clone()), message)
                .key(key)
                .help(help),
        );
    }
}
