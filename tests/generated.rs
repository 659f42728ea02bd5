//! What is generated is fresh: the rule table and the help in the README, the samples of the reports.
//!
//! `UPDATE=1 cargo test --test generated` rewrites them.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may stop where it fails")]

mod scratch;

use std::fs;

use scratch::{Case, example, mhlint, project};

#[test]
fn readme_holds_the_rule_table() {
    let rules = mhlint(&project("."), &["rules", "--format", "markdown"]).stdout;
    check("README.md", "rules", &String::from_utf8(rules).unwrap());
}

#[test]
fn readme_holds_the_help() {
    let help = String::from_utf8(mhlint(&project("."), &["--help"]).stdout).unwrap();
    let lines: Vec<&str> = help.lines().map(str::trim_end).collect();
    check("README.md", "help", &format!("```text\n{}\n```\n", lines.join("\n").trim_end()));
}

#[test]
fn the_samples_of_the_reports_are_what_is_written() {
    let repository = example();
    Case::read(&project("fixtures/rules/macro-steps-length/bad")).apply(repository.path());
    let formats = [
        ("human", "text"),
        ("concise", "text"),
        ("json", "json"),
        ("sarif", "json"),
        ("github", "text"),
        ("gitlab", "json"),
        ("junit", "xml"),
        ("markdown", "markdown"),
    ];
    for (format, language) in formats {
        let args = ["data", "--only", "macro-steps-length", "--report", format];
        let sample = String::from_utf8(mhlint(repository.path(), &args).stdout).unwrap();
        check("docs/reports.md", format, &format!("````{language}\n{}\n````\n", sample.trim_end()));
    }
}

#[test]
fn the_schema_of_the_configuration_is_that_of_keys_and_rules() {
    let schema = mhlint::config::schema(&mhlint::rule_infos());
    let wanted = format!("{}\n", serde_json::to_string_pretty(&schema).unwrap());
    let path = project("schemas/config.schema.json");
    if fs::read_to_string(&path).unwrap_or_default() == wanted {
        return;
    }
    let may_write = std::env::var_os("UPDATE").is_some();
    assert!(may_write, "schemas/config.schema.json is not fresh: UPDATE=1 cargo test --test generated");
    fs::write(path, wanted).unwrap();
}

/// Compares what lies between `<!-- NAME -->` and `<!-- /NAME -->`, or rewrites it.
fn check(file: &str, name: &str, wanted: &str) {
    let path = project(file);
    let text = fs::read_to_string(&path).unwrap();
    let [open, close] = [format!("<!-- {name} -->\n"), format!("<!-- /{name} -->")];
    let (before, rest) = text.split_once(&open).unwrap_or_else(|| panic!("{file} lacks {open}"));
    let (found, after) = rest.split_once(&close).unwrap_or_else(|| panic!("{file} lacks {close}"));
    if found == wanted {
        return;
    }
    assert!(
        std::env::var_os("UPDATE").is_some(),
        "{file}#{name} is not fresh: UPDATE=1 cargo test --test generated -- --test-threads 1"
    );
    fs::write(path, format!("{before}{open}{wanted}{close}{after}")).unwrap();
}
