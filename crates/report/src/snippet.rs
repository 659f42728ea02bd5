//! The quoted lines of a finding, made harmless for a terminal and cut to its width.

use std::ops::Range;

use crate::printable;
use mhlint_diag::Excerpt;

/// Columns that line numbers and frame take.
const FRAME: usize = 12;
/// Characters kept before the mark when a line has to be cut at its start.
const LEAD: usize = 20;

/// Lines to quote.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Snippet {
    /// The lines, joined by `\n`.
    pub(super) text: String,
    /// Number of the first line, counted from 1.
    pub(super) first_line: usize,
    /// The marked bytes within `text`.
    pub(super) mark: Range<usize>,
}

/// Prepares an excerpt for `width` columns.
pub(super) fn snippet(excerpt: &Excerpt, width: usize) -> Option<Snippet> {
    let before = excerpt.text.get(..excerpt.mark.start)?;
    let marked = excerpt.text.get(excerpt.mark.clone())?;
    let after = excerpt.text.get(excerpt.mark.end..)?;
    let (above, lead) = before
        .rsplit_once(['\n', '\r'])
        .map_or(("", before), |(above, lead)| (above, lead));
    let (trail, below) = after.split_once(['\n', '\r']).unwrap_or((after, ""));
    let room = width.saturating_sub(FRAME).max(40);
    let mut text = String::new();
    if before.len() > lead.len() {
        text.push_str(&cut(&printable(above.trim_end_matches(['\r', '\n'])), room));
        text.push('\n');
    }
    let mark = push_marked(&mut text, [lead, marked, trail], room);
    let below = below
        .trim_start_matches('\n')
        .trim_end_matches(['\r', '\n']);
    if !below.is_empty() {
        text.push('\n');
        text.push_str(&cut(&printable(below), room));
    }
    Some(Snippet {
        text,
        first_line: usize::try_from(excerpt.first_line).ok()?,
        mark,
    })
}

/// Adds the marked line, cut at both ends where it does not fit; gives the marked bytes.
fn push_marked(text: &mut String, parts: [&str; 3], room: usize) -> Range<usize> {
    let [lead, marked, trail] = parts.map(printable);
    let length = |part: &str| part.chars().count();
    let fits = length(&lead) + length(&marked) + length(&trail) <= room;
    let skip = if fits {
        0
    } else {
        length(&lead).saturating_sub(LEAD)
    };
    if skip > 0 {
        text.push_str("...");
        text.extend(lead.chars().skip(skip));
    } else {
        text.push_str(&lead);
    }
    let room = room.saturating_sub(length(&lead) - skip);
    let start = text.len();
    text.push_str(&cut(&marked, room));
    let end = text.len();
    // A mark that was cut says already that the line goes on.
    if length(&marked) <= room {
        text.push_str(&cut(&trail, room - length(&marked)));
    }
    start..end
}

/// The text, or as much of it as fits.
fn cut(text: &str, room: usize) -> String {
    if text.chars().count() <= room {
        return text.to_owned();
    }
    text.chars()
        .take(room.saturating_sub(3))
        .chain("...".chars())
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(text: &str, mark: &str, width: usize) -> Snippet {
        let at = text.find(mark).unwrap();
        let excerpt = Excerpt {
            text: text.to_owned(),
            first_line: 7,
            mark: at..at + mark.len(),
        };
        snippet(&excerpt, width).unwrap()
    }

    #[test]
    fn lines_around_the_mark_are_kept() {
        let found = of("one\r\ntwo three\r\nfour", "three", 80);
        assert_eq!(found.text, "one\ntwo three\nfour");
        assert_eq!(&found.text[found.mark], "three");
        assert_eq!(of("two\n\n", "two", 80).text, "two");
        assert_eq!(of("\ntwo", "two", 80).text, "\ntwo");
    }

    #[test]
    fn escape_sequences_are_shown_as_what_they_are() {
        let found = of("a\u{1b}[31m\tbone", "bone", 80);
        assert_eq!(found.text, "a\u{fffd}[31m bone");
        assert_eq!(&found.text[found.mark], "bone");
    }

    #[test]
    fn a_long_line_is_cut_around_the_mark() {
        let found = of(
            &format!("{}MARK{}", "x".repeat(150), "y".repeat(150)),
            "MARK",
            80,
        );
        assert_eq!(&found.text[found.mark.clone()], "MARK");
        assert!(found.text.chars().count() <= 75, "{}", found.text);
        assert!(found.text.starts_with("...x") && found.text.ends_with("y..."));
    }
}
