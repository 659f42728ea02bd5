//! Every report of the damaged copies, written for readers that are not ours.

use std::fs;
use std::path::{Path, PathBuf};

use mhlint::report::{self, Format, View};
use mhlint::{Config, Level, Outcome, rule_infos};

use super::cases::{CASES, NUMERIC};
use super::harm::Files;
use super::run;

/// Writes the reports of a run without baseline on a damaged copy, a list of its files, and as
/// `new.txt` the human report of what the damage added. Does nothing unless `MHLINT_DAMAGED` names
/// a folder.
pub(crate) fn write(name: &str, files: &Files, new: &Outcome, config: &Config) {
    let Some(folder) = folder_of(name) else {
        return;
    };
    fs::create_dir_all(&folder).unwrap();
    let paths: Vec<&str> = files.keys().map(String::as_str).collect();
    fs::write(folder.join("files.txt"), paths.join("\n")).unwrap();
    one(&folder.join("new.txt"), Format::Human, false, new, config);
    let plain = Config {
        baseline: None,
        fail_on: Some(Level::Error),
        ..config.clone()
    };
    let outcome = run(files, "", &plain);
    for (format, number) in Format::ALL {
        one(
            &folder.join(format!("report.{format}")),
            *number,
            true,
            &outcome,
            &plain,
        );
    }
}

/// The folder of a case, if its reports are wanted.
fn folder_of(name: &str) -> Option<PathBuf> {
    let folder = PathBuf::from(std::env::var_os("MHLINT_DAMAGED")?);
    let every = std::env::var("MHLINT_DAMAGED_EVERY")
        .ok()
        .and_then(|every| every.parse().ok())
        .unwrap_or(1);
    let number = CASES
        .iter()
        .chain(NUMERIC)
        .position(|case| case.name == name)?;
    let word = |letter: char| {
        if letter.is_ascii_alphanumeric() {
            letter
        } else {
            '-'
        }
    };
    let folder = folder.join(format!(
        "{number:03}-{}",
        name.chars().map(word).collect::<String>()
    ));
    (number % every == 0).then_some(folder)
}

fn one(file: &Path, format: Format, full: bool, outcome: &Outcome, config: &Config) {
    let rules = rule_infos();
    let view = View {
        pass: config.passes(outcome),
        fail_on: config.fail_on,
        max_warnings: None,
        color: false,
        unicode: true,
        width: 100,
        quiet: false,
        full,
        statistics: false,
        rules: &rules,
    };
    let mut bytes = Vec::new();
    report::write(format, outcome, &view, &mut bytes).unwrap();
    fs::write(file, bytes).unwrap();
}
