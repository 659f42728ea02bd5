//! Vertices that a target names on several rows, of which the application applies the last
//! (`docs/loaders/makehuman2/targets.md#rows`).

use crate::target::Row;
use crate::target::content_hash::ContentHash;

/// What repeats come to.
#[derive(Debug, Default)]
pub(super) struct Repeats {
    /// Vertices with several rows of which one moves something, in order. Repeats of zeros are no
    /// more than zeros.
    pub(super) vertices: Vec<i64>,
    /// Positions of all rows of these vertices but the first, in order.
    pub(super) rows: Vec<usize>,
    /// Positions of the rows of these vertices that a later one replaces, in order.
    pub(super) replaced: Vec<usize>,
    /// Whether one of these is unlike the one that replaces it.
    pub(super) differ: bool,
}

impl Repeats {
    /// Hash over what comes of the rows, be it written with zeros and repeats or without.
    pub(super) fn displacement(&self, rows: &[Row]) -> u64 {
        let counts = |at: &usize, row: &Row| moves(row) && self.replaced.binary_search(at).is_err();
        ContentHash::of(
            rows.iter()
                .enumerate()
                .filter(|(at, row)| counts(at, row))
                .map(|(_, row)| row),
        )
    }
}

/// Whether a row has a number other than 0.
pub(super) fn moves(row: &Row) -> bool {
    row.1.iter().any(|part| *part != 0.0)
}

/// Shipped targets are sorted, which needs no table.
pub(super) fn repeats(rows: &[Row]) -> Repeats {
    let mut repeats = Repeats::default();
    if rows.is_sorted_by(|a, b| a.0 < b.0) {
        return repeats;
    }
    let mut places: Vec<(u32, usize)> = rows
        .iter()
        .enumerate()
        .map(|(at, row)| (row.0, at))
        .collect();
    places.sort_unstable();
    for of_vertex in places.chunk_by(|a, b| a.0 == b.0) {
        let [(index, _), again @ ..] = of_vertex else {
            continue;
        };
        if again.is_empty()
            || !of_vertex
                .iter()
                .any(|(_, at)| rows.get(*at).is_some_and(moves))
        {
            continue;
        }
        let values = |(_, at): &(u32, usize)| rows.get(*at).map(|row| row.1);
        repeats.differ |= of_vertex
            .iter()
            .any(|row| values(row) != of_vertex.last().and_then(values));
        repeats.vertices.push(i64::from(*index));
        repeats.rows.extend(again.iter().map(|(_, at)| *at));
        repeats
            .replaced
            .extend(of_vertex.iter().take(again.len()).map(|(_, at)| *at));
    }
    repeats.rows.sort_unstable();
    repeats.replaced.sort_unstable();
    repeats
}
