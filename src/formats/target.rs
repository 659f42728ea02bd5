//! `.target`: rows of a vertex index and its displacement.
//!
//! MakeHuman 2 strips a line, ignores it if it begins with `#`, splits at white space and takes it as
//! data if there are exactly four fields; everything else is dropped silently. Numbers go through
//! `int()` and `float()`; a failure there stops the program at start (formats/makehuman2.md §6.1).

use serde::Serialize;
use xxhash_rust::xxh3::Xxh3;

use super::fields::fields;
use super::{python_float, python_int};
use crate::diag::Tally;

/// A parsed target.
#[derive(Debug, Clone, Default)]
pub struct Target {
    /// Rows in the order of the file, only those whose numbers could be read.
    pub rows: Vec<Row>,
    /// What was counted on the way.
    pub facts: TargetFacts,
}

/// One displacement. The index is kept as written; deltas are float32, in decimetres.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Row {
    /// Vertex index, saturated to 32 bits (the facts know the truth).
    pub index: u32,
    /// Displacement along x, y, z.
    pub delta: [f32; 3],
}

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

/// Size of the mesh a target is for, where it is known.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct MeshSize {
    /// Vertices of the OBJ.
    pub vertices: usize,
    /// The same with the duplicates that loading adds along texture seams.
    pub with_seams: usize,
}

/// How many unreadable fields are kept.
const UNREADABLE_KEPT: usize = 5;

/// Parses a target. `mesh` is the size of the mesh it is for.
pub fn parse(text: &[u8], mesh: Option<MeshSize>) -> Target {
    let mut parser = Parser { target: Target::default(), mesh, lengths: Vec::new() };
    parser.target.rows.reserve(text.len() / 20);
    let mut line = 1;
    let mut start = 0;
    while start < text.len() {
        let rest = text.get(start..).unwrap_or_default();
        let (row, length) = fast_row(rest);
        if let Some(row) = row {
            parser.row(line, i64::from(row.index), row.delta);
            start += length;
        } else {
            start += parser.slow_line(line, rest, start);
        }
        line += 1;
    }
    parser.finish()
}

struct Parser {
    target: Target,
    mesh: Option<MeshSize>,
    lengths: Vec<f32>,
}

impl Parser {
    /// Any line the fast path does not know. Returns the bytes consumed, line end included.
    fn slow_line(&mut self, line: u32, rest: &[u8], offset: usize) -> usize {
        let end = rest.iter().position(|byte| matches!(byte, b'\n' | b'\r')).unwrap_or(rest.len());
        let text = rest.get(..end).unwrap_or_default();
        let fields = fields(text);
        match fields.as_slice() {
            [] => {}
            [(_, first), ..] if first.starts_with(b"#") => self.comment(line, text),
            [index, x, y, z] => self.data(line, offset, [*index, *x, *y, *z]),
            other => {
                let count = i64::try_from(other.len()).unwrap_or(i64::MAX);
                self.target.facts.field_count.add(line, count);
            }
        }
        let crlf = rest.get(end..end + 2) == Some(b"\r\n");
        end + if crlf { 2 } else { 1 }
    }

    fn comment(&mut self, line: u32, text: &[u8]) {
        if self.target.facts.basemesh.is_some() {
            return;
        }
        let text = String::from_utf8_lossy(text);
        let mut words = text.trim().trim_start_matches('#').split_whitespace();
        if words.next() == Some("basemesh")
            && let Some(name) = words.next()
        {
            self.target.facts.basemesh = Some((line, name.to_owned()));
        }
    }

    fn data(&mut self, line: u32, offset: usize, fields: [(usize, &[u8]); 4]) {
        let [(_, index), x, y, z] = fields;
        let parsed = python_int(index).ok_or(0);
        let floats = [x, y, z].map(|(_, token)| python_float(token));
        match (parsed, floats) {
            #[expect(clippy::cast_possible_truncation, reason = "stored as float32, as the application does")]
            (Ok(index), [Some(x), Some(y), Some(z)]) => self.row(line, index, [x as f32, y as f32, z as f32]),
            (parsed, floats) => {
                let bad = if parsed.is_err() {
                    fields.first()
                } else {
                    let at = floats.iter().position(Option::is_none).unwrap_or(0);
                    fields.get(at + 1)
                };
                self.unreadable(line, offset, bad);
            }
        }
    }

    fn unreadable(&mut self, line: u32, offset: usize, field: Option<&(usize, &[u8])>) {
        let facts = &mut self.target.facts;
        facts.rows += 1;
        facts.unreadable_rows += 1;
        if let Some((start, token)) = field
            && facts.unreadable.len() < UNREADABLE_KEPT
        {
            facts.unreadable.push(UnreadableField {
                line,
                start: offset + start,
                field: String::from_utf8_lossy(token).into_owned(),
            });
        }
    }

    fn row(&mut self, line: u32, index: i64, delta: [f32; 3]) {
        let facts = &mut self.target.facts;
        facts.rows += 1;
        if index < 0 {
            facts.negative.add(line, index);
        } else if let Some(mesh) = self.mesh {
            let at = u64::try_from(index).unwrap_or(u64::MAX);
            if at >= mesh.with_seams as u64 {
                facts.out_of_range.add(line, index);
            } else if at >= mesh.vertices as u64 {
                facts.seam.add(line, index);
            }
        }
        facts.max_index = facts.max_index.max(Some(index));
        let [x, y, z] = delta;
        let square = x * x + y * y + z * z;
        if square.is_finite() && square > 0.0 {
            facts.moving += 1;
            let length = square.sqrt();
            self.lengths.push(length);
            if facts.largest.is_none_or(|largest| length > largest.length) {
                facts.largest = Some(Largest { length, line, index });
            }
        } else if x == 0.0 && y == 0.0 && z == 0.0 {
            facts.zero.add(line, index);
        } else if !(x.is_finite() && y.is_finite() && z.is_finite()) {
            facts.non_finite.add(line, index);
        } else {
            // The square of a finite delta can overflow or vanish; such a row still moves.
            facts.moving += 1;
            let length = delta.iter().fold(0.0_f32, |most, part| most.max(part.abs()));
            if facts.largest.is_none_or(|largest| length > largest.length) {
                facts.largest = Some(Largest { length, line, index });
            }
        }
        self.target.rows.push(Row { index: u32::try_from(index.max(0)).unwrap_or(u32::MAX), delta });
    }

    fn finish(mut self) -> Target {
        self.count_duplicates();
        let facts = &mut self.target.facts;
        let middle = self.lengths.len() / 2;
        if middle < self.lengths.len() {
            facts.median_length = *self.lengths.select_nth_unstable_by(middle, f32::total_cmp).1;
        }
        let mut hash = Xxh3::new();
        for row in &self.target.rows {
            let [x, y, z] = row.delta.map(f32::to_le_bytes);
            for part in [row.index.to_le_bytes(), x, y, z] {
                hash.update(&part);
            }
        }
        facts.content = hash.digest();
        self.target
    }

    /// Shipped targets are sorted, which needs no table.
    fn count_duplicates(&mut self) {
        let rows = &self.target.rows;
        if rows.is_sorted_by(|a, b| a.index < b.index) {
            return;
        }
        let mut indices: Vec<u32> = rows.iter().map(|row| row.index).collect();
        indices.sort_unstable();
        let repeated: Vec<u32> = indices
            .windows(2)
            .filter_map(|pair| match pair {
                [a, b] if a == b => Some(*b),
                _ => None,
            })
            .collect();
        self.target.facts.duplicate.count = repeated.len() as u64;
        for index in repeated.into_iter().take(crate::diag::EXAMPLES) {
            self.target.facts.duplicate.first.push((0, i64::from(index)));
        }
    }
}

/// The plain row `INDEX X Y Z`, single blanks, at most nine digits a number: nearly every line of every
/// shipped target. Gives the row and the bytes consumed, or nothing for any other line.
fn fast_row(text: &[u8]) -> (Option<Row>, usize) {
    let mut at = 0;
    let mut index = 0_u32;
    while let Some(digit) = text.get(at).map(|byte| byte.wrapping_sub(b'0')).filter(|digit| *digit < 10) {
        index = index.wrapping_mul(10).wrapping_add(u32::from(digit));
        at += 1;
    }
    if at == 0 || at > 9 {
        return (None, 0);
    }
    let mut delta = [0.0; 3];
    for part in &mut delta {
        if text.get(at) != Some(&b' ') {
            return (None, 0);
        }
        let Some((value, length)) = fast_decimal(text.get(at + 1..).unwrap_or_default()) else {
            return (None, 0);
        };
        *part = value;
        at += 1 + length;
    }
    match (text.get(at), text.get(at + 1)) {
        (None, _) => (Some(Row { index, delta }), at),
        (Some(b'\r'), Some(b'\n')) => (Some(Row { index, delta }), at + 2),
        (Some(b'\n' | b'\r'), _) => (Some(Row { index, delta }), at + 1),
        _ => (None, 0),
    }
}

const POWERS: [f64; 10] = [1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9];

/// A decimal of at most nine digits. Mantissa and power of ten are exact in f64, so the quotient is the
/// correctly rounded value, as in Python.
fn fast_decimal(text: &[u8]) -> Option<(f32, usize)> {
    let negative = text.first() == Some(&b'-');
    let mut at = usize::from(negative);
    let mut mantissa = 0_u32;
    let mut digits = 0_usize;
    let mut point = None;
    loop {
        match text.get(at) {
            Some(byte @ b'0'..=b'9') => {
                mantissa = mantissa.wrapping_mul(10).wrapping_add(u32::from(byte - b'0'));
                digits += 1;
            }
            Some(b'.') if point.is_none() => point = Some(digits),
            _ => break,
        }
        at += 1;
    }
    if digits == 0 || digits > 9 {
        return None;
    }
    let value = f64::from(mantissa) / POWERS.get(digits - point.unwrap_or(digits))?;
    #[expect(clippy::cast_possible_truncation, reason = "stored as float32, as the application does")]
    Some((if negative { -value } else { value } as f32, at))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn facts(text: &str) -> TargetFacts {
        let mesh = MeshSize { vertices: 10, with_seams: 12 };
        parse(text.as_bytes(), Some(mesh)).facts
    }

    #[test]
    fn rows_are_read_with_any_line_end() {
        let target = parse(b"# basemesh hm08\n0 .119 -10.205 -.775\r\n1 1 2 3\r2 0 0 0", None);
        let rows: Vec<_> = target.rows.iter().map(|row| (row.index, row.delta)).collect();
        assert_eq!(rows, [(0, [0.119, -10.205, -0.775]), (1, [1.0, 2.0, 3.0]), (2, [0.0, 0.0, 0.0])]);
        assert_eq!(target.facts.basemesh, Some((1, "hm08".to_owned())));
        assert_eq!((target.facts.zero.first_line(), target.facts.moving), (Some(4), 2));
    }

    #[test]
    fn fast_and_slow_path_agree() {
        for number in ["0", "-0.001", ".5", "12.25", "123456789", "0.12345678", "-7."] {
            let fast = parse(format!("3 {number} 1 2\n").as_bytes(), None);
            let slow = parse(format!("3  {number} 1 2\n").as_bytes(), None);
            assert_eq!(fast.rows, slow.rows, "{number}");
        }
    }

    #[test]
    fn only_four_fields_are_data() {
        let facts = facts("12 .1 .2 .3 # note\n1 2 3\n\n  # c\n1 1 1 1\n");
        assert_eq!((facts.rows, facts.field_count.count), (1, 2));
        assert_eq!(facts.field_count.first, [(1, 6), (2, 3)]);
    }

    #[test]
    fn bad_fields_know_their_place() {
        let facts = facts("0 0 0 1\n1.0 0 0 1\n2 0 1,5 0\n");
        let bad: Vec<_> = facts.unreadable.iter().map(|f| (f.line, f.start, f.field.as_str())).collect();
        assert_eq!(bad, [(2, 8, "1.0"), (3, 22, "1,5")]);
    }

    #[test]
    fn indices_are_sorted_into_their_faults() {
        let facts = facts("-1 0 0 1\n9 0 0 1\n10 0 0 1\n12 0 0 1\n9 0 0 2\n99999999999999999999 0 0 1\n");
        let counts = [&facts.negative, &facts.seam, &facts.out_of_range, &facts.duplicate].map(|t| t.count);
        assert_eq!(counts, [1, 1, 2, 1]);
    }

    #[test]
    fn non_finite_rows_are_counted() {
        let facts = facts("0 nan 0 0\n1 0 inf 0\n2 0 0 1e400\n3 1e30 0 0\n");
        assert_eq!((facts.non_finite.count, facts.moving), (3, 1));
    }
}
