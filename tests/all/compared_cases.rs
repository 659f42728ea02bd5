//! A change is never hidden: every fixture case taken as a change to the example, which is clean,
//! must show all of its findings beside the example.

use std::fs;
use std::path::{Path, PathBuf};

use crate::scratch::memory::{Asked, Memory, concise};
use crate::scratch::{Case, example, findings, folders, mhlint, project};
use rayon::prelude::*;

#[test]
fn every_fixture_case_beside_the_example_shows_all_its_findings() {
    let only = std::env::var("CASE").unwrap_or_default();
    let cases: Vec<PathBuf> = folders(&project("fixtures/rules"))
        .iter()
        .flat_map(|rule| folders(rule))
        .collect();
    let chosen: Vec<&PathBuf> = cases
        .iter()
        .filter(|case| case.join("expected.txt").exists() && case.to_str().unwrap().contains(&only))
        .collect();
    assert!(!chosen.is_empty(), "no case fits CASE={only}");
    let faults: Vec<String> = chosen.par_iter().filter_map(|case| hidden(case)).collect();
    assert!(faults.is_empty(), "\n{}", faults.join("\n"));
}

/// Runs a case beside the example; gives what is not shown of its findings.
fn hidden(folder: &Path) -> Option<String> {
    let case = Case::read(folder);
    // Not checked for users, or on a disk with another example.
    if case
        .application
        .as_deref()
        .is_some_and(|name| name != "makehuman1" || Asked::of(&case).is_none())
    {
        return None;
    }
    let shown = match Asked::of(&case) {
        Some(asked) => in_memory(&case, &asked),
        None => on_disk(&case)?,
    };
    let expected = fs::read_to_string(folder.join("expected.txt")).unwrap();
    let is_there = |line: &&str| shown.iter().any(|found| found == line);
    let missed: Vec<&str> = expected.lines().filter(|line| !is_there(line)).collect();
    (!missed.is_empty()).then(|| format!("{} hides\n  {}", folder.display(), missed.join("\n  ")))
}

/// What is found in the example, with the settings and arguments of the case, and what the case
/// brings.
fn in_memory(case: &Case, asked: &Asked) -> Vec<String> {
    let before = Memory::example(case);
    let mut now = before.clone();
    now.apply(case);
    // Without settings and arguments nothing is found in the example: it is clean.
    let is_plain = case.args.is_empty() && !now.has("mhlint.toml");
    let old = (!is_plain).then(|| asked.lint(&before));
    old.iter()
        .chain([&asked.lint_beside(&now, &before)])
        .flat_map(concise)
        .collect()
}

/// The same with the binary; nothing for a case that compares for itself or several folders.
fn on_disk(case: &Case) -> Option<Vec<String>> {
    if case.args.iter().filter(|arg| !arg.starts_with('-')).count() > 2 {
        return None;
    }
    let (before, repository) = (example(), example());
    case.apply(repository.path());
    let mut args: Vec<&str> = case.args.iter().map(String::as_str).collect();
    if args.is_empty() {
        args.extend(["check", "."]);
    }
    let path = args
        .iter()
        .skip(1)
        .find(|arg| !arg.starts_with('-'))
        .copied()
        .unwrap_or(".");
    let other = before.path().join(path);
    if !other.exists() {
        return None;
    }
    args.extend(["--report", "concise"]);
    // Both sides have the settings of the case.
    let settings = repository.path().join("mhlint.toml");
    if settings.exists() {
        fs::copy(settings, before.path().join("mhlint.toml")).unwrap();
    }
    let mut shown = findings(&mhlint(before.path(), &args));
    args.extend(["--against", other.to_str().unwrap()]);
    shown.extend(findings(&mhlint(repository.path(), &args)));
    Some(shown)
}
