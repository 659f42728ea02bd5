//! `.mhclo` and `.proxy`: an asset tied to the vertices of a base mesh (formats/makehuman2.md §15.1, makehuman1.md §10,
//! mpfb.md §26.1).
//!
//! Words split at white space; a keyword may have a colon behind it. All lines are read, also behind one that some
//! application stops at, or that ends a section for it: such lines are kept as faults. What comes of a fault is a matter
//! of the application's own evaluation.

mod names;
mod reader;

pub use names::{Name, Named, names};
pub use reader::parse;

/// The file.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Clothes {
    /// `obj_file`: the first word of the last such line.
    pub obj_file: Option<String>,
    /// `x_scale`, `y_scale`, `z_scale`.
    pub scales: [Option<Scale>; 3],
    /// The vertex lines: one for each vertex of the asset.
    pub references: Vec<Reference>,
    /// Runs of base vertices to hide, both ends included, as written.
    pub deleted: Vec<(i64, i64)>,
    /// Lines that are not what their section or keyword wants.
    pub faults: Vec<Fault>,
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

/// A line that is not what its section or keyword wants.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Fault {
    /// Line from 1.
    pub line: u32,
    /// What is wrong.
    pub kind: FaultKind,
}

/// The kinds of [`Fault`].
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FaultKind {
    /// A vertex line with 2 to 5, 7 or 8 words.
    FieldCount(usize),
    /// A word that is no number where one must be.
    NoNumber,
    /// A scale or a keyword without its values.
    MissingValue,
    /// `-` with nothing before it in the delete section.
    OpenRange,
    /// A keyword in the delete section.
    KeywordInDelete,
    /// A line of the vertex section that begins with neither a plain number nor a letter.
    NoVertex,
    /// `weights`, of an old format.
    OldFormat,
}

#[cfg(test)]
mod tests {
    #![allow(clippy::float_cmp, clippy::panic, reason = "tests choose numbers without rounding and may stop")]

    use proptest::prelude::*;

    use super::*;

    #[test]
    fn sections_and_faults() {
        let text = "# author Ann Ex\nname: a shirt\nuuid 1\nobj_file shirt.obj\nx_scale 1 2 3.5\ny_scale 1\nverts 0\n\
            5\n0 1 2 .5 .25 .25\n0 1 2 1 0 0 .1 .2 .3\n-5\n1 2\n# note\ndelete_verts\n1 2 - 4\n- 6\nname x\n";
        let clothes = parse(text.as_bytes());
        assert_eq!(clothes.obj_file.as_deref(), Some("shirt.obj"));
        assert_eq!(clothes.scales[0].unwrap().vertices, [1, 2]);
        let lines: Vec<u32> = clothes.references.iter().map(|reference| reference.line).collect();
        assert_eq!(lines, [8, 9, 10]);
        assert_eq!(clothes.deleted, [(1, 1), (2, 2), (2, 4), (4, 6)]);
        let faults: Vec<_> = clothes.faults.iter().map(|fault| (fault.line, fault.kind)).collect();
        let kinds = [
            (6, FaultKind::MissingValue),
            (11, FaultKind::NoVertex),
            (12, FaultKind::FieldCount(2)),
            (17, FaultKind::KeywordInDelete),
        ];
        assert_eq!(faults, kinds);
    }

    proptest! {
        /// Every vertex line that is written is found again, whatever stands around it.
        #[test]
        fn vertex_lines_survive(rows in prop::collection::vec((0u32..9999, -9.0f32..9.0, any::<bool>()), 0..40), noise in "[ -~\n]{0,80}") {
            let mut text = String::from("name n\nverts 0\n");
            for (vertex, weight, short) in &rows {
                let line = if *short { format!("{vertex}\n") } else { format!("{vertex} 1 2 {weight} 0 0 0 0 0\n") };
                text.push_str(&line);
            }
            let whole = parse(text.as_bytes());
            prop_assert_eq!(whole.references.len(), rows.len());
            for (reference, (vertex, weight, short)) in whole.references.iter().zip(&rows) {
                prop_assert_eq!(reference.vertices[0], i64::from(*vertex));
                prop_assert_eq!(reference.weights[0], if *short { 1.0 } else { *weight });
            }
            parse(noise.as_bytes());
            parse(format!("{text}delete_verts\n{noise}").as_bytes());
        }

        #[test]
        fn no_bytes_stop_the_parser(bytes in prop::collection::vec(any::<u8>(), 0..200)) {
            parse(&bytes);
        }
    }
}
