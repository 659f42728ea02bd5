//! Every pattern must be registered once.

use super::super::{Check, Rule, RuleCx};
use super::with_patterns;
use mhlint_diag::{Application::Makehuman2, Finding, Level, Place, RuleInfo, grouped};
use mhlint_repo::makehuman2::{Base, View};

pub(crate) static RULE: Rule = Check::Makehuman2(run).rule(RuleInfo {
    breaks: &[(
        Makehuman2,
        "saves and loads only the last of the sliders; the values of the others are lost",
    )],
    docs: include_str!("duplicate_pattern.md").trim_ascii_end(),
    ..RuleInfo::new(
        "modelling-duplicate-pattern",
        Level::Error,
        "two entries have the same pattern",
    )
});

fn run(_: &View<'_>, base: &Base<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let sliders = with_patterns(base).unwrap_or_default();
    let by_pattern = sliders.iter().flat_map(|slider| {
        slider
            .pattern
            .names()
            .iter()
            .map(move |name| (name, slider))
    });
    for (pattern, sliders) in grouped(by_pattern) {
        let [hidden @ .., last] = sliders.as_slice() else {
            continue;
        };
        let Some(first) = hidden.first() else {
            continue;
        };
        let (key, winner) = (first.slider.key.as_str(), last.slider.key.as_str());
        let message = if std::ptr::eq(*first, *last) {
            format!("`{key}` has the pattern `{pattern}` twice")
        } else {
            format!("`{key}` and `{winner}` have the same pattern `{pattern}`")
        };
        let mut finding = RULE
            .at(last.file, Place::key([winner]), message)
            .key(pattern)
            .parts(sliders.iter().map(|slider| &slider.slider.key))
            .help("remove one of the entries, or give it targets (a macro: a pattern) of its own");
        for other in hidden.iter().filter(|other| !std::ptr::eq(**other, *last)) {
            let place = Place::key([&other.slider.key]);
            finding = finding.related(other.file.path.clone(), place, "cannot be saved or loaded");
        }
        out.push(finding);
    }
}
