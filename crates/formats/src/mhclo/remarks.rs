//! Keywords behind `#`, which up to alpha 7 was how they were written
//! (`docs/loaders/versions.md#formats-that-are-gone`): to later readers they are comments, and so
//! they are where an author keeps a line.

use std::collections::BTreeSet;

use super::Entry;
use crate::outdated::{Alpha, Outdated};
use crate::{python_float, python_int};

type Word<'l> = (usize, &'l [u8]);

/// Lines of which one at least is in every such file.
const TELLING: [&str; 5] = ["obj_file", "verts", "weightfile", "obj_data", "faces"];

/// Further lines of it. Since alpha 8 comments say who made an asset, and no more.
const FURTHER: [&str; 13] = [
    "name",
    "uuid",
    "basemesh",
    "material",
    "texture",
    "z_depth",
    "x_scale",
    "y_scale",
    "z_scale",
    "weights",
    "delete_verts",
    "uvLayer",
    "max_pole",
];

/// Keywords that are lines of their own since alpha 8: with one of them what is behind `#` was put
/// there by hand.
const LIVE: [&str; 6] = [
    "name",
    "uuid",
    "obj_file",
    "verts",
    "basemesh",
    "vertexboneweights_file",
];

/// What was counted of comments, and of rows before any section.
#[derive(Default)]
pub(super) struct Remarks {
    keywords: BTreeSet<&'static str>,
    basemesh: Option<Box<str>>,
    has_costume: bool,
    has_remarked_row: bool,
    /// The words of the first row.
    row: Option<usize>,
}

impl Remarks {
    /// Takes a comment.
    pub(super) fn take(&mut self, words: &[Word<'_>]) {
        let [(_, b"#"), (_, second), values @ ..] = words else {
            return;
        };
        match values {
            _ if python_int(second).is_some() => {
                self.has_remarked_row |=
                    values.iter().all(|(_, word)| python_float(word).is_some());
            }
            [_, (_, uuid)] if *second == b"clothing" => self.has_costume |= is_uuid(uuid),
            [(_, name), ..] if *second == b"basemesh" => {
                self.basemesh = Some(String::from_utf8_lossy(name).into());
            }
            _ => {}
        }
        let known = TELLING
            .into_iter()
            .chain(FURTHER)
            .find(|known| known.as_bytes() == *second);
        // Behind a word of prose there is a sentence.
        self.keywords.extend(known.filter(|_| values.len() <= 3));
    }

    /// Takes a row before any section.
    pub(super) fn row(&mut self, words: usize) {
        self.row = self.row.or(Some(words));
    }

    /// The old format, if the lines and the entries of the whole file say so: two lines make it
    /// certain.
    pub(super) fn format(&self, entries: &[Entry]) -> Option<Outdated> {
        let has = |keyword: &str| {
            entries
                .iter()
                .any(|entry| !entry.is_comment && *entry.keyword == *keyword)
        };
        if self.has_costume && !has("obj_file") && !has("verts") {
            return Some(Outdated::Costume);
        }
        let is_by_hand = self.has_remarked_row && self.row.is_none();
        let named = self.basemesh.as_deref().and_then(Alpha::of_basemesh);
        let is_telling = named.is_some()
            || TELLING
                .iter()
                .any(|keyword| self.keywords.contains(keyword));
        if LIVE.into_iter().any(has) || is_by_hand || !is_telling || self.keywords.len() < 2 {
            return None;
        }
        Some(Outdated::Worn(named.unwrap_or_else(|| self.version())))
    }

    /// The version where no line names its base mesh.
    fn version(&self) -> Alpha {
        match (self.basemesh.as_deref(), self.row) {
            (Some("hm08"), _) => Alpha::BeforeEight,
            (None, Some(6 | 7)) => Alpha::Six,
            _ if self.keywords.contains("weightfile") => Alpha::Six,
            _ => Alpha::Seven,
        }
    }
}

/// `8-4-4-4-12` digits.
fn is_uuid(word: &[u8]) -> bool {
    let parts = word.split(|byte| *byte == b'-');
    let is_hex = word
        .iter()
        .all(|byte| byte.is_ascii_hexdigit() || *byte == b'-');
    is_hex && parts.map(<[u8]>::len).eq([8, 4, 4, 4, 12])
}

#[cfg(test)]
mod tests {
    use super::super::parse;
    use super::*;

    #[test]
    fn two_keywords_behind_a_hash_make_an_old_asset() {
        let seven = Some(Outdated::Worn(Alpha::Seven));
        for (text, expected) in [
            ("# obj_file a.obj\n# verts 0\n1 2 3 .3 .3 .4 0 0 0\n", seven),
            ("# basemesh alpha_7\n# obj_file a.obj\n", seven),
            (
                "# name a\n# weightfile a b\n# verts 0\n1 2 3 .3 .3 .4 0\n",
                Some(Outdated::Worn(Alpha::Six)),
            ),
            (
                "# name a\n# verts 0\n1 2 3 .3 .3 .4\n",
                Some(Outdated::Worn(Alpha::Six)),
            ),
            (
                "# basemesh hm08\n# obj_file a.obj\n# verts 0\n1\n",
                Some(Outdated::Worn(Alpha::BeforeEight)),
            ),
            (
                "# name a\n# clothing b 01234567-89ab-cdef-0123-456789abcdef\n",
                Some(Outdated::Costume),
            ),
            // One line, or nothing but what comments say.
            ("# obj_file a.obj\n1\n", None),
            ("# author a\n# name b\n# material c\n", None),
            ("# clothing for all\n# name b\n", None),
            // An author put lines away.
            (
                "# obj_file old.obj\n# verts 0\nname a\nobj_file a.obj\nverts 0\n1\n",
                None,
            ),
            ("name a\n# obj_file a.obj\n# verts 0\n1\n", None),
            ("# obj_file a.obj\n# verts 0\n# 1\n# 2\n", None),
        ] {
            assert_eq!(parse(text.as_bytes(), None).outdated, expected, "{text}");
        }
    }
}
