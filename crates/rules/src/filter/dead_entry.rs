//! What a selection filter leads to must be a label of its tree.

use std::collections::BTreeSet;

use super::super::{Check, Rule, RuleCx, did_you_mean};
use mhlint_diag::{Application::Makehuman2, Evidence, Finding, Level, Place, RuleInfo, grouped};
use mhlint_formats::selection_filter::SelectionFilter;
use mhlint_repo::{FileFacts, View};

pub(crate) static RULE: Rule = Check::File(run).rule(RuleInfo {
    breaks: &[(
        Makehuman2,
        "gives assets a label that no filter has: they disappear from the filters that showed them",
    )],
    docs: include_str!("dead_entry.md").trim_ascii_end(),
    ..RuleInfo::new(
        "filter-dead-entry",
        Level::Warning,
        "a selection filter leads to a label that is not in its tree",
    )
});

/// A path that is not in the tree, and the pointer to where it is written.
type Dead = (String, String);

fn run(view: &View<'_>, file: &FileFacts, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some(filter) = file.filter().filter(|_| !file.json.falsy) else {
        return;
    };
    // What is lost with a repeated key has a finding of its own.
    let repeated: Vec<String> = file
        .json
        .duplicates
        .iter()
        .map(|one| one.pointer.to_lowercase())
        .collect();
    let repeated: BTreeSet<&str> = repeated
        .iter()
        .filter_map(|pointer| pointer.split('/').nth(1))
        .collect();
    let is_lost = |path: &str| {
        let path = path.to_lowercase();
        path.split(':')
            .next()
            .is_some_and(|first| repeated.contains(first))
    };
    let by_path = grouped(dead(filter).into_iter().filter(|(path, _)| !is_lost(path)));
    for (path, places) in by_path {
        let Some(first) = places.first() else {
            continue;
        };
        let more = if places.len() > 1 {
            format!(" ({} entries)", places.len())
        } else {
            String::new()
        };
        let message = format!("`{path}` is not in the tree of labels{more}");
        let help = did_you_mean(
            nearest(filter, &path, cx),
            "use a path that exists in the tree, or add the label",
        );
        let mut finding = RULE
            .at(file, Place::Pointer(first.clone()), message)
            .key(&path)
            .help(help);
        if places.iter().all(|place| place.starts_with("/Shortcut/")) {
            finding = finding.effect_in(
                view.application(),
                "shows nothing for this part of the button's rule",
            );
        }
        out.push(finding.evidence(Evidence::of_cases(&places)));
    }
}

fn dead(filter: &SelectionFilter) -> Vec<Dead> {
    let pointer = |key: &str, name: &str| mhlint_diag::pointer(&[key, name]);
    let translated = filter
        .translate
        .values()
        .filter_map(|led| Some((&led.key, led.to.as_deref()?)));
    let translated = translated.map(|(tag, path)| {
        (
            path.strip_prefix('=').unwrap_or(path),
            pointer("Translate", tag),
        )
    });
    let guessed = filter
        .guess
        .values()
        .map(|led| (led.to.as_str(), pointer("GuessName", &led.key)));
    let led = translated
        .chain(guessed)
        .filter(|(path, _)| filter.is_dead(path));
    let rules = filter.shortcuts.iter().flat_map(|(at, rule)| {
        let place = format!("/Shortcut/{at}/1");
        rule.split(['|', '&'])
            .map(move |path| (path.trim(), place.clone()))
    });
    let rules = rules.filter(|(path, _)| filter.is_dead(&path.to_lowercase()));
    led.chain(rules)
        .map(|(path, place)| (path.to_owned(), place))
        .collect()
}

/// The path with the same last label, or one that is spelt much alike.
fn nearest<'f>(filter: &'f SelectionFilter, path: &str, cx: &RuleCx<'_>) -> Option<&'f str> {
    let last = path.rsplit(':').next().unwrap_or(path).to_lowercase();
    let same = filter.leaves.get(&last).map(String::as_str);
    same.or_else(|| {
        cx.suggestions
            .nearest(path, filter.paths.iter().map(String::as_str))
    })
}
