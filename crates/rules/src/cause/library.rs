//! What keeps the scan of a library of MakeHuman 1 from coming to its end
//! (`docs/loaders/makehuman1/libraries.md#why-a-library-is-empty`).

use mhlint_formats::mhclo::{Clothes, Entry, Section};

/// The line `uuid` without a value that the scan stops at. Below `verts` it does not look.
pub(crate) fn empty_uuid(clothes: &Clothes) -> Option<&Entry> {
    let is_bare =
        |entry: &&Entry| &*entry.keyword == "uuid" && entry.value.is_empty() && !entry.has_colon;
    let mut head = clothes
        .entries
        .iter()
        .filter(|entry| entry.section == Section::Header && !entry.is_comment);
    head.find(is_bare)
}

/// The skin that MakeHuman 1 starts with, and the eyes that it puts on by itself: that they are
/// missing is told of the program.
pub(crate) const FIRST_SKIN: &str = "skins/default.mhmat";
pub(crate) const FIRST_EYES: &str = "eyes/high-poly/high-poly.mhclo";
