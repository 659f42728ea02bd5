//! `.target`: rows of a vertex index and its displacement.
//!
//! MakeHuman 2 strips a line, ignores it if it begins with `#`, splits at white space and takes it
//! as data if there are exactly four fields; everything else is dropped silently. Numbers go
//! through `int()` and `float()`; a failure there stops the program at start
//! (`docs/loaders/makehuman2/targets.md#rows`).

mod blanks;
pub(crate) mod content_hash;
pub mod edit;
mod facts;
pub mod name;
pub(crate) mod print;
mod repeats;
mod row;

use crate::faulty_rows::row_name;
use crate::fields::fields;
use crate::inline_ignore::{self, InlineIgnore};
pub use crate::target::blanks::rows as rows_at_blanks;
use crate::target::content_hash::ContentHash;
use crate::target::facts::length_of;
pub use crate::target::facts::{BlankFacts, Largest, TargetFacts, UnreadableField};
use crate::target::print::PackedPrint;
use crate::target::repeats::{moves, repeats};
use crate::target::row::fast_row;
use crate::{python_float, python_int, stored};
use mhlint_source::{Encoding, first_line, lines};

/// A parsed target.
#[derive(Debug, Clone, Default)]
pub struct Target {
    /// Rows in the order of the file, only those whose numbers could be read and whose index fits.
    pub rows: Vec<Row>,
    /// What was counted on the way.
    pub facts: TargetFacts,
    /// Ignores in comments.
    pub ignores: Vec<InlineIgnore>,
}

/// One displacement as evaluation takes it: the vertex as written, in 32 bits as the application
/// holds it, and how it moves along x, y, z, in decimetres.
pub type Row = (u32, [f32; 3]);

/// Size of the mesh a target is for, where it is known.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub struct MeshSize {
    /// Vertices of the OBJ.
    pub vertices: usize,
    /// The same with the duplicates that loading adds along texture seams.
    pub with_seams: usize,
}

/// How many unreadable fields are kept.
const UNREADABLE_KEPT: usize = 5;
/// Of this many rows the longest one is left out of [`TargetFacts::tail_length`].
const ROWS_PER_OUTLIER: usize = 50;

/// What tells a target from other files of its name: its header, or a row.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Recognised {
    /// The base mesh that it says it is for.
    pub basemesh: Option<String>,
}

/// Whether a file called `.target` is one: it says which base mesh it is for, or has a row. Systemd
/// has others.
pub fn recognise(text: &[u8]) -> Option<Recognised> {
    let mut has_row = false;
    for (_, line) in lines(text) {
        let fields = fields(line);
        match fields.as_slice() {
            [(_, first), ..] if first.starts_with(b"#") => {
                if let Some(basemesh) = basemesh_of(line) {
                    return Some(Recognised {
                        basemesh: Some(basemesh),
                    });
                }
            }
            [(_, index), (_, x), (_, y), (_, z)] => {
                has_row = python_int(index).is_some()
                    && [x, y, z].iter().all(|word| python_float(word).is_some());
            }
            _ => {}
        }
        if has_row {
            break;
        }
    }
    has_row.then_some(Recognised { basemesh: None })
}

/// Whether lines of a text that cannot be recognised begin as rows do.
pub fn has_broken_rows(text: &[u8]) -> bool {
    lines(text).any(|(_, line)| {
        let fields = fields(line);
        fields.len() > 1 && begins_a_row(&fields)
    })
}

/// Whether a line that is no row was to be one: prose begins with a word.
fn begins_a_row(fields: &[(usize, &[u8])]) -> bool {
    fields
        .first()
        .is_some_and(|(_, first)| python_float(first).is_some())
}

/// The name in a header `# basemesh NAME`.
fn basemesh_of(comment: &[u8]) -> Option<String> {
    let text = String::from_utf8_lossy(comment);
    let mut words = text.trim().trim_start_matches('#').split_whitespace();
    (words.next() == Some("basemesh"))
        .then(|| words.next().map(str::to_owned))
        .flatten()
}

/// Parses a target. `mesh` is the size of the mesh it is for.
pub fn parse(text: &[u8], mesh: Option<MeshSize>) -> Target {
    parse_by(fast_row, text, mesh)
}

/// Parses a file with its encoding. `None` if it is no UTF-8: the application decodes the whole
/// file before it uses a row, so nothing of it counts.
pub fn parse_file(bytes: &[u8], encoding: &Encoding, mesh: Option<MeshSize>) -> Option<Target> {
    if encoding.invalid_utf8_at.is_some() {
        return None;
    }
    if !encoding.byte_order_mark {
        return Some(parse(bytes, mesh));
    }
    // The mark is a fault of its own; blanks in its place keep it out of the first row and all
    // offsets right.
    let mut unmarked = bytes.to_vec();
    unmarked.iter_mut().take(3).for_each(|byte| *byte = b' ');
    Some(parse(&unmarked, mesh))
}

/// `fast` reads the lines it knows; tests take it away.
fn parse_by(
    fast: impl Fn(&[u8]) -> (Option<Row>, usize),
    text: &[u8],
    mesh: Option<MeshSize>,
) -> Target {
    let mut parser = Parser {
        target: Target::default(),
        mesh,
        lengths: Vec::new(),
        longest: 0.0,
        zeros: Vec::new(),
        line_offsets: Vec::new(),
    };
    parser.target.rows.reserve(text.len() / 20);
    let mut line = 1;
    let mut start = 0;
    while start < text.len() {
        let rest = text.get(start..).unwrap_or_default();
        let (row, length) = fast(rest);
        if let Some(row) = row {
            parser.row(line, i64::from(row.0), row.1);
            start += length;
        } else {
            start += parser.slow_line(line, rest, start);
        }
        line += 1;
    }
    parser.finish()
}

/// What begins and ends a merge conflict; what stands between may be a line under a heading.
pub const MARKERS: [&str; 2] = ["<<<<<<<", ">>>>>>>"];

struct Parser {
    target: Target,
    mesh: Option<MeshSize>,
    lengths: Vec<f32>,
    /// The longest of them, also of a vertex that does not exist.
    longest: f32,
    /// Line and index of the rows that move nothing.
    zeros: Vec<(u32, i64)>,
    /// Line minus position of the row, wherever it changes: position and difference.
    line_offsets: Vec<(usize, usize)>,
}

impl Parser {
    /// Any line the fast path does not know. Returns the bytes consumed, line end included.
    fn slow_line(&mut self, line: u32, rest: &[u8], offset: usize) -> usize {
        let (text, length) = first_line(rest);
        let fields = fields(text);
        let mut is_odd = blanks::is_odd(text);
        if let Some((_, first)) = fields.first() {
            self.marker(line, first);
        }
        match fields.as_slice() {
            [] => {}
            [(_, first), ..] if first.starts_with(b"#") => self.comment(line, text),
            [index, x, y, z] => is_odd |= !self.data(line, offset, [*index, *x, *y, *z]),
            other => {
                let count = i64::try_from(other.len()).unwrap_or(i64::MAX);
                is_odd = true;
                self.target.facts.field_count.add(line, count);
                self.target.facts.broken_rows += u64::from(begins_a_row(other));
                self.target.facts.field_count_names.add(|| row_name(other));
            }
        }
        // Lines that the fast path knows are read alike by all.
        if is_odd {
            self.target
                .facts
                .blanks
                .get_or_insert_default()
                .read(line, offset, text);
        }
        length
    }

    /// What git leaves around both sides of a conflict.
    fn marker(&mut self, line: u32, first: &[u8]) {
        let facts = &mut self.target.facts;
        if facts.conflict.is_none() && MARKERS.iter().any(|marker| marker.as_bytes() == first) {
            facts.conflict = Some((line, String::from_utf8_lossy(first).into_owned()));
        }
    }

    fn comment(&mut self, line: u32, text: &[u8]) {
        inline_ignore::note(line, text, &mut self.target.ignores);
        if self.target.facts.basemesh.is_some() {
            return;
        }
        if let Some(name) = basemesh_of(text) {
            self.target.facts.basemesh = Some((line, name));
        }
    }

    /// Whether all fields are numbers.
    fn data(&mut self, line: u32, offset: usize, fields: [(usize, &[u8]); 4]) -> bool {
        let [(_, index), x, y, z] = fields;
        let parsed = python_int(index).ok_or(0);
        let floats = [x, y, z].map(|(_, token)| python_float(token));
        match (parsed, floats) {
            (Ok(index), [Some(x), Some(y), Some(z)]) => {
                self.row(line, index, [x, y, z].map(stored));
                true
            }
            (parsed, floats) => {
                let bad = if parsed.is_err() {
                    fields.first()
                } else {
                    let at = floats.iter().position(Option::is_none).unwrap_or(0);
                    fields.get(at + 1)
                };
                self.unreadable(line, offset, bad);
                self.target.facts.unreadable_names.add(|| row_name(&fields));
                false
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
        self.target.facts.rows += 1;
        self.index(line, index);
        self.displacement(line, index, delta);
        let Ok(index) = u32::try_from(index) else {
            return;
        };
        let at = self.target.rows.len();
        let offset = (line as usize).wrapping_sub(at);
        if self
            .line_offsets
            .last()
            .is_none_or(|(_, known)| *known != offset)
        {
            self.line_offsets.push((at, offset));
        }
        self.target.rows.push((index, delta));
    }

    fn index(&mut self, line: u32, index: i64) {
        let facts = &mut self.target.facts;
        facts.max_index = facts.max_index.max(Some(index));
        let Ok(at) = u64::try_from(index) else {
            facts.negative.add(line, index);
            return;
        };
        if at > u64::from(u32::MAX) {
            facts.overflow.add(line, index);
        }
        match self.mesh {
            Some(mesh) if at >= mesh.with_seams as u64 => facts.out_of_range.add(line, index),
            Some(mesh) if at >= mesh.vertices as u64 => facts.seam.add(line, index),
            _ => {}
        }
    }

    fn displacement(&mut self, line: u32, index: i64, delta: [f32; 3]) {
        let facts = &mut self.target.facts;
        if delta.iter().all(|part| *part == 0.0) {
            self.zeros.push((line, index));
            return;
        }
        if !delta.iter().all(|part| part.is_finite()) {
            facts.non_finite.add(line, index);
            return;
        }
        let length = length_of(delta);
        facts.moving += 1;
        self.lengths.push(length);
        self.longest = self.longest.max(length);
        // A vertex that does not exist goes nowhere.
        let exists = u64::try_from(index)
            .is_ok_and(|at| self.mesh.is_none_or(|mesh| at < mesh.with_seams as u64));
        if exists && facts.largest.is_none_or(|largest| length > largest.length) {
            facts.largest = Some(Largest {
                length,
                line,
                index,
            });
        }
    }

    fn finish(mut self) -> Target {
        self.count_repeats();
        self.measure_lengths();
        self.target.facts.content = ContentHash::of(&self.target.rows);
        self.target.facts.thousandths = thousandths(&self.target.rows);
        self.target.facts.beyond_sixteen_bits = self.beyond_sixteen_bits();
        self.target
    }

    /// The first row that the archive of MakeHuman 1 cannot hold. There is none where the longest
    /// displacement fits.
    fn beyond_sixteen_bits(&self) -> Option<(u32, i64, f32)> {
        let facts = &self.target.facts;
        if self.longest < PACKED_PART
            && facts
                .max_index
                .is_none_or(|most| most <= i64::from(u16::MAX))
        {
            return None;
        }
        let longest = |delta: &[f32; 3]| {
            delta.iter().copied().fold(
                0.0_f32,
                |most, part| if part.abs() > most.abs() { part } else { most },
            )
        };
        let is_beyond =
            |row: &Row| longest(&row.1).abs() >= PACKED_PART || row.0 > u32::from(u16::MAX);
        let (at, row) = self
            .target
            .rows
            .iter()
            .enumerate()
            .find(|(_, row)| is_beyond(row))?;
        Some((self.line_of(at), i64::from(row.0), longest(&row.1)))
    }

    fn measure_lengths(&mut self) {
        let facts = &mut self.target.facts;
        let count = self.lengths.len();
        let middle = count.saturating_sub(1) / 2;
        if middle >= count {
            return;
        }
        let (_, median, above) = self.lengths.select_nth_unstable_by(middle, f32::total_cmp);
        facts.median_length = *median;
        let outliers = (count / ROWS_PER_OUTLIER).max(1);
        let tail = above.len().checked_sub(1 + outliers);
        facts.tail_length = tail.map_or(*median, |tail| {
            *above.select_nth_unstable_by(tail, f32::total_cmp).1
        });
        facts.keep_longest(&self.target.rows);
    }

    fn count_repeats(&mut self) {
        let repeats = repeats(&self.target.rows);
        for at in &repeats.rows {
            let Some(index) = self.target.rows.get(*at).map(|row| i64::from(row.0)) else {
                continue;
            };
            let line = self.line_of(*at);
            self.target.facts.duplicate.add(line, index);
        }
        let facts = &mut self.target.facts;
        let replaced = repeats
            .replaced
            .iter()
            .filter_map(|at| self.target.rows.get(*at));
        let is_counted = |row: &&Row| moves(row) && row.1.iter().all(|part| part.is_finite());
        facts.moving -= replaced.filter(is_counted).count();
        facts.repeats_are_equal = facts.duplicate.count > 0 && !repeats.differ;
        facts.displacement = repeats.displacement(&self.target.rows);
        let zeros = self
            .zeros
            .iter()
            .filter(|(_, index)| repeats.vertices.binary_search(index).is_err());
        zeros.for_each(|(line, index)| facts.zero.add(*line, *index));
    }

    /// Line of a kept row.
    fn line_of(&self, at: usize) -> u32 {
        let known = self.line_offsets.partition_point(|(from, _)| *from <= at);
        let offset = known
            .checked_sub(1)
            .and_then(|last| self.line_offsets.get(last))
            .map_or(0, |(_, offset)| *offset);
        u32::try_from(at.wrapping_add(offset)).unwrap_or(u32::MAX)
    }
}

/// A part of a displacement, in decimetres, that is too long for 16 bits of thousandths.
pub const PACKED_PART: f32 = 32.768;

/// What rows are compared by in `targets.npz`.
fn thousandths(rows: &[Row]) -> u64 {
    let mut print = PackedPrint::default();
    rows.iter()
        .for_each(|(index, delta)| print.add(*index, delta.map(|part| f64::from(part) * 1000.0)));
    print.finish()
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn facts(text: &str) -> TargetFacts {
        let mesh = MeshSize {
            vertices: 10,
            with_seams: 12,
        };
        parse(text.as_bytes(), Some(mesh)).facts
    }

    #[test]
    fn rows_are_read_with_any_line_end() {
        let target = parse(
            b"# basemesh hm08\n0 .119 -10.205 -.775\r\n1 1 2 3\r2 0 0 0",
            None,
        );
        let rows = target.rows;
        assert_eq!(
            rows,
            [
                (0, [0.119, -10.205, -0.775]),
                (1, [1.0, 2.0, 3.0]),
                (2, [0.0, 0.0, 0.0])
            ]
        );
        assert_eq!(target.facts.basemesh, Some((1, "hm08".to_owned())));
        assert_eq!(
            (target.facts.zero.first_line(), target.facts.moving),
            (Some(4), 2)
        );
    }

    #[test]
    fn fast_and_slow_path_agree() {
        for number in [
            "0",
            "-0.001",
            ".5",
            "12.25",
            "123456789",
            "0.12345678",
            "-7.",
        ] {
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
        let bad: Vec<_> = facts
            .unreadable
            .iter()
            .map(|f| (f.line, f.start, f.field.as_str()))
            .collect();
        assert_eq!(bad, [(2, 8, "1.0"), (3, 22, "1,5")]);
    }

    #[test]
    fn indices_are_sorted_into_their_faults() {
        let target = parse(
            b"-1 0 0 1\n9 0 0 1\n10 0 0 1\n12 0 0 1\n\n9 0 0 2\n99999999999999999999 0 0 1\n4294967296 0 0 1\n0 0 0 1\n",
            Some(MeshSize { vertices: 10, with_seams: 12 }),
        );
        let facts = &target.facts;
        let tallies = [
            &facts.negative,
            &facts.seam,
            &facts.out_of_range,
            &facts.overflow,
            &facts.duplicate,
        ];
        assert_eq!(tallies.map(|tally| tally.count), [1, 1, 3, 2, 1]);
        assert_eq!(facts.duplicate.first, [(6, 9)]);
        assert_eq!((facts.rows, target.rows.len()), (8, 5));
    }

    #[test]
    fn zeros_of_a_vertex_that_moves_are_repeats_and_repeated_zeros_are_zeros() {
        let facts = facts("1 0 .1 0\n1 0 0 0\n2 0 0 0\n3 0 0 0\n3 0 0 0\n4 0 0 0\n4 0 .1 0\n");
        assert_eq!(facts.zero.first, [(3, 2), (4, 3), (5, 3)]);
        assert_eq!(facts.duplicate.first, [(2, 1), (7, 4)]);
        assert_eq!(
            (facts.rows, facts.moving, facts.moves_nothing()),
            (7, 1, false)
        );
    }

    #[test]
    fn a_target_whose_rows_are_all_undone_moves_nothing() {
        let undone = facts("1 0 .1 0\n1 0 0 0\n");
        assert_eq!(
            (undone.zero.count, undone.moving, undone.moves_nothing()),
            (0, 0, true)
        );
        assert!(!facts("1 nan 0 0\n").moves_nothing() && !facts("# a\n").moves_nothing());
    }

    #[test]
    fn repeats_are_named_in_the_order_of_the_file() {
        let facts = facts("# c\n5 0 0 1\n\n3 0 0 1\nword\n5 0 0 1\n# c\n3 0 0 1\n5 0 0 1\n");
        assert_eq!(facts.duplicate.first, [(6, 5), (8, 3), (9, 5)]);
    }

    #[test]
    fn lengths_are_measured_without_the_outlier() {
        let rows: Vec<_> = (0..9)
            .map(|at| format!("{at} 0 0 {}\n", if at == 4 { 100 } else { 1 + at }))
            .collect();
        let facts = facts(&rows.concat());
        assert_eq!((facts.median_length, facts.tail_length), (6.0, 9.0));
        let pair = parse(b"1 0 0 .01\n2 0 0 100\n", None).facts;
        assert_eq!((pair.median_length, pair.tail_length), (0.01, 0.01));
        assert_eq!(
            facts.largest.map(|largest| (largest.length, largest.line)),
            Some((100.0, 5))
        );
    }

    #[test]
    fn zeros_of_either_sign_are_one_content() {
        assert_eq!(facts("1 -0 0 1\n").content, facts("1 0 0 1\n").content);
        assert_ne!(facts("1 0 0 1\n").content, facts("2 0 0 1\n").content);
        let written = facts("1 0 0 2\n3 0 0 0\n2 0 0 1\n1 0 0 0\n");
        assert_eq!(written.displacement, facts("2 0 0 1\n").displacement);
    }

    #[test]
    fn non_finite_rows_are_counted() {
        let facts = facts("0 nan 0 0\n1 0 inf 0\n2 0 0 1e400\n3 1e30 0 0\n");
        assert_eq!((facts.non_finite.count, facts.moving), (3, 1));
    }

    /// What both paths must agree on, NaN included.
    fn seen(target: &Target) -> String {
        format!("{target:?}")
    }

    fn by_the_slow_path(text: &[u8], mesh: Option<MeshSize>) -> Target {
        parse_by(|_| (None, 0), text, mesh)
    }

    #[test]
    fn every_truncation_agrees_on_both_paths() {
        let text =
            b"# basemesh hm08\n0 .119 -10.205 -.775\r\n1 1 2 3\r9 0 0 0\n\n11 -.5 7. 123456789\n4 1 2\n3 1e3 nan _\n";
        let mesh = Some(MeshSize {
            vertices: 10,
            with_seams: 12,
        });
        for length in 0..=text.len() {
            let text = &text[..length];
            assert_eq!(
                seen(&parse(text, mesh)),
                seen(&by_the_slow_path(text, mesh))
            );
        }
    }

    proptest! {
        #[test]
        fn any_bytes_agree_on_both_paths(text in proptest::collection::vec(any::<u8>(), 0..200)) {
            prop_assert_eq!(seen(&parse(&text, None)), seen(&by_the_slow_path(&text, None)));
        }

        #[test]
        fn rows_of_any_shape_agree_on_both_paths(
            text in "([0-9]{1,11}|[-+]?[0-9.]{1,12}|[ \t]|[0-9]{1,3} -?[0-9]{0,3}\\.?[0-9]{0,7} \
                -?\\.[0-9]{1,9} 0(\r\n|\r|\n)|[-#.e_ \n\r]){0,40}"
        ) {
            let mesh = Some(MeshSize { vertices: 500, with_seams: 600 });
            prop_assert_eq!(seen(&parse(text.as_bytes(), mesh)), seen(&by_the_slow_path(text.as_bytes(), mesh)));
        }

        #[test]
        fn every_repeat_is_counted_on_its_line(indices in proptest::collection::vec(0_u32..20, 0..30)) {
            let text: Vec<_> = indices.iter().map(|index| format!("# c\n{index} 0 0 1\n")).collect();
            let facts = parse(text.concat().as_bytes(), None).facts;
            let repeats = (0..indices.len()).filter(|at| indices[..*at].contains(&indices[*at]));
            let expected: Vec<(u32, i64)> =
                repeats.map(|at| (u32::try_from(2 * at + 2).unwrap(), i64::from(indices[at]))).collect();
            prop_assert_eq!(facts.duplicate.count, expected.len() as u64);
            prop_assert_eq!(facts.duplicate.first, expected.into_iter().take(mhlint_diag::EXAMPLES).collect::<Vec<_>>());
        }
    }
}
