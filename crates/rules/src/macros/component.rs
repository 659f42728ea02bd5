//! What the rules on components and their patterns share.

use super::super::cause::component::{is_sound_component, patterns};
use mhlint_diag::{Finding, Level};
use mhlint_formats::macro_json::{Component, MacroFile};
use mhlint_repo::FileFacts;
use mhlint_repo::makehuman2::{Base, Pattern};

/// Lowers a finding on a component that no macro definition uses: it is never evaluated.
pub(super) fn weigh(finding: Finding, macros: &MacroFile, component: &Component) -> Finding {
    if macros.used.contains(&component.name) {
        return finding;
    }
    finding
        .level(Level::Info)
        .effect("never evaluates the component: no macrodef uses it")
}

/// The components that the schema has nothing against.
pub(super) fn sound_components<'a>(
    file: &'a FileFacts,
    macros: &'a MacroFile,
) -> impl Iterator<Item = &'a Component> + use<'a> {
    macros
        .components
        .iter()
        .filter(|component| is_sound_component(file, component))
}

/// The highest slider position at which a component with these steps has a value: the loader takes
/// the first interval whose upper step the slider does not exceed. None without an interval.
pub(super) fn reach(steps: &[f64]) -> Option<f64> {
    steps.iter().skip(1).copied().reduce(f64::max)
}

/// Whether a component has no value but with its slider at exactly 0, so that none of its macros
/// ever applies.
pub(super) fn is_dead(steps: &[f64]) -> bool {
    reach(steps).is_none_or(|reach| reach <= 0.0)
}

/// Patterns of a component that no slider is registered under. Empty without a `modelling.json` to
/// ask.
pub(super) fn unknown_patterns(base: &Base<'_>, component: &Component) -> Vec<String> {
    if base.modelling.winner().is_none() {
        return Vec::new();
    }
    let unknown =
        |pattern: &String| base.slider(pattern).is_none() && !base.explains_pattern(pattern);
    patterns(component).into_iter().filter(unknown).collect()
}

/// Patterns of all macro sliders.
pub(super) fn macro_patterns<'s>(base: &'s Base<'_>) -> impl Iterator<Item = &'s str> {
    let macros = base
        .sliders
        .iter()
        .filter(|bound| matches!(bound.pattern, Pattern::Macro(_) | Pattern::Barycentric(_)));
    macros
        .flat_map(|bound| bound.pattern.names())
        .map(String::as_str)
}
