//! The baseline through the real binary: what it hides, what it does not, and what leaves it alone.

use std::fs;
use std::io::Write;
use std::path::Path;

use crate::scratch::{
    Case, assert_refused, copy_folder, edit, example, findings, lose_a_step, mhlint, project,
    stderr, stdout,
};

const MACROS: &str = "data/target/figure/macro.json";
const MODELLING: &str = "data/target/figure/modelling.json";
const OVAL: &str = "data/target/figure/head/head-oval.target";
const SIDE: &str = "data/target/figure/head/head-side-in.target";
const CATEGORIES: &str = "data/target/figure/target_cat.json";
const MESH: &str = "data/base/figure/base.obj";
const WEIGHTS: &str = "data/rigs/figure/default_weights.mhw";

fn run(root: &Path, args: &[&str]) -> Vec<String> {
    let output = mhlint(
        root,
        &[args, &["--baseline", "known.json", "--report", "concise"]].concat(),
    );
    assert!(
        matches!(output.status.code(), Some(0 | 1)),
        "{}",
        stderr(&output)
    );
    findings(&output)
}

/// Writes the baseline and gives its lines.
fn write(root: &Path, args: &[&str]) -> Vec<String> {
    assert_eq!(
        run(root, &[args, &["--write-baseline"]].concat()),
        Vec::<String>::new()
    );
    let text = fs::read_to_string(root.join("known.json")).unwrap();
    text.lines()
        .map(|line| line.trim_end_matches(',').to_owned())
        .filter(|line| line.starts_with("{\"path"))
        .collect()
}

/// A copy of the example repository with faults of many kinds.
fn damaged() -> tempfile::TempDir {
    let repository = example();
    let root = repository.path();
    lose_a_step(root);
    edit(root, OVAL, "339 0 .001 .001", "339 0 0 0");
    edit(root, WEIGHTS, "[158, 1.0]", "[158, 0.5]");
    fs::write(
        root.join("data/target/figure/head/head-lost.target"),
        "337 .1 0 0\n337 .1 0 0\n",
    )
    .unwrap();
    fs::write(root.join("data/rigs/figure/walk.xyz"), "x").unwrap();
    gzip(&root.join("data/target/figure/head/packed.target.gz"), 1);
    repository
}

fn gzip(path: &Path, level: u32) {
    let file = fs::File::create(path).unwrap();
    let mut encoder = flate2::write::GzEncoder::new(file, flate2::Compression::new(level));
    encoder
        .write_all("337 .002 0 0\n".repeat(40).as_bytes())
        .unwrap();
    encoder.finish().unwrap();
}

#[test]
fn what_is_known_is_hidden_and_what_is_new_is_not() {
    let repository = damaged();
    let root = repository.path();
    let before = mhlint(root, &["--report", "concise"]);
    assert_eq!(before.status.code(), Some(1));
    let lines = write(root, &[]);
    assert_eq!(lines.len(), findings(&before).len());
    assert!(lines.is_sorted());
    let hidden = mhlint(root, &["--baseline", "known.json", "--report", "json"]);
    assert_eq!(hidden.status.code(), Some(0));
    let report: serde_json::Value = serde_json::from_slice(&hidden.stdout).unwrap();
    assert_eq!(report["summary"]["suppressed"], lines.len());
    edit(root, SIDE, "\n", "\n1 2 x 4\n");
    let found = run(root, &[]);
    assert_eq!(found.len(), 1, "{found:?}");
    assert!(found[0].contains("error[target-syntax]"), "{found:?}");
}

#[test]
fn the_baseline_of_the_configuration_is_used() {
    let repository = damaged();
    fs::write(
        repository.path().join("mhlint.toml"),
        "baseline = \"known.json\"\n",
    )
    .unwrap();
    let missing = mhlint(repository.path(), &[]);
    assert_eq!(missing.status.code(), Some(2));
    assert!(
        stderr(&missing).contains("create one with `--write-baseline`"),
        "{}",
        stderr(&missing)
    );
    let written = mhlint(repository.path(), &["--write-baseline"]);
    assert_eq!(written.status.code(), Some(0), "{}", stderr(&written));
    assert!(
        stderr(&written).contains("written to `known.json`"),
        "{}",
        stderr(&written)
    );
    assert_eq!(mhlint(repository.path(), &[]).status.code(), Some(0));
    assert_eq!(
        mhlint(&repository.path().join("data"), &[]).status.code(),
        Some(0)
    );
}

/// Changes something and asks that the baseline hides as much as before.
fn stays_hidden(change: impl Fn(&Path)) {
    let repository = damaged();
    write(repository.path(), &[]);
    change(repository.path());
    assert_eq!(run(repository.path(), &[]), Vec::<String>::new());
}

#[test]
fn layout_of_json_does_not_matter() {
    for file in [
        MACROS,
        MODELLING,
        WEIGHTS,
        "data/target/figure/target_cat.json",
    ] {
        stays_hidden(|root| {
            let text = fs::read_to_string(root.join(file)).unwrap();
            let value: serde_json::Value = serde_json::from_str(&text).unwrap();
            fs::write(root.join(file), format!("\n\n{value}")).unwrap();
        });
    }
}

#[test]
fn the_order_of_keys_does_not_matter() {
    fn reversed(value: &serde_json::Value) -> serde_json::Value {
        match value {
            serde_json::Value::Object(members) => members
                .iter()
                .rev()
                .map(|(key, value)| (key.clone(), reversed(value)))
                .collect(),
            serde_json::Value::Array(elements) => elements.iter().map(reversed).collect(),
            other => other.clone(),
        }
    }
    for file in [MACROS, MODELLING, WEIGHTS] {
        stays_hidden(|root| {
            let text = fs::read_to_string(root.join(file)).unwrap();
            fs::write(
                root.join(file),
                reversed(&serde_json::from_str(&text).unwrap()).to_string(),
            )
            .unwrap();
        });
    }
}

#[test]
fn packing_anew_and_other_assets_do_not_matter() {
    stays_hidden(|root| gzip(&root.join("data/target/figure/head/packed.target.gz"), 9));
    stays_hidden(|root| {
        fs::create_dir_all(root.join("data/clothes/figure/hat")).unwrap();
        fs::write(root.join("data/clothes/figure/hat/readme.txt"), "a hat").unwrap();
    });
    stays_hidden(|root| edit(root, OVAL, "337 .002", "# a remark\n\n337 .002"));
}

#[test]
fn a_moved_repository_keeps_its_baseline() {
    let repository = damaged();
    write(repository.path(), &["."]);
    let elsewhere = tempfile::tempdir().unwrap();
    let moved = elsewhere.path().join("other/name");
    copy_folder(repository.path(), &moved);
    assert_eq!(run(&moved, &[]), Vec::<String>::new());
    let known = moved.join("known.json");
    let at = |folder: &Path, args: &[&str]| {
        let output = mhlint(
            folder,
            &[
                args,
                &["--baseline", known.to_str().unwrap(), "--report", "concise"],
            ]
            .concat(),
        );
        findings(&output)
    };
    assert_eq!(
        at(elsewhere.path(), &[moved.to_str().unwrap()]),
        Vec::<String>::new()
    );
    assert_eq!(at(&moved.join("user"), &["../data"]), Vec::<String>::new());
    fs::rename(moved.join("data"), moved.join("makehuman2")).unwrap();
    assert_eq!(run(&moved, &[]), Vec::<String>::new());
}

/// Writes the baseline with the first fault, fixes it and makes the second: that one must be
/// reported, and by a rule of this name.
fn does_not_cancel_out(rule: &str, first: impl Fn(&Path), second: impl Fn(&Path)) {
    let repository = example();
    first(repository.path());
    assert!(
        write(repository.path(), &[])
            .iter()
            .any(|line| line.contains(rule)),
        "{rule} does not fire"
    );
    let fixed = example();
    fs::copy(
        repository.path().join("known.json"),
        fixed.path().join("known.json"),
    )
    .unwrap();
    second(fixed.path());
    let found = run(fixed.path(), &[]);
    assert!(
        found.iter().any(|line| line.contains(&format!("[{rule}]"))),
        "{rule}: {found:?}"
    );
}

#[test]
fn fixing_one_fault_and_making_another_does_not_cancel_out() {
    let write_file =
        |root: &Path, file: &str, text: &str| fs::write(root.join(file), text).unwrap();
    does_not_cancel_out(
        "target-zero-delta",
        |root| edit(root, OVAL, "339 0 .001 .001", "339 0 0 0"),
        |root| edit(root, SIDE, "\n", "\n1 0 0 0\n"),
    );
    does_not_cancel_out(
        "target-duplicate-vertex",
        |root| {
            edit(
                root,
                OVAL,
                "338 .001 .001 .001",
                "338 .001 .001 .001\n338 .001 .001 .001",
            );
        },
        |root| edit(root, OVAL, "337 .002 0 0", "337 .002 0 0\n337 .002 0 0"),
    );
    does_not_cancel_out(
        "file-unreferenced",
        |root| write_file(root, "data/rigs/figure/walk.xyz", "x"),
        |root| write_file(root, "data/rigs/figure/run.xyz", "x"),
    );
    does_not_cancel_out(
        "weights-not-normalized",
        |root| edit(root, WEIGHTS, "[158, 1.0]", "[158, 0.5]"),
        |root| edit(root, WEIGHTS, "[159, 1.0]", "[159, 0.5]"),
    );
    does_not_cancel_out("macro-steps-length", lose_a_step, |root| {
        edit(
            root,
            MACROS,
            "\"steps\": [0.0, 1.0]",
            "\"steps\": [0.0, 0.5, 1.0]",
        );
    });
}

/// Faults of one rule in other rows, bones and members of one file: what, file, text and its first
/// and second damage.
const ELSEWHERE: [(&str, &str, [&str; 2], [&str; 2]); 6] = [
    (
        "target-field-count",
        OVAL,
        ["337 .002 0 0", "337 .002 0"],
        ["339 0 .001 .001", "339 0 .001 .001 x"],
    ),
    (
        "target-syntax",
        OVAL,
        ["337 .002 0 0", "337 x 0 0"],
        ["339 0 .001 .001", "339 0 x .001"],
    ),
    ("mesh-syntax", MESH, ["\nv ", "\nv x "], ["\nf ", "\nf x "]),
    ("json-syntax", CATEGORIES, ["{", "{,"], ["}", ",}"]),
    (
        "weights-malformed-pair",
        WEIGHTS,
        ["[158, 1.0]", "[158]"],
        ["[159, 1.0]", "[159]"],
    ),
    (
        "json-unknown-key",
        MACROS,
        ["\"coastal-female\"", "\"coastal-female\", \"x\": 1"],
        ["\"woodland-male\"", "\"woodland-male\", \"x\": 1"],
    ),
];

/// Cases of one rule: the first is known, fixed, and the second comes in its place.
#[test]
fn another_fault_of_a_rule_and_a_worse_one_are_not_known() {
    let pairs = [
        ("base-unknown-preset", "bad-measure-size", "bad-measure-age"),
        ("macro-steps-range", "bad-wide", "bad"),
        ("macro-folder-missing", "bad-inherited", "bad"),
        ("macro-folder-missing", "bad-first", "bad-folder-of-another"),
        (
            "modelling-duplicate-pattern",
            "bad-macro",
            "bad-renamed-macro",
        ),
        ("macro-steps-length", "bad-surplus", "bad"),
        ("target-stale-binary", "bad-incomplete", "bad"),
        (
            "file-byte-order-mark",
            "bad-target-comment",
            "bad-target-row",
        ),
    ];
    for (rule, known, new) in pairs {
        let with = |case: &str| {
            let repository = example();
            Case::read(&project("fixtures/rules").join(rule).join(case)).apply(repository.path());
            repository
        };
        let (before, after) = (with(known), with(new));
        assert!(
            write(before.path(), &[])
                .iter()
                .any(|line| line.contains(rule)),
            "{rule}/{known}"
        );
        fs::copy(
            before.path().join("known.json"),
            after.path().join("known.json"),
        )
        .unwrap();
        let found = run(after.path(), &[]);
        assert!(
            found.iter().any(|line| line.contains(&format!("[{rule}]"))),
            "{rule}/{new}: {found:?}"
        );
    }
}

#[test]
fn the_level_of_the_settings_does_not_make_it_worse() {
    let repository = example();
    let root = repository.path();
    edit(root, WEIGHTS, "[158, 1.0]", "[158, 0.5]");
    let lines = write(root, &[]);
    assert!(
        lines
            .iter()
            .any(|line| line.contains("weights-not-normalized")
                && line.contains("\"level\":\"info\""))
    );
    assert_eq!(
        run(root, &["--level", "weights-not-normalized=error"]),
        Vec::<String>::new()
    );
}

#[test]
fn a_fault_elsewhere_in_the_file_does_not_cancel_out() {
    for (rule, file, first, second) in ELSEWHERE {
        let damage = |[from, to]: [&'static str; 2]| {
            move |root: &Path| {
                let text = fs::read_to_string(root.join(file)).unwrap();
                fs::write(root.join(file), text.replacen(from, to, 1)).unwrap();
            }
        };
        does_not_cancel_out(rule, damage(first), damage(second));
        // Lines and blanks before the fault do not matter.
        let repository = example();
        damage(first)(repository.path());
        write(repository.path(), &[]);
        let text = fs::read_to_string(repository.path().join(file)).unwrap();
        fs::write(repository.path().join(file), format!("\n\n{text}")).unwrap();
        assert_eq!(run(repository.path(), &[]), Vec::<String>::new(), "{rule}");
    }
}

/// An item of a list is known by its title.
#[test]
fn another_item_of_a_list_does_not_cancel_out() {
    let items =
        |root: &Path, change: &dyn Fn(usize, &mut serde_json::Map<String, serde_json::Value>)| {
            let text = fs::read_to_string(root.join(CATEGORIES)).unwrap();
            let mut file: serde_json::Value = serde_json::from_str(&text).unwrap();
            let lists = file
                .as_object_mut()
                .unwrap()
                .values_mut()
                .filter_map(|tab| tab["items"].as_array_mut());
            let all = lists.flatten().filter_map(serde_json::Value::as_object_mut);
            all.enumerate()
                .for_each(|(index, item)| change(index, item));
            fs::write(root.join(CATEGORIES), file.to_string()).unwrap();
        };
    let without = |which: usize| {
        move |root: &Path| {
            items(root, &|index, item| {
                if index == which {
                    item.remove("cat");
                }
            });
        }
    };
    does_not_cancel_out("json-schema", without(0), without(1));
}

#[test]
fn equal_faults_of_two_data_roots_are_two() {
    let file = "target/imp/broken.target";
    let at = |folder: &'static str| {
        move |root: &Path| {
            fs::create_dir_all(root.join(folder).join("target/imp")).unwrap();
            fs::write(root.join(folder).join(file), "1 2 x 4\n").unwrap();
        }
    };
    does_not_cancel_out("target-syntax", at("data"), at("user"));
    let repository = example();
    let root = repository.path();
    at("data")(root);
    write(root, &[]);
    at("user")(root);
    let user = || run(root, &["user", "--system", "data"]);
    assert!(
        user().iter().any(|line| line.contains("[target-syntax]")),
        "{:?}",
        user()
    );
    fs::remove_file(root.join("data").join(file)).unwrap();
    assert_eq!(user(), Vec::<String>::new(), "it was moved");
}

#[test]
fn an_earlier_neighbour_that_goes_away_does_not_matter() {
    let base = "data/base/figure/base.json";
    let repository = example();
    let root = repository.path();
    edit(
        root,
        base,
        "[\"clothes\", \"hair\", \"eyes\", \"teeth\", \"proxy\"]",
        "[\"cloths\", \"hairs\"]",
    );
    edit(root, MACROS, "\"coastal-female\"", "\"costal-female\"");
    edit(
        root,
        MACROS,
        "\"woodland-male\", \"t\"",
        "\"woodlnd-male\", \"t\"",
    );
    let all = write(root, &[]).len();
    edit(root, base, "\"cloths\", ", "");
    let named = "{ \"name\": \"costal-female\", \"t\": null },";
    edit(
        root,
        MACROS,
        named,
        "{ \"name\": \"coastal-female\", \"t\": null },",
    );
    edit(root, MACROS, "\"name\": \"phenotype-gender\",", "");
    let found = run(root, &[]);
    assert!(
        found.len() == 1 && found[0].contains("[baseline-stale]"),
        "{found:?} of {all}"
    );
}

#[test]
fn a_part_of_a_known_finding_is_still_known() {
    let repository = example();
    let root = repository.path();
    fs::write(root.join("data/rigs/figure/walk.xyz"), "x").unwrap();
    fs::write(root.join("data/rigs/figure/run.xyz"), "x").unwrap();
    assert_eq!(write(root, &[]).len(), 1);
    fs::remove_file(root.join("data/rigs/figure/run.xyz")).unwrap();
    assert_eq!(run(root, &[]), Vec::<String>::new());
    fs::write(root.join("data/rigs/figure/jump.xyz"), "x").unwrap();
    assert_eq!(run(root, &[]).len(), 1);
}

/// Targets of a folder that nothing names are told as one, and one by one as soon as one of them is
/// used.
#[test]
fn a_folder_and_its_files_are_known_by_each_other() {
    const ONE: &str = "data/target/figure/spare/one.target";
    const TWO: &str = "data/target/figure/spare/two.target";
    const THREE: &str = "data/target/figure/spare/three.target";
    let add = |root: &Path, file: &str, vertex: u32| {
        fs::create_dir_all(root.join("data/target/figure/spare")).unwrap();
        fs::write(root.join(file), format!("{vertex} .01 0 0\n")).unwrap();
    };
    let slider = |root: &Path| {
        let entry =
            "{ \"Spare\": { \"name\": \"Spare\", \"group\": \"GROUP\", \"incr\": \"spare/one\" },";
        let text = fs::read_to_string(root.join(MODELLING)).unwrap();
        let value: serde_json::Value = serde_json::from_str(&text).unwrap();
        let group = value
            .as_object()
            .unwrap()
            .values()
            .find_map(|slider| slider["group"].as_str())
            .unwrap();
        fs::write(
            root.join(MODELLING),
            text.replacen('{', &entry.replace("GROUP", group), 1),
        )
        .unwrap();
    };
    let repository = example();
    let root = repository.path();
    add(root, ONE, 337);
    add(root, TWO, 338);
    add(root, THREE, 339);
    assert_eq!(write(root, &[]).len(), 1);
    slider(root);
    let found = mhlint(
        root,
        &["--report", "concise", "--only", "target-unreferenced"],
    );
    assert_eq!(findings(&found).len(), 2, "two are told one by one now");
    assert_eq!(
        run(root, &["--only", "target-unreferenced"]),
        Vec::<String>::new()
    );
    add(root, "data/target/figure/spare/four.target", 340);
    let new = run(root, &["--only", "target-unreferenced"]);
    assert!(new.len() == 1 && new[0].contains("spare/four`"), "{new:?}");

    let repository = example();
    let root = repository.path();
    add(root, ONE, 337);
    add(root, TWO, 338);
    add(root, THREE, 339);
    let before = fs::read(root.join(MODELLING)).unwrap();
    slider(root);
    assert_eq!(write(root, &["--only", "target-unreferenced"]).len(), 2);
    fs::write(root.join(MODELLING), before).unwrap();
    assert_eq!(
        run(root, &["--only", "target-unreferenced"]).len(),
        1,
        "the third was used"
    );
    fs::remove_file(root.join(ONE)).unwrap();
    assert_eq!(
        run(root, &["--only", "target-unreferenced"]),
        Vec::<String>::new()
    );
}

/// More vertices than anybody lists are told apart: fixing one does not hide another.
#[test]
fn a_mass_is_told_apart() {
    let weights = |root: &Path, wrong: std::ops::Range<u32>| {
        let text = fs::read_to_string(root.join(WEIGHTS)).unwrap();
        let mut file: serde_json::Value = serde_json::from_str(&text).unwrap();
        for pair in file["weights"]
            .as_object_mut()
            .unwrap()
            .values_mut()
            .flat_map(|list| list.as_array_mut().unwrap())
        {
            if wrong.contains(&u32::try_from(pair[0].as_u64().unwrap()).unwrap()) {
                pair[1] = serde_json::json!(pair[1].as_f64().unwrap() / 2.0);
            }
        }
        fs::write(root.join(WEIGHTS), file.to_string()).unwrap();
    };
    does_not_cancel_out(
        "weights-not-normalized",
        |root| weights(root, 0..300),
        |root| weights(root, 1..301),
    );
    let repository = example();
    weights(repository.path(), 0..300);
    let lines = write(repository.path(), &[]);
    let entry = lines
        .iter()
        .find(|line| line.contains("weights-not-normalized"))
        .unwrap();
    assert!(entry.ends_with("\"parts\":[\"0-299\"]}"), "{entry}");
}

#[test]
fn stale_entries_are_told_and_pruned() {
    let repository = damaged();
    let root = repository.path();
    let all = write(root, &[]).len();
    edit(root, OVAL, "339 0 0 0", "339 0 .001 .001");
    let found = run(root, &[]);
    let expected =
        format!("known.json: info[baseline-stale] 1 of {all} baseline entries no longer occurs");
    assert_eq!(found, [expected]);
    assert_eq!(
        run(root, &["user", "--system", "data"]),
        Vec::<String>::new()
    );
    assert_eq!(run(root, &["--skip", "target-*"]), Vec::<String>::new());
    assert_eq!(write(root, &[]).len(), all - 1);
    assert_eq!(run(root, &[]), Vec::<String>::new());
}

/// A file that cannot be read any more hides what was known of it: that is not fixed.
#[test]
fn errors_hide_what_the_baseline_knows() {
    let repository = damaged();
    let root = repository.path();
    let all = write(root, &[]).len();
    let known = fs::read_to_string(root.join("known.json")).unwrap();
    for file in [MACROS, MESH] {
        let whole = fs::read(root.join(file)).unwrap();
        let broken: &[&dyn Fn()] = &[
            &|| fs::write(root.join(file), &whole[..whole.len() / 2]).unwrap(),
            &|| {
                fs::write(
                    root.join(file),
                    [b"\xef\xbb\xbf", whole.as_slice()].concat(),
                )
                .unwrap();
            },
            &|| fs::remove_file(root.join(file)).unwrap(),
        ];
        // A mesh may be cut off between two lines, and a mark before it does no harm.
        let broken = if file == MESH {
            &broken[2..]
        } else {
            &broken[..2]
        };
        for damage in broken {
            damage();
            let text = stdout(&mhlint(root, &["--baseline", "known.json", "--full"]));
            assert!(
                text.contains(&format!(" of {all} baseline entries w"))
                    && text.contains(" not found again"),
                "{text}"
            );
            assert!(
                text.contains("help: fix the errors first: they may hide what is not found"),
                "{text}"
            );
            assert!(!text.contains("prune"), "{text}");
            let written = mhlint(root, &["--baseline", "known.json", "--write-baseline"]);
            let said = stderr(&written);
            assert!(
                said.contains(": 1 new (1 error), ")
                    && said.contains(" removed; errors can hide findings"),
                "{said}"
            );
            fs::write(root.join("known.json"), &known).unwrap();
        }
        fs::write(root.join(file), whole).unwrap();
    }
    assert_eq!(run(root, &[]), Vec::<String>::new());
}

#[test]
fn writing_a_baseline_says_what_changes() {
    let repository = damaged();
    let root = repository.path();
    let said = || {
        stderr(&mhlint(
            root,
            &["--baseline", "known.json", "--write-baseline"],
        ))
    };
    let first = said();
    assert!(
        first.ends_with("known findings written to `known.json`\n"),
        "{first}"
    );
    assert!(said().ends_with("written to `known.json` (unchanged)\n"));
    edit(root, OVAL, "339 0 0 0", "339 0 .001 .001");
    assert!(said().ends_with("written to `known.json`: 0 new, 1 removed\n"));
    edit(root, SIDE, "\n", "\n1 2 x 4\n");
    assert!(said().ends_with("written to `known.json`: 1 new (1 error), 0 removed\n"));
}

/// An ignored fault and a known one, in files of their own.
fn known_and_ignored() -> tempfile::TempDir {
    let repository = example();
    let root = repository.path();
    lose_a_step(root);
    edit(root, OVAL, "339 0 .001 .001", "339 0 0 0");
    write(root, &["--only", "target-*"]);
    let ignore = "[[ignore]]\nrule = \"macro-steps-length\"\npath = \"**\"\nreason = \"old\"\n";
    fs::write(root.join("mhlint.toml"), ignore).unwrap();
    repository
}

fn words(root: &Path, format: &str) -> String {
    let output = mhlint(root, &["--baseline", "known.json", "--report", format]);
    stdout(&output)
        .split_whitespace()
        .collect::<Vec<_>>()
        .join(" ")
}

#[test]
fn the_ignore_of_what_an_error_hides_is_not_to_be_removed() {
    let repository = known_and_ignored();
    let root = repository.path();
    assert!(!words(root, "human").contains("config-unused-ignore"));
    let whole = fs::read(root.join(MACROS)).unwrap();
    fs::write(root.join(MACROS), &whole[..whole.len() / 2]).unwrap();
    let found = words(root, "human");
    assert!(
        found.contains("config-unused-ignore") && found.contains("help: fix the errors first"),
        "{found}"
    );
    assert!(!found.contains("help: remove the unused ignore"), "{found}");
}

#[test]
fn reports_tell_what_is_known_from_what_is_ignored() {
    let repository = known_and_ignored();
    let verdict = "Passed: no findings apart from 1 in the baseline and 1 ignored.";
    for (format, counts) in [
        ("human", "0 infos, 1 in the baseline, 1 ignored in "),
        (
            "markdown",
            "| errors | warnings | infos | in the baseline | ignored | files |",
        ),
        ("html", ", 1 finding in the baseline, 1 finding ignored"),
    ] {
        let text = words(repository.path(), format);
        assert!(text.contains(counts) && text.contains(verdict), "{text}");
    }
    let report: serde_json::Value =
        serde_json::from_str(&words(repository.path(), "json")).unwrap();
    assert_eq!(report["summary"]["suppressed"], 2);
}

#[test]
fn a_narrow_run_keeps_what_it_did_not_look_at() {
    let repository = damaged();
    let root = repository.path();
    let all = write(root, &[]);
    assert_eq!(write(root, &["user", "--system", "data"]), all);
    assert_eq!(write(root, &["--only", "macro-*"]), all);
    assert_eq!(write(root, &["--base", "figure"]), all);
}

#[test]
fn a_baseline_that_is_none_is_refused_and_left_alone() {
    let repository = damaged();
    let root = repository.path();
    let good = write(root, &[]).len();
    assert!(good > 3);
    let text = fs::read_to_string(root.join("known.json")).unwrap();
    for (text, words) in [
        (text[..text.len() / 2].to_owned(), "is damaged"),
        (
            text.replace("baseline/1", "baseline/2"),
            "this version reads `mhlint-baseline/1`",
        ),
        (
            "{\"format\": \"mhlint-report/1\"}".to_owned(),
            "is not a baseline of mhlint",
        ),
        (String::new(), "is damaged"),
        (
            format!("<<<<<<< HEAD\n{text}=======\n{text}>>>>>>> other\n"),
            "has an unresolved merge conflict",
        ),
        (
            "{\"format\": \"mhlint-baseline/1\", \"entries\": [{\"path\": 3}]}".to_owned(),
            "is damaged",
        ),
    ] {
        fs::write(root.join("known.json"), &text).unwrap();
        for args in [&[][..], &["--write-baseline"]] {
            let output = mhlint(root, &[&["--baseline", "known.json"], args].concat());
            assert_eq!(
                (output.status.code(), output.stdout.len()),
                (Some(2), 0),
                "{}",
                stderr(&output)
            );
            assert!(stderr(&output).contains(words), "{}", stderr(&output));
            assert_eq!(fs::read_to_string(root.join("known.json")).unwrap(), text);
        }
    }
}

#[test]
fn a_baseline_that_cannot_be_written_is_refused_before_the_run() {
    let repository = damaged();
    for (args, words) in [
        (&["--write-baseline"][..], "add `--baseline FILE`"),
        (
            &["--baseline", "no/such/b.json", "--write-baseline"],
            "folder `no/such` does not exist",
        ),
        (&["--baseline", "data", "--write-baseline"], "is a folder"),
        (
            &["--baseline", "gone.json"],
            "create one with `--write-baseline`",
        ),
    ] {
        let output = mhlint(repository.path(), args);
        assert_eq!(
            (output.status.code(), output.stdout.len()),
            (Some(2), 0),
            "{}",
            stderr(&output)
        );
        assert!(stderr(&output).contains(words), "{}", stderr(&output));
    }
}

#[test]
fn entries_of_another_repository_are_told_as_such() {
    let repository = damaged();
    write(repository.path(), &[]);
    let other = example();
    fs::copy(
        repository.path().join("known.json"),
        other.path().join("known.json"),
    )
    .unwrap();
    let found = run(other.path(), &[]);
    assert!(
        found.len() == 1 && found[0].contains("it may be the baseline of another repository"),
        "{found:?}"
    );
}

/// A baseline of which nothing is here is refused; one whose assets were removed is not, nor one of
/// moved data.
#[test]
fn a_baseline_of_other_data_is_refused() {
    let repository = example();
    let root = repository.path();
    let entry = |path: &str| {
        let entry =
            format!("{{\"path\":\"{path}\",\"rule\":\"target-syntax\",\"fingerprint\":\"0123\"}}");
        fs::write(
            root.join("known.json"),
            format!("{{\"format\":\"mhlint-baseline/1\",\"entries\":[{entry}]}}"),
        )
        .unwrap();
    };
    entry("assets/target/troll/nose.target");
    for args in [&[][..], &["--write-baseline"]] {
        let output = mhlint(root, &[&["--baseline", "known.json"], args].concat());
        assert_refused(
            &output,
            &[
                "known.json",
                "to another repository",
                "troll/nose.target",
                "--write-baseline",
            ],
        );
    }
    assert_eq!(run(root, &["--only", "macro-*"]), Vec::<String>::new());
    for path in ["data/target/figure/head/gone.target", "gone.target", OVAL] {
        entry(path);
        let found = run(root, &[]);
        assert!(
            found.len() == 1 && found[0].contains("[baseline-stale]"),
            "{path}: {found:?}"
        );
    }
}

/// Neither the report nor the baseline takes the place of a file that the run needs.
#[test]
fn two_writers_of_one_file_are_refused() {
    let repository = damaged();
    let root = repository.path();
    write(root, &[]);
    fs::write(root.join("mhlint.toml"), "").unwrap();
    let before = fs::read(root.join("known.json")).unwrap();
    for (args, words) in [
        (
            &["--baseline", "known.json", "--report", "json=./known.json"][..],
            "that is the baseline",
        ),
        (
            &[
                "--baseline",
                "known.json",
                "--write-baseline",
                "--report",
                "json=known.json",
            ],
            "that is the baseline",
        ),
        (
            &["--report", "human=mhlint.toml"],
            "that is the configuration file",
        ),
        (
            &["--baseline", "mhlint.toml", "--write-baseline"],
            "that is the configuration file",
        ),
    ] {
        assert_refused(&mhlint(root, args), &[words, "use another file"]);
    }
    assert_eq!(fs::read(root.join("known.json")).unwrap(), before);
    assert!(fs::read(root.join("mhlint.toml")).unwrap().is_empty());
    assert_eq!(
        run(root, &["--report", "json=other.json"]),
        Vec::<String>::new()
    );
}

#[test]
fn keys_tell_all_findings_of_an_asset_apart() {
    let repository = damaged();
    let mut seen: Vec<(String, String, String)> = Vec::new();
    for line in write(repository.path(), &[]) {
        let entry: serde_json::Value = serde_json::from_str(&line).unwrap();
        let text = |key: &str| entry[key].as_str().unwrap_or_default().to_owned();
        seen.push((text("path"), text("rule"), text("key")));
    }
    let all = seen.len();
    seen.sort();
    seen.dedup();
    assert_eq!(seen.len(), all);
}
