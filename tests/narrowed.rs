//! A change is never hidden: every fixture case taken as a change to the example, which is clean, must show all of its
//! findings in the narrowed run; and changes that rules see only from afar.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may stop where it fails")]

mod scratch;

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Output;

use rayon::prelude::*;
use scratch::{Case, content, edit, example, findings, folders, mhlint, project, remove, stderr, stdout};

const SIDE: &str = "data/target/figure/head/head-side-in.target";
const OVAL: &str = "data/target/figure/head/head-oval.target";
const FOOT: &str = "data/target/figure/legs/l-foot-trans-forward.target";

#[test]
fn every_fixture_case_as_a_change_shows_all_its_findings() {
    let only = std::env::var("CASE").unwrap_or_default();
    let cases: Vec<PathBuf> = folders(&project("fixtures/rules")).iter().flat_map(|rule| folders(rule)).collect();
    let chosen: Vec<&PathBuf> = cases
        .iter()
        .filter(|case| case.join("expected.txt").exists() && case.to_str().unwrap().contains(&only))
        .collect();
    assert!(!chosen.is_empty(), "no case fits CASE={only}");
    let faults: Vec<String> = chosen.par_iter().filter_map(|case| hidden(case)).collect();
    assert!(faults.is_empty(), "\n{}", faults.join("\n"));
}

/// Runs a case narrowed to what it changes; gives what is not shown of its findings.
fn hidden(folder: &Path) -> Option<String> {
    let case = Case::read(folder);
    // The binary does not check it.
    if case.application.is_some() {
        return None;
    }
    let repository = example();
    let root = repository.path();
    let before = content(root);
    case.apply(root);
    let after = content(root);
    let mut changed: BTreeSet<String> = case.link.iter().map(|[path, _]| path.clone()).collect();
    let paths: BTreeSet<&PathBuf> = before.keys().chain(after.keys()).collect();
    let differs = paths.into_iter().filter(|path| before.get(*path) != after.get(*path));
    changed.extend(differs.map(|path| path.to_str().unwrap().to_owned()));
    // Git knows no empty folders: what they bring is no matter of a change.
    let expected = fs::read_to_string(folder.join("expected.txt")).unwrap();
    if changed.is_empty() {
        return None;
    }
    let list = tempfile::NamedTempFile::new().unwrap();
    let names: Vec<&str> = changed.iter().map(String::as_str).collect();
    fs::write(list.path(), names.join("\n") + "\n").unwrap();
    let mut args: Vec<&str> = case.args.iter().map(String::as_str).collect();
    if args.is_empty() {
        args.extend(["check", "."]);
    }
    args.extend(["--report", "concise", "--changed-files", list.path().to_str().unwrap()]);
    let shown = findings(&mhlint(root, &args));
    let missed: Vec<&str> = expected.lines().filter(|line| !shown.iter().any(|found| found == line)).collect();
    let name = folder.display();
    (!missed.is_empty()).then(|| format!("{name}: {changed:?} hides\n  {}", missed.join("\n  ")))
}

/// The report on the example after `earlier` and then a change, narrowed to the files of the change.
fn narrowed(earlier: impl Fn(&Path), change: impl Fn(&Path), changed: &[&str], more: &[&str]) -> Output {
    let repository = example();
    let root = repository.path();
    earlier(root);
    change(root);
    let list = tempfile::NamedTempFile::new().unwrap();
    fs::write(list.path(), changed.join("\n")).unwrap();
    let fixed = ["check", ".", "--no-eval", "--report", "concise", "--changed-files", list.path().to_str().unwrap()];
    mhlint(root, &[&fixed, more].concat())
}

#[track_caller]
fn assert_shown(output: &Output, rule: &str, is_shown: bool) {
    let text = stdout(output);
    assert_eq!(text.contains(&format!("[{rule}]")), is_shown, "{rule}: {text}{}", stderr(output));
}

fn ruin(root: &Path, target: &str) {
    fs::write(root.join(target), "1 nan 0 0\n").unwrap();
}

#[test]
fn with_other_settings_the_report_is_whole() {
    let settings = |text: &'static str| move |root: &Path| fs::write(root.join("mhlint.toml"), text).unwrap();
    let old = |root: &Path| ruin(root, OVAL);
    let whole = "touches the configuration `mhlint.toml`: the whole report";
    let output = narrowed(old, settings("fail-on = 'warning'\n"), &["mhlint.toml", SIDE], &[]);
    assert_shown(&output, "target-non-finite", true);
    assert!(stderr(&output).contains(whole), "{}", stderr(&output));
    // One that was deleted, and one that plays no part.
    assert_shown(&narrowed(old, |_| (), &["mhlint.toml"], &[]), "target-non-finite", true);
    assert_shown(&narrowed(old, |_| (), &["data/hair/mhlint.toml"], &[]), "target-non-finite", false);
    let known = |root: &Path| {
        ruin(root, OVAL);
        let written = mhlint(root, &["check", ".", "--no-eval", "--baseline", "known.json", "--write-baseline"]);
        assert_eq!(written.status.code(), Some(0), "{}", stderr(&written));
    };
    let emptied = |root: &Path| {
        fs::remove_file(root.join("known.json")).unwrap();
        let clean = example();
        let file = root.join("known.json");
        let args = ["check", ".", "--no-eval", "--write-baseline", "--baseline", file.to_str().unwrap()];
        mhlint(clean.path(), &args);
    };
    let output = narrowed(known, emptied, &["known.json"], &["--baseline", "known.json"]);
    assert_shown(&output, "target-non-finite", true);
    assert!(stderr(&output).contains("touches the baseline `known.json`"), "{}", stderr(&output));
}

#[cfg(unix)]
#[test]
fn a_link_counts_with_what_it_leads_to() {
    use std::os::unix::fs::symlink;
    let real = "data/target/figure/legs/real.txt";
    let linked = |root: &Path| {
        fs::rename(root.join(FOOT), root.join(real)).unwrap();
        symlink("real.txt", root.join(FOOT)).unwrap();
    };
    assert_shown(&narrowed(linked, |root| ruin(root, real), &[real], &[]), "target-non-finite", true);
    assert_shown(&narrowed(linked, |root| remove(&root.join(real)), &[real], &[]), "file-unreadable", true);
    let circle = |root: &Path| {
        fs::create_dir_all(root.join("data/clothes/figure")).unwrap();
        symlink("two", root.join("data/clothes/figure/one")).unwrap();
    };
    let close = |root: &Path| symlink("one", root.join("data/clothes/figure/two")).unwrap();
    assert_shown(&narrowed(circle, close, &["data/clothes/figure/two"], &[]), "file-link-loop", true);
    assert_shown(&narrowed(circle, close, &[SIDE], &[]), "file-link-loop", false);
}

#[test]
fn what_is_told_once_for_a_folder_counts_with_all_of_it() {
    let measure = "data/target/figure/measure";
    let example = example();
    let all: Vec<String> =
        content(&example.path().join(measure)).keys().map(|name| format!("{measure}/{}", name.display())).collect();
    for last in all.iter().filter(|path| path.ends_with(".target")) {
        let output = narrowed(|_| (), |root| remove(&root.join(measure)), &[last], &[]);
        assert_shown(&output, "modelling-missing-target", true);
    }
}

#[test]
fn names_that_belong_together_count_together() {
    let toes = |root: &Path| {
        let row = "1 0.1 0 0\n";
        fs::write(root.join("data/target/figure/legs/l-toe-new.target"), row).unwrap();
        edit(root, "data/target/figure/modelling.json", "legs/l-foot-trans-forward", "legs/l-toe-new");
    };
    let gone = "data/target/figure/legs/r-toe-new.target";
    assert_shown(&narrowed(toes, |_| (), &[gone], &[]), "target-missing-side", true);
    assert_shown(&narrowed(toes, |_| (), &[OVAL], &[]), "target-missing-side", false);
}
