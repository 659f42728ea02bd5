//! The lines of an asset in turn: which section they stand in decides what they are.

use super::{Clothes, Fault, FaultKind, Reference, Scale};
use crate::formats::fields::fields;
use crate::formats::{python_float, python_int, stored};
use crate::source::lines;

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

/// Parses an asset.
pub fn parse(text: &[u8]) -> Clothes {
    let mut reader =
        Reader { clothes: Clothes::default(), section: Section::Header, line: 0, last: None, range: false };
    for (_, line) in lines(text) {
        reader.line = reader.line.saturating_add(1);
        let words: Vec<&[u8]> = fields(line).into_iter().map(|(_, word)| word).collect();
        reader.take(&words);
    }
    reader.clothes
}

impl Reader {
    fn take(&mut self, words: &[&[u8]]) {
        let [first, rest @ ..] = words else { return };
        if first.starts_with(b"#") {
            return;
        }
        let keyword = String::from_utf8_lossy(first.strip_suffix(b":").unwrap_or(first));
        match (self.section, keyword.as_ref()) {
            (_, "verts") => self.section = Section::Vertices,
            (Section::Deleted, _) => self.delete(words),
            (_, "delete_verts") => self.section = Section::Deleted,
            (Section::Vertices, word) if is_numeric(word) => self.vertex(words),
            (_, word) => self.keyword(word, rest),
        }
    }

    fn fault(&mut self, kind: FaultKind) {
        self.clothes.faults.push(Fault { line: self.line, kind });
    }

    fn keyword(&mut self, word: &str, rest: &[&[u8]]) {
        match word {
            "obj_file" => self.clothes.obj_file = rest.first().map(|name| String::from_utf8_lossy(name).into_owned()),
            "x_scale" => self.scale(0, rest),
            "y_scale" => self.scale(1, rest),
            "z_scale" => self.scale(2, rest),
            "weights" => self.fault(FaultKind::OldFormat),
            "z_depth" | "version" => match rest.first().map(|value| python_int(value)) {
                Some(Some(_)) => {}
                Some(None) => self.fault(FaultKind::NoNumber),
                None => self.fault(FaultKind::MissingValue),
            },
            word if self.section == Section::Vertices && !word.starts_with(char::is_alphabetic) => {
                self.fault(FaultKind::NoVertex);
            }
            _ => {}
        }
    }

    fn scale(&mut self, axis: usize, rest: &[&[u8]]) {
        let [a, b, distance, ..] = rest else { return self.fault(FaultKind::MissingValue) };
        let read = python_int(a).zip(python_int(b)).zip(python_float(distance));
        let Some(((a, b), distance)) = read else { return self.fault(FaultKind::NoNumber) };
        if let Some(slot) = self.clothes.scales.get_mut(axis) {
            *slot = Some(Scale { vertices: [a, b], distance: stored(distance), line: self.line });
        }
    }

    fn vertex(&mut self, words: &[&[u8]]) {
        let (exact, offset) = match words.len() {
            1 => (true, false),
            6 => (false, false),
            9.. => (false, true),
            count => return self.fault(FaultKind::FieldCount(count)),
        };
        let reference = if exact { exact_vertex(words) } else { triple(words, offset) };
        match reference {
            Some(reference) => self.clothes.references.push(Reference { line: self.line, ..reference }),
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

/// A line with one number is that base vertex itself.
fn exact_vertex(words: &[&[u8]]) -> Option<Reference> {
    let vertex = python_int(words.first()?)?;
    Some(Reference { vertices: [vertex; 3], weights: [1.0, 0.0, 0.0], offset: [0.0; 3], line: 0 })
}

/// Three base vertices, their weights, and a displacement if there is one.
fn triple(words: &[&[u8]], with_offset: bool) -> Option<Reference> {
    let vertex = |place: usize| python_int(words.get(place)?);
    let number = |place: usize| Some(stored(python_float(words.get(place)?)?));
    let numbers = |from: usize| Some([number(from)?, number(from + 1)?, number(from + 2)?]);
    Some(Reference {
        vertices: [vertex(0)?, vertex(1)?, vertex(2)?],
        weights: numbers(3)?,
        offset: if with_offset { numbers(6)? } else { [0.0; 3] },
        line: 0,
    })
}

/// Python's `isnumeric()`: no sign, no point.
fn is_numeric(word: &str) -> bool {
    !word.is_empty() && word.chars().all(char::is_numeric)
}
