//! Symbolic places to lines, columns and excerpts: late, and only for what is reported.

use std::collections::BTreeMap;
use std::ops::Range;

use rayon::prelude::*;

use crate::diag::{Finding, Location, Place};
use crate::json::{self, Document};
use crate::source::{Limits, Tree, excerpt, line_span, position};

/// Texts kept at a time; findings come sorted by path, so few are needed twice.
const OPEN_TEXTS: usize = 16;

/// A file that findings point into.
struct Text {
    bytes: Vec<u8>,
    document: Option<Document>,
}

/// Fills the locations of findings and their related places. `trees` are asked for each path in turn.
pub(super) fn locate(findings: &mut [Finding], trees: &[&Tree], limits: &Limits) {
    findings.par_chunk_by_mut(|one, next| one.path == next.path).for_each(|of_one_file| {
        let mut texts: BTreeMap<String, Option<Text>> = BTreeMap::new();
        for finding in of_one_file {
            finding.location = location(&finding.path, &finding.place, &mut texts, trees, limits);
            for related in &mut finding.related {
                related.location = location(&related.path, &related.place, &mut texts, trees, limits);
            }
        }
    });
}

fn location(
    path: &str,
    place: &Place,
    texts: &mut BTreeMap<String, Option<Text>>,
    trees: &[&Tree],
    limits: &Limits,
) -> Location {
    let mut location = Location::default();
    match place {
        Place::File => return location,
        Place::Pointer(pointer) | Place::Key(pointer) => location.pointer = Some(pointer.clone()),
        Place::Line(line) => location.line = Some(*line),
        Place::Row(line, element) => (location.line, location.element) = (Some(*line), Some(*element)),
        Place::Element(element) => {
            location.element = Some(*element);
            return location;
        }
        Place::Span(_) => {}
    }
    if texts.len() > OPEN_TEXTS {
        texts.clear();
    }
    let text = texts.entry(path.to_owned()).or_insert_with(|| open(path, trees, limits));
    if let Some(text) = text
        && let Some(span) = span(text, place)
    {
        let position = position(&text.bytes, span.start);
        location.line = Some(position.line);
        location.column = Some(position.column);
        location.excerpt = excerpt(&text.bytes, span);
    }
    location
}

fn open(path: &str, trees: &[&Tree], limits: &Limits) -> Option<Text> {
    let bytes = trees.iter().find_map(|tree| {
        let rel = if tree.label().is_empty() { path } else { path.strip_prefix(tree.label())?.strip_prefix('/')? };
        tree.read(tree.entry(rel)?, limits).ok()
    })?;
    Some(Text { bytes, document: None })
}

fn span(text: &mut Text, place: &Place) -> Option<Range<usize>> {
    match place {
        Place::Span(span) => Some(span.clone()),
        Place::Line(line) | Place::Row(line, _) => line_span(&text.bytes, *line),
        Place::Pointer(pointer) => document(text)?.at(pointer).map(|node| node.span.clone()),
        Place::Key(pointer) => document(text)?.key_at(pointer),
        Place::File | Place::Element(_) => None,
    }
}

fn document(text: &mut Text) -> Option<&Document> {
    if text.document.is_none() {
        text.document = json::parse(&text.bytes).ok();
    }
    text.document.as_ref()
}
