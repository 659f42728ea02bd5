//! The lines of an asset in turn: which section they stand in decides what they are.

use std::ops::Range;

use super::header::{Header, Words};
use super::mpfb::Machine;
use super::remarks::Remarks;
use super::{Clothes, Fault, FaultKind, Reference, Scale, Section};
use crate::fields::fields;
use crate::target::MeshSize;
use crate::{python_float, python_int, stored};
use mhlint_source::lines;

type Word<'l> = (usize, &'l [u8]);

#[derive(Default)]
struct Reader {
    clothes: Clothes,
    header: Header,
    remarks: Remarks,
    section: Section,
    mesh: Option<MeshSize>,
    line: u32,
    /// Where the line starts.
    start: usize,
    /// Last index of the delete section; a range may begin on the next line.
    last: Option<i64>,
}

/// Parses an asset for a mesh of this size, if that is known.
pub fn parse(text: &[u8], mesh: Option<MeshSize>) -> Clothes {
    let mut reader = Reader {
        mesh,
        ..Reader::default()
    };
    let mut machine = Machine::default();
    reader.clothes.rows.mesh = mesh;
    for (Range { start, .. }, line) in lines(text) {
        reader.line = reader.line.saturating_add(1);
        reader.start = start;
        let words = fields(line);
        let is_row = words
            .first()
            .is_some_and(|(_, word)| is_numeric(&String::from_utf8_lossy(word)));
        reader.header.scan(reader.words(&words), line, is_row);
        machine.take(reader.line, &words);
        reader.take(&words);
    }
    let Reader {
        clothes,
        header,
        remarks,
        ..
    } = reader;
    let outdated = remarks.format(&header.entries);
    Clothes {
        entries: header.entries,
        scanned: header.scanned,
        flow: machine.finish(),
        outdated,
        ..clothes
    }
}

impl Reader {
    fn words<'l>(&self, words: &'l [Word<'l>]) -> Words<'l> {
        Words {
            start: self.start,
            list: words,
            line: self.line,
        }
    }

    fn take(&mut self, words: &[Word<'_>]) {
        let Some((_, first)) = words.first() else {
            return;
        };
        if first.starts_with(b"#") {
            self.remarks.take(words);
            return self.header.remark(self.words(words), self.section);
        }
        let keyword =
            String::from_utf8_lossy(first.strip_suffix(b":").unwrap_or(first)).into_owned();
        match (self.section, keyword.as_str()) {
            (_, "weights") => self.fault(FaultKind::OldFormat, words.first()),
            (_, "verts") => self.open(Section::Vertices, words),
            (_, "delete_verts") => self.open(Section::Deleted, words),
            (Section::Deleted, _) => self.delete(words),
            (Section::Vertices, word) if is_numeric(word) => self.vertex(words),
            (Section::Vertices, word) if is_meant_as_row(word, words) => {
                self.fault(FaultKind::DroppedRow, words.first());
            }
            (Section::Header, word) if is_numeric(word) => {
                self.remarks.row(words.len());
                self.fault(FaultKind::NumbersInHeader, words.first());
            }
            (_, word) => self.keyword(word, words),
        }
    }

    fn open(&mut self, section: Section, words: &[Word<'_>]) {
        self.section = section;
        self.header.take(self.words(words), section);
    }

    fn fault(&mut self, kind: FaultKind, word: Option<&Word<'_>>) {
        let (at, word) = word.copied().unwrap_or_default();
        let span = self.start + at..self.start + at + word.len();
        let word = String::from_utf8_lossy(word).into();
        self.clothes.faults.add(Fault {
            line: self.line,
            kind,
            word,
            span,
        });
    }

    fn keyword(&mut self, word: &str, words: &[Word<'_>]) {
        self.header.take(self.words(words), self.section);
        // A keyword alone is passed over.
        let Some(value) = words.get(1) else {
            if is_valued(word) {
                self.fault(FaultKind::MissingValue, words.first());
            }
            return;
        };
        match word {
            "x_scale" => self.scale(0, words),
            "y_scale" => self.scale(1, words),
            "z_scale" => self.scale(2, words),
            "z_depth" | "version" if python_int(value.1).is_none() => {
                self.fault(FaultKind::NotWhole, Some(value));
            }
            _ => {}
        }
    }

    fn scale(&mut self, axis: usize, words: &[Word<'_>]) {
        let [_, a, b, distance, ..] = words else {
            // The first that is not a number is met before the end of the line.
            let wrong = words
                .iter()
                .skip(1)
                .find(|(_, word)| python_int(word).is_none());
            return match wrong {
                Some(wrong) => self.fault(FaultKind::ScaleWord, Some(wrong)),
                None => self.fault(FaultKind::ShortScale, words.first()),
            };
        };
        let vertices = [a, b].map(|(_, word)| python_int(word));
        let wrong = [a, b]
            .into_iter()
            .find(|(_, word)| python_int(word).is_none());
        match (vertices, python_float(distance.1)) {
            ([Some(a), Some(b)], Some(distance)) => {
                if let Some(slot) = self.clothes.scales.get_mut(axis) {
                    *slot = Some(Scale {
                        vertices: [a, b],
                        distance: stored(distance),
                        line: self.line,
                    });
                }
            }
            _ => self.fault(FaultKind::ScaleWord, Some(wrong.unwrap_or(distance))),
        }
    }

    fn vertex(&mut self, words: &[Word<'_>]) {
        let read = if words.len() == 1 {
            exact_vertex(words)
        } else {
            triple(words)
        };
        match read {
            Ok(reference) => {
                let reference = Reference {
                    line: self.line,
                    ..reference
                };
                self.clothes.rows.count(&reference, words.len() > 1);
                self.clothes.references.push(reference);
            }
            Err(BadRow::Short) => self.fault(FaultKind::FieldCount(words.len()), words.first()),
            Err(BadRow::Word(place)) => self.fault(FaultKind::RowWord, words.get(place)),
        }
    }

    fn delete(&mut self, words: &[Word<'_>]) {
        let mut is_range = false;
        for word in words {
            match (word.1, python_int(word.1), self.last) {
                (b"-", ..) => is_range = true,
                (_, Some(_), None) if is_range => {
                    return self.fault(FaultKind::OpenRange, words.first());
                }
                (_, Some(index), last) => {
                    let first = last.filter(|_| is_range).unwrap_or(index);
                    self.clothes.deleted.push((first, index));
                    self.clothes
                        .deletes
                        .count(self.line, (first, index), self.mesh);
                    self.last = Some(index);
                    is_range = false;
                }
                (_, None, _) => {
                    self.header.take(self.words(words), Section::Deleted);
                    return self.fault(FaultKind::DeleteWord, Some(word));
                }
            }
        }
        if let Some(last) = self.last.filter(|_| is_range) {
            self.clothes.deletes.cut_ranges.add(self.line, last);
        }
    }
}

/// Why a line among the rows gives no vertex.
enum BadRow {
    /// Too few words.
    Short,
    /// The word of this number is not a number.
    Word(usize),
}

/// A line with one number is that base vertex itself.
fn exact_vertex(words: &[Word<'_>]) -> Result<Reference, BadRow> {
    let vertex = words
        .first()
        .and_then(|(_, word)| python_int(word))
        .ok_or(BadRow::Word(0))?;
    Ok(Reference {
        vertices: [vertex; 3],
        weights: [1.0, 0.0, 0.0],
        offset: [0.0; 3],
        line: 0,
    })
}

/// Three base vertices, their weights, and a displacement if there is one. Read in the order of the
/// words, up to the first that is missing or wrong.
fn triple(words: &[Word<'_>]) -> Result<Reference, BadRow> {
    let word = |place: usize| words.get(place).map(|(_, word)| *word).ok_or(BadRow::Short);
    let vertex = |place: usize| python_int(word(place)?).ok_or(BadRow::Word(place));
    let number = |place: usize| {
        Ok(stored(
            python_float(word(place)?).ok_or(BadRow::Word(place))?,
        ))
    };
    let numbers = |from: usize| Ok([number(from)?, number(from + 1)?, number(from + 2)?]);
    Ok(Reference {
        vertices: [vertex(0)?, vertex(1)?, vertex(2)?],
        weights: numbers(3)?,
        offset: if words.len() > 6 {
            numbers(6)?
        } else {
            [0.0; 3]
        },
        line: 0,
    })
}

/// Python's `isnumeric()`: no sign, no point.
fn is_numeric(word: &str) -> bool {
    !word.is_empty() && word.chars().all(char::is_numeric)
}

/// Whether a line that is no row looks like one: it begins with a number of another form, or has as
/// many numbers.
fn is_meant_as_row(first: &str, words: &[Word<'_>]) -> bool {
    let begins = first
        .trim_start_matches(['+', '-', '.'])
        .starts_with(|first: char| first.is_ascii_digit());
    let rest = words.get(1..).unwrap_or_default();
    let has_numbers =
        matches!(rest.len(), 5 | 8) && rest.iter().all(|(_, word)| python_float(word).is_some());
    begins || has_numbers
}

/// Keywords that say nothing without a value.
fn is_valued(word: &str) -> bool {
    let valued = [
        "name",
        "uuid",
        "obj_file",
        "material",
        "vertexboneweights_file",
        "z_depth",
        "basemesh",
        "version",
        "max_pole",
    ];
    valued.contains(&word)
        || word.contains("shear_")
        || matches!(word, "x_scale" | "y_scale" | "z_scale")
}
