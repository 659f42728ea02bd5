//! Bad input in everything a body wears, in the examples of both applications: files that are
//! empty, cut off, in another encoding or a pointer, and each number as something else. No rule
//! fails, every finding has a place, and what is lost is reported.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;
use std::sync::Arc;

use crate::scratch::{content, project};
use mhlint::{Config, Outcome, Tree, lint_trees};
use rayon::prelude::*;

type Files = BTreeMap<String, Arc<[u8]>>;

/// Texts that are read line by line.
const TEXT: [&str; 8] = [
    "mhclo", "proxy", "mhmat", "obj", "bvh", "meta", "mhm", "txt",
];
/// What else there is of a wardrobe.
const OTHERS: [&str; 4] = ["mhw", "mhpose", "png", "thumb"];
const POINTER: &[u8] = b"version https://git-lfs.github.com/spec/v1\noid sha256:4d7a214614ab2935c943f9e0ff69d22eadbb8f32b1258daaa5e2ca24d17e2393\nsize 12345\n";

/// An example, both its data folders, in memory.
fn example(name: &str) -> Files {
    let listed = content(&project("fixtures").join(name)).into_iter();
    listed
        .map(|(path, bytes)| (path.to_str().unwrap().replace('\\', "/"), bytes.into()))
        .collect()
}

fn has_extension(path: &str, extensions: &[&str]) -> bool {
    Path::new(path)
        .extension()
        .is_some_and(|own| extensions.iter().any(|one| own == *one))
}

/// Files of a wardrobe: not the pictures of sliders, nor what the body is made of.
fn worn<'f>(
    files: &'f Files,
    extensions: &'f [&str],
) -> impl Iterator<Item = (&'f String, &'f Arc<[u8]>)> {
    let folders = [
        "/base/",
        "/target/",
        "/contarget/",
        "/rigs/",
        "/shaders/",
        "/3dobjs/",
    ];
    let is_worn = move |path: &str| !folders.iter().any(|folder| path.contains(folder));
    files
        .iter()
        .filter(move |(path, _)| has_extension(path, extensions) && is_worn(path))
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
        ..Config::default()
    };
    let outcome = lint_trees(vec![Tree::in_memory("", changed)], None, &options).unwrap();
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

/// Runs a damage on all chosen files of both examples; gives those of which nothing is said.
fn silent(extensions: &[&str], damage: impl Fn(&[u8]) -> Vec<u8> + Sync) -> Vec<String> {
    let mut silent = Vec::new();
    for files in ["makehuman2", "makehuman1"].map(example) {
        let chosen: Vec<_> = worn(&files, extensions).collect();
        assert!(chosen.len() > 10, "{extensions:?}");
        let quiet = chosen
            .par_iter()
            .filter(|(path, bytes)| run(&files, path, damage(bytes)).findings.is_empty());
        silent.extend(quiet.map(|(path, _)| (*path).clone()).collect::<Vec<_>>());
    }
    silent
}

#[test]
fn pointers_in_place_of_files_are_reported() {
    let all: Vec<&str> = TEXT.into_iter().chain(OTHERS).collect();
    assert_eq!(silent(&all, |_| POINTER.to_vec()), Vec::<String>::new());
}

#[test]
fn empty_files_are_reported() {
    let all: Vec<&str> = TEXT.into_iter().chain(OTHERS).collect();
    assert_eq!(silent(&all, |_| Vec::new()), Vec::<String>::new());
}

#[test]
fn files_that_end_early_fail_no_rule() {
    let all: Vec<&str> = TEXT.into_iter().chain(OTHERS).collect();
    for part in [3, 2] {
        let quiet = silent(&all, |bytes| bytes[..bytes.len() / part].to_vec());
        // A material, a model or a description may end after any line.
        let lost: Vec<_> = quiet
            .iter()
            .filter(|path| !has_extension(path, &["mhmat", "mhm", "meta", "txt"]))
            .collect();
        assert!(lost.is_empty(), "cut at 1/{part}: {lost:?}");
    }
    for cut in [1, 2] {
        silent(&all, |bytes| {
            bytes[..bytes.len().saturating_sub(cut)].to_vec()
        });
    }
}

#[test]
fn line_ends_of_windows_are_silent() {
    let damage = |bytes: &[u8]| {
        String::from_utf8(bytes.to_vec())
            .unwrap()
            .replace('\n', "\r\n")
            .into_bytes()
    };
    for files in ["makehuman2", "makehuman1"].map(example) {
        for (path, bytes) in worn(&files, &TEXT) {
            assert_eq!(run(&files, path, damage(bytes)).findings, [], "{path}");
        }
    }
}

#[test]
fn bytes_of_another_encoding_are_reported() {
    let behind_first_line = |bytes: &[u8]| {
        let end = bytes.iter().position(|byte| *byte == b'\n').unwrap();
        [&bytes[..end], b" \xe9", &bytes[end..]].concat()
    };
    let quiet = silent(&TEXT, behind_first_line);
    // What a compiler of shaders makes of them is not known.
    assert!(
        quiet.iter().all(|path| has_extension(path, &["txt"])),
        "{quiet:?}"
    );
}

#[test]
fn marks_in_front_are_reported() {
    let quiet = silent(&TEXT, |bytes| [b"\xef\xbb\xbf", bytes].concat());
    assert!(
        quiet.iter().all(|path| has_extension(path, &["txt"])),
        "{quiet:?}"
    );
}

/// Every number of the first lines of each keyword.
fn numbers(text: &str) -> Vec<std::ops::Range<usize>> {
    let mut seen: BTreeMap<&str, usize> = BTreeMap::new();
    let mut found = Vec::new();
    for line in text.lines() {
        let words: Vec<&str> = line.split_whitespace().collect();
        let Some(first) = words.first().filter(|first| !first.starts_with('#')) else {
            continue;
        };
        let keyword = if first.parse::<f64>().is_ok() {
            ""
        } else {
            first
        };
        let count = seen.entry(keyword).or_default();
        *count += 1;
        if *count > 2 {
            continue;
        }
        let is_number = |word: &&&str| word.parse::<f64>().is_ok();
        found.extend(words.iter().filter(is_number).map(|word| {
            let start = word.as_ptr() as usize - text.as_ptr() as usize;
            start..start + word.len()
        }));
    }
    found
}

#[test]
fn numbers_that_are_none_fail_no_rule() {
    for (name, least) in [("makehuman2", 0.6), ("makehuman1", 0.6)] {
        let files = example(name);
        let mut damages: BTreeSet<(&str, usize, String)> = BTreeSet::new();
        for (path, bytes) in worn(&files, &["mhclo", "proxy", "mhmat", "obj", "bvh", "mhm"]) {
            let text = std::str::from_utf8(bytes).unwrap();
            for span in numbers(text) {
                for other in ["word", "50%", "0,5", "nan", "1e400", "-", "٣", ""] {
                    let changed = format!("{}{other}{}", &text[..span.start], &text[span.end..]);
                    damages.insert((path, span.start, changed));
                }
            }
        }
        let loud = damages.par_iter().filter(|(path, _, changed)| {
            let outcome = run(&files, path, changed.clone().into_bytes());
            !outcome.findings.is_empty()
        });
        let (loud, all) = (loud.count(), damages.len());
        assert!(all > 300, "{name}: {all} damages");
        assert!(
            loud as f64 > least * all as f64,
            "{name}: {loud} of {all} damages are reported"
        );
    }
}
