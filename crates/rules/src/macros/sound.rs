//! Whether a macro definition is sound enough to be compared with what it generates.
//!
//! A fault in a component or in `comp` is reported by the rule that knows it; the names of the
//! combinations, which are spelled with that component, must not speak a second time.

use super::super::cause::component::{is_even, is_sound_component};
use super::super::cause::schema::is_sound;
use super::space::Space;
use mhlint_formats::macro_json::{MacroFile, Macrodef};
use mhlint_repo::FileFacts;

/// What a definition generates, if neither `comp`, `targets` nor one of its components is faulty.
pub(super) fn sound_space<'a>(
    file: &FileFacts,
    macros: &'a MacroFile,
    macrodef: &Macrodef,
) -> Option<Space<'a>> {
    let own = format!("/macrodef/{}", macrodef.index);
    let is_faulty = |pointer: &str| file.schema.at(pointer).next().is_some();
    let is_whole = is_sound(file, &format!("{own}/comp"))
        && !is_faulty(&own)
        && !is_faulty(&format!("{own}/targets"));
    let space = Space::of(macros, macrodef).filter(|_| is_whole)?;
    space
        .axes
        .iter()
        .all(|axis| is_sound_component(file, axis) && is_even(axis))
        .then_some(space)
}

/// The same, if most of the names are spelled with the components; else `comp` holds other ones
/// than were meant.
pub(super) fn clear_space<'a>(
    file: &FileFacts,
    macros: &'a MacroFile,
    macrodef: &Macrodef,
) -> Option<Space<'a>> {
    let space = sound_space(file, macros, macrodef)?;
    let spelled = macrodef
        .links
        .iter()
        .filter(|link| space.parse(&link.name).is_some())
        .count();
    (spelled * 2 >= macrodef.links.len()).then_some(space)
}
