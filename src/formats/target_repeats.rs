//! Vertices that a target names on several rows, of which the application applies the last (formats/makehuman2.md §6.1).

use super::target::Row;

/// What repeats come to.
#[derive(Debug, Default)]
pub(super) struct Repeats {
    /// Vertices with several rows of which one moves something, in order. Repeats of zeros are no more than zeros.
    pub(super) vertices: Vec<i64>,
    /// Positions of all rows of these vertices but the first, in order.
    pub(super) rows: Vec<usize>,
    /// How many rows that move something are replaced by a later one.
    pub(super) replaced: usize,
}

/// Shipped targets are sorted, which needs no table.
pub(super) fn repeats(rows: &[Row]) -> Repeats {
    let mut repeats = Repeats::default();
    if rows.is_sorted_by(|a, b| a.index < b.index) {
        return repeats;
    }
    let mut places: Vec<(u32, usize)> = rows.iter().enumerate().map(|(at, row)| (row.index, at)).collect();
    places.sort_unstable();
    let delta = |at: usize| rows.get(at).map_or([0.0; 3], |row| row.delta);
    let is_zero = |at: usize| delta(at).iter().all(|part| *part == 0.0);
    let moves = |at: usize| !is_zero(at) && delta(at).iter().all(|part| part.is_finite());
    for of_vertex in places.chunk_by(|a, b| a.0 == b.0) {
        let [(index, _), again @ ..] = of_vertex else { continue };
        if again.is_empty() || of_vertex.iter().all(|(_, at)| is_zero(*at)) {
            continue;
        }
        repeats.vertices.push(i64::from(*index));
        repeats.rows.extend(again.iter().map(|(_, at)| *at));
        repeats.replaced += of_vertex.iter().take(again.len()).filter(|(_, at)| moves(*at)).count();
    }
    repeats.rows.sort_unstable();
    repeats
}
