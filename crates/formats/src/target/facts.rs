//! What the parser of targets counts on its way; the rules read nothing else.

pub use crate::target::blanks::BlankFacts;
use mhlint_diag::{Few, Tally};

/// How many times as long as all but the longest two percent a row is whose like are kept.
const STANDS_OUT: f32 = 2.0;
/// How many times as long as half of the rows the longest one is where any is kept.
const FAR: f32 = 4.0;
/// So many of the others are kept.
const FEW_LONGEST: usize = 8;

/// Facts on one target, counted while parsing.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct TargetFacts {
    /// Data rows (four fields), readable or not.
    pub rows: usize,
    /// Rows with a field that is no number: line and column of the field, and the field.
    pub unreadable: Vec<UnreadableField>,
    /// How many rows have such a field.
    pub unreadable_rows: u64,
    /// What these rows are known by.
    pub unreadable_names: Few<String>,
    /// Lines that are neither comment nor four fields (line, number of fields).
    pub field_count: Tally,
    /// What these lines are known by.
    pub field_count_names: Few<String>,
    /// How many of these lines begin with an integer, as a row does.
    pub broken_rows: u64,
    /// Line and text of the first marker of a merge conflict, `<<<<<<<` or `>>>>>>>`.
    pub conflict: Option<(u32, String)>,
    /// Negative indices.
    pub negative: Tally,
    /// Indices at or beyond the vertex count of the mesh, seam duplicates included.
    pub out_of_range: Tally,
    /// Indices beyond 32 bits, which the application cannot hold; also counted as out of range
    /// where the mesh is known.
    pub overflow: Tally,
    /// Indices that name a seam duplicate: accepted and without effect.
    pub seam: Tally,
    /// Indices that occurred before in the file, of vertices that a row moves.
    pub duplicate: Tally,
    /// Whether all of these are the row of before, number by number: nothing is lost.
    pub repeats_are_equal: bool,
    /// Rows with NaN or infinity.
    pub non_finite: Tally,
    /// Rows that move nothing, of vertices that no row moves: a zero beside another row of its
    /// vertex undoes that or is replaced by it.
    pub zero: Tally,
    /// Rows that move something and are not replaced by a later row of their vertex.
    pub moving: usize,
    /// Largest displacement of a vertex that exists: length in decimetres, line, index.
    pub largest: Option<Largest>,
    /// Median length of the displacements that move something, in decimetres.
    pub median_length: f32,
    /// Length that all but the longest two percent (at least one row) stay below or reach, in
    /// decimetres.
    pub tail_length: f32,
    /// Rows that are longer than that and the next one, where these are far from the others. Where
    /// the longest one is at least `STANDS_OUT` times as long these are all, which shows whether it
    /// leaves its neighbours in the mesh.
    pub longest: Vec<(u32, [f32; 3])>,
    /// Largest index.
    pub max_index: Option<i64>,
    /// Base mesh that the header names (`# basemesh NAME`), with its line.
    pub basemesh: Option<(u32, String)>,
    /// What a loader makes of the text that splits at single blanks; nothing where that is what all
    /// others make of it.
    pub blanks: Option<Box<BlankFacts>>,
    /// Hash over the decoded rows: equal rows, equal hash.
    pub content: u64,
    /// Hash over the rows as `targets.npz` holds them: thousandths of a decimetre in 16 bits, and
    /// the vertex in 16 bits.
    pub thousandths: u64,
    /// The first row with a part that does not fit into these: line, vertex, part in decimetres.
    pub beyond_sixteen_bits: Option<(u32, i64, f32)>,
    /// Hash over what comes of the rows: without those that move nothing or are replaced.
    pub displacement: u64,
}

impl TargetFacts {
    /// Keeps the longest rows where they are far from the others: all of them where they stand out,
    /// else a few.
    pub(super) fn keep_longest(&mut self, rows: &[(u32, [f32; 3])]) {
        let Some(largest) = self
            .largest
            .filter(|largest| largest.length > FAR * self.median_length)
        else {
            return;
        };
        let stands_out = largest.length >= STANDS_OUT * self.tail_length;
        let lengths = || rows.iter().map(|row| (row, length_of(row.1)));
        let longer = lengths().filter(|(_, length)| *length > self.tail_length);
        let next = lengths()
            .filter(|(_, length)| length.total_cmp(&self.tail_length).is_eq())
            .take(1);
        let most = if stands_out { usize::MAX } else { FEW_LONGEST };
        self.longest = longer.take(most).chain(next).map(|(row, _)| *row).collect();
    }

    /// Whether there are rows and the vertices stay where they are all the same.
    pub fn moves_nothing(&self) -> bool {
        self.rows > 0 && self.moving == 0 && self.unreadable_rows == 0 && self.non_finite.count == 0
    }
}

/// How far a displacement goes, in its unit. The square of a finite one can overflow or vanish;
/// such a row still moves.
pub(super) fn length_of(delta: [f32; 3]) -> f32 {
    let square = delta.iter().map(|part| part * part).sum::<f32>();
    if square.is_finite() && square > 0.0 {
        square.sqrt()
    } else {
        delta
            .iter()
            .fold(0.0_f32, |most, part| most.max(part.abs()))
    }
}

/// A field that is no number.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct UnreadableField {
    /// Line from 1.
    pub line: u32,
    /// First byte of the field in the file.
    pub start: usize,
    /// The field as written.
    pub field: String,
}

/// The largest displacement of a target.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Largest {
    /// Length in decimetres.
    pub length: f32,
    /// Line from 1.
    pub line: u32,
    /// Vertex.
    pub index: i64,
}
