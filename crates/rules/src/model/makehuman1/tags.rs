//! Tags are separated by semicolons, and are short.

use super::super::super::{Rule, such};
use super::current;
use mhlint_diag::{Application::Makehuman1, Case, Evidence, Finding, Level, Place};
use mhlint_repo::makehuman1::View;

/// The program keeps this many letters of a tag.
const MOST: usize = 25;
const CUT: Case = &[(
    Makehuman1,
    Level::Warning,
    "keeps the first 25 letters of the tag",
)];

pub(in super::super) fn faults(rule: &Rule, view: &View<'_>, out: &mut Vec<Finding>) {
    for model in current(view) {
        let Some(line) = model.lines.of("tags").next_back() else {
            continue;
        };
        let words: Vec<&str> = line.values.iter().map(|word| &*word.text).collect();
        let text = words.join(" ");
        let tags: Vec<&str> = text.split(';').map(str::trim).collect();
        let place = || Place::Span(line.keyword.span.clone());
        let parts = |tag: &str| {
            tag.split(',')
                .filter(|part| !part.trim().is_empty())
                .count()
        };
        if let [only] = tags.as_slice()
            && parts(only) > 1
        {
            let right: Vec<&str> = only
                .split(',')
                .map(str::trim)
                .filter(|tag| !tag.is_empty())
                .collect();
            let finding = rule.at(model.file, place(), format!("`tags {only}` is one tag"));
            out.push(finding.help(format!("write `tags {}`", right.join(";"))));
            continue;
        }
        let long: Vec<&str> = tags
            .into_iter()
            .filter(|tag| tag.chars().count() > MOST)
            .collect();
        let Some(first) = long.first() else { continue };
        let message = format!(
            "tag `{first}` has more than {MOST} letters{}",
            such(long.len(), "tags")
        );
        let finding = rule.at(model.file, place(), message).key("long").case(CUT);
        out.push(
            finding
                .evidence(Evidence::of_cases(long.iter().copied()))
                .help("write shorter tags"),
        );
    }
}
