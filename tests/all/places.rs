//! Places of every shape that data are found in: what each is taken for, and what is found there.
//!
//! `fixtures/places/<name>/place.toml` says in one sentence what the place is, and makes it: parts
//! of the example repositories (`take`), large meshes (`mesh`), and edits as in `case.toml`.
//! `expected.txt` holds what each data folder was taken for, the findings, and what was not
//! checked. `UPDATE=1 cargo test places::` rewrites them; read the diff before you commit.

use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};

use rayon::prelude::*;
use serde::Deserialize;
use serde_json::Value;

use crate::scratch::{Case, copy_folder, folders, mhlint, project, remove, stderr};

/// What makes a place besides edits.
#[derive(Debug, Default, Deserialize)]
struct Parts {
    /// Arguments; `.` if there are none.
    #[serde(default)]
    args: Vec<String>,
    /// Folders or files of `fixtures/`, and where they come to lie.
    #[serde(default)]
    take: Vec<[String; 2]>,
    /// Files and folders that go when all else is done.
    #[serde(default)]
    gone: Vec<String>,
    /// Meshes too large to write down.
    #[serde(default)]
    mesh: Vec<Mesh>,
}

/// A mesh with so many vertices and texture coordinates: a strip of squares.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Mesh {
    file: String,
    vertices: usize,
    uvs: usize,
}

impl Mesh {
    fn text(&self) -> String {
        let mut text = String::new();
        for number in 0..self.vertices {
            let (row, side) = (number / 2, number % 2);
            writeln!(text, "v {side} {:.3} 0.{:03}", row as f64 / 1000.0, row % 7).unwrap();
        }
        for number in 0..self.uvs {
            writeln!(text, "vt 0.{:04} 0.{}", number % 9973, number % 7).unwrap();
        }
        text.push_str("g body\n");
        for square in 0..(self.vertices / 2).saturating_sub(1) {
            let [a, b, c, d] = [1, 2, 4, 3].map(|corner| square * 2 + corner);
            writeln!(text, "f {a}/{a} {b}/{b} {c}/{c} {d}/{d}").unwrap();
        }
        text
    }
}

/// Makes the place of a fixture; gives it with the arguments.
fn made(folder: &Path) -> (tempfile::TempDir, Vec<String>) {
    let text = fs::read_to_string(folder.join("place.toml")).unwrap();
    let parts: Parts =
        toml::from_str(&text).unwrap_or_else(|error| panic!("{}: {error}", folder.display()));
    let mut edits: toml::Table = toml::from_str(&text).unwrap();
    ["args", "take", "gone", "mesh"]
        .iter()
        .for_each(|key| drop(edits.remove(*key)));
    let edits: Case = toml::Value::Table(edits)
        .try_into()
        .unwrap_or_else(|error| panic!("{}: {error}", folder.display()));
    let place = tempfile::tempdir().unwrap();
    for [from, to] in &parts.take {
        let (from, to) = (project("fixtures").join(from), place.path().join(to));
        fs::create_dir_all(to.parent().unwrap()).unwrap();
        if from.is_dir() {
            copy_folder(&from, &to);
        } else {
            fs::copy(&from, &to).unwrap_or_else(|error| panic!("{}: {error}", from.display()));
        }
    }
    edits.apply(place.path());
    parts
        .gone
        .iter()
        .for_each(|path| remove(&place.path().join(path)));
    for mesh in &parts.mesh {
        let path = place.path().join(&mesh.file);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, mesh.text()).unwrap();
    }
    let args = if parts.args.is_empty() {
        vec![".".to_owned()]
    } else {
        parts.args
    };
    (place, args)
}

/// What a run says of a place.
fn told(place: &Path, args: &[String]) -> String {
    let args: Vec<&str> = args
        .iter()
        .map(String::as_str)
        .chain(["--report", "json"])
        .collect();
    let output = mhlint(place, &args);
    let mut text = format!("exit {}\n", output.status.code().unwrap());
    let Ok(report) = serde_json::from_slice::<Value>(&output.stdout) else {
        return text + &stderr(&output);
    };
    let list = |value: &Value| value.as_array().cloned().unwrap_or_default();
    let word = |value: &Value| value.as_str().unwrap_or("-").to_owned();
    for root in list(&report["roots"]) {
        let (kind, version) = (word(&root["kind"]), word(&root["version"]));
        writeln!(
            text,
            "{}: {kind} of {} {version}",
            word(&root["path"]),
            word(&root["application"])
        )
        .unwrap();
        for sign in list(&root["evidence"]) {
            let [application, speaks, sign] =
                ["application", "speaks", "sign"].map(|key| word(&sign[key]));
            writeln!(text, "  {speaks} {application}: {sign}").unwrap();
        }
    }
    for finding in list(&report["findings"]) {
        let [level, rule, path, message] =
            ["level", "rule", "path", "message"].map(|key| word(&finding[key]));
        writeln!(text, "{path}: {level}[{rule}] {message}").unwrap();
    }
    for entry in list(&report["not_checked"]) {
        let examples: Vec<String> = list(&entry["examples"]).iter().map(word).collect();
        let (application, what) = (word(&entry["application"]), word(&entry["what"]));
        writeln!(
            text,
            "not checked for {application}: {what} {}: {}",
            entry["count"],
            examples.join(", ")
        )
        .unwrap();
    }
    text
}

fn places() -> Vec<PathBuf> {
    folders(&project("fixtures/places"))
}

#[test]
fn every_place_is_taken_for_what_it_is() {
    let only = std::env::var("CASE").unwrap_or_default();
    let fault = |folder: &PathBuf| {
        let (place, args) = made(folder);
        let (told, path) = (told(place.path(), &args), folder.join("expected.txt"));
        if std::env::var_os("UPDATE").is_some() {
            fs::write(&path, &told).unwrap();
        }
        let expected = fs::read_to_string(&path).unwrap_or_default();
        (told != expected).then(|| format!("{}:\n{told}\nexpected:\n{expected}", folder.display()))
    };
    let chosen = places()
        .into_iter()
        .filter(|folder| folder.to_string_lossy().contains(&only));
    let faults: Vec<String> = chosen
        .collect::<Vec<_>>()
        .par_iter()
        .filter_map(fault)
        .collect();
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn there_are_places_of_every_kind_for_every_application() {
    assert!(places().len() >= 40, "{}", places().len());
    let all: Vec<String> = places()
        .iter()
        .map(|folder| fs::read_to_string(folder.join("expected.txt")).unwrap())
        .collect();
    for application in ["makehuman1", "makehuman2", "mpfb"] {
        for kind in ["program", "partial", "user", "pack", "asset", "loose"] {
            let wanted = format!(": {kind} of {application} ");
            assert!(all.iter().any(|text| text.contains(&wanted)), "{wanted}");
        }
    }
    for wanted in [": release of makehuman1", ": helpers ", ": tests "] {
        assert!(all.iter().any(|text| text.contains(wanted)), "{wanted}");
    }
}
