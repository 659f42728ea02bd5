//! Bad input of every kind on the example repository: no panic, no failed rule, no hang; a finding
//! with a place wherever something is lost, silence only where the loader does not mind.

use std::collections::BTreeMap;
use std::path::Path;
use std::sync::Arc;

use crate::scratch::pack::packed;
use crate::scratch::{example, findings, mhlint, project, stderr};
use flate2::{Compression, write::GzEncoder};
use mhlint::{Config, Outcome, Tree, lint_trees};
use rayon::prelude::*;
use serde_json::{Value, json};

type Files = BTreeMap<String, Arc<[u8]>>;

/// Text formats of the example.
const TEXT: [&str; 6] = ["json", "target", "mhskel", "mhw", "obj", "mhm"];
const JSON: [&str; 3] = ["json", "mhskel", "mhw"];

/// The system data of the example, in memory.
fn files() -> Files {
    let root = project("fixtures/makehuman2/data");
    let listed = walkdir::WalkDir::new(&root).into_iter().map(Result::unwrap);
    listed
        .filter(|entry| entry.file_type().is_file())
        .map(|entry| {
            let path = entry
                .path()
                .strip_prefix(&root)
                .unwrap()
                .to_str()
                .unwrap()
                .replace('\\', "/");
            (path, std::fs::read(entry.path()).unwrap().into())
        })
        .collect()
}

fn is_one_of(path: &str, kinds: &[&str]) -> bool {
    Path::new(path)
        .extension()
        .is_some_and(|ext| kinds.iter().any(|kind| ext == *kind))
}

/// The run on the example with one file replaced; every finding lies in the tree.
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
    let failed = || {
        (
            &outcome.failed_rules,
            &outcome.failed_files,
            &outcome.failed_steps,
        )
    };
    assert!(outcome.is_whole(), "{path}: {:?}", failed());
    outcome
}

/// Whether the run says something about the file.
fn speaks(outcome: &Outcome, path: &str) -> bool {
    outcome.findings.iter().any(|finding| finding.path == path)
}

#[test]
fn the_example_is_silent_in_memory() {
    let files = files();
    let outcome = run(
        &files,
        "base/figure/base.json",
        files["base/figure/base.json"].to_vec(),
    );
    assert_eq!(outcome.findings, []);
}

#[test]
fn truncation_of_json_is_always_a_finding() {
    let files = files();
    let documents = files.iter().filter(|(path, _)| is_one_of(path, &JSON));
    for (path, bytes) in documents {
        let end = bytes.trim_ascii_end().len();
        for cut in [0, 1, end / 3, end / 2, end - 1] {
            let outcome = run(&files, path, bytes[..cut].to_vec());
            assert!(!outcome.findings.is_empty(), "{path} cut at {cut} of {end}");
        }
    }
}

#[test]
fn truncation_of_lines_never_fails() {
    let files = files();
    let mut per_format: BTreeMap<&str, usize> = BTreeMap::new();
    for (path, bytes) in files
        .iter()
        .filter(|(path, _)| is_one_of(path, &TEXT) && !is_one_of(path, &JSON))
    {
        let kind = path.rsplit('.').next().unwrap();
        let seen = per_format.entry(kind).or_default();
        *seen += 1;
        if *seen > 4 {
            continue;
        }
        for cut in [
            0,
            1,
            bytes.len() / 2,
            bytes.len() / 2 + 1,
            bytes.len().saturating_sub(2),
        ] {
            let outcome = run(&files, path, bytes[..cut].to_vec());
            let placed = outcome
                .findings
                .iter()
                .all(|finding| !finding.path.is_empty());
            assert!(placed, "{path} cut at {cut}");
        }
    }
    assert!(per_format.len() >= 3, "{per_format:?}");
}

#[test]
fn a_packed_mesh_that_is_cut_or_changed_is_named_or_harmless() {
    let files = files();
    let path = "base/figure/base.mhbin";
    let whole = packed(&files["base/figure/base.obj"]);
    assert_eq!(run(&files, path, whole.clone()).findings, []);
    let step = whole.len() / 40;
    let cuts: Vec<usize> = (0..whole.len())
        .step_by(step)
        .chain([1, whole.len() - 1])
        .collect();
    cuts.par_iter().for_each(|cut| {
        assert!(
            speaks(&run(&files, path, whole[..*cut].to_vec()), path),
            "cut at {cut} of {}",
            whole.len()
        );
    });
    cuts.par_iter().for_each(|at| {
        let mut changed = whole.clone();
        changed[*at] ^= 0x55;
        // Some bytes say nothing of the mesh: times, attributes.
        run(&files, path, changed);
    });
}

/// Pointers to every value; of long lists only the first two entries and the last.
fn pointers(value: &Value, at: &str, found: &mut Vec<String>) {
    found.push(at.to_owned());
    match value {
        Value::Array(items) => {
            let chosen = items
                .iter()
                .enumerate()
                .filter(|(index, _)| *index < 2 || index + 1 == items.len());
            chosen.for_each(|(index, item)| pointers(item, &format!("{at}/{index}"), found));
        }
        Value::Object(members) => {
            for (key, member) in members.iter().take(12) {
                let key = key.replace('~', "~0").replace('/', "~1");
                pointers(member, &format!("{at}/{key}"), found);
            }
        }
        _ => {}
    }
}

#[test]
fn wrong_types_at_any_place_fail_no_rule() {
    let files = files();
    let others = [
        json!(null),
        json!(true),
        json!(7),
        json!("x"),
        json!([]),
        json!({}),
    ];
    let (mut loud, mut all, mut faults) = (0, 0, Vec::new());
    // What a pose is made of has no model yet.
    let is_checked = |path: &str| is_one_of(path, &JSON) && !path.ends_with("-poses.json");
    for (path, bytes) in files.iter().filter(|(path, _)| is_checked(path)) {
        let whole: Value = serde_json::from_slice(bytes).unwrap();
        let mut places = Vec::new();
        pointers(&whole, "", &mut places);
        let damages: Vec<(&String, &Value)> = places
            .iter()
            .flat_map(|place| others.iter().map(move |other| (place, other)))
            .collect();
        let results = damages.par_iter().map(|(place, other)| {
            let mut copy = whole.clone();
            *copy.pointer_mut(place).unwrap() = (*other).clone();
            let outcome = run(&files, path, serde_json::to_vec(&copy).unwrap());
            let has_paths = outcome
                .findings
                .iter()
                .all(|finding| !finding.path.is_empty());
            // What the loader reads is an object: whatever else the whole file is, it is named.
            let named = !place.is_empty() || other.is_object() || speaks(&outcome, path);
            let fault = (!has_paths || !named).then(|| format!("{path} with {other} at {place:?}"));
            (outcome.findings.len(), fault)
        });
        let checked: Vec<(usize, Option<String>)> = results.collect();
        loud += checked.iter().filter(|(findings, _)| *findings > 0).count();
        all += checked.len();
        faults.extend(checked.into_iter().filter_map(|(_, fault)| fault));
    }
    assert!(faults.is_empty(), "{faults:#?}");
    assert!(all > 1000, "{all} damages");
    // Free texts (names, tips, licences) may be anything; what the loader reads may not.
    assert!(loud * 2 > all, "{loud} of {all} damages speak");
}

#[test]
fn line_ends_of_windows_are_silent() {
    let files = files();
    for (path, bytes) in files
        .iter()
        .filter(|(path, _)| is_one_of(path, &TEXT))
        .step_by(5)
    {
        let text = std::str::from_utf8(bytes).unwrap().replace('\n', "\r\n");
        let outcome = run(&files, path, text.into_bytes());
        assert_eq!(outcome.findings, [], "{path}");
    }
}

#[test]
fn bytes_that_do_not_belong_are_named_in_every_document() {
    let files = files();
    for (path, bytes) in files.iter().filter(|(path, _)| is_one_of(path, &JSON)) {
        let behind_brace = |junk: &[u8]| [&bytes[..1], junk, &bytes[1..]].concat();
        let damaged = [
            [b"\xef\xbb\xbf", &bytes[..]].concat(),
            behind_brace(b"\"\xe9\": 1,"),
            behind_brace(b"\0"),
            behind_brace(b"\"twice\": 1, \"twice\": 2,"),
            behind_brace(b"\"n\": 1e400 1,"),
        ];
        for bytes in damaged {
            assert!(
                speaks(&run(&files, path, bytes.clone()), path),
                "{path}: {:?}",
                bytes.get(..30)
            );
        }
    }
}

#[test]
fn numbers_beyond_sense_in_targets_are_named() {
    let files = files();
    let path = files.keys().find(|path| path.ends_with(".target")).unwrap();
    for row in [
        "0 nan 0 0",
        "0 inf 0 0",
        "0 1e400 0 0",
        "-1 1 0 0",
        "99999999 1 0 0",
        "99999999999999999999999 1 0 0",
        "1.5 1 0 0",
        "x 1 0 0",
        "0 1 0",
        "0 0,5 0 0",
        "\0 1 0 0",
        "0 1 \u{0} 0",
        "0x10 1 0 0",
    ] {
        let bytes = [&files[path][..], row.as_bytes(), b"\n"].concat();
        assert!(speaks(&run(&files, path, bytes), path), "{row:?}");
    }
}

#[test]
fn a_million_brackets_are_refused() {
    let files = files();
    for (path, _) in files.iter().filter(|(path, _)| is_one_of(path, &JSON)) {
        for open in ["[", "{\"a\":"] {
            assert!(
                speaks(
                    &run(&files, path, open.repeat(1_000_000).into_bytes()),
                    path
                ),
                "{path}"
            );
        }
    }
}

#[test]
fn a_folder_where_a_file_is_expected_is_no_file() {
    let files = files();
    for (path, _) in files
        .iter()
        .filter(|(path, _)| path.starts_with("base/") || path.starts_with("rigs/"))
    {
        let mut rest = files.clone();
        rest.remove(path);
        run(&rest, &format!("{path}/inside.txt"), b"x".to_vec());
    }
}

#[test]
fn a_file_where_a_folder_is_expected_ends_with_a_verdict() {
    for folder in ["target/figure", "rigs", "target", "base/figure"] {
        let root = example();
        let path = root.path().join("data").join(folder);
        std::fs::remove_dir_all(&path).unwrap();
        std::fs::write(&path, "no folder").unwrap();
        let output = mhlint(root.path(), &["data", "--report", "concise", "--no-eval"]);
        assert!(
            matches!(output.status.code(), Some(0..=2)),
            "{}",
            stderr(&output)
        );
    }
}

/// 256 members of 16 MiB of zeros are 4 GiB; packed they take a few megabytes.
fn bomb() -> Vec<u8> {
    let mut encoder = GzEncoder::new(Vec::new(), Compression::fast());
    std::io::Write::write_all(&mut encoder, &vec![0; 16 << 20]).unwrap();
    encoder.finish().unwrap().repeat(256)
}

#[test]
fn four_gibibytes_of_zeros_in_four_megabytes_are_given_up() {
    let files = files();
    let path = "target/figure/head/zeros.target.gz";
    let outcome = run(&files, path, bomb());
    let rules: Vec<_> = outcome
        .findings
        .iter()
        .filter(|finding| finding.path == path)
        .map(|f| f.rule)
        .collect();
    assert!(rules.contains(&"file-decompression-bomb"), "{rules:?}");
}

/// The shell takes the address space away that a program would need to unpack so much. Threads and
/// the program itself take a few hundred megabytes of addresses, without using them.
#[cfg(target_os = "linux")]
#[test]
fn four_gibibytes_of_zeros_need_no_memory() {
    let root = example();
    std::fs::write(
        root.path().join("data/target/figure/head/zeros.target.gz"),
        bomb(),
    )
    .unwrap();
    let limited = |megabytes: u32| {
        let script = format!(
            "ulimit -v {}; exec \"$0\" data --report concise",
            megabytes * 1024
        );
        let mut command = std::process::Command::new("sh");
        command
            .args(["-c", &script, env!("CARGO_BIN_EXE_mhlint")])
            .env("RAYON_NUM_THREADS", "2");
        command.current_dir(root.path()).output().unwrap()
    };
    let output = limited(768);
    assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
    let lines = findings(&output);
    let named = |line: &&String| {
        line.contains("zeros.target.gz") && line.contains("[file-decompression-bomb]")
    };
    assert_eq!(lines.iter().filter(named).count(), 1, "{lines:?}");
    // That the limit is one: with too little room the program does not get anywhere.
    assert_ne!(limited(4).status.code(), Some(0));
}

#[cfg(unix)]
#[test]
fn files_without_permission_are_named_each() {
    use std::os::unix::{fs::PermissionsExt, process::CommandExt};

    let files = [
        "base/figure/base.json",
        "base/figure/base.obj",
        "target/figure/macro.json",
        "target/figure/head/head-oval.target",
        "rigs/figure/default.mhskel",
        "rigs/figure/default_weights.mhw",
    ];
    for file in files {
        let root = example();
        let path = root.path().join("data").join(file);
        let set = |path: &Path, mode| {
            std::fs::set_permissions(path, PermissionsExt::from_mode(mode)).unwrap();
        };
        set(root.path(), 0o755);
        set(&path, 0o000);
        let mut command = std::process::Command::new(env!("CARGO_BIN_EXE_mhlint"));
        command
            .current_dir(root.path())
            .args(["data", "--report", "concise", "--no-eval"]);
        if std::fs::read(&path).is_ok() {
            // Root reads everything; nobody does not.
            command.uid(65534).gid(65534);
        }
        let output = match command.output() {
            Ok(output) => output,
            Err(error) => return eprintln!("skipped: the command cannot run as nobody: {error}"),
        };
        assert_eq!(output.status.code(), Some(1), "{file}: {}", stderr(&output));
        let lines = findings(&output);
        let [line] = lines.as_slice() else {
            panic!("{file}: {lines:?}")
        };
        assert!(
            line.starts_with(&format!("data/{file}")) && line.contains("error[file-unreadable]"),
            "{line}"
        );
    }
}

#[cfg(unix)]
#[test]
fn links_in_a_circle_end_and_are_named() {
    let root = example();
    let target = root.path().join("data/target/figure");
    std::os::unix::fs::symlink("..", target.join("up")).unwrap();
    std::os::unix::fs::symlink("self.target", target.join("self.target")).unwrap();
    let output = mhlint(
        root.path(),
        &["data", "--report", "concise", "--only", "file-link-loop"],
    );
    let lines = findings(&output);
    assert_eq!(
        lines
            .iter()
            .filter(|line| line.contains("[file-link-loop]"))
            .count(),
        2,
        "{lines:?}"
    );
}
