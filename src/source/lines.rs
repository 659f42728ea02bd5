//! Byte offsets to lines, columns and excerpts, as late as possible: only for what is printed.
//!
//! Lines end as in the applications (Python's universal newlines): `\n`, `\r\n` or a lone `\r`.

use std::ops::Range;

use crate::diag::Excerpt;

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

/// Position of a byte offset. Offsets beyond the end give the end.
pub fn position(bytes: &[u8], offset: usize) -> Position {
    let offset = offset.min(bytes.len());
    let (line, start) = line_of(bytes, offset);
    let column = String::from_utf8_lossy(bytes.get(start..offset).unwrap_or_default()).chars().count();
    Position { line, column: u32::try_from(column).unwrap_or(u32::MAX - 1) + 1 }
}

/// Byte range of a line (from 1) without its line end.
pub fn line_span(bytes: &[u8], line: u32) -> Option<Range<usize>> {
    let mut start = 0;
    let mut number = 1;
    while number < line {
        start = next_line(bytes, start)?;
        number += 1;
    }
    Some(start..end_of_line(bytes, start))
}

/// The marked range with one line of context before and after, if it is fit to be quoted.
pub fn excerpt(bytes: &[u8], mark: Range<usize>) -> Option<Excerpt> {
    let start = mark.start.min(bytes.len());
    let (line, line_start) = line_of(bytes, start);
    let line_end = end_of_line(bytes, start);
    let previous = line.checked_sub(2).and_then(|_| previous_line(bytes, line_start));
    let first = previous.unwrap_or(line_start);
    let last = next_line(bytes, start).map_or(line_end, |next| end_of_line(bytes, next));
    if last - first > 3 * LONGEST_QUOTED_LINE || line_end - line_start > LONGEST_QUOTED_LINE {
        return None;
    }
    let text = std::str::from_utf8(bytes.get(first..last)?).ok()?;
    let mark_end = mark.end.clamp(start, line_end);
    Some(Excerpt {
        text: text.to_owned(),
        first_line: if previous.is_some() { line - 1 } else { line },
        mark: start - first..mark_end - first,
    })
}

fn line_of(bytes: &[u8], offset: usize) -> (u32, usize) {
    let mut line = 1;
    let mut start = 0;
    while let Some(next) = next_line(bytes, start) {
        if next > offset {
            break;
        }
        start = next;
        line += 1;
    }
    (line, start)
}

fn end_of_line(bytes: &[u8], from: usize) -> usize {
    let rest = bytes.get(from..).unwrap_or_default();
    rest.iter().position(|byte| matches!(byte, b'\n' | b'\r')).map_or(bytes.len(), |length| from + length)
}

fn next_line(bytes: &[u8], from: usize) -> Option<usize> {
    let end = end_of_line(bytes, from);
    match (bytes.get(end)?, bytes.get(end + 1)) {
        (b'\r', Some(b'\n')) => Some(end + 2),
        _ => Some(end + 1),
    }
}

fn previous_line(bytes: &[u8], line_start: usize) -> Option<usize> {
    let before = bytes.get(..line_start)?;
    let body =
        before.strip_suffix(b"\r\n").or_else(|| before.strip_suffix(b"\n")).or_else(|| before.strip_suffix(b"\r"))?;
    let start = body.iter().rposition(|byte| matches!(byte, b'\n' | b'\r'));
    Some(start.map_or(0, |at| at + 1))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_line_ends_count_once() {
        let text = b"a\nb\r\nc\rd";
        let at = |offset| {
            let Position { line, column } = position(text, offset);
            (line, column)
        };
        assert_eq!((at(0), at(2), at(5), at(7), at(99)), ((1, 1), (2, 1), (3, 1), (4, 1), (4, 2)));
        assert_eq!(line_span(text, 2), Some(2..3));
        assert_eq!(line_span(text, 4), Some(7..8));
        assert_eq!(line_span(text, 5), None);
    }

    #[test]
    fn excerpt_has_one_line_around() {
        let found = excerpt(b"one\ntwo\nthree\nfour\n", 4..7).unwrap();
        assert_eq!((found.text.as_str(), found.first_line), ("one\ntwo\nthree", 1));
        assert_eq!(found.mark, 4..7);
    }

    #[test]
    fn columns_are_characters() {
        assert_eq!(position("äb".as_bytes(), 2), Position { line: 1, column: 2 });
    }

    proptest::proptest! {
        #[test]
        fn every_offset_has_a_place_and_every_line_a_span(
            bytes in proptest::collection::vec(proptest::sample::select(b"a\n\r\xc3\xa4 ".to_vec()), 0..60),
            offset in 0_usize..70,
            length in 0_usize..20,
        ) {
            let Position { line, column } = position(&bytes, offset);
            let span = line_span(&bytes, line).unwrap();
            let offset = offset.min(bytes.len());
            // An offset between the two bytes of a line end belongs to the line before it.
            proptest::prop_assert!(span.start <= offset && offset <= span.end + 1);
            proptest::prop_assert!(column as usize <= offset - span.start + 1);
            if let Some(found) = excerpt(&bytes, offset..offset + length) {
                proptest::prop_assert!(found.mark.start <= found.mark.end && found.mark.end <= found.text.len());
                proptest::prop_assert!(found.first_line == line || found.first_line + 1 == line);
            }
        }
    }
}
