//! What MPFB makes of the lines of an asset (`docs/loaders/mpfb/clothes.md#lines`).

pub(super) mod companion;
pub(super) mod list;
pub(super) mod names;
pub(super) mod rows;
pub(super) mod scale;
pub(super) mod weights;

use super::{Text, texts};
use mhlint_diag::Place;
use mhlint_formats::mhclo::{Flow, Gap, Part};
use mhlint_repo::Body;

/// The assets whose lines are read to the end.
fn whole<'b, 'v>(body: &'b Body<'v>) -> impl Iterator<Item = Text<'b, 'v>> {
    texts(body).filter(|text| text.clothes.flow.stop.is_none())
}

/// Those of which every row is taken: vertices are counted as they are meant.
fn counted<'b, 'v>(body: &'b Body<'v>) -> impl Iterator<Item = Text<'b, 'v>> {
    whole(body).filter(|text| {
        let flow = &text.clothes.flow;
        flow.rows == text.clothes.rows.count && lost_rows(flow).is_none()
    })
}

/// Where rows are lost.
fn lost_rows(flow: &Flow) -> Option<&Gap> {
    flow.gaps
        .iter()
        .find(|gap| gap.ended == Some(Part::Rows) && gap.lines > 0 && !is_list(&gap.word))
}

/// Whether a word opens the list of vertices to hide, or is meant to.
fn is_list(word: &str) -> bool {
    let word = word.strip_suffix(':').unwrap_or(word).to_lowercase();
    word.starts_with("delete_v") || mhlint_diag::nearest(&word, ["delete_verts"]).is_some()
}

/// Whether a word begins like a row, and is no plain number.
fn is_number(word: &str) -> bool {
    word.trim_start_matches(['+', '-', '.'])
        .starts_with(|first: char| first.is_ascii_digit())
}

fn at(line: u32) -> Place {
    Place::Line(line)
}
