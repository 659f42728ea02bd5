//! `sum` of a component must be the `barycentric` list of its slider.

use super::super::cause::component::is_even;
use super::super::cause::component::patterns;
use super::super::{Check, Rule, RuleCx};
use super::component::{sound_components, weigh};
use mhlint_diag::{Application::Makehuman2, Finding, Level, Place, RuleInfo};
use mhlint_repo::makehuman2::{Base, BoundSlider, Pattern, View};

pub(crate) static RULE: Rule = Check::Makehuman2(run).rule(RuleInfo {
    breaks: &[(
        Makehuman2,
        "takes the weights by position, so that values get the weights of other corners; crashes \
         with `TypeError` if `sum` names a plain slider",
    )],
    docs: include_str!("barycentric_mismatch.md").trim_ascii_end(),
    ..RuleInfo::new(
        "macro-barycentric-mismatch",
        Level::Error,
        "`sum` of a component and `barycentric` of its slider differ",
    )
});

const WITHOUT_CORNERS: &str = "crashes with `TypeError`: a plain slider has no weights for corners";
const BY_POSITION: &str =
    "takes the weights by position, so that values get the weights of other corners";

fn run(_: &View<'_>, base: &Base<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some((file, macros)) = base.macro_file() else {
        return;
    };
    for component in sound_components(file, macros)
        .filter(|c| c.steps.is_none() && c.sum.is_some() && is_even(c))
    {
        let patterns = patterns(component);
        let Some((at, fault)) = patterns
            .iter()
            .enumerate()
            .find_map(|(at, p)| Some((at, fault(base, &patterns, at, p)?)))
        else {
            continue;
        };
        let name = &component.name;
        let (level, message, slider) = fault;
        let place = Place::pointer(["components", name, "sum", &at.to_string()]);
        let finding = RULE
            .at(file, place, format!("component `{name}`: {message}"))
            .key(name)
            .level(level);
        let finding = if level == Level::Error {
            finding
                .effect(WITHOUT_CORNERS)
                .help("replace it with a corner of the triangle slider")
        } else {
            finding
                .effect(BY_POSITION)
                .help("list the same corners in the same order as `barycentric` of the slider")
        };
        let place = Place::key([&slider.slider.key]);
        out.push(weigh(
            finding.related(&slider.file.path, place, "the slider"),
            macros,
            component,
        ));
    }
}

/// What is wrong with the entry at a place. Unknown patterns and lists of another length are other
/// findings.
fn fault<'s>(
    base: &'s Base<'_>,
    all: &[String],
    at: usize,
    pattern: &str,
) -> Option<(Level, String, &'s BoundSlider<'s>)> {
    let slider = base.slider(pattern)?;
    let Pattern::Barycentric(corners) = &slider.pattern else {
        return Some((
            Level::Error,
            format!("`{pattern}` is a plain slider, not a corner of a triangle"),
            slider,
        ));
    };
    let first = all.iter().find_map(|pattern| base.slider(pattern))?;
    if !std::ptr::eq(first, slider) {
        let message =
            format!("`{pattern}` belongs to another triangle slider than the entries before it");
        return Some((Level::Warning, message, slider));
    }
    if corners.get(at).is_none_or(|corner| corner == pattern) {
        return None;
    }
    let corner = corners.get(at)?;
    Some((
        Level::Warning,
        format!("`{pattern}` is listed where the slider has `{corner}`"),
        slider,
    ))
}
