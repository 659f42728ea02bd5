//! Versions: told by the data, or asked for; what is said then is what that version does.

use std::fs;
use std::path::Path;

use serde_json::Value;

use crate::scratch::{assert_refused, edit, example_of, mhlint, stderr};

fn report(root: &Path, args: &[&str]) -> Value {
    let output = mhlint(root, &[args, &["--report", "json"]].concat());
    serde_json::from_slice(&output.stdout).unwrap_or_else(|_| panic!("{}", stderr(&output)))
}

/// Level and words of the finding of a rule in the first application that it names.
fn told(report: &Value, rule: &str) -> (String, String) {
    let findings = report["findings"].as_array().unwrap();
    let finding = findings
        .iter()
        .find(|one| one["rule"] == rule)
        .unwrap_or_else(|| panic!("{rule}: {report:#}"));
    let first = &finding["breaks"][0];
    (
        first["level"].as_str().unwrap().to_owned(),
        first["effect"].as_str().unwrap().to_owned(),
    )
}

#[test]
fn a_version_that_does_not_exist_stops_the_run_and_names_those_that_do() {
    let repository = example_of("makehuman1");
    let known = "makehuman1@1.0, makehuman1@1.1, makehuman1@1.2, makehuman1@1.3";
    assert_refused(
        &mhlint(repository.path(), &["data", "--app", "makehuman1@1.9"]),
        &[known],
    );
    assert_refused(
        &mhlint(repository.path(), &["data", "--app", "makehuman@1.1"]),
        &["makehuman1"],
    );
    fs::write(
        repository.path().join("mhlint.toml"),
        "apps = [\"makehuman1@7\"]\n",
    )
    .unwrap();
    assert_refused(
        &mhlint(repository.path(), &["data"]),
        &["unknown version", "makehuman1@1.3"],
    );
    fs::write(
        repository.path().join("mhlint.toml"),
        "apps = [\"makehuman1@1.2\"]\n",
    )
    .unwrap();
    assert_eq!(
        report(repository.path(), &["data"])["roots"][0]["version"],
        "1.2"
    );
    assert_eq!(
        report(repository.path(), &["data", "--app", "makehuman1@1.1"])["roots"][0]["version"],
        "1.1"
    );
}

#[test]
fn where_versions_differ_each_is_told_its_own_and_nobody_in_particular_both() {
    let repository = example_of("makehuman2");
    fs::write(
        repository.path().join("data/rigs/figure/second.mhskel"),
        "{ \"name\": ",
    )
    .unwrap();
    let words = |args: &[&str]| {
        told(
            &report(repository.path(), &[&["data"], args].concat()),
            "json-syntax",
        )
        .1
    };
    let both = words(&[]);
    assert!(
        both.contains("up to 2026-08-05 crashes at start")
            && both.contains("since 2026-08-14 logs a line"),
        "{both}"
    );
    let crash = "crashes at start with `AttributeError` while scanning the assets";
    assert_eq!(words(&["--app", "makehuman2@2026-08-05"]), crash);
    for version in ["makehuman2@2026-08-20", "makehuman2@2025"] {
        assert_eq!(
            words(&["--app", version]),
            "logs a line and does not list the file",
            "{version}"
        );
    }
}

#[test]
fn one_byte_empties_the_list_of_older_programs() {
    let repository = example_of("makehuman1");
    edit(
        repository.path(),
        "data/clothes/shirt/shirt.mhclo",
        "name ",
        "# caf\u{e9}\nname ",
    );
    let path = repository.path().join("data/clothes/shirt/shirt.mhclo");
    let text = fs::read_to_string(&path).unwrap();
    let latin: Vec<u8> = text
        .chars()
        .map(|letter| u8::try_from(u32::from(letter)).unwrap())
        .collect();
    fs::write(path, latin).unwrap();
    let of = |app: &str| {
        told(
            &report(repository.path(), &["data", "--app", app]),
            "file-not-utf8",
        )
    };
    let (level, words) = of("makehuman1");
    assert!(
        level != "error" && words.contains("up to 1.2 loses the whole list"),
        "{level} {words}"
    );
    let (level, words) = of("makehuman1@1.2");
    assert!(
        level == "error" && words.contains("loses the whole list"),
        "{level} {words}"
    );
}
