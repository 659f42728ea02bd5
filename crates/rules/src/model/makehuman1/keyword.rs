//! Each line of a model begins with a word that the program knows.

use std::collections::{BTreeMap, BTreeSet};

use super::super::super::{Rule, RuleCx, did_you_mean, such};
use super::super::unparted::of_line;
use super::current;
use mhlint_diag::{Evidence, Finding, Place};
use mhlint_formats::mhm::lines::{Line, keywords};
use mhlint_repo::makehuman1::View;

pub(in super::super) fn faults(
    rule: &Rule,
    view: &View<'_>,
    cx: &RuleCx<'_>,
    out: &mut Vec<Finding>,
) {
    let tabs = view
        .modifiers
        .sets
        .iter()
        .filter_map(|set| set.sliders)
        .flat_map(|(_, sliders)| &sliders.tabs);
    let mut known: BTreeSet<&str> = tabs.filter_map(|tab| tab.saved_as.as_deref()).collect();
    for word in keywords() {
        known.insert(word);
    }
    let mut by_small_letters: BTreeMap<String, &str> = BTreeMap::new();
    for word in &known {
        let small = word.to_ascii_lowercase();
        by_small_letters.entry(small).or_insert(word);
    }
    for model in current(view) {
        // Not reported here: a remark without a blank behind its `#`, for which nothing is lost,
        // and a word behind a byte order mark, which `file-byte-order-mark` reports.
        let is_told = |line: &&Line| {
            let word = &*line.keyword.text;
            !known.contains(word) && !word.starts_with(['#', '\u{feff}'])
        };
        let unknown: Vec<&Line> = model.lines.all.iter().filter(is_told).collect();
        let Some(first) = unknown.first() else {
            continue;
        };
        let word = &*first.keyword.text;
        let message = format!(
            "no line of a model begins with `{word}`{}",
            such(unknown.len(), "lines")
        );
        let unparted = of_line(first).map(|one| one.help());
        let same = by_small_letters.get(&word.to_ascii_lowercase()).copied();
        let near = same.or_else(|| cx.suggestions.nearest(word, known.iter().copied()));
        let finding = rule
            .at(model.file, Place::Span(first.keyword.span.clone()), message)
            .key("unknown");
        let evidence = Evidence::of_cases(unknown.iter().map(|line| &*line.keyword.text));
        let help =
            unparted.unwrap_or_else(|| did_you_mean(near, "correct the word, or remove the line"));
        out.push(finding.evidence(evidence).help(help));
    }
}
