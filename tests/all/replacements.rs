//! The fixes in SARIF: a program that replaces the texts gets the same bytes as `--fix`.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use crate::scratch::{
    Case, copy_folder, edit, example, example_of, folders, mhlint, project, stdout,
};
use rayon::prelude::*;
use serde_json::Value;

const OVAL: &str = "data/target/figure/head/head-oval.target";

/// The results of a run with one rule.
fn results(root: &Path, rule: &str) -> Vec<Value> {
    let output = mhlint(root, &["check", ".", "--only", rule, "--report", "sarif"]);
    let log: Value = serde_json::from_str(&stdout(&output)).unwrap();
    log["runs"][0]["results"].as_array().unwrap().clone()
}

/// Replaces what the one fix of a result names, the last place first.
fn replace(root: &Path, result: &Value) {
    let [fix] = result["fixes"].as_array().unwrap().as_slice() else {
        panic!("{result}")
    };
    for change in fix["artifactChanges"].as_array().unwrap() {
        let file = root.join(change["artifactLocation"]["uri"].as_str().unwrap());
        let mut text = fs::read_to_string(&file).unwrap();
        for one in change["replacements"].as_array().unwrap().iter().rev() {
            let region = &one["deletedRegion"];
            let [from, to] = [["startLine", "startColumn"], ["endLine", "endColumn"]]
                .map(|place| offset(&text, place.map(|name| region[name].as_u64().unwrap())));
            let inserted = one["insertedContent"]["text"].as_str().unwrap_or_default();
            text.replace_range(from..to, inserted);
        }
        fs::write(file, text).unwrap();
    }
}

/// The byte at a line and column, which are counted from 1, the column in code points.
fn offset(text: &str, [line, column]: [u64; 2]) -> usize {
    let (mut at_line, mut at_column) = (1, 1);
    let mut characters = text.char_indices().peekable();
    while let Some((offset, character)) = characters.next() {
        if (at_line, at_column) == (line, column) {
            return offset;
        }
        let goes_on = character == '\r' && characters.peek().is_some_and(|(_, next)| *next == '\n');
        (at_line, at_column) = if matches!(character, '\n' | '\r') && !goes_on {
            (at_line + 1, 1)
        } else {
            (at_line, at_column + 1)
        };
    }
    assert_eq!((at_line, at_column), (line, column), "in the text");
    text.len()
}

/// Whether the case has one finding with a fix in SARIF, which then must do what `--fix` does.
fn replaces_as_fix_does(rule: &str, folder: &Path) -> bool {
    let case = Case::read(folder);
    let of_case = || example_of(case.application.as_deref().unwrap_or("makehuman2"));
    let [repository, other] = [of_case(), of_case()];
    for copy in [&repository, &other] {
        case.apply(copy.path());
    }
    let results = results(repository.path(), rule);
    let [result] = results.as_slice() else {
        return false;
    };
    if result["fixes"].is_null() {
        return false;
    }
    replace(repository.path(), result);
    mhlint(other.path(), &["check", ".", "--only", rule, "--fix"]);
    let [replaced, fixed] = [&repository, &other].map(|copy| crate::scratch::content(copy.path()));
    assert_eq!(replaced, fixed, "{}", folder.display());
    true
}

#[test]
fn what_sarif_replaces_is_what_fix_writes() {
    let output = mhlint(&project("."), &["rules", "--format", "json"]);
    let rules: Value = serde_json::from_str(&stdout(&output)).unwrap();
    let safe = rules
        .as_array()
        .unwrap()
        .iter()
        .filter(|rule| rule["fix"] == "safe");
    let safe: Vec<&str> = safe.map(|rule| rule["id"].as_str().unwrap()).collect();
    let cases = |rule: &str| folders(&project("fixtures/rules").join(rule));
    let done = safe.par_iter().filter(|rule| {
        cases(rule)
            .iter()
            .filter(|case| replaces_as_fix_does(rule, case))
            .count()
            > 0
    });
    let done: BTreeSet<&str> = done.copied().collect();
    let expected = [
        "file-backslash-path",
        "macro-target-extension",
        "pose-licence-spelling",
        "target-zero-delta",
        "weights-below-threshold",
        "weights-duplicate-vertex",
    ];
    assert_eq!(
        done,
        BTreeSet::from(expected),
        "a byte order mark is no place in a text"
    );
}

#[test]
fn columns_are_counted_in_characters_and_lines_as_the_applications_do() {
    let [repository, other] = [example(), example()];
    for copy in [&repository, &other] {
        let rows =
            "339 0 .001 .001\n# \u{e4}\u{1f600}\r600 0 0 0\r\n601 0 0 0\n340 .001 0 0\n602 0 0 0\n";
        edit(copy.path(), OVAL, "339 0 .001 .001\n", rows);
    }
    let results = results(repository.path(), "target-zero-delta");
    assert_eq!(
        results[0]["fixes"][0]["artifactChanges"][0]["replacements"]
            .as_array()
            .unwrap()
            .len(),
        2
    );
    replace(repository.path(), &results[0]);
    mhlint(other.path(), &["--only", "target-zero-delta", "--fix"]);
    let [replaced, fixed] =
        [&repository, &other].map(|copy| fs::read(copy.path().join(OVAL)).unwrap());
    assert_eq!(replaced, fixed);
}

#[test]
fn unsafe_fixes_and_those_of_large_files_are_left_out() {
    let repository = example();
    edit(
        repository.path(),
        OVAL,
        "339 0 .001 .001\n",
        "339 0 .001 .001\n339 0 .001 .001\n",
    );
    let found = results(repository.path(), "target-duplicate-vertex");
    assert!(found.len() == 1 && found[0]["fixes"].is_null(), "{found:?}");
    let large = format!("339 0 .001 .001\n600 0 0 0\n# {}\n", "x".repeat(1 << 20));
    edit(
        repository.path(),
        OVAL,
        "339 0 .001 .001\n339 0 .001 .001\n",
        &large,
    );
    let found = results(repository.path(), "target-zero-delta");
    assert!(found.len() == 1 && found[0]["fixes"].is_null(), "{found:?}");
}

#[test]
fn files_in_a_folder_of_the_workspace_are_named_from_its_top() {
    let workspace = tempfile::tempdir().unwrap();
    let inside = workspace.path().join("assets");
    copy_folder(example().path(), &inside);
    edit(&inside, OVAL, "339 0 .001 .001", "339 0 0 0");
    let mut command = crate::scratch::command(
        &inside,
        &["--report", "sarif", "--only", "target-zero-delta"],
    );
    let output = command
        .env("GITHUB_WORKSPACE", workspace.path())
        .output()
        .unwrap();
    let log: Value = serde_json::from_str(&stdout(&output)).unwrap();
    let change = &log["runs"][0]["results"][0]["fixes"][0]["artifactChanges"][0];
    assert_eq!(change["artifactLocation"]["uri"], format!("assets/{OVAL}"));
}
