//! An asset has a name.

use super::super::{Check, Rule, RuleCx};
use super::{Text, texts};
use crate::diag::{Application::Makehuman2, Finding, Level, Place, RuleInfo};
use crate::repo::Body;

pub(in crate::rules) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[(Makehuman2, "lists the asset without a name, and models lose it")],
    docs: "An asset has no `name`.\n\n\
        MakeHuman 2 lists it under an empty name at the first start, and as `generic` from the second start on. Models \
        that were saved with the one do not find the other: the asset is missing in them without a message.\n\n\
        The library reads the file up to the first vertex row with several numbers, so a `name` below the rows does \
        not count.\n\n\
        Add a line `name`, with a single word, above `verts`.",
    ..RuleInfo::new("proxy-missing-name", Level::Error, "an asset has no name")
});

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for text in texts(body) {
        if text.clothes.scanned.name.is_none() {
            out.extend(
                missing(&text, "name", "name")
                    .map(|(place, message, help)| RULE.at(text.file, place, message).help(help)),
            );
        }
    }
}

/// Where a keyword of the head is missed, in words, and what to do; nothing if the finding is elsewhere.
pub(super) fn missing(text: &Text<'_, '_>, keyword: &str, example: &str) -> Option<(Place, String, String)> {
    let loaded = text.clothes.last(keyword);
    // With a colon it has a finding of its own.
    if text.has_hidden(keyword) || loaded.is_some_and(|entry| entry.has_colon) {
        return None;
    }
    if let Some(entry) = loaded {
        let message = format!("`{keyword}` stands below the vertex rows, where the library does not look");
        return Some((Place::Span(entry.keyword_span.clone()), message, format!("move `{keyword}` above `verts`")));
    }
    if let Some(entry) = text.misspelt(keyword) {
        let message = format!("`{}` is not the keyword `{keyword}`", entry.keyword);
        return Some((Place::Span(entry.keyword_span.clone()), message, format!("write `{keyword}`")));
    }
    let empty = text.clothes.entries.iter().find(|entry| *entry.keyword == *keyword && !entry.is_comment);
    Some(match empty {
        Some(entry) => {
            let help = format!("write the {example} behind `{keyword}`");
            (Place::Span(entry.keyword_span.clone()), format!("`{keyword}` has no value"), help)
        }
        None => (Place::File, format!("`{keyword}` is missing"), format!("add a line `{keyword}` with a {example}")),
    })
}
