//! What a loader that splits rows at single blanks makes of a target
//! (`docs/loaders/mpfb/targets.md#rows`).

use crate::fields::fields;
use crate::target::facts::UnreadableField;
use crate::{python_float, python_int, stored};
use mhlint_diag::Tally;

/// Lines that such a loader stops at, or reads otherwise. Without any it reads what all others
/// read.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct BlankFacts {
    /// Rows with white space between their fields that is not one blank.
    pub separators: Tally,
    /// Whether there is a tab in the first of these.
    pub has_tab: bool,
    /// Lines with fewer than four fields, with their number.
    pub few: Tally,
    /// Rows with more than four fields, with their number: it takes the first four.
    pub further: Tally,
    /// The first field that is no number.
    pub unreadable: Option<UnreadableField>,
    /// Lines with such a field.
    pub unreadable_lines: u64,
}

/// Letters of a field that are looked for in its line.
const SOUGHT: usize = 64;

/// Fields that are read.
const READ: usize = 4;

/// Whether a line has anything in it that may be read otherwise: in nearly all targets none has.
pub(super) fn is_odd(line: &[u8]) -> bool {
    let line = line.trim_ascii();
    if line.first() == Some(&b'#') {
        return ends_within(line);
    }
    let odd = |byte: &u8| *byte >= 0x80 || *byte == b'"' || *byte < b' ';
    line.iter().any(odd) || line.windows(2).any(|pair| pair == b"  ")
}

/// Whether Python has the end of a line within it: of a comment only what follows such an end is
/// looked at.
fn ends_within(line: &[u8]) -> bool {
    let may_end = |byte: &u8| *byte >= 0x80 || *byte < b' ';
    line.iter().any(may_end) && String::from_utf8_lossy(line).contains(is_line_break)
}

/// The rows that such a loader reads: the first four fields of each line. Of a line at which it
/// stops there is none.
pub fn rows(text: &[u8]) -> Vec<(i64, [f32; 3])> {
    let text = String::from_utf8_lossy(text);
    let lines = text
        .split(is_line_break)
        .map(str::trim)
        .filter(|line| !is_passed_over(line));
    lines.filter_map(row).collect()
}

fn row(line: &str) -> Option<(i64, [f32; 3])> {
    let mut words = line.split(' ').map(str::as_bytes);
    let index = python_int(words.next()?)?;
    let mut number = || words.next().and_then(python_float).map(stored);
    Some((index, [number()?, number()?, number()?]))
}

fn is_passed_over(line: &str) -> bool {
    line.is_empty() || line.starts_with(['#', '"'])
}

/// Python ends lines at more than `\n`.
const fn is_line_break(letter: char) -> bool {
    matches!(
        letter,
        '\n' | '\r' | '\u{b}' | '\u{c}' | '\u{1c}'..='\u{1e}' | '\u{85}' | '\u{2028}' | '\u{2029}'
    )
}

impl BlankFacts {
    /// Reads one line, which begins `offset` bytes into the text.
    pub(super) fn read(&mut self, number: u32, offset: usize, line: &[u8]) {
        for part in String::from_utf8_lossy(line).split(is_line_break) {
            self.line(number, part, offset, line);
        }
    }

    fn line(&mut self, number: u32, line: &str, offset: usize, raw: &[u8]) {
        let line = line.trim();
        if is_passed_over(line) {
            return;
        }
        let words: Vec<&str> = line.split(' ').collect();
        let count = i64::try_from(words.len()).unwrap_or(i64::MAX);
        let Some(wrong) = words
            .iter()
            .enumerate()
            .take(READ)
            .position(|(at, word)| !fits(at, word.as_bytes()))
        else {
            match words.len() {
                0..READ => self.few.add(number, count),
                READ => {}
                _ => self.further.add(number, count),
            }
            return;
        };
        let loose = fields(line.as_bytes());
        if loose.len() >= READ
            && loose
                .iter()
                .enumerate()
                .take(READ)
                .all(|(at, (_, word))| fits(at, word))
        {
            self.has_tab |= self.separators.count == 0 && line.contains('\t');
            return self.separators.add(number, 0);
        }
        self.unreadable_lines += 1;
        let field = words.get(wrong).copied().unwrap_or_default();
        // Of a long field the beginning shows where it is.
        let sought = field.as_bytes();
        let sought = sought.get(..SOUGHT).unwrap_or(sought);
        let within = raw
            .windows(sought.len().max(1))
            .position(|bytes| bytes == sought)
            .unwrap_or(0);
        let start = offset + within;
        self.unreadable.get_or_insert_with(|| UnreadableField {
            line: number,
            start,
            field: field.to_owned(),
        });
    }
}

/// Whether a field is the number that is expected at its place.
fn fits(at: usize, word: &[u8]) -> bool {
    if at == 0 {
        python_int(word).is_some()
    } else {
        python_float(word).is_some()
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::target::parse;

    /// All lines, whether they are odd or not.
    fn read(text: &[u8]) -> BlankFacts {
        let mut facts = BlankFacts::default();
        let mut offset = 0;
        for (number, line) in (1..).zip(text.split_inclusive(|byte| *byte == b'\n')) {
            facts.read(number, offset, line);
            offset += line.len();
        }
        facts
    }

    fn counts(text: &str) -> (u64, u64, u64, u64) {
        let facts = read(text.as_bytes());
        (
            facts.separators.count,
            facts.few.count,
            facts.further.count,
            facts.unreadable_lines,
        )
    }

    #[test]
    fn rows_are_split_at_single_blanks() {
        assert_eq!(
            counts("# x\n \"x\n\n  1 2 3 4  \r\n1 .5 -1e3 0\n"),
            (0, 0, 0, 0)
        );
        assert_eq!(counts("1  2 3 4\n1\t2 3 4\n1 2\u{a0}3 4\n"), (3, 0, 0, 0));
        assert_eq!(counts("1 2 3\n7\n"), (0, 2, 0, 0));
        assert_eq!(counts("1 2 3 4 5\n1 2 3 4 # note\n"), (0, 0, 2, 0));
        assert_eq!(
            counts("3#c 1 2 3\n// no\n0.0 1 2 3\n1 0x1 2 3\n"),
            (0, 0, 0, 4)
        );
        assert_eq!(counts("1 2 3 4\u{c}1 2\n"), (0, 1, 0, 0));
    }

    #[test]
    fn the_first_four_fields_are_a_row() {
        let rows = rows(b"# x\n 7 1 .5 -2 9 # note\n\n-1 0 0 1\r\n1 2 3\n");
        assert_eq!(rows, [(7, [1.0, 0.5, -2.0]), (-1, [0.0, 0.0, 1.0])]);
    }

    #[test]
    fn a_usual_line_is_not_looked_at_twice() {
        let usual = [
            "# x",
            "#  by  \u{e4}  me\t",
            "  # x",
            "1 .5 -1 0",
            "  1 .5 -1 0 ",
        ];
        assert!(usual.iter().all(|line| !is_odd(line.as_bytes())));
        let odd = [
            "1  2 3 4",
            "1\t2",
            "\"x",
            "1 2\u{a0}3",
            "# x\u{2028}1 2",
            "# x\u{c}1 2",
        ];
        assert!(odd.iter().all(|line| is_odd(line.as_bytes())));
    }

    #[test]
    fn a_comment_with_more_than_one_blank_is_no_reason_to_read_again() {
        let header = "#  This  is  a  target  file  of  M\u{e4}rz\n#\n#   by:  nobody\n";
        assert_eq!(
            parse(format!("{header}1 0 0 1\n").as_bytes(), None)
                .facts
                .blanks,
            None
        );
    }

    proptest! {
        #[test]
        fn what_is_read_line_by_line_is_what_the_whole_text_says(
            text in "([0-9]{1,4}|-?\\.[0-9]{1,3}|[ \t#\"\n\u{c}\u{2028}\u{a0}]|[0-9]{1,3} 0 0 \
                1\n|#  x\n|1 2  3 4\n){0,30}"
        ) {
            let found = parse(text.as_bytes(), None).facts.blanks;
            prop_assert_eq!(found.map(|blanks| *blanks).unwrap_or_default(), read(text.as_bytes()));
        }
    }
}
