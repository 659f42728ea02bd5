//! The absent combinations of one macro definition, split into systems and holes and written as
//! patterns.

use super::combination_patterns::{Cell, Pattern, cover, digits, index, systematic};
use super::listing::Listing;
use super::space::Space;
use mhlint_formats::macro_json::Component;
use mhlint_repo::makehuman2::Base;

/// Absent combinations that are told apart by name; more of them are one mass.
const NAMED: usize = 256;

/// Absent combinations of one kind.
#[derive(Default)]
pub(super) struct Absence {
    pub(super) count: usize,
    /// Their names, as long as they are few.
    pub(super) names: Vec<String>,
    /// Patterns with the number of combinations each stands for.
    pub(super) patterns: Vec<(String, usize)>,
}

/// Systems and holes. The grid of the space must be walkable; in no system are the cells that are
/// `wanted`.
pub(super) fn absences(
    base: &Base<'_>,
    space: &Space<'_>,
    listing: &Listing<'_>,
    wanted: &[bool],
) -> [Absence; 2] {
    let sizes = space.sizes();
    let mut cells = vec![Cell::Absent; sizes.iter().product()];
    for (combination, link) in &listing.found {
        if let Some(cell) = cells.get_mut(index(&sizes, combination)) {
            *cell = if link.target.is_some() {
                Cell::Target
            } else {
                Cell::Null
            };
        }
    }
    for combination in &listing.claimed {
        if let Some(cell) = cells
            .get_mut(index(&sizes, combination))
            .filter(|cell| **cell == Cell::Absent)
        {
            *cell = Cell::Target;
        }
    }
    let neutral: Vec<Vec<bool>> = space
        .axes
        .iter()
        .map(|axis| neutral_values(base, axis))
        .collect();
    let system = systematic(&sizes, &cells, &neutral, wanted);
    let holes: Vec<bool> = cells
        .iter()
        .zip(&system)
        .map(|(cell, system)| *cell == Cell::Absent && !system)
        .collect();
    [
        absence(space, &sizes, &system),
        absence(space, &sizes, &holes),
    ]
}

fn absence(space: &Space<'_>, sizes: &[usize], member: &[bool]) -> Absence {
    let count = member.iter().filter(|member| **member).count();
    let patterns = if count == 0 {
        Vec::new()
    } else {
        cover(sizes, member)
    };
    let names = if count > NAMED {
        Vec::new()
    } else {
        names(space, sizes, member)
    };
    Absence {
        count,
        names,
        patterns: patterns
            .iter()
            .map(|pattern| (text(space, pattern), pattern.count(sizes)))
            .collect(),
    }
}

fn names(space: &Space<'_>, sizes: &[usize], member: &[bool]) -> Vec<String> {
    let absent = member.iter().enumerate().filter(|(_, member)| **member);
    absent
        .map(|(at, _)| space.name(&digits(sizes, at)))
        .collect()
}

/// `*` for any value, `a|b` for a choice.
fn text(space: &Space<'_>, pattern: &Pattern) -> String {
    let part = |(axis, values): (&&Component, &Vec<usize>)| match values.as_slice() {
        [] => "*".to_owned(),
        values => values
            .iter()
            .filter_map(|v| axis.values.get(*v))
            .map(String::as_str)
            .collect::<Vec<_>>()
            .join("|"),
    };
    space
        .axes
        .iter()
        .zip(&pattern.values)
        .map(part)
        .collect::<Vec<_>>()
        .join("-")
}

/// Values that stand for "no change": called `none` or `neutral`, or at the default position of
/// their slider.
fn neutral_values(base: &Base<'_>, component: &Component) -> Vec<bool> {
    let slider = component
        .pattern
        .as_deref()
        .and_then(|pattern| base.slider(pattern));
    // A slider without `default` is reset to 0.
    let default = slider.map(|bound| bound.slider.default.unwrap_or(0.0));
    let at_default = |at: usize| {
        let step = component.steps.as_ref().and_then(|steps| steps.get(at));
        step.zip(default)
            .is_some_and(|(step, default)| (step - default).abs() < 1e-9)
    };
    let called = |value: &String| matches!(value.as_str(), "none" | "neutral");
    component
        .values
        .iter()
        .enumerate()
        .map(|(at, value)| called(value) || at_default(at))
        .collect()
}
