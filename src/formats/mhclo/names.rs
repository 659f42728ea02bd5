//! The files that an asset names, without its vertices.

use std::ops::Range;

use crate::formats::fields::fields;
use crate::source::lines;

/// A line that names a file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Name {
    /// What the file is.
    pub what: Named,
    /// The first word behind the keyword.
    pub word: Box<str>,
    /// Whether the keyword has a colon behind it, with which not every application knows it.
    pub has_colon: bool,
    /// Where the word stands, in bytes.
    pub span: Range<usize>,
}

/// What an asset names.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Named {
    /// `obj_file`.
    Mesh,
    /// `material`.
    Material,
    /// `vertexboneweights_file`.
    Weights,
}

const KEYWORDS: [(&str, Named); 3] =
    [("obj_file", Named::Mesh), ("material", Named::Material), ("vertexboneweights_file", Named::Weights)];

/// The names in the order of their lines, wherever these stand.
pub fn names(text: &[u8]) -> Vec<Name> {
    let name = |(Range { start, .. }, line): (Range<usize>, &[u8])| {
        let words = fields(line);
        let [(_, first), (at, word), ..] = words.as_slice() else { return None };
        let keyword = first.strip_suffix(b":").unwrap_or(first);
        let (_, what) = KEYWORDS.iter().find(|(known, _)| known.as_bytes() == keyword)?;
        let span = start + at..start + at + word.len();
        let word = String::from_utf8_lossy(word).into();
        Some(Name { what: *what, word, has_colon: keyword.len() < first.len(), span })
    };
    lines(text).filter_map(name).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_is_the_word_behind_its_keyword() {
        let text = b"# material no\nobj_file a.obj b\r\nmaterial:\t x/y.mhmat\nverts 0\n5\nvertexboneweights_file w.mhw\nmaterial\n";
        let found = names(text);
        let told: Vec<_> = found.iter().map(|name| (name.what, &*name.word, name.has_colon)).collect();
        let mesh = (Named::Mesh, "a.obj", false);
        let weights = (Named::Weights, "w.mhw", false);
        assert_eq!(told, [mesh, (Named::Material, "x/y.mhmat", true), weights]);
        assert!(found.iter().all(|name| text.get(name.span.clone()) == Some(name.word.as_bytes())));
    }
}
