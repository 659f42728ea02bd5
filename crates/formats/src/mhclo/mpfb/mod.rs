//! An asset as MPFB reads it (`docs/loaders/mpfb/clothes.md#rows-of-an-asset`): line by line, where
//! a section ends at the first line of another sort, and that line is thrown away.

pub mod in_order;

use std::collections::BTreeMap;

use super::reading::{Reader, Stopped};
use crate::{python_float, python_int};
use in_order::{InOrder, Row};
use mhlint_diag::EXAMPLES;

type Word<'l> = (usize, &'l [u8]);

/// How it reads. Its sections and rows are in [`Flow`].
pub static READER: Reader = Reader {
    knows: |entry| !entry.has_colon,
    is_fault: |_, _| true,
    passes_over: &[],
    needs_value: |keyword| VALUED.contains(&keyword),
    stop: |clothes| clothes.flow.stop.as_ref().map(Stop::stopped),
};

/// What comes of the lines.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Flow {
    /// Rows that are taken.
    pub rows: usize,
    /// Numbers of the list that are taken, a range counting as one more.
    pub listed: usize,
    /// The first line at which the reader stops for good.
    pub stop: Option<Stop>,
    /// Where a section ended, or a line of an unknown keyword stood, with lines of numbers behind
    /// it that nothing reads.
    pub gaps: Vec<Gap>,
    /// A range of the list in front of the first row, by its line: it counts as a row.
    pub early_range: Option<u32>,
    /// Ranges that a dash at the end of their line leaves without an end, by line.
    pub cut: Vec<u32>,
    /// Ranges that go down, by line.
    pub reversed: Vec<u32>,
    /// Negative numbers in the list, by line.
    pub negative: Vec<u32>,
    /// Numbers on the line of the keyword of the list, by line.
    pub beside: Option<u32>,
    /// Lines of the keywords that are read, the last of each.
    read: BTreeMap<&'static str, u32>,
}

/// A line at which the reader stops for good.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Stop {
    /// Line from 1.
    pub line: u32,
    /// Why.
    pub cause: StopCause,
    /// The word that is wrong, or the keyword.
    pub word: Box<str>,
}

/// Why a reader stops.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum StopCause {
    /// A keyword without its value.
    NoValue,
    /// A keyword whose value is not the number that it has to be.
    Value,
    /// A row of so many words.
    Words(usize),
    /// A word of a row that is not a number.
    RowWord,
    /// A scale with too few words.
    ShortScale,
    /// A word of a scale that is not a number.
    ScaleWord,
    /// A word of the list that is not a number.
    ListWord,
}

impl Stop {
    fn stopped(&self) -> Stopped {
        let exception = self.cause.exception();
        Stopped {
            line: self.line,
            exception,
            reason: format!("`{}` cannot be read", self.word),
        }
    }
}

impl StopCause {
    /// What the loader stops with.
    const fn exception(self) -> &'static str {
        match self {
            Self::NoValue | Self::Words(_) | Self::ShortScale => "IndexError",
            Self::Value | Self::RowWord | Self::ScaleWord | Self::ListWord => "ValueError",
        }
    }
}

/// Lines of numbers that nothing reads.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Gap {
    /// What the line in front of them ended.
    pub ended: Option<Part>,
    /// That line, from 1.
    pub line: u32,
    /// Its first word; empty for an empty line.
    pub word: Box<str>,
    /// Rows or numbers that were taken of the section before.
    pub taken: usize,
    /// Lines of numbers behind it.
    pub lines: u64,
}

/// A section.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Part {
    /// The rows.
    Rows,
    /// The list of vertices to hide.
    List,
}

/// Keywords that need a value, and all that are read.
const VALUED: [&str; 6] = ["material", "obj_file", "name", "uuid", "tag", "z_depth"];
const SCALES: [&str; 3] = ["x_scale", "y_scale", "z_scale"];

/// Takes the lines in turn.
#[derive(Default)]
pub(super) struct Machine {
    flow: Flow,
    part: Option<Part>,
    listed_here: usize,
    last: Option<i64>,
    line: u32,
    /// The values themselves, for who asks for them.
    kept: Option<InOrder>,
}

impl Flow {
    /// The last line with this keyword that is read.
    pub fn line_of(&self, keyword: &str) -> Option<u32> {
        self.read.get(keyword).copied()
    }
}

impl Machine {
    /// One that keeps the values that it takes.
    pub(super) fn keeping() -> Self {
        Self {
            kept: Some(InOrder::default()),
            ..Self::default()
        }
    }

    /// Whether nothing more is taken.
    pub(super) fn has_stopped(&self) -> bool {
        self.flow.stop.is_some()
    }

    /// The values up to where the reader stops, and that place.
    pub(super) fn into_kept(self) -> (InOrder, Option<Stop>) {
        (self.kept.unwrap_or_default(), self.flow.stop)
    }

    pub(super) fn take(&mut self, line: u32, words: &[Word<'_>]) {
        self.line = line;
        if self.flow.stop.is_some() {
            return;
        }
        let Some((_, first)) = words.first() else {
            return self.end("");
        };
        let first = String::from_utf8_lossy(first);
        match (&*first, self.part) {
            ("#", _) => {}
            // Kept and never used; real assets have it among the rows, and all of these are taken
            // (`docs/loaders/mpfb/clothes.md#known-assets`).
            (word, _) if word.starts_with("vertexboneweights") => {}
            ("material", _) => self.keyword(&first, words),
            (word, Some(Part::Rows)) if is_digits(word) => self.row(words),
            (word, Some(Part::List)) if is_digits(word) => self.list(words),
            (word, Some(_)) => self.end(word),
            (word, None) if is_digits(word) => {
                if let Some(gap) = self.flow.gaps.last_mut() {
                    gap.lines = gap.lines.saturating_add(1);
                }
            }
            (word, None) => self.keyword(word, words),
        }
    }

    pub(super) fn finish(mut self) -> Flow {
        let is_thrown_away = |gap: &Gap| gap.ended.is_some() && !gap.word.is_empty();
        self.flow
            .gaps
            .retain(|gap| gap.lines > 0 || is_thrown_away(gap));
        self.flow
    }

    /// Ends the section, if there is one.
    fn end(&mut self, word: &str) {
        let Some(part) = self.part.take() else { return };
        let taken = if part == Part::Rows {
            self.flow.rows
        } else {
            self.listed_here
        };
        self.gap(Some(part), word, taken);
        // Rows behind such a list are gone for the application; that is said once, and what is in
        // them is still looked at.
        if part == Part::List && word == "verts" && self.kept.is_none() {
            self.part = Some(Part::Rows);
        }
    }

    fn gap(&mut self, ended: Option<Part>, word: &str, taken: usize) {
        let is_idle = |gap: &Gap| gap.lines == 0 && gap.ended.is_none();
        if self.flow.gaps.last().is_some_and(is_idle) || self.flow.gaps.len() >= 4 * EXAMPLES {
            self.flow.gaps.pop();
        }
        self.flow.gaps.push(Gap {
            ended,
            line: self.line,
            word: word.into(),
            taken,
            lines: 0,
        });
    }

    fn stop(&mut self, cause: StopCause, word: &[u8]) {
        let word = String::from_utf8_lossy(word).into();
        self.flow.stop = Some(Stop {
            line: self.line,
            cause,
            word,
        });
    }

    fn keyword(&mut self, word: &str, words: &[Word<'_>]) {
        let (key, value) = (
            words.first().map_or(&b""[..], |(_, key)| *key),
            words.get(1).map(|(_, value)| *value),
        );
        match word {
            "verts" => match value {
                Some(value) if python_int(value).is_none() => self.stop(StopCause::Value, value),
                Some(_) => self.open(Part::Rows),
                None => self.gap(None, word, 0),
            },
            "delete_verts" => {
                if value.is_some() {
                    self.flow.beside.get_or_insert(self.line);
                }
                self.open(Part::List);
            }
            _ if SCALES.contains(&word) => self.scale(words),
            _ => match VALUED.into_iter().find(|known| *known == word) {
                Some(_) if value.is_none() => self.stop(StopCause::NoValue, key),
                Some("z_depth") if value.and_then(python_int).is_none() => {
                    self.stop(StopCause::Value, value.unwrap_or_default());
                }
                Some(known) => {
                    self.flow.read.insert(known, self.line);
                    if let Some(kept) = self.kept.as_mut().filter(|_| known == "obj_file") {
                        kept.obj_file =
                            value.map(|value| String::from_utf8_lossy(value).into_owned());
                    }
                }
                None => self.gap(None, word, 0),
            },
        }
    }

    fn open(&mut self, part: Part) {
        self.part = Some(part);
        self.listed_here = 0;
        self.last = None;
    }

    fn scale(&mut self, words: &[Word<'_>]) {
        let [key, a, b, distance, ..] = words else {
            let key = words.first().map_or(&b""[..], |(_, key)| *key);
            return self.stop(StopCause::ShortScale, key);
        };
        let vertices = whole(*a).and_then(|a| Ok([a, whole(*b)?]));
        let scale = match vertices.and_then(|vertices| Ok((vertices, number(*distance)?))) {
            Ok(scale) => scale,
            Err(word) => return self.stop(StopCause::ScaleWord, word),
        };
        if let Some((axis, known)) = (0..)
            .zip(SCALES)
            .find(|(_, known)| known.as_bytes() == key.1)
        {
            self.flow.read.insert(known, self.line);
            if let Some(slot) = self
                .kept
                .as_mut()
                .and_then(|kept| kept.scales.get_mut::<usize>(axis))
            {
                *slot = Some(scale);
            }
        }
    }

    fn row(&mut self, words: &[Word<'_>]) {
        let row = match row(words) {
            Ok(row) => row,
            Err(word) => return self.stop(StopCause::RowWord, word),
        };
        if (2..9).contains(&words.len()) {
            let first = words.first().map_or(&b""[..], |(_, word)| *word);
            return self.stop(StopCause::Words(words.len()), first);
        }
        self.flow.rows += 1;
        if let Some(kept) = &mut self.kept {
            kept.rows.push(row);
        }
    }

    fn list(&mut self, words: &[Word<'_>]) {
        let mut is_range = false;
        for (_, word) in words {
            if *word == b"-" {
                is_range = true;
                continue;
            }
            let Some(number) = python_int(word) else {
                return self.stop(StopCause::ListWord, word);
            };
            if is_range {
                self.range(number);
            }
            if let Some(kept) = &mut self.kept {
                kept.hide(number, is_range);
            }
            if number < 0 {
                note(&mut self.flow.negative, self.line);
            }
            self.flow.listed += 1;
            self.listed_here += 1;
            self.last = Some(number);
            is_range = false;
        }
        if is_range {
            note(&mut self.flow.cut, self.line);
        }
    }

    fn range(&mut self, end: i64) {
        self.flow.listed += 1;
        if self.flow.rows == 0 {
            self.flow.early_range.get_or_insert(self.line);
        }
        if self.last.is_some_and(|first| end < first) {
            note(&mut self.flow.reversed, self.line);
        }
    }
}

/// Vertices, weights and offset of a row; one word is all three vertices. Of a line of another
/// length only whether its words are numbers counts.
///
/// # Errors
/// The first word that is not the number that it has to be.
fn row<'l>(words: &[Word<'l>]) -> Result<Row, &'l [u8]> {
    let (mut vertices, mut numbers) = ([0; 3], [0.0; 6]);
    for (slot, word) in vertices.iter_mut().zip(words) {
        *slot = whole(*word)?;
    }
    for (slot, word) in numbers.iter_mut().zip(words.iter().skip(3)) {
        *slot = number(*word)?;
    }
    let ([u, v, w, offset @ ..], [vertex, ..]) = (numbers, vertices);
    Ok(if words.len() == 1 {
        ([vertex; 3], [1.0, 0.0, 0.0], [0.0; 3])
    } else {
        (vertices, [u, v, w], offset)
    })
}

fn whole((_, word): Word<'_>) -> Result<i64, &[u8]> {
    python_int(word).ok_or(word)
}

fn number((_, word): Word<'_>) -> Result<f64, &[u8]> {
    python_float(word).ok_or(word)
}

fn note(lines: &mut Vec<u32>, line: u32) {
    if lines.len() < EXAMPLES {
        lines.push(line);
    }
}

/// Python's `isdigit()`, but for rare digits of other scripts.
fn is_digits(word: &str) -> bool {
    !word.is_empty() && word.chars().all(char::is_numeric)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mhclo::parse;

    fn of(text: &str) -> Flow {
        parse(text.as_bytes(), None).flow
    }

    fn gaps(text: &str) -> Vec<(u32, String, usize, u64)> {
        of(text)
            .gaps
            .into_iter()
            .map(|gap| (gap.line, gap.word.into(), gap.taken, gap.lines))
            .collect()
    }

    #[test]
    fn a_line_of_another_sort_ends_the_rows_and_is_lost() {
        let row = "1 2 3 1 0 0 0 0 0\n";
        let text = format!(
            "verts 0\nvertexboneweights_file a.mhw\n{row}# a note\nmaterial a.mhmat\n{row}7\n\n"
        );
        assert_eq!(of(&text).rows, 3);
        assert_eq!(
            gaps(&format!("verts 0\ntag a\n{row}")),
            [(2, "tag".to_owned(), 0, 1)]
        );
        assert_eq!(
            gaps(&format!("verts 0\n{row}#note\n{row}{row}")),
            [(3, "#note".to_owned(), 1, 2)]
        );
        assert_eq!(
            gaps(&format!("verts 0\n{row}\n{row}")),
            [(3, String::new(), 1, 1)]
        );
        assert_eq!(
            gaps(&format!("verts 0\n{row}delete_verts\n5 - 7\n")),
            [(3, "delete_verts".to_owned(), 1, 1)]
        );
        assert_eq!(
            gaps(&format!("verts 0\n{row}\ndelete_vertices\n5\n")),
            [(4, "delete_vertices".to_owned(), 0, 1)]
        );
        assert_eq!(
            gaps(&format!("verts 0\n{row}\ndelete_verts\n\n5 - 7\n")),
            [(5, String::new(), 0, 1)]
        );
        assert_eq!(
            gaps(&format!("verts 0\n{row}\ndelete_verts\n5 - 7\n\ntag x\n")),
            []
        );
        assert_eq!(
            gaps(&format!("verts 0\n{row}\ndelete_verts\n5-7\n")),
            [(5, "5-7".to_owned(), 0, 0)]
        );
        assert_eq!(of(&format!("verts\n{row}")).gaps.len(), 1);
        assert_eq!(
            of("tag a\nverts 0\n5\nuuid 3\n\nname n\n").line_of("uuid"),
            None
        );
        assert_eq!(of("tag a\nverts 0\n5\n\nuuid 3\n").line_of("uuid"), Some(5));
    }

    #[test]
    fn a_list_of_vertices_to_hide() {
        let flow = of("verts 0\n5\n\ndelete_verts 3\n5 - 7 9 -\n7 - 5 -2\n");
        assert_eq!(
            (flow.beside, flow.cut, flow.reversed, flow.negative),
            (Some(4), vec![5], vec![6], vec![6])
        );
        assert_eq!(
            of("delete_verts\n1 - 2\n\nverts 0\n5\n").early_range,
            Some(2)
        );
        assert_eq!(of("delete_verts\n1 2\n\nverts 0\n5\n").early_range, None);
    }

    #[test]
    fn where_the_reader_stops() {
        for (text, cause, word) in [
            ("name\n", StopCause::NoValue, "name"),
            ("z_depth a\n", StopCause::Value, "a"),
            ("verts x\n", StopCause::Value, "x"),
            ("x_scale 1 2\n", StopCause::ShortScale, "x_scale"),
            ("x_scale 1 2 3,0\n", StopCause::ScaleWord, "3,0"),
            ("verts 0\n1 2 3 1 0 0\n", StopCause::Words(6), "1"),
            ("verts 0\n1 2 3 1,0 0 0 0 0 0\n", StopCause::RowWord, "1,0"),
            ("delete_verts\n5 to 7\n", StopCause::ListWord, "to"),
            ("delete_verts\n5 6-7\n", StopCause::ListWord, "6-7"),
        ] {
            let stop = of(text)
                .stop
                .map(|stop| (stop.cause, stop.word.to_string()));
            assert_eq!(stop, Some((cause, word.to_owned())), "{text}");
        }
        assert_eq!(of("verts 0\n1 2 3 nan 0 0 0 0 0 x\n\u{663}\n").rows, 2);
    }
}
