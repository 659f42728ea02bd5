//! Damage done to a real repository, one thing at a time: each case must show the finding that
//! names the cause, and nothing behind it. What the undamaged data have is in a baseline, which
//! must hide all of that and nothing else.
//!
//! Needs the corpora, in the folder that `MHLINT_CORPORA` names, and is ignored unless asked for
//! (`-- --ignored`). Where `MHLINT_DAMAGED` names a folder, every report of every damaged copy is
//! written into it (of every tenth with `MHLINT_DAMAGED_EVERY=10`): `tests/browser/run.sh` has them
//! read.

mod cases;
mod copies;
mod harm;

use std::path::Path;
use std::sync::Arc;

use cases::{CASES, Case, NUMERIC};
use harm::{Files, apply, corpus, load};
use mhlint::{Config, Finding, Level, Outcome, Tree, lint_trees};

/// A run on files as if they lay in `folder`.
fn run(files: &Files, folder: &str, config: &Config) -> Outcome {
    let tree = Tree::in_memory(
        folder,
        files
            .iter()
            .map(|(path, bytes)| (path.clone(), Arc::clone(bytes))),
    );
    lint_trees(vec![tree], None, config).unwrap()
}

/// `rule path` of a finding or of an entry of the baseline.
fn line(rule: &str, path: &str) -> String {
    let below = path
        .rsplit_once("/data/")
        .map(|(_, below)| below)
        .or(path.strip_prefix("data/"));
    format!("{rule} {}", below.unwrap_or(path))
}

/// Expected lines, each as often as it says.
fn each(lines: &[&str]) -> Vec<String> {
    let times = |line: &&str| {
        let (line, times) = line.split_once(" ×").unwrap_or((line, "1"));
        vec![line.to_owned(); times.parse().unwrap()]
    };
    lines.iter().flat_map(times).collect()
}

/// Entries of the baseline that no longer occur, sorted.
fn gone(outcome: &Outcome) -> Vec<String> {
    let stale = outcome
        .findings
        .iter()
        .filter(|finding| finding.rule == "baseline-stale");
    let mut lines: Vec<String> = stale
        .flat_map(|finding| finding.subject.parts.iter())
        .map(|(entry, _)| {
            let entry = entry.to_string();
            let (path, rule) = entry.split_once(": ").unwrap();
            line(rule.split(' ').next().unwrap(), path)
        })
        .collect();
    lines.sort();
    lines
}

/// What is wrong with a case; empty when it is as expected.
fn verdict(case: &Case, files: &Files, folder: &str, config: &Config) -> String {
    let mut damaged = files.clone();
    if let Err(reason) = case
        .damage
        .iter()
        .try_for_each(|edit| apply(&mut damaged, edit))
    {
        return format!("{}: {reason}\n", case.name);
    }
    let outcome = run(&damaged, folder, config);
    copies::write(case.name, &damaged, &outcome, config);
    let new: Vec<&Finding> = outcome
        .findings
        .iter()
        .filter(|finding| finding.rule != "baseline-stale")
        .collect();
    let mut fresh: Vec<String> = new
        .iter()
        .map(|finding| line(finding.rule, &finding.path))
        .collect();
    fresh.sort();
    // A fault may silence what can no longer be checked, and the case says what: nothing else may
    // go.
    let gone = gone(&outcome);
    let mut texts = new.iter().flat_map(|finding| {
        finding
            .related
            .iter()
            .map(|one| &one.message)
            .chain([&finding.message])
    });
    let says = new.is_empty() || texts.any(|text| text.contains(case.says));
    let fails = !config.passes(&outcome);
    let is_expected = fails != case.fresh.is_empty();
    if fresh == each(case.fresh)
        && gone == each(case.gone)
        && says
        && is_expected
        && outcome.failed_rules.is_empty()
    {
        return String::new();
    }
    let messages: Vec<_> = new
        .iter()
        .map(|finding| {
            format!(
                "    {}: {} [{}]",
                finding.path, finding.message, finding.subject.key
            )
        })
        .collect();
    format!(
        "{}: fails {fails}\n  says {:?}: {says}\n  new  {fresh:?}\n  not  {:?}\n  gone {gone:?}\n  not  {:?}\n  failed rules {:?}\n{}\n",
        case.name,
        case.says,
        case.fresh,
        case.gone,
        outcome.failed_rules,
        messages.join("\n")
    )
}

/// A run that fails at any finding, with a baseline of the undamaged data, written as
/// `--write-baseline` does.
fn with_baseline(files: &Files, folder: &str, no_eval: bool) -> Config {
    let baseline = Path::new(folder).join("known.json");
    let config = Config {
        no_eval,
        baseline: Some(baseline.clone()),
        fail_on: Some(Level::Info),
        ..Config::default()
    };
    let healthy = run(
        files,
        folder,
        &Config {
            write_baseline: true,
            ..config.clone()
        },
    );
    let written = healthy.baseline.unwrap();
    assert!(written.entries.len() > 1 && healthy.findings.is_empty());
    std::fs::write(baseline, written.text()).unwrap();
    let hidden = run(files, folder, &config);
    assert_eq!(
        hidden.findings,
        [],
        "the baseline hides all of the undamaged data"
    );
    assert_eq!(hidden.summary.suppressed, written.entries.len());
    assert!(config.passes(&hidden));
    config
}

fn every_case_of(cases: &[&Case], base: &str, without: &str, no_eval: bool) {
    let files = load(&corpus(), without);
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path().to_str().unwrap();
    let config = with_baseline(&files, folder, no_eval);
    let only = std::env::var("CASE").unwrap_or_default();
    let wanted = cases
        .iter()
        .filter(|case| case.base == base && case.name.contains(&only));
    let wrong: Vec<String> = wanted
        .map(|case| verdict(case, &files, folder, &config))
        .filter(|text| !text.is_empty())
        .collect();
    assert!(
        wrong.is_empty(),
        "{} cases:\n{}",
        wrong.len(),
        wrong.join("\n")
    );
}

#[test]
#[ignore = "needs the corpora: MHLINT_CORPORA=FOLDER cargo test -- --ignored"]
fn damage_to_hm08_is_named_once() {
    every_case_of(&CASES.iter().collect::<Vec<_>>(), "hm08", "mh2bot", true);
}

#[test]
#[ignore = "needs the corpora: MHLINT_CORPORA=FOLDER cargo test -- --ignored"]
fn damage_to_mh2bot_is_named_once() {
    every_case_of(&CASES.iter().collect::<Vec<_>>(), "mh2bot", "hm08", true);
}

/// Whether the rules of this build include `rule`; an unknown selector is refused.
fn knows(rule: &str) -> bool {
    let options = Config {
        only: vec![rule.to_owned()],
        ..Config::default()
    };
    lint_trees(Vec::new(), None, &options).is_ok()
}

#[test]
#[ignore = "needs the corpora: MHLINT_CORPORA=FOLDER cargo test -- --ignored"]
fn damage_that_evaluation_sees_is_named_once() {
    let findings = NUMERIC.iter().flat_map(|case| case.fresh.iter().copied());
    let unknown = findings.filter(|finding| !finding.split(' ').next().is_some_and(knows));
    assert_eq!(
        unknown.collect::<Vec<_>>(),
        Vec::<&str>::new(),
        "a rule was renamed"
    );
    every_case_of(&NUMERIC.iter().collect::<Vec<_>>(), "hm08", "mh2bot", false);
}

#[test]
fn there_are_enough_cases_and_their_names_differ() {
    let names: std::collections::BTreeSet<_> = CASES.iter().map(|case| case.name).collect();
    assert_eq!(names.len(), CASES.len());
    assert!(names.len() >= 60, "{}", names.len());
}
