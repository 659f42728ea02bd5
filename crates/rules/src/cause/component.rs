//! Components of `macro.json` with faults of their own: what is made of their values follows from
//! them.

use std::collections::BTreeSet;

use super::schema::is_sound;
use mhlint_diag::{Grouped, grouped, pointer};
use mhlint_formats::macro_json::{Component, MacroFile, Macrodef};
use mhlint_repo::FileFacts;

/// Whether the schema has nothing against a component.
pub(crate) fn is_sound_component(file: &FileFacts, component: &Component) -> bool {
    is_sound(file, &pointer(&["components", &component.name]))
}

/// A combination counts only above this weight (`docs/loaders/makehuman2/macros.md#evaluation`).
pub(crate) const SMALLEST_WEIGHT: f64 = 0.01;

/// How many combinations of a macro definition are active at once between its steps, where these
/// are so many that none of them counts; nothing if a component is unknown.
pub(crate) fn too_many_at_once(macros: &MacroFile, macrodef: &Macrodef) -> Option<f64> {
    let component = |name: &String| macros.components.iter().find(|own| own.name == *name);
    let names = macrodef.components.iter();
    let active: Option<f64> = names
        .map(|name| component(name).map(active_values))
        .product();
    active.filter(|active| 1.0 / active <= SMALLEST_WEIGHT)
}

/// How many values of a component are active at once where most are: two between steps, three in a
/// triangle.
fn active_values(component: &Component) -> f64 {
    let slots = if component.steps.is_some() { 2 } else { 3 };
    component.values.len().clamp(1, slots) as f64
}

/// Whether every value has a step or a corner of its own: `macro-steps-length`, `macro-sum-arity`.
pub(crate) fn is_even(component: &Component) -> bool {
    let places = match (&component.steps, &component.sum) {
        (Some(steps), _) => Some(steps.len()),
        (None, sum) => sum.as_ref().map(Vec::len),
    };
    places.is_none_or(|places| places == component.values.len())
}

/// Whether a step is `NaN` or infinite and `json-syntax` says so.
pub(crate) fn has_special_step(file: &FileFacts, component: &Component) -> bool {
    !file.json.specials.is_empty()
        && component
            .steps
            .iter()
            .flatten()
            .any(|step| !step.is_finite())
}

/// Whether the steps of a component are as they must be, so that no other rule speaks of them.
pub(crate) fn has_sound_steps(component: &Component) -> bool {
    component.steps.as_ref().is_some_and(|steps| {
        steps.len() == component.values.len()
            && steps.is_sorted_by(|a, b| a < b)
            && steps.first() == Some(&0.0)
            && steps.last() == Some(&1.0)
    })
}

/// Patterns of sliders that a component names, whatever else is wrong with it.
pub(crate) fn named_patterns(component: &Component) -> Vec<String> {
    let Some(own) = &component.pattern else {
        return Vec::new();
    };
    match (&component.steps, &component.sum) {
        (None, Some(sum)) => sum.iter().map(|end| format!("{own}{end}")).collect(),
        _ => vec![own.clone()],
    }
}

/// Patterns under which a component reads sliders. A third entry of `sum` is the last that is read.
pub(crate) fn patterns(component: &Component) -> Vec<String> {
    let Some(pattern) = &component.pattern else {
        return Vec::new();
    };
    match (&component.steps, &component.sum) {
        (Some(_), _) => vec![pattern.clone()],
        (None, Some(sum)) => {
            let read = sum.iter().take(component.values.len().min(3));
            read.map(|end| format!("{pattern}{end}")).collect()
        }
        (None, None) => Vec::new(),
    }
}

/// Which macro definitions read a slider, by its patterns.
pub(crate) struct Readers<'m> {
    macros: &'m MacroFile,
    /// Names of the components that some definition uses, by pattern.
    components: Grouped<String, &'m str>,
    /// Positions of the definitions, by component.
    definitions: Grouped<&'m str, usize>,
}

impl<'m> Readers<'m> {
    /// Those of a file; `patterns` says which ones a component reads.
    pub(crate) fn of(macros: &'m MacroFile, patterns: fn(&Component) -> Vec<String>) -> Self {
        let components = macros.components.iter();
        let components = components.filter(|own| macros.used.contains(&own.name));
        let definitions = macros.macrodefs.iter().enumerate();
        Self {
            macros,
            components: grouped(components.flat_map(|own| {
                let patterns = patterns(own).into_iter();
                patterns.map(|pattern| (pattern, own.name.as_str()))
            })),
            definitions: grouped(definitions.flat_map(|(at, own)| {
                let names = own.components.iter();
                names.map(move |name| (name.as_str(), at))
            })),
        }
    }

    /// The definitions with a component that reads one of some patterns, in their order.
    pub(crate) fn of_any(&self, patterns: &[String]) -> Vec<&'m Macrodef> {
        let components = patterns.iter().filter_map(|own| self.components.get(own));
        let components: BTreeSet<&str> = components.flatten().copied().collect();
        let places = components
            .iter()
            .filter_map(|own| self.definitions.get(own));
        let places: BTreeSet<usize> = places.flatten().copied().collect();
        let macrodefs = places.into_iter();
        macrodefs
            .filter_map(|at| self.macros.macrodefs.get(at))
            .collect()
    }
}
