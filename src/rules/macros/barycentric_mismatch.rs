//! `sum` of a component must be the `barycentric` list of its slider.

use super::super::cause::component::is_even;
use super::super::cause::component::patterns;
use super::super::{Check, Rule, RuleCx};
use super::component::{sound_components, weigh};
use crate::diag::{Application, Finding, Level, Place, RuleInfo};
use crate::repo::makehuman2::{Base, BoundSlider, Pattern, View};

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        breaks: &[(
            Application::Makehuman2,
            "stops with a TypeError when an entry leads to a plain slider; another order gives the values each other's weights",
        )],
        docs: "A triangle slider has three weights. `sum` names the corners for the values of a component, \
            `barycentric` of the slider names them for the slider.\n\nMakeHuman 2 looks an entry of `sum` up by \
            name, but then takes the weight at *its own* position in `sum`. If the order differs, the values \
            silently get each other's weights (warning). If an entry leads to a plain slider there are no \
            weights to choose from, and the program stops.\n\nList the corners in the same order in both files.",
        ..RuleInfo::new(
            "macro-barycentric-mismatch",
            Level::Error,
            "`sum` of a component and the `barycentric` list of its slider differ",
        )
    },
    check: Check::Makehuman2(run),
};

fn run(_: &View<'_>, base: &Base<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some((file, macros)) = base.macro_file() else { return };
    for component in sound_components(file, macros).filter(|c| c.steps.is_none() && c.sum.is_some() && is_even(c)) {
        let patterns = patterns(component);
        let Some((at, fault)) =
            patterns.iter().enumerate().find_map(|(at, p)| Some((at, fault(base, &patterns, at, p)?)))
        else {
            continue;
        };
        let name = &component.name;
        let (level, message, slider) = fault;
        let place = Place::pointer(["components", name, "sum", &at.to_string()]);
        let mut finding = RULE.at(file, place, format!("component `{name}`: {message}")).key(name).level(level);
        finding = finding.help("list the corners as in `barycentric` of the slider, in the same order");
        if level == Level::Warning {
            finding = finding.effect("takes the weights by position: values get the weights of others");
        }
        let place = Place::key([&slider.slider.key]);
        out.push(weigh(finding.related(&slider.file.path, place, "the slider"), macros, component));
    }
}

/// What is wrong with the entry at a place. Unknown patterns and lists of another length are other findings.
fn fault<'s>(
    base: &'s Base<'_>,
    all: &[String],
    at: usize,
    pattern: &str,
) -> Option<(Level, String, &'s BoundSlider<'s>)> {
    let slider = base.slider(pattern)?;
    let Pattern::Barycentric(corners) = &slider.pattern else {
        return Some((Level::Error, format!("`{pattern}` is a plain slider, no corner of a triangle"), slider));
    };
    let first = all.iter().find_map(|pattern| base.slider(pattern))?;
    if !std::ptr::eq(first, slider) {
        let message = format!("`{pattern}` is a corner of another triangle slider than the entries before it");
        return Some((Level::Warning, message, slider));
    }
    if corners.get(at).is_none_or(|corner| corner == pattern) {
        return None;
    }
    let corner = corners.get(at)?;
    Some((Level::Warning, format!("`{pattern}` stands where the slider has `{corner}`"), slider))
}
