//! A line of the head that is missing, in words.

use super::{Text, keywords, sections};
use mhlint_diag::Place;

/// Where a keyword of the head is missed, in words, and what to do; nothing if the finding is
/// elsewhere.
pub(super) fn missing(
    text: &Text<'_, '_>,
    keyword: &str,
    example: &str,
) -> Option<(Place, String, String)> {
    let loaded = text.reading.last(keyword);
    // Nothing behind a misplaced list is read.
    if sections::keyword_below_list(text).is_some() {
        return None;
    }
    // With a colon it has a finding of its own.
    if text.has_hidden(keyword) || loaded.is_some_and(|entry| entry.has_colon) {
        return None;
    }
    if let Some(entry) = loaded {
        let message =
            format!("`{keyword}` is below the vertex rows, where the library does not look");
        return Some((
            Place::Span(entry.keyword_span.clone()),
            message,
            format!("move `{keyword}` above `verts`"),
        ));
    }
    if let Some(entry) = text
        .misspelt(keyword)
        .filter(|entry| *entry.keyword != *keyword)
    {
        let message = format!("`{}` is not the keyword `{keyword}`", entry.keyword);
        return Some((
            Place::Span(entry.keyword_span.clone()),
            message,
            format!("write `{}`", keywords::corrected(entry, keyword)),
        ));
    }
    let empty = text
        .clothes
        .entries
        .iter()
        .find(|entry| *entry.keyword == *keyword && !entry.is_comment);
    Some(match empty {
        Some(entry) if entry.has_colon => {
            let help = format!("write `{keyword}` without a colon");
            (
                Place::Span(entry.keyword_span.clone()),
                format!("`{keyword}:` has a colon and is another word"),
                help,
            )
        }
        Some(entry) => {
            let help = format!("write the {example} after `{keyword}`");
            (
                Place::Span(entry.keyword_span.clone()),
                format!("`{keyword}` has no value"),
                help,
            )
        }
        None => (
            Place::File,
            format!("`{keyword}` is missing"),
            format!("add a line `{keyword}` with a {example}"),
        ),
    })
}
