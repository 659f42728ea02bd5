//! Findings at folders: no report gives a folder to a reader that expects a file.

use std::fs;
use std::path::Path;

use crate::scratch::{edit, example, mhlint, stdout};
use serde_json::Value;

/// The folder of a finding.
const FOLDER: &str = "data/target/figure/head/";
/// The first of its two files that the finding speaks for.
const FILE: &str = "data/target/figure/head/head-oval.target.bak";

/// Two backup copies in a folder are one finding at the folder.
fn backups() -> tempfile::TempDir {
    let repository = example();
    for name in ["head-oval", "head-size-incr"] {
        let file = format!("{FOLDER}{name}.target.bak");
        fs::write(repository.path().join(file), "339 0 .001 .001\n").unwrap();
    }
    repository
}

fn run(root: &Path, format: &str) -> String {
    stdout(&mhlint(
        root,
        &[
            "--report",
            format,
            "--full",
            "--report",
            "human=human.txt",
            "--fail-on",
            "info",
        ],
    ))
}

fn json(root: &Path, format: &str) -> Value {
    serde_json::from_str(&run(root, format)).unwrap()
}

#[test]
fn people_see_a_folder_as_a_folder() {
    let repository = backups();
    let text = |format: &str| run(repository.path(), format);
    assert!(text("concise").starts_with(&format!(
        "{FOLDER}: info[file-unreferenced] 2 files are not used"
    )));
    assert!(text("markdown").contains(&format!("### `{FOLDER}`\n")));
    let page = text("html");
    assert!(
        page.contains(&format!("<code>{FOLDER}</code>"))
            && page.contains(&format!("data-path=\"{FOLDER}\""))
    );
    let human = fs::read_to_string(repository.path().join("human.txt")).unwrap();
    assert!(
        human.contains(&format!("\n{FOLDER}\n")) || human.starts_with(&format!("{FOLDER}\n")),
        "{human}"
    );
}

#[test]
fn a_program_gets_the_path_as_it_is() {
    let report = json(backups().path(), "json");
    assert_eq!(report["findings"][0]["path"], FOLDER.trim_end_matches('/'));
    assert_eq!(
        report["findings"][0]["place"].as_object().unwrap().len(),
        4,
        "the schema knows four members"
    );
}

#[test]
fn a_code_host_gets_the_first_file_and_reads_of_the_folder() {
    let repository = backups();
    let named = format!("`{FOLDER}`: 2 files are not used");
    let log = json(repository.path(), "sarif");
    let result = &log["runs"][0]["results"][0];
    assert_eq!(
        result["locations"][0]["physicalLocation"]["artifactLocation"]["uri"],
        FILE
    );
    assert!(
        result["message"]["text"]
            .as_str()
            .unwrap()
            .starts_with(&named),
        "{result}"
    );
    let issue = &json(repository.path(), "gitlab")[0];
    assert_eq!(issue["location"]["path"], FILE);
    assert!(
        issue["description"].as_str().unwrap().starts_with(&named),
        "{issue}"
    );
    let command = run(repository.path(), "github");
    let expected = format!("::notice file={FILE},title=mhlint%3A file-unreferenced::{named}");
    assert!(command.starts_with(&expected), "{command}");
    let suite = run(repository.path(), "junit");
    assert!(
        suite.contains(&format!("classname=\"{FOLDER}\" file=\"{FILE}\"")),
        "{suite}"
    );
}

#[test]
fn the_file_of_another_place_in_the_finding_is_better_than_the_first_in_the_folder() {
    let repository = example();
    fs::rename(
        repository.path().join("data/target"),
        repository.path().join("data/Target"),
    )
    .unwrap();
    let issues = json(repository.path(), "gitlab");
    let issue = issues
        .as_array()
        .unwrap()
        .iter()
        .find(|one| one["check_name"] == "file-case-mismatch")
        .unwrap();
    let path = issue["location"]["path"].as_str().unwrap();
    assert!(
        path.starts_with("data/Target/") && repository.path().join(path).is_file(),
        "{path}"
    );
}

#[test]
#[cfg(target_os = "linux")]
fn a_folder_without_files_is_given_as_no_file() {
    let repository = example();
    // Two names that only differ in case, with nothing in them.
    for name in ["Rest", "rest"] {
        fs::create_dir_all(repository.path().join("user/target").join(name)).unwrap();
    }
    let log = json(repository.path(), "sarif");
    let results = log["runs"][0]["results"].as_array().unwrap();
    let uri = |result: &Value| {
        result["locations"][0]["physicalLocation"]["artifactLocation"]["uri"]
            .as_str()
            .unwrap()
            .to_owned()
    };
    assert_eq!(
        results.iter().map(uri).collect::<Vec<_>>(),
        ["user/target/rest/"],
        "{log}"
    );
    assert_eq!(
        json(repository.path(), "gitlab")[0]["location"]["path"],
        "user/target/rest/"
    );
    let command = run(repository.path(), "github");
    assert!(
        command.contains(" title=mhlint%3A file-case-conflict::`user/target/rest/`: "),
        "{command}"
    );
    let suite = run(repository.path(), "junit");
    assert!(
        suite.contains("classname=\"user/target/rest/\">"),
        "{suite}"
    );
}

#[test]
fn every_file_of_every_report_is_one() {
    let repository = backups();
    let root = repository.path();
    for name in ["head-oval", "head-size-incr"] {
        edit(
            root,
            &format!("{FOLDER}{name}.target"),
            "# basemesh figure",
            "# basemesh imp",
        );
    }
    fs::create_dir_all(root.join("user/Contarget")).unwrap();
    fs::write(root.join("user/Contarget/x.target"), "1 0 0 0\n").unwrap();
    let log = json(root, "sarif");
    let results = log["runs"][0]["results"].as_array().unwrap().clone();
    let places = results
        .iter()
        .map(|one| &one["locations"][0]["physicalLocation"]["artifactLocation"]["uri"]);
    let issues = json(root, "gitlab");
    let issues = issues
        .as_array()
        .unwrap()
        .iter()
        .map(|one| &one["location"]["path"]);
    let files: Vec<&str> = places
        .chain(issues)
        .map(|path| path.as_str().unwrap())
        .collect();
    assert!(files.len() > 5, "{files:?}");
    for file in files {
        assert!(root.join(file).is_file(), "{file}");
    }
}
