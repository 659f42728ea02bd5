//! Whether a macro definition is sound enough to be compared with what it generates.
//!
//! A fault in a component or in `comp` is reported by the rule that knows it; the names of the combinations, which
//! are spelled with that component, must not speak a second time.

use super::component::{is_sound, is_sound_component};
use super::space::Space;
use crate::formats::macro_json::{Component, MacroFile, Macrodef};
use crate::repo::FileFacts;

/// What a definition generates, if neither `comp`, `targets` nor one of its components is faulty.
pub(super) fn judged_space<'a>(file: &FileFacts, macros: &'a MacroFile, macrodef: &Macrodef) -> Option<Space<'a>> {
    let own = format!("/macrodef/{}", macrodef.index);
    let faulty = |fault: &str| fault == own || fault == format!("{own}/targets");
    let is_whole = is_sound(file, &format!("{own}/comp")) && !file.schema.faults.iter().any(|f| faulty(&f.pointer));
    let space = Space::of(macros, macrodef).filter(|_| is_whole)?;
    space.axes.iter().all(|axis| is_sound_component(file, axis) && is_even(axis)).then_some(space)
}

/// The same, if most of the names are spelled with the components; else `comp` holds other ones than were meant.
pub(super) fn clear_space<'a>(file: &FileFacts, macros: &'a MacroFile, macrodef: &Macrodef) -> Option<Space<'a>> {
    let space = judged_space(file, macros, macrodef)?;
    let spelled = macrodef.links.iter().filter(|link| space.parse(&link.name).is_some()).count();
    (spelled * 2 >= macrodef.links.len()).then_some(space)
}

/// Whether every value has a step or a corner of its own: `macro-steps-length`, `macro-sum-arity`.
pub(super) fn is_even(component: &Component) -> bool {
    let places = match (&component.steps, &component.sum) {
        (Some(steps), _) => Some(steps.len()),
        (None, sum) => sum.as_ref().map(Vec::len),
    };
    places.is_none_or(|places| places == component.values.len())
}

/// Whether a step is `NaN` or infinite and `json-syntax` says so.
pub(super) fn has_special_step(file: &FileFacts, component: &Component) -> bool {
    !file.json.specials.is_empty() && component.steps.iter().flatten().any(|step| !step.is_finite())
}
