//! Bad input in rigs, weights, tables, poses and what is worn of MPFB: each value as something
//! else, lists of another length, files that are empty, cut off or a pointer. No rule fails, every
//! finding has a place, and what the loader stops at is reported. What is large or deep goes
//! through the binary.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::fs;
use std::sync::Arc;

use crate::scratch::exchanged::{exchanged, pointers};
use crate::scratch::{content, copy_folder, findings, mhlint, project};
use mhlint::{Application, Config, Outcome, Tree, lint_trees};
use rayon::prelude::*;
use serde_json::{Value, json};

type Files = BTreeMap<String, Arc<[u8]>>;

const RIGS: [&str; 2] = [
    "data/rigs/rigify/rig.cube_control.json",
    "user/data/rigs/stick.json",
];
const WEIGHTS: [&str; 2] = [
    "data/rigs/standard/weights.cube.json",
    "user/data/rigs/weights.stick.json",
];
const TABLES: [&str; 2] = [
    "data/mesh_metadata/basemesh_vertex_groups.json",
    "data/mesh_metadata/hm08_config.json",
];

fn example() -> Files {
    let listed = content(&project("fixtures/mpfb")).into_iter();
    listed
        .map(|(path, bytes)| (path.to_str().unwrap().replace('\\', "/"), bytes.into()))
        .collect()
}

fn run(files: &Files, path: &str, bytes: Vec<u8>) -> Outcome {
    let shared = files
        .iter()
        .map(|(path, bytes)| (path.clone(), Arc::clone(bytes)));
    let changed = shared
        .filter(|(other, _)| other != path)
        .chain([(path.to_owned(), bytes.into())]);
    let options = Config {
        no_eval: true,
        applications: vec![Application::Mpfb],
        ..Config::default()
    };
    let tree = Tree::in_memory("", changed);
    let outcome = lint_trees(vec![tree], None, &options).unwrap();
    assert!(
        outcome.is_whole(),
        "{path}: {:?} {:?}",
        outcome.failed_rules,
        outcome.failed_files
    );
    assert!(
        outcome
            .findings
            .iter()
            .all(|finding| !finding.path.is_empty()),
        "{path}"
    );
    outcome
}

/// How many of the damages are reported.
fn reported(files: &Files, path: &str, others: &[Value]) -> (usize, usize) {
    let whole: Value = serde_json::from_slice(&files[path]).unwrap();
    let damages = exchanged(&whole, others);
    let told = damages.par_iter().filter(|(_, copy)| {
        !run(files, path, serde_json::to_vec(copy).unwrap())
            .findings
            .is_empty()
    });
    (told.count(), damages.len())
}

#[test]
fn every_value_of_rigs_and_tables_may_be_anything() {
    let files = example();
    let others = [
        json!(null),
        json!("1"),
        json!(-1),
        json!(1e300),
        json!([]),
        json!({}),
        json!([1, 2]),
        json!([[]]),
    ];
    for path in RIGS.into_iter().chain(WEIGHTS).chain(TABLES) {
        let (told, all) = reported(&files, path, &others);
        // Of the dimensions only numbers of vertices are read.
        let share = if path.ends_with("hm08_config.json") {
            4
        } else {
            2
        };
        assert!(
            told * share > all,
            "{path}: {told} of {all} damages are reported"
        );
    }
}

#[test]
fn lists_of_another_length_are_reported_in_bones_and_constraints() {
    let files = example();
    let path = "user/data/rigs/stick.json";
    let whole: Value = serde_json::from_slice(&files[path]).unwrap();
    let mut places = Vec::new();
    pointers(&whole, "", &mut places);
    let mut silent = Vec::new();
    let list = |place: &&String| {
        whole
            .pointer(place)
            .unwrap()
            .as_array()
            .is_some_and(|list| !list.is_empty())
    };
    // Names of collections and of bones may be any number; a default position is read where nothing
    // else is found.
    let open = [
        "collections",
        "identifying_bones",
        "constraints",
        "default_position",
    ];
    let is_open = |place: &&String| open.iter().any(|key| place.ends_with(key));
    let lists: Vec<&String> = places
        .iter()
        .filter(list)
        .filter(|place| !is_open(place))
        .collect();
    assert!(!lists.is_empty());
    for place in lists {
        for longer in [false, true] {
            let mut copy = whole.clone();
            let items = copy.pointer_mut(place).unwrap().as_array_mut().unwrap();
            if longer {
                items.push(json!(0.5));
            } else {
                drop(items.pop());
            }
            if run(&files, path, serde_json::to_vec(&copy).unwrap())
                .findings
                .is_empty()
            {
                silent.push(format!(
                    "{place} {}",
                    if longer { "longer" } else { "shorter" }
                ));
            }
        }
    }
    assert!(silent.is_empty(), "{silent:#?}");
}

#[test]
fn empty_and_cut_files_and_pointers_are_reported() {
    const POINTER: &[u8] = b"version https://git-lfs.github.com/spec/v1\noid sha256:4d7a214614ab2935c943f9e0ff69d22eadbb8f32b1258daaa5e2ca24d17e2393\nsize 12345\n";
    let files = example();
    let checked = |path: &&String| {
        [
            ".json", ".mhclo", ".proxy", ".mhmat", ".obj", ".mirror", ".gz",
        ]
        .iter()
        .any(|ending| path.ends_with(ending))
    };
    let chosen: Vec<&String> = files.keys().filter(checked).collect();
    let quiet: Vec<String> = chosen
        .par_iter()
        .flat_map_iter(|path| {
            let bytes = &files[*path];
            let cut = [
                Vec::new(),
                bytes[..bytes.len() / 2].to_vec(),
                POINTER.to_vec(),
            ];
            cut.into_iter()
                .enumerate()
                .map(move |(at, bytes)| (*path, at, bytes))
        })
        .filter(|(path, _, bytes)| run(&files, path, bytes.clone()).findings.is_empty())
        .map(|(path, at, _)| format!("{path} {at}"))
        .collect();
    // A material and the table of counterparts may end after any line; a target of the macros may
    // be empty.
    let may_end = |line: &&String| {
        [".mhmat 1", ".mirror 1"]
            .iter()
            .any(|end| line.ends_with(end))
    };
    let may_be_empty = |line: &&String| line.ends_with(".target.gz 0");
    let lost: Vec<_> = quiet
        .iter()
        .filter(|line| !may_end(line) && !may_be_empty(line))
        .collect();
    assert!(lost.is_empty(), "{lost:#?}");
}

/// The example on disk.
fn on_disk() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    copy_folder(&project("fixtures/mpfb"), folder.path());
    folder
}

/// A bone at a joint of the example.
fn bone(name: &str, parent: &str) -> String {
    format!(
        r#""{name}": {{"head": {{"strategy": "CUBE", "cube_name": "joint-ground", "default_position": [0, 0, 0]}},
        "tail": {{"strategy": "CUBE", "cube_name": "joint-head", "default_position": [0, 0, 1]}}, "roll": 0, "parent": "{parent}",
        "use_connect": false, "use_inherit_rotation": true, "use_local_location": true, "inherit_scale": "FULL", "rigify": {{}}}}"#
    )
}

/// What the binary reports of the example with another file.
fn with(path: &str, text: &str) -> (Option<i32>, Vec<String>) {
    let folder = on_disk();
    let file = folder.path().join(path);
    fs::create_dir_all(file.parent().unwrap()).unwrap();
    fs::write(&file, text).unwrap();
    let output = mhlint(folder.path(), &["check", ".", "--report", "concise"]);
    (output.status.code(), findings(&output))
}

#[test]
fn a_hundred_thousand_bones_in_a_chain_end_with_a_verdict() {
    let mut text = String::from("{\n");
    for at in 0..100_000 {
        let parent = if at == 0 {
            String::new()
        } else {
            format!("b{}", at - 1)
        };
        let comma = if at == 0 { "" } else { ",\n" };
        write!(text, "{comma}{}", bone(&format!("b{at}"), &parent)).unwrap();
    }
    text.push_str("\n}");
    let (code, found) = with("data/rigs/standard/rig.long.json", &text);
    // It has no weights.
    assert_eq!(code, Some(1), "{found:?}");
    assert!(
        found
            .iter()
            .any(|line| line.contains("rig-missing-weights")),
        "{found:?}"
    );
    assert!(found.len() < 7, "{found:?}");
}

#[test]
fn a_name_of_64_bytes_is_reported_and_one_of_63_is_not() {
    for (length, is_told) in [(63, false), (64, true)] {
        let text = format!("{{{}}}", bone(&"b".repeat(length), ""));
        let (_, found) = with("data/rigs/standard/rig.one.json", &text);
        assert_eq!(
            found.iter().any(|line| line.contains("rig-bone-name")),
            is_told,
            "{length}: {found:?}"
        );
    }
}

#[test]
fn deep_nesting_in_a_rig_and_in_weights_is_reported() {
    for path in [
        "data/rigs/standard/rig.cube.json",
        "data/rigs/standard/weights.cube.json",
        "user/data/rigs/stick.json",
    ] {
        let text = format!(
            "{{\"version\": 110, \"bones\": {}{}}}",
            "[".repeat(100_000),
            "]".repeat(100_000)
        );
        let (code, found) = with(path, &text);
        assert_eq!(code, Some(1), "{path}: {found:?}");
        assert!(
            found.iter().any(|line| line.contains("json-too-deep")),
            "{path}: {found:?}"
        );
    }
}

#[test]
fn weights_of_two_hundred_megabytes_end_with_a_verdict() {
    let entry = "[0, 0.5], [1, 0.25], ";
    let mut text = String::with_capacity(210_000_000);
    text.push_str("{\"weights\": {\"top\": [");
    while text.len() < 200_000_000 {
        text.push_str(entry);
    }
    text.push_str("[2, 1.0]]}}");
    let (code, found) = with("data/rigs/standard/weights.cube.json", &text);
    // Nothing of it is worse than a warning.
    assert_eq!(code, Some(0), "{found:?}");
    assert!(
        !found.is_empty() && found.iter().all(|line| line.contains("weights.cube.json")),
        "{found:?}"
    );
}
