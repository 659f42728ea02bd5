//! The reports: JSON against its published schema, the human one as a reader sees it.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may stop where it fails")]

mod scratch;

use std::fs;
use std::path::Path;

use scratch::{example, mhlint, project};
use serde_json::Value;

fn edit(root: &Path, file: &str, find: &str, replace: &str) {
    let path = root.join(file);
    let text = fs::read_to_string(&path).unwrap();
    assert!(text.contains(find), "`{find}` is not in {file}");
    fs::write(path, text.replacen(find, replace, 1)).unwrap();
}

/// A copy of the example repository with two errors in two files.
fn broken() -> tempfile::TempDir {
    let repository = example();
    let [old, new] = ["\"steps\": [0.0, 0.25, 0.5, 1.0]", "\"steps\": [0.0, 0.5, 1.0]"];
    edit(repository.path(), "data/target/figure/macro.json", old, new);
    edit(repository.path(), "data/target/figure/head/head-oval.target", "339 0 .001 .001", "339 0 0,001 .001");
    repository
}

fn run(root: &Path, args: &[&str]) -> String {
    String::from_utf8(mhlint(root, args).stdout).unwrap()
}

#[test]
fn json_reports_fit_their_schema() {
    let schema: Value =
        serde_json::from_str(&fs::read_to_string(project("schemas/report.schema.json")).unwrap()).unwrap();
    let validator = jsonschema::validator_for(&schema).unwrap();
    let other = example();
    fs::create_dir_all(other.path().join("other/targets")).unwrap();
    fs::write(other.path().join("other/targets/target.json"), "{}").unwrap();
    let empty = tempfile::tempdir().unwrap();
    for root in [broken().path(), other.path(), empty.path(), &project("fixtures/makehuman2")] {
        let report: Value = serde_json::from_str(&run(root, &["--report", "json"])).unwrap();
        let faults: Vec<String> =
            validator.iter_errors(&report).map(|fault| format!("{}: {fault}", fault.instance_path())).collect();
        assert_eq!(faults, Vec::<String>::new());
    }
}

#[test]
fn json_counts_what_it_lists() {
    let report: Value = serde_json::from_str(&run(broken().path(), &["--report", "json"])).unwrap();
    let listed = report["findings"].as_array().unwrap();
    for level in ["error", "warning", "info"] {
        let count = listed.iter().filter(|finding| finding["level"] == level).count() as u64;
        assert_eq!(report["summary"][level].as_u64(), Some(count), "{level}");
    }
    assert_eq!(report["verdict"], "fail");
}

#[test]
fn all_reports_tell_the_same_findings() {
    let repository = broken();
    let report: Value = serde_json::from_str(&run(repository.path(), &["--report", "json"])).unwrap();
    let concise = run(repository.path(), &["--report", "concise"]);
    let human = run(repository.path(), &[]);
    let findings = report["findings"].as_array().unwrap();
    assert_eq!(concise.lines().count(), findings.len() + 1);
    for finding in findings {
        let rule = finding["rule"].as_str().unwrap();
        assert!(concise.contains(&format!("[{rule}]")) && human.contains(&format!("[{rule}]")), "{rule}");
    }
}

#[test]
fn human_report_shows_source_consequence_and_help() {
    let text = run(broken().path(), &["--only", "macro-steps-length"]);
    for part in [
        "data/target/figure/macro.json\n",
        "  error[macro-steps-length] component `age` has 4 values but 3 steps",
        "MakeHuman 2: stops with an IndexError",
        "[data/target/figure/macro.json:11:22]",
        "11 |",
        "^^^^",
        "  help: give every value a step",
        "  more: mhlint explain macro-steps-length",
        "1 error, 0 warnings, 0 infos in ",
        "Failed. 1 error: MakeHuman 2 would",
    ] {
        assert!(text.contains(part), "no `{part}` in:\n{text}");
    }
}

#[test]
fn human_report_fits_eighty_columns_and_ascii_when_piped() {
    let text = run(broken().path(), &[]);
    assert!(text.is_ascii(), "{text}");
    let wide: Vec<&str> = text.lines().filter(|line| line.len() > 80).collect();
    assert_eq!(wide, Vec::<&str>::new());
}

#[test]
fn human_report_names_what_passes() {
    let level = "macro-steps-length=warning";
    let text = run(broken().path(), &["--only", "macro-steps-length", "--level", level]);
    assert!(text.contains("Passed: nothing at or above error. 1 warning:"), "{text}");
}

#[test]
fn names_in_assets_cannot_steer_the_terminal() {
    let repository = example();
    let hostile = "\\u001b]0;owned\\u0007\\u001b[2Jage\\u202e";
    let macros = "data/target/figure/macro.json";
    edit(repository.path(), macros, "\"steps\": [0.0, 0.25, 0.5, 1.0]", "\"steps\": [0.0, 0.5, 1.0]");
    edit(repository.path(), macros, "\"age\"", &format!("\"{hostile}\""));
    edit(repository.path(), "data/target/figure/head/head-oval.target", "339 0 .001 .001", "339 0 \u{1b}[31mred .001");
    for format in ["human", "concise"] {
        let text = run(repository.path(), &["--report", format]);
        assert!(text.contains("owned") && text.contains("red"), "{format} must show the name:\n{text}");
        let steering = text.chars().find(|c| (c.is_control() && *c != '\n') || *c == '\u{202e}');
        assert_eq!(steering, None, "{format}:\n{text}");
    }
}

#[test]
fn long_lists_are_cut_with_a_word_on_the_rest() {
    let repository = example();
    let folder = repository.path().join("data/target/figure/head");
    for number in 0..14 {
        fs::write(folder.join(format!("broken{number}.target")), "1 2 x 4\n").unwrap();
    }
    let text = run(repository.path(), &["--only", "target-breaks-start"]);
    assert_eq!(text.matches("error[target-breaks-start]").count(), 10, "{text}");
    assert!(text.contains("and 4 more like it: `--only target-breaks-start --report concise` lists all"), "{text}");
    assert!(text.contains("14 errors, "), "{text}");
}
