//! What the parser of targets counts on its way; the rules read nothing else.

use serde::Serialize;

use crate::diag::Tally;

/// Facts on one target, counted while parsing.
#[derive(Debug, Clone, Default, PartialEq, Serialize)]
pub struct TargetFacts {
    /// Data rows (four fields), readable or not.
    pub rows: usize,
    /// Rows with a field that is no number: line and column of the field, and the field.
    pub unreadable: Vec<UnreadableField>,
    /// How many rows have such a field.
    pub unreadable_rows: u64,
    /// Lines that are neither comment nor four fields (line, number of fields).
    pub field_count: Tally,
    /// Negative indices.
    pub negative: Tally,
    /// Indices at or beyond the vertex count of the mesh, seam duplicates included.
    pub out_of_range: Tally,
    /// Indices beyond 32 bits, which the application cannot hold; also counted as out of range where the
    /// mesh is known.
    pub overflow: Tally,
    /// Indices that name a seam duplicate: accepted and without effect.
    pub seam: Tally,
    /// Indices that occurred before in the file.
    pub duplicate: Tally,
    /// Rows with NaN or infinity.
    pub non_finite: Tally,
    /// Rows that move nothing.
    pub zero: Tally,
    /// Rows that move something.
    pub moving: usize,
    /// Largest displacement: length in decimetres, line, index.
    pub largest: Option<Largest>,
    /// Median length of the displacements that move something, in decimetres.
    pub median_length: f32,
    /// Length that all but the longest two percent (at least one row) stay below or reach, in decimetres.
    pub tail_length: f32,
    /// Largest index.
    pub max_index: Option<i64>,
    /// Base mesh that the header names (`# basemesh NAME`), with its line.
    pub basemesh: Option<(u32, String)>,
    /// Hash over the decoded rows: equal displacement, equal hash.
    pub content: u64,
}

/// A field that is no number.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct UnreadableField {
    /// Line from 1.
    pub line: u32,
    /// First byte of the field in the file.
    pub start: usize,
    /// The field as written.
    pub field: String,
}

/// The largest displacement of a target.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Largest {
    /// Length in decimetres.
    pub length: f32,
    /// Line from 1.
    pub line: u32,
    /// Vertex.
    pub index: i64,
}

/// How many times the median of its target a displacement may be, where nobody sets another number.
pub const OUTLIER_RATIO: f32 = 20.0;
/// Share of the mesh's size below which nothing is oversized: no detail of a face is torn by less.
const SMALLEST_SHARE: f32 = 0.05;
/// How many times the length that all but the longest rows keep an outlier must have. In the shipped
/// targets the longest row is at most twice as long.
const ISOLATION: f32 = 4.0;

/// What a displacement is out of proportion to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Oversize {
    /// The whole base mesh.
    Mesh,
    /// The rest of its target, and a considerable part of the mesh.
    Target,
}

impl TargetFacts {
    /// Whether the largest displacement is out of all proportion to a mesh of `size` (longest side, decimetres).
    pub fn oversize(&self, size: f32, ratio: f32) -> Option<Oversize> {
        let length = self.largest?.length;
        if length > size {
            return Some(Oversize::Mesh);
        }
        let is_outlier = length > ratio * self.median_length
            && length > ISOLATION * self.tail_length
            && length > SMALLEST_SHARE * size;
        is_outlier.then_some(Oversize::Target)
    }
}

/// The longest side of the box around a mesh, in decimetres.
pub fn extent(positions: &[[f32; 3]]) -> Option<f32> {
    let range = |axis: fn(&[f32; 3]) -> f32| {
        let values = positions.iter().map(axis).filter(|value| value.is_finite());
        let (low, high) = values.fold((f32::MAX, f32::MIN), |(low, high), value| (low.min(value), high.max(value)));
        high - low
    };
    let size = range(|[x, _, _]| *x).max(range(|[_, y, _]| *y)).max(range(|[_, _, z]| *z));
    (size > 0.0 && size.is_finite()).then_some(size)
}
