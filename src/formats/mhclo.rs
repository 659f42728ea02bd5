//! `.mhclo` and `.proxy`: an asset tied to the vertices of a base mesh, as MakeHuman 2 reads it
//! (formats/makehuman2.md §15.1).
//!
//! Words split at white space; a keyword may have a colon behind it. Faults are kept with their lines and
//! never end the reading: what the application would do at a fault is in [`FaultKind::effect`].

use serde::Serialize;

use super::fields::fields;
use super::{python_float, python_int};

/// The file.
#[derive(Debug, Clone, Default, PartialEq, Serialize)]
pub struct Clothes {
    /// Keywords with a text or a file name in file order, tags included: keyword, rest of the line, line.
    pub texts: Vec<Text>,
    /// The author that the asset library shows: of a line `# author …`.
    pub comment_author: Option<Text>,
    /// `z_depth`, as far as it is an integer.
    pub z_depth: Option<i64>,
    /// `x_scale`, `y_scale`, `z_scale`.
    pub scales: [Option<Scale>; 3],
    /// The vertex lines: one for each vertex of the asset.
    pub references: Vec<Reference>,
    /// Runs of base vertices to hide, both ends included, as written.
    pub deleted: Vec<(i64, i64)>,
    /// What the loader stops at or drops.
    pub faults: Vec<Fault>,
    /// Keywords that the loader does not know: the word and its line.
    pub unknown: Vec<(String, u32)>,
}

/// A keyword with text.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize)]
pub struct Text {
    /// The keyword without colon.
    pub keyword: String,
    /// Rest of the line, words joined by one blank.
    pub text: String,
    /// Line from 1.
    pub line: u32,
    /// Whether a colon follows the keyword, which the asset library does not accept.
    pub colon: bool,
}

/// Two base vertices and the distance they had on an axis.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Scale {
    /// The vertices.
    pub vertices: [i64; 2],
    /// The distance, decimetres.
    pub distance: f32,
    /// Line from 1.
    pub line: u32,
}

/// A vertex of the asset in terms of the base mesh.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
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

/// A line that the loader cannot take.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Fault {
    /// Line from 1.
    pub line: u32,
    /// What is wrong.
    pub kind: FaultKind,
}

/// The kinds of [`Fault`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
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
    /// A line of the vertex section that begins with no plain number: dropped, all later vertices shift.
    Dropped,
    /// `weights`: a format that is no longer read.
    OldFormat,
}

impl FaultKind {
    /// The exception that stops the application; `None` if it goes on without the line.
    pub const fn effect(self) -> Option<&'static str> {
        match self {
            Self::FieldCount(_) | Self::MissingValue => Some("IndexError"),
            Self::NoNumber | Self::KeywordInDelete | Self::OldFormat => Some("ValueError"),
            Self::OpenRange => Some("UnboundLocalError"),
            Self::Dropped => None,
        }
    }
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Section {
    Header,
    Vertices,
    Deleted,
}

struct Reader {
    clothes: Clothes,
    section: Section,
    line: u32,
    /// Last index of the delete section; a range may continue on the next line.
    last: Option<i64>,
    range: bool,
}

const TEXTS: [&str; 11] = [
    "name",
    "uuid",
    "description",
    "author",
    "license",
    "homepage",
    "tag",
    "obj_file",
    "material",
    "vertexboneweights_file",
    "version",
];
const IGNORED: [&str; 4] = ["basemesh", "max_pole", "shapekey", "z_depth"];

/// Parses an asset.
pub fn parse(text: &[u8]) -> Clothes {
    let mut reader =
        Reader { clothes: Clothes::default(), section: Section::Header, line: 0, last: None, range: false };
    for line in text.split(|byte| *byte == b'\n') {
        reader.line = reader.line.saturating_add(1);
        let words: Vec<&[u8]> = fields(line).into_iter().map(|(_, word)| word).collect();
        reader.take(&words);
    }
    reader.clothes
}

impl Clothes {
    /// Text of a keyword; of several the last.
    pub fn text(&self, keyword: &str) -> Option<&str> {
        self.texts.iter().rev().find(|text| text.keyword == keyword).map(|text| text.text.as_str())
    }

    /// First word behind a keyword that names a file.
    pub fn file(&self, keyword: &str) -> Option<&str> {
        self.text(keyword)?.split(' ').next().filter(|word| !word.is_empty())
    }

    /// The first line that stops the application.
    pub fn stops_at(&self) -> Option<(&Fault, &'static str)> {
        self.faults.iter().find_map(|fault| Some((fault, fault.kind.effect()?)))
    }
}

impl Reader {
    fn take(&mut self, words: &[&[u8]]) {
        let [first, rest @ ..] = words else { return };
        if first.starts_with(b"#") {
            return self.comment(first, rest);
        }
        let colon = first.ends_with(b":");
        let keyword =
            String::from_utf8_lossy(if colon { first.get(..first.len() - 1).unwrap_or(first) } else { first });
        match (self.section, keyword.as_ref()) {
            (_, "verts") => self.section = Section::Vertices,
            (Section::Deleted, _) => self.delete(words),
            (_, "delete_verts") => self.section = Section::Deleted,
            (Section::Vertices, word) if is_numeric(word) => self.vertex(words),
            (_, word) => {
                let word = word.to_owned();
                self.keyword(&word, rest, colon);
            }
        }
    }

    fn fault(&mut self, kind: FaultKind) {
        self.clothes.faults.push(Fault { line: self.line, kind });
    }

    fn comment(&mut self, first: &[u8], rest: &[&[u8]]) {
        let inner = first.strip_prefix(b"#").filter(|inner| !inner.is_empty());
        let words: Vec<&[u8]> = inner.into_iter().chain(rest.iter().copied()).collect();
        if let [key, text @ ..] = words.as_slice()
            && key.starts_with(b"author")
        {
            self.clothes.comment_author =
                Some(Text { keyword: "author".to_owned(), text: joined(text), line: self.line, colon: false });
        }
    }

    fn keyword(&mut self, word: &str, rest: &[&[u8]], colon: bool) {
        match word {
            "x_scale" => self.scale(0, rest),
            "y_scale" => self.scale(1, rest),
            "z_scale" => self.scale(2, rest),
            "weights" => self.fault(FaultKind::OldFormat),
            _ if TEXTS.contains(&word) || IGNORED.contains(&word) => {
                let text = Text { keyword: word.to_owned(), text: joined(rest), line: self.line, colon };
                self.clothes.texts.push(text);
                if matches!(word, "z_depth" | "version") {
                    self.integer(word, rest);
                }
            }
            _ => {
                if self.section == Section::Vertices && !word.starts_with(char::is_alphabetic) {
                    self.fault(FaultKind::Dropped);
                }
                self.clothes.unknown.push((word.to_owned(), self.line));
            }
        }
    }

    fn integer(&mut self, word: &str, rest: &[&[u8]]) {
        match rest.first().map(|value| python_int(value)) {
            Some(Some(depth)) if word == "z_depth" => self.clothes.z_depth = Some(depth),
            Some(Some(_)) => {}
            Some(None) => self.fault(FaultKind::NoNumber),
            None => self.fault(FaultKind::MissingValue),
        }
    }

    fn scale(&mut self, axis: usize, rest: &[&[u8]]) {
        let [a, b, distance, ..] = rest else { return self.fault(FaultKind::MissingValue) };
        let read = python_int(a).zip(python_int(b)).zip(python_float(distance));
        let Some(((a, b), distance)) = read else { return self.fault(FaultKind::NoNumber) };
        if let Some(slot) = self.clothes.scales.get_mut(axis) {
            *slot = Some(Scale { vertices: [a, b], distance: narrow(distance), line: self.line });
        }
    }

    fn vertex(&mut self, words: &[&[u8]]) {
        match words {
            [one] => match python_int(one) {
                Some(vertex) => self.clothes.references.push(Reference {
                    vertices: [vertex; 3],
                    weights: [1.0, 0.0, 0.0],
                    offset: [0.0; 3],
                    line: self.line,
                }),
                None => self.fault(FaultKind::NoNumber),
            },
            [a, b, c, x, y, z] => self.triple([a, b, c], [x, y, z], None),
            [a, b, c, x, y, z, u, v, w, ..] => self.triple([a, b, c], [x, y, z], Some([u, v, w])),
            _ => self.fault(FaultKind::FieldCount(words.len())),
        }
    }

    fn triple(&mut self, vertices: [&[u8]; 3], weights: [&[u8]; 3], offset: Option<[&[u8]; 3]>) {
        let all = |words: [&[u8]; 3]| -> Option<[f32; 3]> {
            let [a, b, c] = words.map(python_float);
            Some([narrow(a?), narrow(b?), narrow(c?)])
        };
        let [a, b, c] = vertices.map(python_int);
        let read = (|| Some(([a?, b?, c?], all(weights)?, offset.map_or(Some([0.0; 3]), all)?)))();
        match read {
            Some((vertices, weights, offset)) => {
                self.clothes.references.push(Reference { vertices, weights, offset, line: self.line });
            }
            None => self.fault(FaultKind::NoNumber),
        }
    }

    fn delete(&mut self, words: &[&[u8]]) {
        for word in words {
            match (*word, python_int(word), self.last) {
                (b"-", _, None) => self.fault(FaultKind::OpenRange),
                (b"-", _, Some(_)) => self.range = true,
                (_, Some(index), last) => {
                    let first = last.filter(|_| self.range).unwrap_or(index);
                    self.clothes.deleted.push((first, index));
                    self.last = Some(index);
                    self.range = false;
                }
                (word, None, _) => {
                    let is_word = word.first().is_some_and(u8::is_ascii_alphabetic);
                    return self.fault(if is_word { FaultKind::KeywordInDelete } else { FaultKind::NoNumber });
                }
            }
        }
    }
}

/// Python's `isnumeric()`: no sign, no point.
fn is_numeric(word: &str) -> bool {
    !word.is_empty() && word.chars().all(char::is_numeric)
}

fn joined(words: &[&[u8]]) -> String {
    words.iter().map(|word| String::from_utf8_lossy(word)).collect::<Vec<_>>().join(" ")
}

#[expect(clippy::cast_possible_truncation, reason = "the application stores float32")]
fn narrow(value: f64) -> f32 {
    value as f32
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    #[test]
    fn sections_and_faults() {
        let text = "# author Ann Ex\nname: a shirt\nuuid 1\nobj_file shirt.obj\nx_scale 1 2 3.5\ny_scale 1\nverts 0\n\
            5\n0 1 2 .5 .25 .25\n0 1 2 1 0 0 .1 .2 .3\n-5\n1 2\n# note\ndelete_verts\n1 2 - 4\n- 6\nname x\n";
        let clothes = parse(text.as_bytes());
        assert_eq!(clothes.text("name"), Some("a shirt"));
        assert_eq!(clothes.file("obj_file"), Some("shirt.obj"));
        assert_eq!(clothes.comment_author.unwrap().text, "Ann Ex");
        assert_eq!(clothes.scales[0].unwrap().vertices, [1, 2]);
        let lines: Vec<u32> = clothes.references.iter().map(|reference| reference.line).collect();
        assert_eq!(lines, [8, 9, 10]);
        assert_eq!(clothes.deleted, [(1, 1), (2, 2), (2, 4), (4, 6)]);
        let faults: Vec<_> = clothes.faults.iter().map(|fault| (fault.line, fault.kind)).collect();
        let kinds = [
            (6, FaultKind::MissingValue),
            (11, FaultKind::Dropped),
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
                text += &if *short { format!("{vertex}\n") } else { format!("{vertex} 1 2 {weight} 0 0 0 0 0\n") };
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
