//! `.mhclo` and `.proxy`: an asset tied to the vertices of a base mesh
//! (`docs/loaders/makehuman2/clothes.md#keywords`, `docs/loaders/makehuman1/clothes.md#keywords`,
//! `docs/loaders/mpfb/clothes.md#lines`).
//!
//! Words split at white space; a keyword may have a colon behind it. All lines are read, also
//! behind one that some application stops at, or that ends a section for it: such lines are kept as
//! faults. What an application makes of them is in the file of its name.

mod faults;
mod header;
pub mod makehuman1;
pub mod makehuman2;
pub mod mpfb;
mod reader;
mod reading;
mod remarks;
mod rows;

pub use faults::{Fault, FaultKind, Faults};
pub use header::{Entry, Scanned, Value};
pub use mpfb::{Flow, Gap, Part, Stop, StopCause};
pub use reader::parse;
pub use reading::{Reader, Reading, Stopped};
pub use rows::{DeleteFacts, RowFacts, VISIBLE_SUM};

use super::outdated::Outdated;

/// The file.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Clothes {
    /// Lines with keywords in file order, those of comments that say who made the asset among them.
    pub entries: Vec<Entry>,
    /// What the library of MakeHuman 2 knows it by.
    pub scanned: Scanned,
    /// `x_scale`, `y_scale`, `z_scale`: of several the last.
    pub scales: [Option<Scale>; 3],
    /// The vertex lines: one for each vertex of the asset. Not kept of the files of a repository.
    pub references: Vec<Reference>,
    /// What is kept of them; empty if one of them has a number that no vertex has.
    pub kept: Box<[Row]>,
    /// What was counted of them.
    pub rows: RowFacts,
    /// Runs of base vertices to hide, both ends included, as written.
    pub deleted: Vec<(i64, i64)>,
    /// What was counted of them.
    pub deletes: DeleteFacts,
    /// Lines that are not what their section or keyword wants.
    pub faults: Faults,
    /// What is taken by a reader that ends a section at any other line.
    pub flow: Flow,
    /// The format that it has instead, of an older version.
    pub outdated: Option<Outdated>,
}

/// Where a line stands.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Section {
    /// Before any other section.
    #[default]
    Header,
    /// Behind `verts`.
    Vertices,
    /// Behind `delete_verts`.
    Deleted,
}

/// Two base vertices and the distance they had on an axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Scale {
    /// The vertices.
    pub vertices: [i64; 2],
    /// The distance, decimetres.
    pub distance: f32,
    /// Line from 1.
    pub line: u32,
}

/// A vertex of the asset in terms of the base mesh.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Reference {
    /// Base vertices; three times the same for a line with one number.
    pub vertices: [i64; 3],
    /// Their weights.
    pub weights: [f32; 3],
    /// Displacement.
    pub offset: [f32; 3],
    /// Line from 1.
    pub line: u32,
}

impl Reference {
    /// Whether the vertex takes part of a second or third one of the base mesh.
    fn has_shares(&self) -> bool {
        let [_, second, third] = self.weights;
        second != 0.0 || third != 0.0
    }
}

/// A [`Reference`] whose vertices can exist.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Row {
    /// Base vertices.
    pub vertices: [u32; 3],
    /// Their weights.
    pub weights: [f32; 3],
    /// Displacement.
    pub offset: [f32; 3],
    /// Line from 1.
    pub line: u32,
}

impl Row {
    fn of(reference: &Reference) -> Option<Self> {
        let [a, b, c] = reference.vertices.map(|vertex| u32::try_from(vertex).ok());
        let Reference {
            weights,
            offset,
            line,
            ..
        } = *reference;
        Some(Self {
            vertices: [a?, b?, c?],
            weights,
            offset,
            line,
        })
    }
}

impl Clothes {
    /// With its rows as they are kept: assets of a repository have hundreds of thousands.
    #[must_use]
    pub fn kept(self) -> Self {
        let kept = self
            .references
            .iter()
            .map(Row::of)
            .collect::<Option<_>>()
            .unwrap_or_default();
        Self {
            references: Vec::new(),
            kept,
            ..self
        }
    }

    /// The line of a row.
    pub fn line_of(&self, row: usize) -> u32 {
        self.kept.get(row).map_or(0, |row| row.line)
    }

    /// The vertices to hide as runs that do not overlap, of a mesh with so many. Negative numbers
    /// count from the end.
    pub fn merged_deletes(&self, vertices: usize) -> Vec<std::ops::Range<usize>> {
        let end = i64::try_from(vertices).unwrap_or(i64::MAX);
        let from_start = |vertex: i64| {
            if vertex < 0 {
                vertex.saturating_add(end)
            } else {
                vertex
            }
        };
        let run = |(first, last): (i64, i64)| {
            let first = usize::try_from(from_start(first)).ok()?;
            let last = usize::try_from(from_start(last)).ok()?;
            Some(first..last.saturating_add(1).min(vertices)).filter(|run| run.start < run.end)
        };
        // From a negative number to another one: both ends of the mesh.
        let parts = |(first, last): &(i64, i64)| match (*first, *last) {
            (first @ ..0, last @ 0..) => [Some((first, -1)), Some((0, last))],
            whole => [Some(whole), None],
        };
        let mut runs: Vec<_> = self
            .deleted
            .iter()
            .flat_map(parts)
            .flatten()
            .filter_map(run)
            .collect();
        runs.sort_by_key(|run| run.start);
        let mut merged: Vec<std::ops::Range<usize>> = Vec::new();
        for run in runs {
            match merged.last_mut().filter(|last| run.start <= last.end) {
                Some(last) => last.end = last.end.max(run.end),
                None => merged.push(run),
            }
        }
        merged
    }

    /// The last line of a keyword that has a value, comments aside.
    pub fn last(&self, keyword: &str) -> Option<&Entry> {
        self.all(keyword).next_back()
    }

    /// All lines of a keyword that have a value, comments aside.
    pub fn all(&self, keyword: &str) -> impl DoubleEndedIterator<Item = &Entry> {
        self.entries.iter().filter(move |entry| {
            *entry.keyword == *keyword && !entry.is_comment && !entry.value.is_empty()
        })
    }
}

#[cfg(test)]
mod tests {
    #![allow(
        clippy::float_cmp,
        clippy::panic,
        reason = "tests choose numbers without rounding and may stop"
    )]

    use proptest::prelude::*;

    use super::*;
    use crate::target::MeshSize;

    const SIZE: MeshSize = MeshSize {
        vertices: 10,
        with_seams: 12,
    };

    fn of(text: &str) -> Clothes {
        parse(text.as_bytes(), Some(SIZE))
    }

    fn faults(clothes: &Clothes) -> Vec<(u32, FaultKind, &str)> {
        clothes
            .faults
            .iter()
            .map(|fault| (fault.line, fault.kind, &*fault.word))
            .collect()
    }

    #[test]
    fn sections_and_faults() {
        let text = "# author Ann Ex\nname: a shirt\nuuid 1\nobj_file shirt.obj\nx_scale 1 2 3.5\ny_scale 1\nverts 0\n\
            5\n0 1 2 .5 .25 .25\n0 1 2 1 0 0 .1 .2 .3\n-5\n1 2\n# note\ndelete_verts\n1 2 - 4\n- \
            6\nname x\n";
        let clothes = of(text);
        assert_eq!(clothes.last("obj_file").unwrap().word(), "shirt.obj");
        assert_eq!(clothes.scales[0].unwrap().vertices, [1, 2]);
        let lines: Vec<u32> = clothes
            .references
            .iter()
            .map(|reference| reference.line)
            .collect();
        assert_eq!(lines, [8, 9, 10]);
        assert_eq!(clothes.deleted, [(1, 1), (2, 2), (2, 4), (4, 6)]);
        let kinds = [
            (6, FaultKind::ShortScale, "y_scale"),
            (11, FaultKind::DroppedRow, "-5"),
            (12, FaultKind::FieldCount(2), "1"),
            (17, FaultKind::DeleteWord, "name"),
        ];
        assert_eq!(faults(&clothes), kinds);
    }

    #[test]
    fn a_library_reads_the_head_in_its_own_way() {
        let text = "# author: Ann Ex\nname a shirt\nuuid: 1\nuuid 12 3\ntag Warm Wool\ndescription vintage coat\n\
            author someone\nobj_file shirt.obj tag\nverts 0\n5\nname other\n1 2 3 1 0 0\nname \
            late\n";
        let clothes = of(text);
        let text = |value: &Option<Value>| {
            value
                .as_ref()
                .map(|value| (value.text.to_string(), value.line))
        };
        assert_eq!(text(&clothes.scanned.name), Some(("other".to_owned(), 11)));
        assert_eq!(text(&clothes.scanned.uuid), Some(("12".to_owned(), 4)));
        assert_eq!(
            text(&clothes.scanned.author),
            Some(("Ann Ex".to_owned(), 1))
        );
        let tags: Vec<_> = clothes.scanned.tags.iter().map(|tag| &*tag.text).collect();
        assert_eq!(tags, ["Warm Wool", "vintage coat"]);
        assert_eq!(&*clothes.last("name").unwrap().value, "late");
        assert_eq!(&*clothes.last("uuid").unwrap().value, "12 3");
        let comments: Vec<_> = clothes
            .entries
            .iter()
            .filter(|entry| entry.is_comment)
            .collect();
        assert_eq!(
            (comments.len(), &*comments[0].keyword, &*comments[0].value),
            (1, "author", "Ann Ex")
        );
    }

    #[test]
    fn words_that_are_not_numbers() {
        for (row, kind, word) in [
            ("1 2 - 1 0 0", FaultKind::RowWord, "-"),
            ("1 - 4", FaultKind::RowWord, "-"),
            ("1 2 3 0,5 0 0", FaultKind::RowWord, "0,5"),
            ("1 2 3 1 0 0 #", FaultKind::RowWord, "#"),
            ("1 2 3 1 0 0 0", FaultKind::FieldCount(7), "1"),
            ("\u{b2}", FaultKind::RowWord, "\u{b2}"),
            ("5:", FaultKind::RowWord, "5:"),
            ("6.0", FaultKind::DroppedRow, "6.0"),
            ("1_0", FaultKind::DroppedRow, "1_0"),
            ("+5", FaultKind::DroppedRow, "+5"),
            ("x1 2 3 1 0 0", FaultKind::DroppedRow, "x1"),
        ] {
            let clothes = of(&format!("verts 0\n{row}\n"));
            assert_eq!(faults(&clothes), [(2, kind, word)], "{row}");
        }
        for row in ["1 2 3 nan 0 0", "1 2 3 1 0 0 0 0 0 x", "\u{663}"] {
            let clothes = of(&format!("verts 0\n{row}\n"));
            assert_eq!((clothes.rows.count, faults(&clothes)), (1, vec![]), "{row}");
        }
    }

    #[test]
    fn rows_are_counted_against_the_mesh() {
        let clothes = of(
            "verts 0\n9\n10\n12\n1 -2 4294967296 1 0 0\n1 2 3 .5 .25 .2\n1 2 3 nan 0 0\n1 2 3 \
                0.999 0 0\n",
        );
        let rows = &clothes.rows;
        assert_eq!(
            (rows.count, &rows.in_seams.first, &rows.out_of_range.first),
            (7, &vec![(3, 10)], &vec![(4, 12)])
        );
        assert_eq!(
            (&rows.unstorable.first, rows.unstorable.count),
            (&vec![(5, -2), (5, 4_294_967_296)], 2)
        );
        assert_eq!(
            (&rows.off_sums.first, rows.visible_sums),
            (&vec![(6, 4), (8, 6)], 1)
        );
        assert_eq!(rows.non_finite.first, [(7, 5)]);
        assert_eq!(rows.worst_sum.unwrap().0, 4);
    }

    #[test]
    fn beside_a_vertex_with_all_the_weight_others_are_not_compared() {
        let prints = |rows: &str| of(&format!("verts 0\n{rows}\n")).rows.prints;
        assert_eq!(
            prints("5\n1 2 3 .5 .25 .25"),
            prints("5 0 1 1 0 0\n1 2 3 .5 .25 .25 0 0 0")
        );
        assert_ne!(prints("5"), prints("6"));
        assert_ne!(prints("1 2 3 .5 .5 0"), prints("1 2 4 .5 .5 0"));
        assert_ne!(prints("5\n6"), prints("6\n5"));
        assert_ne!(prints("5 0 1 1 0 0"), prints("5 0 1 1 0 0 0 .5 0"));
    }

    #[test]
    fn ranges_are_counted_against_the_mesh() {
        let deletes = of("delete_verts\n2 -\n- 4 9 - 10\n-1 -11\n7 - 3\n").deletes;
        assert_eq!(
            (&deletes.cut_ranges.first, &deletes.reversed.first),
            (&vec![(2, 2)], &vec![(5, 7)])
        );
        assert_eq!(
            (&deletes.out_of_range.first, &deletes.negative.first),
            (&vec![(3, 10), (4, -11)], &vec![(4, -1)])
        );
        assert_eq!(faults(&of("delete_verts\n- 4\n0-3\n")).len(), 2);
    }

    #[test]
    fn long_lists_are_bounded() {
        let text = format!(
            "{}name x\n{}",
            "zzz 1\n".repeat(5000),
            "1 2\nname y\n".repeat(5000)
        );
        let clothes = of(&format!("{text}verts 0\n{}", "-5\n".repeat(5000)));
        assert!(clothes.entries.len() < 2010 && clothes.faults.iter().count() <= 10);
        assert_eq!(&*clothes.last("name").unwrap().value, "y");
        assert_eq!(
            clothes
                .faults
                .of(|kind| kind == FaultKind::DroppedRow)
                .unwrap()
                .1,
            5000
        );
    }

    proptest! {
        /// Every vertex line that is written is found again, whatever stands around it.
        #[test]
        fn vertex_lines_survive(rows in prop::collection::vec((0u32..9999, -9.0f32..9.0, any::<bool>()), 0..40), noise in "[ -~\n]{0,80}") {
            let mut text = String::from("name n\nverts 0\n");
            for (vertex, weight, short) in &rows {
                let line = if *short { format!("{vertex}\n") } else { format!("{vertex} 1 2 \
                    {weight} 0 0 0 0 0\n") };
                text.push_str(&line);
            }
            let whole = of(&text);
            prop_assert_eq!(whole.references.len(), rows.len());
            for (reference, (vertex, weight, short)) in whole.references.iter().zip(&rows) {
                prop_assert_eq!(reference.vertices[0], i64::from(*vertex));
                prop_assert_eq!(reference.weights[0], if *short { 1.0 } else { *weight });
            }
            of(&noise);
            of(&format!("{text}delete_verts\n{noise}"));
        }

        #[test]
        fn values_stand_where_they_say(text in prop::collection::vec(prop::sample::select(vec!["name", "uuid:", " ", "\u{e4}", "\n", "# author", "a"]), 0..30)) {
            let text = text.concat();
            let clothes = of(&text);
            for entry in &clothes.entries {
                prop_assert_eq!(text.get(entry.word_span()), Some(entry.word()));
            }
            for value in [&clothes.scanned.name, &clothes.scanned.uuid].into_iter().flatten() {
                prop_assert_eq!(text.get(value.span.clone()), Some(&*value.text));
            }
        }

        #[test]
        fn no_bytes_stop_the_parser(bytes in prop::collection::vec(any::<u8>(), 0..200)) {
            parse(&bytes, Some(SIZE));
        }

        #[test]
        fn no_words_stop_the_parser(words in prop::collection::vec("verts|delete_verts|weights|x_scale|-|-?[0-9]{1,20}|nan|1e999|0,5|5%|#|name:|\n", 0..60)) {
            parse(words.join(" ").as_bytes(), Some(SIZE));
        }
    }
}
