//! Which lines of an asset stand in another section than they are meant for.

use super::Text;
use mhlint_diag::Application::Makehuman1;
use mhlint_formats::mhclo::{Entry, FaultKind, Section, makehuman1};

/// The first line from which on rows are meant as something else; beyond the end if there is none.
pub(super) fn misplaced_from(text: &Text<'_, '_>) -> u32 {
    let misspelt = misspelt_list(text).map(|entry| entry.line);
    let dash = text
        .reading
        .faults(|kind| kind == FaultKind::RowWord)
        .and_then(|(faults, _)| {
            faults
                .iter()
                .find(|fault| &*fault.word == "-")
                .map(|fault| fault.line)
        });
    misspelt.into_iter().chain(dash).min().unwrap_or(u32::MAX)
}

/// Whether the rows are lost as a whole.
pub(super) fn has_no_rows(text: &Text<'_, '_>) -> bool {
    !text.reading.opens_rows()
}

/// How many lines of numbers stand above `verts`, where nothing reads them.
pub(super) fn rows_above(text: &Text<'_, '_>) -> u64 {
    let above = text
        .reading
        .faults(|kind| kind == FaultKind::NumbersInHeader);
    above
        .filter(|_| text.reading.opens_rows())
        .map_or(0, |(_, count)| count)
}

/// A line that is meant to open the list of vertices to hide, and is a row that is none.
pub(super) fn misspelt_list<'v>(text: &Text<'_, 'v>) -> Option<&'v Entry> {
    text.misspelt("delete_verts")
        .filter(|entry| is_among_rows(text, entry))
}

/// Whether a line of a word that is no keyword is taken for a row. One with a colon opens a section
/// only where that is known.
pub(super) fn is_among_rows(text: &Text<'_, '_>, entry: &Entry) -> bool {
    if text.application != Makehuman1 {
        return entry.section == Section::Vertices;
    }
    entry.section != Section::Header
        && text
            .clothes
            .all("verts")
            .any(|verts| verts.line < entry.line && !verts.has_colon)
}

/// The first line in the list that begins with a letter.
pub(super) fn keyword_below_list<'v>(text: &Text<'_, 'v>) -> Option<&'v Entry> {
    // MakeHuman 1 knows its keywords wherever they stand.
    let is_read =
        |entry: &Entry| text.application == Makehuman1 && makehuman1::knows(&entry.keyword);
    let in_list = |entry: &&Entry| {
        entry.section == Section::Deleted && &*entry.keyword != "delete_verts" && !is_read(entry)
    };
    let mut entries = text
        .clothes
        .entries
        .iter()
        .filter(|entry| !entry.is_comment);
    entries.find(|entry| in_list(entry) && entry.keyword.starts_with(char::is_alphabetic))
}
