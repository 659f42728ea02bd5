//! Where in a file something is wrong: symbolic first, line and column late.

use std::ops::Range;

use serde::Serialize;

/// The place inside one file as a rule knows it.
///
/// Rules name places symbolically; the engine turns them into a [`Location`] for what is printed.
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize)]
pub enum Place {
    /// The file as a whole (also: the file that is missing).
    #[default]
    File,
    /// A JSON pointer (RFC 6901) to a value.
    Pointer(String),
    /// A JSON pointer to a member whose key is meant, not its value.
    Key(String),
    /// A byte range of the decoded text.
    Span(Range<usize>),
    /// A line of a text format, counted from 1.
    Line(u32),
    /// A line of a text format that describes an element, a row of a target say.
    Row(u32, Element),
    /// An element that has no line: a vertex of a computed result, a member of an archive.
    Element(Element),
}

/// A numbered thing of the domain: a vertex, a face, a row.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize)]
pub struct Element {
    /// What is counted: `vertex`, `face`, `row`.
    pub kind: &'static str,
    /// The index, counted from 0 as the formats do.
    pub index: u64,
}

/// A place after the source text was consulted. Members are `None` where they make no sense.
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize)]
pub struct Location {
    /// Line, counted from 1.
    pub line: Option<u32>,
    /// Column in characters, counted from 1.
    pub column: Option<u32>,
    /// JSON pointer.
    pub pointer: Option<String>,
    /// Element of a bulk format.
    pub element: Option<Element>,
    /// The text around the place, for readers. Not part of the JSON report.
    #[serde(skip)]
    pub excerpt: Option<Excerpt>,
    /// Set where the path is that of a folder. Not part of the JSON report.
    #[serde(skip)]
    pub folder: Option<Folder>,
}

/// A folder in the place of a file.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Folder {
    /// A file that stands in for it where a reader of the report knows only files; none if the
    /// folder has none.
    pub file: Option<String>,
}

/// A few lines of source text with the marked part.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Excerpt {
    /// The lines, joined by `\n`.
    pub text: String,
    /// Number of the first line in `text`, counted from 1.
    pub first_line: u32,
    /// The marked bytes within `text`.
    pub mark: Range<usize>,
}

impl Place {
    /// A JSON pointer built from unescaped parts.
    pub fn pointer<const N: usize>(parts: [&str; N]) -> Self {
        Self::Pointer(pointer(&parts))
    }

    /// The key of a JSON member, its pointer built from unescaped parts.
    pub fn key<const N: usize>(parts: [&str; N]) -> Self {
        Self::Key(pointer(&parts))
    }
}

/// A JSON pointer built from unescaped parts.
pub fn pointer(parts: &[&str]) -> String {
    let mut pointer = String::new();
    parts.iter().for_each(|part| add_step(&mut pointer, part));
    pointer
}

/// Adds a part, unescaped, to a JSON pointer.
pub fn add_step(pointer: &mut String, part: &str) {
    pointer.push('/');
    for character in part.chars() {
        match character {
            '~' => pointer.push_str("~0"),
            '/' => pointer.push_str("~1"),
            other => pointer.push(other),
        }
    }
}

/// The parts of a JSON pointer, unescaped.
pub fn steps(pointer: &str) -> impl Iterator<Item = String> {
    pointer
        .split('/')
        .skip(1)
        .map(|step| step.replace("~1", "/").replace("~0", "~"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pointer_parts_are_escaped() {
        assert_eq!(
            Place::pointer(["a/b", "c~d", "0"]),
            Place::Pointer("/a~1b/c~0d/0".to_owned())
        );
        assert_eq!(
            steps("/a~1b/c~0d/0").collect::<Vec<_>>(),
            ["a/b", "c~d", "0"]
        );
        assert_eq!((steps("").count(), steps("/").count()), (0, 1));
    }
}
