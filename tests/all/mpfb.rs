//! The data of MPFB and the folder of a user through the binary: which folders are found, and how
//! they lie over one another.

use std::path::Path;

use serde_json::Value;

use crate::scratch::{copy_folder, mhlint, project};

/// A copy of the example.
fn example() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    copy_folder(&project("fixtures/mpfb"), folder.path());
    folder
}

fn report(root: &Path, args: &[&str]) -> Value {
    let output = mhlint(root, &[args, &["--report", "json"]].concat());
    serde_json::from_slice(&output.stdout).unwrap()
}

/// The checked roots with their applications.
fn roots(report: &Value) -> Vec<(String, String)> {
    let text = |root: &Value, key: &str| root[key].as_str().unwrap().to_owned();
    let roots = report["roots"].as_array().unwrap().iter();
    roots
        .map(|root| (text(root, "path"), text(root, "application")))
        .collect()
}

fn of_mpfb(paths: &[&str]) -> Vec<(String, String)> {
    paths
        .iter()
        .map(|path| ((*path).to_owned(), "mpfb".to_owned()))
        .collect()
}

fn findings(report: &Value) -> Vec<String> {
    let findings = report["findings"].as_array().unwrap().iter();
    findings
        .map(|one| {
            format!(
                "{} {}",
                one["path"].as_str().unwrap(),
                one["rule"].as_str().unwrap()
            )
        })
        .collect()
}

#[test]
fn a_user_folder_is_found_beside_the_data_alone_and_over_a_system() {
    let folder = example();
    let root = folder.path();
    assert_eq!(
        roots(&report(root, &["check", "."])),
        of_mpfb(&["data", "user/data"])
    );
    assert_eq!(
        roots(&report(root, &["check", "user"])),
        of_mpfb(&["user/data"])
    );
    assert_eq!(
        roots(&report(root, &["check", "user", "--system", "data"])),
        of_mpfb(&["user/data"])
    );
    for args in [
        &["check", "."][..],
        &["check", "user"],
        &["check", "user", "--system", "data"],
    ] {
        assert_eq!(
            findings(&report(root, args)),
            Vec::<String>::new(),
            "{args:?}"
        );
    }
}

#[test]
fn what_a_character_names_is_looked_for_where_all_of_it_is_at_hand() {
    let folder = example();
    let character = folder.path().join("user/config/human.ada.json");
    let text = std::fs::read_to_string(&character)
        .unwrap()
        .replace("nose-hump-incr", "nose-lump-incr");
    std::fs::write(&character, text).unwrap();
    let told = ["user/config/human.ada.json preset-schema"];
    assert_eq!(findings(&report(folder.path(), &["check", "."])), told);
    assert_eq!(
        findings(&report(
            folder.path(),
            &["check", "user", "--system", "data"]
        )),
        told
    );
    // The target may be one of MPFB's own.
    assert_eq!(
        findings(&report(folder.path(), &["check", "user"])),
        Vec::<String>::new()
    );
}

#[test]
fn what_a_character_names_may_lie_in_another_folder_of_the_user() {
    let folder = example();
    let (first, second) = (
        folder.path().join("user/data/targets"),
        folder.path().join("second/data/targets"),
    );
    std::fs::create_dir_all(&second).unwrap();
    std::fs::rename(first.join("custom"), second.join("custom")).unwrap();
    assert_eq!(
        findings(&report(folder.path(), &["check", "."])),
        Vec::<String>::new()
    );
    let alone = findings(&report(
        folder.path(),
        &["check", "user", "--system", "data"],
    ));
    assert!(
        alone.iter().any(|told| told.ends_with(" preset-schema")),
        "{alone:?}"
    );
}

#[test]
fn what_has_no_rules_yet_is_not_passed_over_in_silence() {
    let folder = example();
    let walks = folder.path().join("data/walkcycles");
    std::fs::create_dir_all(&walks).unwrap();
    std::fs::write(walks.join("walk.json"), "{}").unwrap();
    let report = report(folder.path(), &["check", "."]);
    let kinds = report["not_checked"]
        .as_array()
        .unwrap()
        .iter()
        .find(|one| one["what"] == "kind")
        .unwrap();
    let examples: Vec<&str> = kinds["examples"]
        .as_array()
        .unwrap()
        .iter()
        .map(|one| one.as_str().unwrap())
        .collect();
    assert!(
        examples.iter().any(|path| path.contains(".json")),
        "{kinds}"
    );
}
