//! The rows of what is worn as archives have them: a column of vertices, one of weights, one of
//! offsets (`docs/loaders/makehuman2/compiled-clothes.md#members`,
//! `docs/loaders/makehuman1/compiled-clothes.md#members-of-the-archive`).

use std::ops::Range;

use super::mhclo::{Reference, RowFacts};
use super::stored;
use super::target::MeshSize;
use crate::npy::table::{Cell, Table};

/// The columns; where each row has but one vertex there are no offsets.
pub(super) struct Columns {
    pub(super) vertices: Table,
    pub(super) weights: Table,
    pub(super) offsets: Option<Table>,
}

/// What a row of the vertices has to be, and one of the weights and the offsets.
pub(super) const fn cells(is_exact: bool) -> (&'static [Cell], &'static [Cell]) {
    if is_exact {
        (&[Cell::Integer], &[Cell::Number])
    } else {
        (&[Cell::Integer; 3], &[Cell::Number; 3])
    }
}

impl Columns {
    /// Counts all rows against a base mesh.
    pub(super) fn count(&self, size: Option<MeshSize>) -> RowFacts {
        let mut rows = RowFacts {
            mesh: size,
            ..RowFacts::default()
        };
        for row in 0..self.vertices.rows {
            rows.count(&self.reference(row), self.offsets.is_some());
        }
        rows
    }

    fn reference(&self, row: usize) -> Reference {
        let axes = [0, 1, 2];
        let of = |table: &Table, cell| table.number(row, cell).map_or(0.0, stored);
        let vertex = |cell| self.vertices.integer(row, cell).unwrap_or_default();
        match &self.offsets {
            None => {
                let weights = [of(&self.weights, 0), 0.0, 0.0];
                Reference {
                    vertices: [vertex(0); 3],
                    weights,
                    offset: [0.0; 3],
                    line: 0,
                }
            }
            Some(offsets) => {
                let weights = axes.map(|axis| of(&self.weights, axis));
                Reference {
                    vertices: axes.map(vertex),
                    weights,
                    offset: axes.map(|axis| of(offsets, axis)),
                    line: 0,
                }
            }
        }
    }
}

/// Runs of flags that are set: the vertices that an asset hides.
pub(super) fn runs(flags: &Table) -> Vec<Range<usize>> {
    let mut runs: Vec<Range<usize>> = Vec::new();
    for vertex in
        (0..flags.rows).filter(|row| flags.number(*row, 0).is_some_and(|flag| flag != 0.0))
    {
        match runs.last_mut().filter(|run| run.end == vertex) {
            Some(run) => run.end = vertex + 1,
            None => runs.push(vertex..vertex + 1),
        }
    }
    runs
}
