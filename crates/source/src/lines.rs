//! Texts to lines; and byte offsets to lines, columns and excerpts, as late as possible: only for
//! what is printed.
//!
//! Lines end as in the applications (Python's universal newlines): `\n`, `\r\n` or a lone `\r`.

use std::ops::Range;

use mhlint_diag::Excerpt;

/// All lines of a text, and the bytes of each with its end.
pub fn lines(text: &[u8]) -> impl Iterator<Item = (Range<usize>, &[u8])> {
    let mut start = 0;
    std::iter::from_fn(move || {
        let rest = text.get(start..).filter(|rest| !rest.is_empty())?;
        let (line, length) = first_line(rest);
        start += length;
        Some((start - length..start, line))
    })
}

/// The first line of a text, and its length with its end: `\n`, `\r\n` or a lone `\r`.
pub fn first_line(text: &[u8]) -> (&[u8], usize) {
    let length = text
        .iter()
        .position(|byte| matches!(byte, b'\n' | b'\r'))
        .unwrap_or(text.len());
    let is_pair = text.get(length..length + 2) == Some(b"\r\n");
    let (line, tail) = text.split_at(length);
    (line, length + if is_pair { 2 } else { tail.len().min(1) })
}

/// Longest line that is quoted; longer ones (minified or bulk data) say nothing to a reader.
const LONGEST_QUOTED_LINE: usize = 400;

/// Line and column, counted from 1; columns in characters.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Position {
    /// Line, from 1.
    pub line: u32,
    /// Column, from 1.
    pub column: u32,
}

/// Bytes between two places up to which the characters are counted once for all.
const COUNTED_STEP: usize = 4096;

#[cfg(any(test, feature = "counted"))]
thread_local! {
    /// Bytes gone through by this thread: a bound on the work, for tests.
    pub static PASSED: std::cell::Cell<usize> = const { std::cell::Cell::new(0) };
}

/// Where the lines of a text begin, found once for any number of questions.
pub struct Lines<'t> {
    bytes: &'t [u8],
    /// First byte of each line.
    starts: Vec<usize>,
    /// Bytes and the number of characters up to there, in steps: a line may be as long as the text.
    counted: Vec<(usize, usize)>,
}

impl<'t> Lines<'t> {
    /// The lines of a text.
    pub fn of(bytes: &'t [u8]) -> Self {
        #[cfg(any(test, feature = "counted"))]
        PASSED.set(PASSED.get() + bytes.len());
        let ended = lines(bytes).filter(|(range, line)| range.len() > line.len());
        let starts = std::iter::once(0)
            .chain(ended.map(|(range, _)| range.end))
            .collect();
        Self {
            bytes,
            starts,
            counted: counted(bytes),
        }
    }

    /// Position of a byte offset. Offsets beyond the end give the end.
    pub fn position(&self, offset: usize) -> Position {
        let offset = offset.min(self.bytes.len());
        let line = self.line_of(offset);
        let column = self.column(self.start(line).min(offset), offset);
        let number = |count: usize| u32::try_from(count).unwrap_or(u32::MAX - 1) + 1;
        Position {
            line: number(line),
            column: number(column),
        }
    }

    /// Byte range of a line (from 1) without its line end.
    pub fn span(&self, line: u32) -> Option<Range<usize>> {
        let line = usize::try_from(line.saturating_sub(1)).ok()?;
        let start = *self.starts.get(line)?;
        Some(start..self.end(line))
    }

    /// The marked range with one line of context before and after, if it is fit to be quoted.
    pub fn excerpt(&self, mark: Range<usize>) -> Option<Excerpt> {
        let start = mark.start.min(self.bytes.len());
        let line = self.line_of(start);
        // A mark may begin within a line end.
        let line_end = self.end(line).max(start);
        let first_line = line.saturating_sub(1);
        let first = self.start(first_line);
        let last = if line + 1 < self.starts.len() {
            self.end(line + 1)
        } else {
            line_end
        };
        if last - first > 3 * LONGEST_QUOTED_LINE
            || line_end - self.start(line) > LONGEST_QUOTED_LINE
        {
            return None;
        }
        let text = std::str::from_utf8(self.bytes.get(first..last)?).ok()?;
        let mark_end = mark.end.clamp(start, line_end);
        Some(Excerpt {
            text: text.to_owned(),
            first_line: u32::try_from(first_line).ok()? + 1,
            mark: start - first..mark_end - first,
        })
    }

    /// The line that an offset lies in, from 0.
    fn line_of(&self, offset: usize) -> usize {
        self.starts
            .partition_point(|start| *start <= offset)
            .saturating_sub(1)
    }

    fn start(&self, line: usize) -> usize {
        self.starts.get(line).copied().unwrap_or(self.bytes.len())
    }

    /// Where the line end of a line begins.
    fn end(&self, line: usize) -> usize {
        let Some(next) = self.starts.get(line + 1) else {
            return self.bytes.len();
        };
        let upto = self.bytes.get(self.start(line)..*next).unwrap_or_default();
        next - if upto.ends_with(b"\r\n") { 2 } else { 1 }
    }

    /// Characters between the beginning of a line and an offset in it.
    fn column(&self, start: usize, offset: usize) -> usize {
        if offset - start > COUNTED_STEP {
            return self.characters(offset) - self.characters(start);
        }
        #[cfg(any(test, feature = "counted"))]
        PASSED.set(PASSED.get() + (offset - start));
        String::from_utf8_lossy(self.bytes.get(start..offset).unwrap_or_default())
            .chars()
            .count()
    }

    /// Characters before an offset.
    fn characters(&self, offset: usize) -> usize {
        let step = self
            .counted
            .partition_point(|(at, _)| *at <= offset)
            .checked_sub(1);
        let (at, before) = step
            .and_then(|step| self.counted.get(step))
            .copied()
            .unwrap_or_default();
        #[cfg(any(test, feature = "counted"))]
        PASSED.set(PASSED.get() + (offset - at));
        before
            + String::from_utf8_lossy(self.bytes.get(at..offset).unwrap_or_default())
                .chars()
                .count()
    }
}

/// Characters up to some places, all of them at the beginning of a character.
fn counted(bytes: &[u8]) -> Vec<(usize, usize)> {
    let mut counted = vec![(0, 0)];
    let (mut at, mut characters, mut next) = (0, 0, COUNTED_STEP);
    for chunk in bytes.utf8_chunks() {
        for character in chunk.valid().chars() {
            at += character.len_utf8();
            characters += 1;
            if at >= next {
                counted.push((at, characters));
                next = at + COUNTED_STEP;
            }
        }
        at += chunk.invalid().len();
        characters += usize::from(!chunk.invalid().is_empty());
    }
    counted
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_line_ends_count_once() {
        let text = b"a\nb\r\nc\rd";
        let at = |offset| {
            let Position { line, column } = Lines::of(text).position(offset);
            (line, column)
        };
        assert_eq!(
            (at(0), at(2), at(5), at(7), at(99)),
            ((1, 1), (2, 1), (3, 1), (4, 1), (4, 2))
        );
        assert_eq!(Lines::of(text).span(2), Some(2..3));
        assert_eq!(Lines::of(text).span(4), Some(7..8));
        assert_eq!(Lines::of(text).span(5), None);
    }

    #[test]
    fn excerpt_has_one_line_around() {
        let found = Lines::of(b"one\ntwo\nthree\nfour\n").excerpt(4..7).unwrap();
        assert_eq!(
            (found.text.as_str(), found.first_line),
            ("one\ntwo\nthree", 1)
        );
        assert_eq!(found.mark, 4..7);
    }

    #[test]
    fn columns_are_characters() {
        assert_eq!(
            Lines::of("äb".as_bytes()).position(2),
            Position { line: 1, column: 2 }
        );
    }

    #[test]
    fn characters_are_counted_alike_far_into_a_line() {
        // Whole letters and bytes that are none, in a line longer than a step and after one.
        let line: Vec<u8> = b"a\xc3\xa4\xff\xe2\x82"
            .iter()
            .copied()
            .cycle()
            .take(3 * COUNTED_STEP)
            .collect();
        let text = [b"x\n".as_slice(), &line, b"\n", &line].concat();
        let lines = Lines::of(&text);
        for start in [2, line.len() + 3] {
            for length in [
                0,
                1,
                COUNTED_STEP - 1,
                COUNTED_STEP,
                2 * COUNTED_STEP + 3,
                line.len(),
            ] {
                let column = String::from_utf8_lossy(&text[start..start + length])
                    .chars()
                    .count()
                    + 1;
                assert_eq!(
                    lines.position(start + length).column as usize,
                    column,
                    "{start} {length}"
                );
            }
        }
    }

    proptest::proptest! {
        #[test]
        fn every_offset_has_a_place_and_every_line_a_span(
            bytes in proptest::collection::vec(proptest::sample::select(b"a\n\r\xc3\xa4 ".to_vec()), 0..60),
            offset in 0_usize..70,
            length in 0_usize..20,
        ) {
            let lines = Lines::of(&bytes);
            let Position { line, column } = lines.position(offset);
            let span = lines.span(line).unwrap();
            let offset = offset.min(bytes.len());
            // An offset between the two bytes of a line end belongs to the line before it.
            proptest::prop_assert!(span.start <= offset && offset <= span.end + 1);
            proptest::prop_assert!(column as usize <= offset - span.start + 1);
            if let Some(found) = lines.excerpt(offset..offset + length) {
                proptest::prop_assert!(found.mark.start <= found.mark.end && found.mark.end <= found.text.len());
                proptest::prop_assert!(found.first_line == line || found.first_line + 1 == line);
            }
        }
    }
}
