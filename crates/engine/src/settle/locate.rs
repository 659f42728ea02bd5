//! Turns the places of findings into lines, columns and excerpts. This is done last, and only for
//! findings that are reported.

use std::collections::BTreeMap;
use std::ops::Range;

use rayon::prelude::*;

use super::folder;
use crate::caught::caught;
use mhlint_diag::{FailedStep, Finding, Location, Place, Related};
use mhlint_json::Spans;
use mhlint_source::{Limits, Lines, Tree};

/// The text of a file that findings point into.
struct Text<'b> {
    lines: Lines<'b>,
    /// Where the values stand in its JSON that findings point to.
    spans: Spans,
}

/// Sets the locations of findings and sorts them by path, place, rule and key. A file is read from
/// the first of the `trees` that has it.
pub(crate) fn place_and_sort(
    findings: &mut [Finding],
    trees: &[&Tree],
    limits: &Limits,
    failed: &mut Vec<FailedStep>,
) {
    // With cached keys each finding is moved only once, which matters since findings are large.
    findings.sort_by_cached_key(|finding| {
        (
            finding.path.clone(),
            finding.rule,
            finding.subject.key.clone(),
        )
    });
    caught(FailedStep::Places, failed, || {
        locate(findings, trees, limits);
    });
    findings.sort_by_cached_key(
        |Finding {
             path,
             location,
             rule,
             subject,
             ..
         }| {
            (
                path.clone(),
                location.line,
                location.column,
                *rule,
                subject.key.clone(),
            )
        },
    );
}

/// Sets the locations of findings and of their related places.
fn locate(findings: &mut [Finding], trees: &[&Tree], limits: &Limits) {
    // Collects the places by file, so that each file is read once.
    let mut by_path: BTreeMap<&str, Vec<(&Place, &mut Location)>> = BTreeMap::new();
    for finding in &mut *findings {
        let Finding {
            path,
            place,
            location,
            related,
            ..
        } = finding;
        by_path.entry(path).or_default().push((place, location));
        for Related {
            path,
            place,
            location,
            ..
        } in related
        {
            by_path.entry(path).or_default().push((place, location));
        }
    }
    by_path.into_par_iter().for_each(|(path, places)| {
        let folder = folder::at(path, trees);
        let is_in_text = places
            .iter()
            .any(|(place, _)| !matches!(place, Place::File | Place::Element(_)));
        let bytes = if is_in_text {
            read(path, trees, limits)
        } else {
            None
        };
        let mut text = bytes.as_ref().map(|bytes| Text {
            lines: Lines::of(bytes),
            spans: spans(bytes, &places),
        });
        for (place, location) in places {
            *location = symbolic(place);
            location.folder.clone_from(&folder);
            if let Some(text) = &mut text
                && let Some(span) = text.span(place)
            {
                let position = text.lines.position(span.start);
                location.line = Some(position.line);
                location.column = Some(position.column);
                location.excerpt = text.lines.excerpt(span);
            }
        }
    });
    findings.iter_mut().for_each(folder::stand_in);
}

/// The location of a place, as far as it is known without the text.
fn symbolic(place: &Place) -> Location {
    let mut location = Location::default();
    match place {
        Place::Pointer(pointer) | Place::Key(pointer) => location.pointer = Some(pointer.clone()),
        Place::Line(line) => location.line = Some(*line),
        Place::Row(line, element) => {
            (location.line, location.element) = (Some(*line), Some(*element));
        }
        Place::Element(element) => location.element = Some(*element),
        Place::File | Place::Span(_) => {}
    }
    location
}

/// Where the values stand that the places in a JSON file point to.
fn spans(bytes: &[u8], places: &[(&Place, &mut Location)]) -> Spans {
    let pointers: Vec<&str> = places
        .iter()
        .filter_map(|(place, _)| pointer(place))
        .collect();
    if pointers.is_empty() {
        Spans::default()
    } else {
        Spans::of(bytes, pointers.into_iter())
    }
}

fn pointer(place: &Place) -> Option<&str> {
    match place {
        Place::Pointer(pointer) | Place::Key(pointer) => Some(pointer),
        Place::File | Place::Line(_) | Place::Row(..) | Place::Element(_) | Place::Span(_) => None,
    }
}

fn read(path: &str, trees: &[&Tree], limits: &Limits) -> Option<Vec<u8>> {
    trees
        .iter()
        .find_map(|tree| tree.read(tree.entry(tree.below(path)?)?, limits).ok())
}

impl Text<'_> {
    fn span(&mut self, place: &Place) -> Option<Range<usize>> {
        match place {
            Place::Span(span) => Some(span.clone()),
            Place::Line(line) | Place::Row(line, _) => self.lines.span(*line),
            Place::Pointer(pointer) => self.spans.at(pointer),
            Place::Key(pointer) => self.spans.key_at(pointer),
            Place::File | Place::Element(_) => None,
        }
    }
}
