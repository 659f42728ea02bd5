//! Who wins when contarget lies over target: the table of
//! `docs/loaders/makehuman2/folders.md#overlays`, row by row, through the real binary.
//!
//! The base `imp` of the example repository is taken apart: mesh, rig and a full set of targets
//! become the system's, and the user's folder holds `contarget/imp`. Probes tell the winners: each
//! `macro.json` has a `steps` that does not fit its `values`, and a user slider clashes with the
//! sliders that won.

use std::fs;
use std::path::Path;

use crate::scratch::{copy_folder, example, findings, mhlint, remove, stderr};

/// Where contarget lies and what is checked.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Setting {
    /// The user's folder over `--system`.
    OverSystem,
    /// The user's folder, and no system data.
    Alone,
    /// One root that holds `target/` and `contarget/`.
    OneRoot,
}

use Setting::{Alone, OneRoot, OverSystem};

/// Findings as `rule path`; `!`, `?` and `.` stand for error, warning and info.
type Expected<'e> = &'e [&'e str];

/// A row: what is done to contarget, and the findings over the system, alone, and in one root.
struct Row<'e> {
    name: &'e str,
    change: fn(&Path),
    over_system: Expected<'e>,
    alone: Expected<'e>,
    one_root: Expected<'e>,
}

const MACRO_PROBE: &str = "!macro-steps-length contarget/imp/macro.json";
const SYSTEM_PROBE: &str = "!macro-steps-length target/imp/macro.json";
const OWN_SLIDERS: &str =
    "?overlay-user-key-clash target/imp/modelling.json < contarget/imp/modelling.json";
const SYSTEM_SLIDERS: &str =
    "?overlay-user-key-clash target/imp/modelling.json < target/imp/modelling.json";
const BROKEN_MACRO: &str = "!overlay-broken-override contarget/imp/macro.json";
const BROKEN_SLIDERS: &str = "!overlay-broken-override contarget/imp/modelling.json";
const BROKEN_CATEGORIES: &str = "!overlay-broken-override contarget/imp/target_cat.json";
const LOST_TARGETS: &str = "!overlay-targets-not-in-layer contarget/imp/macro.json";
const SHADOWED_MACRO: &str = ".overlay-shadowed contarget/imp/macro.json";
const DEAD_TARGETS: &str = "?overlay-partial-override contarget/imp/body/belly-size-decr.target";

/// A `macro.json` in contarget that is taken for none.
const fn no_macros(name: &str, change: fn(&Path)) -> Row<'_> {
    let alone: Expected<'_> = &[BROKEN_MACRO, OWN_SLIDERS];
    Row {
        name,
        change,
        over_system: alone,
        alone,
        one_root: &[SYSTEM_PROBE, BROKEN_MACRO],
    }
}

/// A `modelling.json` in contarget that is taken for none: the system's sliders over contarget's
/// targets.
const fn no_sliders(name: &str, change: fn(&Path)) -> Row<'_> {
    Row {
        name,
        change,
        over_system: &[MACRO_PROBE, BROKEN_SLIDERS, SYSTEM_SLIDERS],
        alone: &[MACRO_PROBE, BROKEN_SLIDERS],
        one_root: &[MACRO_PROBE, BROKEN_SLIDERS],
    }
}

/// A `target_cat.json` in contarget that is taken for none: the system's categories.
const fn no_categories(name: &str, change: fn(&Path)) -> Row<'_> {
    Row {
        name,
        change,
        over_system: &[MACRO_PROBE, BROKEN_CATEGORIES, OWN_SLIDERS],
        alone: &[MACRO_PROBE, BROKEN_CATEGORIES, OWN_SLIDERS],
        one_root: &[MACRO_PROBE, BROKEN_CATEGORIES],
    }
}

const ROWS: &[Row<'_>] = &[
    Row {
        name: "all three files and all targets: the system's are ignored",
        change: |_| {},
        over_system: &[MACRO_PROBE, SHADOWED_MACRO, OWN_SLIDERS],
        alone: &[MACRO_PROBE, OWN_SLIDERS],
        one_root: &[MACRO_PROBE, SHADOWED_MACRO],
    },
    Row {
        name: "macro.json alone: the system's sliders search their targets in contarget",
        change: |contarget| {
            remove_all(
                contarget,
                &["modelling.json", "target_cat.json", "body", "ears"],
            );
        },
        over_system: &[MACRO_PROBE, LOST_TARGETS, SYSTEM_SLIDERS],
        alone: &[
            MACRO_PROBE,
            "?overlay-partial-override contarget/imp/macro.json",
        ],
        one_root: &[MACRO_PROBE, LOST_TARGETS],
    },
    Row {
        name: "macro.json and modelling.json with a part of the targets",
        change: |contarget| remove_all(contarget, &["ears"]),
        over_system: &[MACRO_PROBE, LOST_TARGETS, OWN_SLIDERS],
        alone: &[MACRO_PROBE, OWN_SLIDERS],
        one_root: &[MACRO_PROBE, LOST_TARGETS],
    },
    Row {
        name: "modelling.json alone: its sliders take the system's targets",
        change: |contarget| {
            remove_all(
                contarget,
                &[
                    "macro.json",
                    "target_cat.json",
                    "body",
                    "ears",
                    "macro_height",
                ],
            );
        },
        over_system: &[
            ".overlay-partial-override contarget/imp/modelling.json",
            OWN_SLIDERS,
        ],
        alone: &[OWN_SLIDERS],
        one_root: &[
            SYSTEM_PROBE,
            ".overlay-partial-override contarget/imp/modelling.json",
        ],
    },
    Row {
        name: "modelling.json with targets of its own and no macro.json: they are never read",
        change: |contarget| {
            remove_all(contarget, &["macro.json"]);
            fs::rename(
                contarget.join("ears/r-ear-trans-out.target"),
                contarget.join("ears/wide.target"),
            )
            .unwrap();
            edit(
                &contarget.join("modelling.json"),
                "ears/r-ear-trans-out",
                "ears/wide",
            );
        },
        over_system: &[
            "!overlay-targets-not-in-layer contarget/imp/modelling.json",
            OWN_SLIDERS,
        ],
        alone: &[OWN_SLIDERS],
        one_root: &[
            SYSTEM_PROBE,
            "!overlay-targets-not-in-layer contarget/imp/modelling.json",
        ],
    },
    Row {
        name: "target_cat.json alone",
        change: |contarget| {
            remove_all(
                contarget,
                &[
                    "macro.json",
                    "modelling.json",
                    "body",
                    "ears",
                    "macro_height",
                ],
            );
        },
        over_system: &[
            ".overlay-partial-override contarget/imp/target_cat.json",
            SYSTEM_SLIDERS,
        ],
        alone: &[".overlay-partial-override contarget/imp/target_cat.json"],
        one_root: &[
            SYSTEM_PROBE,
            ".overlay-partial-override contarget/imp/target_cat.json",
        ],
    },
    no_macros(
        "macro.json malformed: as if absent, without a word",
        |contarget| {
            edit(
                &contarget.join("macro.json"),
                "\"macrodef\": [",
                "\"macrodef\": [,",
            );
        },
    ),
    no_macros(
        "macro.json with a byte order mark: as if absent",
        |contarget| {
            let text = fs::read_to_string(contarget.join("macro.json")).unwrap();
            fs::write(contarget.join("macro.json"), format!("\u{feff}{text}")).unwrap();
        },
    ),
    no_macros("macro.json empty: as if absent", |contarget| {
        write(contarget, "macro.json", "{}");
    }),
    no_sliders(
        "modelling.json malformed: the system's sliders over contarget's targets",
        |contarget| {
            edit(
                &contarget.join("modelling.json"),
                "\"Height\": {",
                "\"Height\": {,",
            );
        },
    ),
    no_categories(
        "target_cat.json empty: the system's categories",
        |contarget| {
            write(contarget, "target_cat.json", "[]");
        },
    ),
    Row {
        name: "targets alone: never read",
        change: |contarget| {
            remove_all(
                contarget,
                &["macro.json", "modelling.json", "target_cat.json"],
            );
        },
        over_system: &[DEAD_TARGETS, SYSTEM_SLIDERS],
        alone: &[DEAD_TARGETS],
        one_root: &[SYSTEM_PROBE, DEAD_TARGETS],
    },
    Row {
        name: "macro.json and modelling.json with all targets: categories from the system",
        change: |contarget| remove_all(contarget, &["target_cat.json"]),
        over_system: &[MACRO_PROBE, SHADOWED_MACRO, OWN_SLIDERS],
        alone: &[MACRO_PROBE, OWN_SLIDERS],
        one_root: &[MACRO_PROBE, SHADOWED_MACRO],
    },
    no_macros("macro.json is an empty list: as if absent", |contarget| {
        write(contarget, "macro.json", "[]");
    }),
    no_macros("macro.json is null: as if absent", |contarget| {
        write(contarget, "macro.json", "null");
    }),
    no_macros("macro.json is false: as if absent", |contarget| {
        write(contarget, "macro.json", "false");
    }),
    no_macros("macro.json is a zero: as if absent", |contarget| {
        write(contarget, "macro.json", "0");
    }),
    no_macros("macro.json is an empty text: as if absent", |contarget| {
        write(contarget, "macro.json", "\"\"");
    }),
    no_sliders(
        "modelling.json empty: the system's sliders over contarget's targets",
        |contarget| {
            write(contarget, "modelling.json", "{}");
        },
    ),
    no_categories(
        "target_cat.json malformed: the system's categories",
        |contarget| {
            write(contarget, "target_cat.json", "{");
        },
    ),
    Row {
        name: "nothing in contarget",
        change: |contarget| fs::remove_dir_all(contarget).unwrap(),
        over_system: &[SYSTEM_SLIDERS],
        alone: &[],
        one_root: &[SYSTEM_PROBE],
    },
];

#[test]
fn every_row_has_its_winners_and_findings() {
    let mut faults = Vec::new();
    for row in ROWS {
        for (setting, expected) in [
            (OverSystem, row.over_system),
            (Alone, row.alone),
            (OneRoot, row.one_root),
        ] {
            let mut expected: Vec<String> =
                expected.iter().map(|text| (*text).to_owned()).collect();
            expected.sort();
            let found = checked(setting, row.change);
            if found != expected {
                faults.push(format!(
                    "{} / {setting:?}\n  expected {expected:#?}\n  found {found:#?}",
                    row.name
                ));
            }
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn a_base_of_user_space_needs_a_macro_file() {
    let repository = example();
    fs::remove_file(repository.path().join("user/contarget/imp/macro.json")).unwrap();
    let found = run(
        repository.path(),
        &["check", "user", "--system", "data"],
        "user/",
    );
    assert_eq!(
        found,
        ["!overlay-partial-override contarget/imp/modelling.json"]
    );
    let empty = "{ \"components\": {}, \"macrodef\": [] }";
    fs::write(
        repository.path().join("user/contarget/imp/macro.json"),
        empty,
    )
    .unwrap();
    assert_eq!(
        run(
            repository.path(),
            &["check", "user", "--system", "data"],
            "user/"
        ),
        Vec::<String>::new()
    );
}

/// Findings of the setting after `change` was made to contarget.
fn checked(setting: Setting, change: fn(&Path)) -> Vec<String> {
    let repository = example();
    let root = repository.path();
    for (from, to) in [
        ("base/imp", "base/imp"),
        ("rigs/imp", "rigs/imp"),
        ("contarget/imp", "target/imp"),
    ] {
        copy_folder(&root.join("user").join(from), &root.join("data").join(to));
    }
    remove_all(&root.join("user"), &["base", "rigs", "target"]);
    probe_macros(
        &root.join("user/contarget/imp/macro.json"),
        "[0.0, 0.5, 1.0]",
    );
    probe_macros(
        &root.join("data/target/imp/macro.json"),
        "[0.0, 0.2, 0.8, 1.0]",
    );
    change(&root.join("user/contarget/imp"));
    if setting == OneRoot {
        if root.join("user/contarget").exists() {
            copy_folder(&root.join("user/contarget"), &root.join("data/contarget"));
        }
        return run(root, &["check", "data"], "data/");
    }
    probe_sliders(&root.join("user/target/imp"));
    let args: &[&str] = if setting == Alone {
        &["check", "user"]
    } else {
        &["check", "user", "--system", "data"]
    };
    run(root, args, "user/")
}

fn probe_macros(path: &Path, steps: &str) {
    edit(
        path,
        "\"steps\": [0.0, 1.0]",
        &format!("\"steps\": {steps}"),
    );
}

fn probe_sliders(folder: &Path) {
    fs::create_dir_all(folder.join("mine")).unwrap();
    fs::write(folder.join("mine/own.target"), "1 .1 0 0\n").unwrap();
    let slider = "{ \"Belly\": { \"group\": \"user|mine\", \"incr\": \"mine/own\", \"user\": 1 } }";
    fs::write(folder.join("modelling.json"), slider).unwrap();
}

/// Runs overlay, JSON and probe rules; `prefix` is the checked root.
fn run(folder: &Path, args: &[&str], prefix: &str) -> Vec<String> {
    let only = [
        "--base",
        "imp",
        "--only",
        "overlay-*",
        "--only",
        "json-*",
        "--only",
        "macro-steps-length",
    ];
    let args: Vec<&str> = args
        .iter()
        .chain(&only)
        .chain(&["--report", "concise"])
        .copied()
        .collect();
    let output = mhlint(folder, &args);
    assert!(
        matches!(output.status.code(), Some(0 | 1)),
        "{args:?}: {}",
        stderr(&output)
    );
    let mut found: Vec<String> = findings(&output)
        .iter()
        .map(|line| short(line, prefix))
        .collect();
    found.sort();
    found
}

/// `path:1:2: error[rule] message` as `!rule path`, and for a clash the file that holds the other
/// slider.
fn short(line: &str, prefix: &str) -> String {
    let (place, rest) = line.split_once(": ").unwrap();
    let path = place
        .split(':')
        .next()
        .unwrap()
        .strip_prefix(prefix)
        .unwrap();
    let (level, rest) = rest.split_once('[').unwrap();
    let (rule, message) = rest.split_once(']').unwrap();
    let mark = [("error", '!'), ("warning", '?'), ("info", '.')]
        .iter()
        .find(|(word, _)| *word == level)
        .unwrap()
        .1;
    match message.split_once(" in `") {
        Some((_, other)) if rule == "overlay-user-key-clash" => {
            let winner = other.trim_end_matches('`').split_once('/').unwrap().1;
            format!("{mark}{rule} {path} < {winner}")
        }
        _ => format!("{mark}{rule} {path}"),
    }
}

fn edit(path: &Path, find: &str, replace: &str) {
    let text = fs::read_to_string(path).unwrap();
    assert!(text.contains(find), "{}: {find}", path.display());
    fs::write(path, text.replace(find, replace)).unwrap();
}

fn write(folder: &Path, name: &str, text: &str) {
    fs::write(folder.join(name), text).unwrap();
}

fn remove_all(folder: &Path, names: &[&str]) {
    names.iter().for_each(|name| remove(&folder.join(name)));
}
