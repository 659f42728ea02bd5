//! Components of `macro.json` with faults of their own: what is made of their values follows from
//! them.

use super::schema::is_sound;
use mhlint_diag::pointer;
use mhlint_formats::macro_json::Component;
use mhlint_repo::FileFacts;

/// Whether the schema has nothing against a component.
pub(crate) fn is_sound_component(file: &FileFacts, component: &Component) -> bool {
    is_sound(file, &pointer(&["components", &component.name]))
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
