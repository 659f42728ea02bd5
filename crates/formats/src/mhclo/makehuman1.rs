//! An asset as MakeHuman 1 reads it (`docs/loaders/makehuman1/clothes.md#keywords`,
//! `docs/loaders/makehuman1/clothes.md#rows`): a keyword with a colon is another word, keywords
//! count in whatever section they stand, and an old section of weights is passed over.

use super::reading::{Reader, first_stop};
use super::{Clothes, Fault, FaultKind, makehuman2};
use crate::python_int;

/// How it reads.
pub static READER: Reader = Reader {
    knows: |entry| !entry.has_colon,
    is_fault,
    passes_over: &OLD,
    needs_value,
    stop: |clothes| first_stop(clothes, |fault| stop(clothes, fault)),
};

/// The keywords that it reads besides those of MakeHuman 2.
pub const KEYWORDS: [&str; 12] = [
    "max_pole",
    "special_pose",
    "uvLayer",
    "shear_x",
    "shear_y",
    "shear_z",
    "l_shear_x",
    "l_shear_y",
    "l_shear_z",
    "r_shear_x",
    "r_shear_y",
    "r_shear_z",
];

/// Those of old that it knows and passes over.
pub const OLD: [&str; 13] = [
    "backface_culling",
    "transparent",
    "shapekey",
    "subsurf",
    "shrinkwrap",
    "solidify",
    "objfile_layer",
    "uvtex_layer",
    "use_projection",
    "mask_uv_layer",
    "texture_uv_layer",
    "delete",
    "vertexgroup_file",
];

/// Whether it reads a keyword, or passes over it as one of old.
pub fn knows(keyword: &str) -> bool {
    makehuman2::KEYWORDS.contains(&keyword)
        || KEYWORDS.contains(&keyword)
        || OLD.contains(&keyword)
        || keyword == "basemesh"
}

/// Keywords whose line is not read without a value.
fn needs_value(keyword: &str) -> bool {
    let own = [
        "obj_file",
        "material",
        "vertexboneweights_file",
        "z_depth",
        "x_scale",
        "y_scale",
        "z_scale",
        "basemesh",
        "version",
        "max_pole",
    ];
    own.contains(&keyword) || keyword.contains("shear_")
}

fn is_fault(clothes: &Clothes, fault: &Fault) -> bool {
    // With a colon behind its keyword it is a line of an unknown one.
    let is_of_colon = || {
        let mut lines = clothes.entries.iter();
        lines.any(|entry| entry.line == fault.line && entry.has_colon)
    };
    let is_one = match fault.kind {
        FaultKind::OldFormat => false,
        FaultKind::NotWhole
        | FaultKind::ScaleWord
        | FaultKind::ShortScale
        | FaultKind::MissingValue => !is_of_colon(),
        // Keywords may stand below any section.
        FaultKind::DeleteWord => !knows(&fault.word),
        // `+5` is a number to Python.
        FaultKind::DroppedRow => python_int(fault.word.as_bytes()).is_none_or(|number| number < 0),
        FaultKind::FieldCount(_)
        | FaultKind::RowWord
        | FaultKind::NumbersInHeader
        | FaultKind::OpenRange => true,
    };
    is_one && fault.line < old_weights(clothes)
}

/// The line of an old section of weights: what stands in it is read and not used.
fn old_weights(clothes: &Clothes) -> u32 {
    let old = clothes.faults.of(|kind| kind == FaultKind::OldFormat);
    old.and_then(|(faults, _)| faults.first())
        .map_or(u32::MAX, |fault| fault.line)
}

fn stop(clothes: &Clothes, fault: &Fault) -> Option<(&'static str, String)> {
    if !is_fault(clothes, fault) {
        return None;
    }
    match fault.kind {
        // A whole number that is left is negative.
        FaultKind::DroppedRow => Some(match python_int(fault.word.as_bytes()) {
            Some(_) => (
                "OverflowError",
                format!("no vertex has the number {}", fault.word),
            ),
            None => ("ValueError", "a word is not a number".to_owned()),
        }),
        FaultKind::MissingValue if needs_value(&fault.word) => {
            Some(("IndexError", format!("`{}` has no value", fault.word)))
        }
        kind => makehuman2::stop(kind),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mhclo::{Entry, Stopped, parse};

    fn stop(text: &str) -> [Option<(u32, &'static str)>; 2] {
        let clothes = parse(text.as_bytes(), None);
        let place = |stopped: Stopped| (stopped.line, stopped.exception);
        [&READER, &makehuman2::READER].map(|reader| reader.of(&clothes).stop().map(place))
    }

    #[test]
    fn it_stops_where_its_successor_does_not_and_the_other_way_round() {
        for (text, own, of_makehuman2) in [
            (
                "verts 0\n1 2 3 1 0 x\n",
                Some((2, "ValueError")),
                Some((2, "ValueError")),
            ),
            (
                "verts 0\n1 2 3 1\n",
                Some((2, "IndexError")),
                Some((2, "IndexError")),
            ),
            ("verts 0\n-5\n", Some((2, "OverflowError")), None),
            ("verts 0\n6.0\n", Some((2, "ValueError")), None),
            ("verts 0\n+5\n", None, None),
            ("obj_file\nverts 0\n5\n", Some((1, "IndexError")), None),
            ("z_depth: x\nverts 0\n5\n", None, Some((1, "ValueError"))),
            (
                "verts 0\n5\ndelete_verts\n1\nname x\n",
                None,
                Some((5, "ValueError")),
            ),
            (
                "verts 0\n5\nweights a\n1 x\n",
                None,
                Some((3, "ValueError")),
            ),
        ] {
            assert_eq!(stop(text), [own, of_makehuman2], "{text}");
        }
    }

    #[test]
    fn a_keyword_with_a_colon_is_another_word() {
        let clothes = parse(
            b"name a\nname: b\nsubsurf 1\nsubsurf: 2\nverts: 0\n5\n",
            None,
        );
        let (own, of_makehuman2) = (READER.of(&clothes), makehuman2::READER.of(&clothes));
        assert_eq!(own.last("name").map(Entry::word), Some("a"));
        assert_eq!(of_makehuman2.last("name").map(Entry::word), Some("b"));
        assert_eq!(
            (own.opens_rows(), of_makehuman2.opens_rows()),
            (false, true)
        );
        let passed = |reader: &'static Reader| {
            let lines = clothes.entries.iter();
            lines
                .filter(|entry| reader.of(&clothes).passes_over(entry))
                .count()
        };
        assert_eq!((passed(&READER), passed(&makehuman2::READER)), (1, 0));
    }
}
