//! Fixes through the real binary: what is fixed is silent, nothing else is touched, nothing is ever
//! half-written.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::os::unix::fs::{PermissionsExt, symlink};
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use std::time::Duration;

use crate::scratch::{
    Case, content, copy_folder, corpus, edit, example, example_of, findings, mhlint, project,
};
use rayon::prelude::*;
use serde_json::Value;

const WEIGHTS: &str = "data/rigs/figure/default_weights.mhw";
const OVAL: &str = "data/target/figure/head/head-oval.target";
const MACRO: &str = "data/target/figure/macro.json";

/// The rules that declare a fix, and of which kind, from the binary itself.
fn fixable_rules() -> BTreeMap<String, String> {
    let output = mhlint(&project("."), &["rules", "--format", "json"]);
    let rules: Value = serde_json::from_slice(&output.stdout).unwrap();
    let pair = |rule: &Value| {
        (
            rule["id"].as_str().unwrap().to_owned(),
            rule["fix"].as_str().unwrap().to_owned(),
        )
    };
    rules
        .as_array()
        .unwrap()
        .iter()
        .map(pair)
        .filter(|(_, fix)| fix != "none")
        .collect()
}

fn changed(
    before: &BTreeMap<PathBuf, Vec<u8>>,
    after: &BTreeMap<PathBuf, Vec<u8>>,
) -> Vec<PathBuf> {
    let paths: BTreeSet<&PathBuf> = before.keys().chain(after.keys()).collect();
    paths
        .into_iter()
        .filter(|path| before.get(*path) != after.get(*path))
        .cloned()
        .collect()
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).unwrap()
}

fn check(root: &Path, args: &[&str]) -> Output {
    mhlint(root, &[&["check", "."], args].concat())
}

fn concise(root: &Path) -> Vec<String> {
    findings(&check(root, &["--report", "concise"]))
}

/// Rule and fix of each finding.
fn reported(root: &Path) -> Vec<(String, Value)> {
    let report: Value = serde_json::from_slice(&check(root, &["--report", "json"]).stdout).unwrap();
    let of = |finding: &Value| {
        (
            finding["rule"].as_str().unwrap().to_owned(),
            finding["fix"].clone(),
        )
    };
    report["findings"]
        .as_array()
        .unwrap()
        .iter()
        .map(of)
        .collect()
}

/// The rule of a line of the concise report.
fn rule_of(line: &str) -> &str {
    line.split_once('[')
        .and_then(|(_, rest)| rest.split_once(']'))
        .map_or("", |(rule, _)| rule)
}

#[test]
fn every_fixable_case_is_fixed_for_good() {
    let rules = fixable_rules();
    let mut cases = Vec::new();
    for rule in rules.keys() {
        for entry in fs::read_dir(project("fixtures/rules").join(rule)).unwrap() {
            let folder = entry.unwrap().path();
            let name = folder.file_name().unwrap().to_str().unwrap();
            if name.starts_with("bad") {
                cases.push((rule.as_str(), folder));
            }
        }
    }
    let results: Vec<Result<Option<&str>, String>> = cases
        .par_iter()
        .map(|(rule, folder)| Ok(fix_case(rule, &rules[*rule], folder)?.then_some(*rule)))
        .collect();
    let faults: Vec<&String> = results
        .iter()
        .filter_map(|result| result.as_ref().err())
        .collect();
    assert!(faults.is_empty(), "{faults:#?}");
    let fixed: BTreeSet<&str> = results.into_iter().filter_map(Result::unwrap).collect();
    assert_eq!(
        fixed,
        rules.keys().map(String::as_str).collect(),
        "every rule that declares a fix has a case for it"
    );
}

/// What an application refuses has no effect and is not checked; once fixed it counts, and what is
/// wrong with it is news.
pub(crate) const HIDDEN: [(&str, &str); 3] = [
    ("file-byte-order-mark", "catalog-unlisted-target"),
    ("file-byte-order-mark", "json-schema"),
    ("overlay-broken-override", "overlay-targets-not-in-layer"),
];

/// Fixes one case with all fixes. `false`: this case is one that only a person can fix.
fn fix_case(rule: &str, declared: &str, folder: &Path) -> Result<bool, String> {
    let case = Case::read(folder);
    let repository = example_of(case.application.as_deref().unwrap_or("makehuman2"));
    let root = repository.path();
    case.apply(root);
    let before = reported(root);
    let old = concise(root);
    let original = content(root);
    let Some((_, fix)) = before.iter().find(|(id, fix)| id == rule && !fix.is_null()) else {
        check(root, &["--fix", "--unsafe-fixes"]);
        let still = reported(root).iter().any(|(id, _)| id == rule);
        return if still {
            Ok(false)
        } else {
            Err(format!("{}: fixed without being offered", folder.display()))
        };
    };
    if fix["kind"] != *declared || fix["title"].as_str().unwrap().is_empty() {
        return Err(format!(
            "{}: {fix} is not the declared kind {declared}",
            folder.display()
        ));
    }
    // A safe fix needs no more than --fix, an unsafe one is not done by it.
    check(root, &["--fix"]);
    let is_safe = declared == "safe";
    if reported(root).iter().any(|(id, _)| id == rule) == is_safe {
        return Err(format!("{}: --fix alone", folder.display()));
    }
    check(root, &["--fix", "--unsafe-fixes"]);
    let fixed = content(root);
    let new = concise(root);
    let known: BTreeSet<&str> = old.iter().map(|line| rule_of(line)).collect();
    let fresh: Vec<&String> = new
        .iter()
        .filter(|line| rule_of(line) == rule || !known.contains(rule_of(line)))
        .collect();
    if fresh
        .iter()
        .any(|line| rule_of(line) == rule || !HIDDEN.contains(&(rule, rule_of(line))))
    {
        return Err(format!("{}: {fresh:#?}", folder.display()));
    }
    let again = check(root, &["--fix", "--unsafe-fixes"]);
    if content(root) != fixed || !text(&again.stderr).contains("nothing fixed") {
        return Err(format!(
            "{}: a second run changes something",
            folder.display()
        ));
    }
    if changed(&original, &fixed).is_empty() {
        return Err(format!("{}: nothing changed", folder.display()));
    }
    Ok(true)
}

#[test]
fn all_bytes_but_the_fault_stay() {
    let repository = example();
    let root = repository.path();
    let before = content(root);
    edit(
        root,
        OVAL,
        "339 0 .001 .001\n",
        "339 0 .001 .001\n# kept  as is\r\n600  0\t0 -0.000\r\n",
    );
    edit(
        root,
        MACRO,
        "\"t\": \"coastal-male\"",
        "\"t\" :\t\"coastal-male.target\"",
    );
    edit(
        root,
        WEIGHTS,
        "[158, 1.0], [159, 1.0]",
        "[158, 0.5], [158,0.5], [159, 2.5e-1]",
    );
    let output = check(root, &["--fix", "--unsafe-fixes"]);
    let told = text(&output.stderr);
    assert!(told.contains("mhlint: 4 fixed in 3 files: "), "{told}");
    assert!(
        told.contains("weights-duplicate-vertex (1), weights-not-normalized (1)"),
        "{told}"
    );
    assert_eq!(output.status.code(), Some(0), "nothing remains");
    let after = content(root);
    let had = |file: &str| text(&before[Path::new(file)]);
    let has = |file: &str| text(&after[Path::new(file)]);
    assert_eq!(
        has(OVAL),
        had(OVAL).replace("339 0 .001 .001\n", "339 0 .001 .001\n# kept  as is\r\n")
    );
    assert_eq!(
        has(MACRO),
        had(MACRO).replace("\"t\": \"coastal-male\"", "\"t\" :\t\"coastal-male\"")
    );
    assert_eq!(has(WEIGHTS), had(WEIGHTS));
}

#[test]
fn several_faults_of_one_name_are_fixed_one_after_the_other() {
    for (file, right, wrong, safely, whole) in [
        (
            "data/target/figure/modelling.json",
            "head/head-oval",
            r"Head\\head-oval",
            "Head/head-oval",
            "head/head-oval",
        ),
        (
            MACRO,
            "coastal-male",
            "Coastal-male.target.gz",
            "Coastal-male",
            "coastal-male",
        ),
        (
            MACRO,
            "coastal-male",
            r".\\\\COASTAL-male.target",
            ".//COASTAL-male",
            ".//coastal-male",
        ),
    ] {
        let repository = example();
        let root = repository.path();
        let written =
            |name: &str| format!("{}: \"{name}\"", if file == MACRO { "\"t\"" } else { "" });
        let text = fs::read_to_string(root.join(file)).unwrap();
        edit(root, file, &written(right), &written(wrong));
        for (options, name) in [
            (&["--fix"][..], safely),
            (&["--fix", "--unsafe-fixes"], whole),
        ] {
            check(root, options);
            let expected = text.replacen(&written(right), &written(name), 1);
            assert_eq!(
                fs::read_to_string(root.join(file)).unwrap(),
                expected,
                "{wrong} {options:?}"
            );
        }
        assert!(reported(root).is_empty(), "{wrong}: {:?}", reported(root));
    }
}

#[test]
fn a_diff_changes_nothing_and_is_what_fix_does() {
    let repository = example();
    let root = repository.path();
    let none = check(root, &["--diff"]);
    assert_eq!(
        (none.status.code(), text(&none.stdout)),
        (Some(0), String::new())
    );
    edit(root, OVAL, "339 0 .001 .001\n", "339 0 0 0\n");
    fs::write(
        root.join("data/target/figure/macro_build/teen-maxmuscle.target"),
        "# nothing\n",
    )
    .unwrap();
    let before = content(root);
    let diff = check(root, &["--diff", "--unsafe-fixes"]);
    assert_eq!(
        (diff.status.code(), content(root) == before),
        (Some(1), true)
    );
    let shown = text(&diff.stdout);
    assert!(
        shown.contains(
            "--- a/data/target/figure/head/head-oval.target\n+++ b/data/target/figure/head/"
        ),
        "{shown}"
    );
    assert!(
        shown.contains("\n-339 0 0 0\n") && shown.contains("\n+++ /dev/null\n"),
        "{shown}"
    );
    assert!(
        text(&diff.stderr).contains("2 would be fixed in 3 files"),
        "{}",
        text(&diff.stderr)
    );
    let patched = tempfile::tempdir().unwrap();
    copy_folder(root, patched.path());
    fs::write(patched.path().join("fix.diff"), &diff.stdout).unwrap();
    let git = Command::new("git")
        .current_dir(&patched)
        .args(["apply", "fix.diff"])
        .output()
        .unwrap();
    assert!(git.status.success(), "{}", text(&git.stderr));
    fs::remove_file(patched.path().join("fix.diff")).unwrap();
    check(root, &["--fix", "--unsafe-fixes"]);
    assert_eq!(content(patched.path()), content(root));
}

/// Carriage returns that end no line, bytes that are no UTF-8, and empty files, one with a blank in
/// its name.
#[test]
fn git_and_patch_apply_every_diff() {
    let repository = example();
    let root = repository.path();
    edit(root, OVAL, "339 0 .001 .001\n", "339 0 0 0\r\n# a\rb\n");
    let side = root.join("data/target/figure/head/head-side-in.target");
    let rows = fs::read(&side).unwrap();
    fs::write(
        &side,
        [b"# \xff\n".as_slice(), &rows, b"450 0 0 0\n# \r"].concat(),
    )
    .unwrap();
    for (name, text) in [
        ("teen-maxmuscle", "# no row\n"),
        ("male-adult-minmuscle", ""),
    ] {
        fs::write(
            root.join(format!("data/target/figure/macro_build/{name}.target")),
            text,
        )
        .unwrap();
    }
    // A name that is not Unicode, where files may have one.
    #[cfg(target_os = "linux")]
    {
        use std::os::unix::ffi::OsStrExt;
        let folder = root
            .join("data/target/figure")
            .join(std::ffi::OsStr::from_bytes(b"k\xf6rper"));
        fs::create_dir(&folder).unwrap();
        fs::write(folder.join("wide.target"), "339 0 .001 .001\n340 0 0 0\n").unwrap();
    }
    let diff = check(root, &["--diff", "--unsafe-fixes"]).stdout;
    let is_named = diff.windows(10).any(|text| text == b"k\\366rper/");
    assert_eq!(is_named, cfg!(target_os = "linux"), "{}", text(&diff));
    let patched = |program: &str, args: &[&str]| {
        let folder = tempfile::tempdir().unwrap();
        copy_folder(root, folder.path());
        let file = tempfile::NamedTempFile::new().unwrap();
        fs::write(file.path(), &diff).unwrap();
        let mut command = Command::new(program);
        command.current_dir(&folder).args(args).arg(file.path());
        let Ok(output) = command.output() else {
            eprintln!("`{program}` is not there: skipped");
            return None;
        };
        assert!(
            output.status.success(),
            "{program}: {} {}",
            text(&output.stdout),
            text(&output.stderr)
        );
        Some(content(folder.path()))
    };
    let by_git = patched("git", &["apply"]);
    let by_patch = patched("patch", &["-p1", "-i"]);
    check(root, &["--fix", "--unsafe-fixes"]);
    let fixed = content(root);
    assert!(
        !fixed
            .keys()
            .any(|path| path.ends_with("teen-maxmuscle.target")),
        "a file without rows is deleted"
    );
    let is_kept = fixed
        .keys()
        .any(|path| path.ends_with("male-adult-minmuscle.target"));
    assert!(is_kept, "what is left of an export that failed is kept");
    for other in [by_git, by_patch].into_iter().flatten() {
        assert_eq!(changed(&other, &fixed), Vec::<PathBuf>::new());
    }
}

/// No JSON says a sum beyond float32, and where the sum is infinite the shares are no measure of
/// the weights.
#[test]
fn weights_beyond_float32_are_left_to_a_person() {
    for weights in [
        "[158, 1.0], [158, 1e40]",
        "[158, 3e38], [158, 3e38]",
        "[158, 3e38], [158, 0]",
    ] {
        let repository = example();
        let root = repository.path();
        edit(root, WEIGHTS, "[158, 1.0]", weights);
        check(root, &["--fix", "--unsafe-fixes"]);
        let after = fs::read_to_string(root.join(WEIGHTS)).unwrap();
        assert!(
            after.contains("3e38") || after.contains("1e40"),
            "{weights}"
        );
        assert!(serde_json::from_str::<Value>(&after).is_ok(), "{weights}");
    }
}

#[test]
fn only_what_is_reported_is_fixed() {
    let damaged = || {
        let repository = example();
        edit(repository.path(), OVAL, "339 0 .001 .001\n", "339 0 0 0\n");
        edit(repository.path(), WEIGHTS, "[158, 1.0]", "[158, 0.5]");
        repository
    };
    for (args, file) in [
        (&["check", ".", "--fix", "--only", "target-*"][..], OVAL),
        (&["check", ".", "--fix", "--skip", "weights-*"][..], OVAL),
        (
            &[
                "check",
                ".",
                "--fix",
                "--unsafe-fixes",
                "--level",
                "target-zero-delta=off",
            ][..],
            WEIGHTS,
        ),
        (
            &["check", "data/rigs", "--fix", "--unsafe-fixes"][..],
            WEIGHTS,
        ),
    ] {
        let repository = damaged();
        let before = content(repository.path());
        mhlint(repository.path(), args);
        assert_eq!(
            changed(&before, &content(repository.path())),
            [PathBuf::from(file)],
            "{args:?}"
        );
    }
}

#[test]
fn system_data_are_never_changed() {
    let repository = example();
    let root = repository.path();
    edit(root, OVAL, "339 0 .001 .001\n", "339 0 0 0\n");
    let before = content(root);
    let output = mhlint(
        root,
        &[
            "check",
            "user",
            "--system",
            "data",
            "--fix",
            "--unsafe-fixes",
        ],
    );
    assert_eq!(
        (output.status.code(), content(root) == before),
        (Some(0), true)
    );
    mhlint(
        root,
        &["check", ".", "--system", "data", "--fix", "--unsafe-fixes"],
    );
    assert!(content(root) == before);
}

#[test]
fn options_that_make_no_sense_together_are_refused() {
    for args in [
        ["--unsafe-fixes"].as_slice(),
        &["--fix", "--diff"],
        &["--diff", "--report", "json"],
    ] {
        let output = check(&project("fixtures/makehuman2"), args);
        assert_eq!(output.status.code(), Some(2), "{args:?}");
    }
}

#[test]
fn a_file_that_may_not_be_written_stops_all() {
    let repository = example();
    let root = repository.path();
    edit(root, OVAL, "339 0 .001 .001\n", "339 0 0 0\n");
    edit(root, WEIGHTS, "[158, 1.0]", "[158, 0.5]");
    fs::set_permissions(root.join(OVAL), fs::Permissions::from_mode(0o444)).unwrap();
    let before = content(root);
    let output = check(root, &["--fix", "--unsafe-fixes"]);
    assert_eq!(
        (output.status.code(), content(root) == before),
        (Some(2), true)
    );
    let told = text(&output.stderr);
    assert!(
        told.contains("cannot change `data/target/figure/head/head-oval.target`: it is read-only"),
        "{told}"
    );
}

#[test]
fn modes_and_links_stay() {
    let repository = example();
    let root = repository.path();
    fs::rename(root.join(OVAL), root.join("data/kept.txt")).unwrap();
    symlink("../../../kept.txt", root.join(OVAL)).unwrap();
    edit(root, "data/kept.txt", "339 0 .001 .001\n", "339 0 0 0\n");
    fs::set_permissions(
        root.join("data/kept.txt"),
        fs::Permissions::from_mode(0o600),
    )
    .unwrap();
    check(root, &["--fix"]);
    assert!(
        !fs::read_to_string(root.join("data/kept.txt"))
            .unwrap()
            .contains("339 0 0 0")
    );
    assert!(fs::symlink_metadata(root.join(OVAL)).unwrap().is_symlink());
    assert_eq!(
        fs::metadata(root.join("data/kept.txt"))
            .unwrap()
            .permissions()
            .mode()
            & 0o777,
        0o600
    );
}

#[test]
fn killed_at_any_moment_every_file_is_whole() {
    let damaged = example();
    edit(damaged.path(), OVAL, "339 0 .001 .001\n", "339 0 0 0\n");
    edit(damaged.path(), WEIGHTS, "[158, 1.0]", "[158, 0.5]");
    let old = content(damaged.path());
    let fixed = tempfile::tempdir().unwrap();
    copy_folder(damaged.path(), fixed.path());
    check(fixed.path(), &["--fix"]);
    let new = content(fixed.path());
    for round in 0..12 {
        let copy = tempfile::tempdir().unwrap();
        copy_folder(damaged.path(), copy.path());
        let mut child = Command::new(env!("CARGO_BIN_EXE_mhlint"));
        let child = child
            .current_dir(&copy)
            .args(["check", ".", "--fix", "--no-eval"]);
        let mut child = child
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .spawn()
            .unwrap();
        std::thread::sleep(Duration::from_millis(round * 15));
        child.kill().unwrap();
        child.wait().unwrap();
        for (path, bytes) in content(copy.path()) {
            let is_left_behind = path.file_name().unwrap().to_str().unwrap().starts_with('.');
            assert!(
                is_left_behind || old.get(&path) == Some(&bytes) || new.get(&path) == Some(&bytes),
                "{path:?}"
            );
        }
        check(copy.path(), &["--fix"]);
        assert_eq!(
            content(copy.path()),
            new,
            "nothing is left after the next one"
        );
    }
}

/// Many targets to fix, so that signals come while they are written.
fn much_to_fix() -> tempfile::TempDir {
    let repository = example();
    for at in 0..300 {
        let target = repository
            .path()
            .join(format!("data/target/figure/head/many-{at}.target"));
        fs::write(target, "# basemesh figure\n1 .1 0 0\n2 0 0 0\n").unwrap();
    }
    repository
}

/// Starts a fix, and sends it a signal as soon as something of it lies beside the data. Gives how
/// it ended.
fn interrupted(root: &Path, signal: &str) -> Option<std::process::ExitStatus> {
    let mut child = Command::new(env!("CARGO_BIN_EXE_mhlint"));
    let child = child.current_dir(root).args([
        "check",
        ".",
        "--fix",
        "--no-eval",
        "--only",
        "target-zero-delta",
    ]);
    let mut child = child
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .unwrap();
    while hidden(root).is_empty() {
        if child.try_wait().unwrap().is_some() {
            return None;
        }
        std::thread::yield_now();
    }
    Command::new("kill")
        .args([signal, &child.id().to_string()])
        .status()
        .unwrap();
    Some(child.wait().unwrap())
}

/// Hidden files of fixes.
fn hidden(root: &Path) -> Vec<String> {
    let names =
        ["", "data/target/figure/head"].map(|folder| fs::read_dir(root.join(folder)).unwrap());
    let names = names
        .into_iter()
        .flatten()
        .map(|one| one.unwrap().file_name().into_string().unwrap());
    names.filter(|name| name.starts_with(".mhlint-")).collect()
}

#[test]
fn a_fix_that_is_ended_by_a_signal_leaves_nothing() {
    for (signal, code) in [("-INT", 130), ("-TERM", 143)] {
        let repository = much_to_fix();
        let ended = interrupted(repository.path(), signal);
        assert!(ended.is_none_or(
            |status| matches!(status.code(), Some(found) if found == code || found == 0)
        ));
        assert_eq!(hidden(repository.path()), [""; 0], "{signal}");
    }
}

#[test]
fn what_a_killed_fix_leaves_is_said_and_removed_by_the_next() {
    // The signal may come when all is done: then once more.
    let is_killed = |repository: &tempfile::TempDir| {
        let ended = interrupted(repository.path(), "-KILL");
        ended.is_some_and(|status| !status.success()) && !hidden(repository.path()).is_empty()
    };
    let repository = (0..20)
        .map(|_| much_to_fix())
        .find(is_killed)
        .expect("one that left something");
    let root = repository.path();
    fs::write(root.join("data/target/figure/head/.mhlint-other"), "mine").unwrap();
    let left = hidden(root);
    let said = |args: &[&str]| text(&check(root, args).stderr);
    let told = said(&[]);
    assert!(
        told.contains("a `--fix` that was interrupted left"),
        "{told}"
    );
    assert_eq!(
        said(&["-q"]).matches("interrupted").count(),
        0,
        "a quiet run is quiet"
    );
    // Over other data these are the system's, which nobody writes.
    let pack = example();
    let over = [
        "check",
        "user",
        "--system",
        root.to_str().unwrap(),
        "--fix",
        "--no-eval",
    ];
    assert_ne!(mhlint(pack.path(), &over).status.code(), Some(2));
    assert_eq!(hidden(root), left, "neither removes anything");
    let told = said(&["--fix"]);
    assert!(
        told.contains("of a `--fix` that was interrupted removed from"),
        "{told}"
    );
    assert_eq!(hidden(root), [".mhlint-other"], "another one's file stays");
    assert_eq!(said(&[]).matches("interrupted").count(), 0);
}

#[test]
fn reports_tell_what_can_be_fixed() {
    let repository = example();
    let root = repository.path();
    edit(root, OVAL, "339 0 .001 .001\n", "339 0 0 0\n");
    let human = text(&check(root, &["--full"]).stdout);
    assert!(
        human.contains("  fix: remove the rows (`--fix`)\n"),
        "{human}"
    );
    let expected = serde_json::json!({ "kind": "safe", "title": "remove the rows" });
    assert_eq!(reported(root), [("target-zero-delta".to_owned(), expected)]);
}

/// The corpus, fixed: what is evaluated stays what it was, as the rules say, and the diff holds
/// fixes only.
#[test]
#[ignore = "needs the corpora: MHLINT_CORPORA=FOLDER cargo test -- --ignored"]
fn the_corpus_keeps_its_shape() {
    let folder = tempfile::tempdir().unwrap();
    let root = folder.path();
    copy_folder(&corpus("makehuman2/data"), &root.join("data"));
    let before = (content(root), evaluated(root));
    let fixable = fixable_rules();
    let output = mhlint(
        root,
        &[
            "check",
            "data",
            "--fix",
            "--unsafe-fixes",
            "--report",
            "concise",
        ],
    );
    assert!(
        matches!(output.status.code(), Some(0 | 1)),
        "{}",
        text(&output.stderr)
    );
    let left: Vec<String> = findings(&output)
        .into_iter()
        .filter(|line| fixable.contains_key(rule_of(line)))
        .collect();
    assert_eq!(left, Vec::<String>::new());
    let after = content(root);
    let again = mhlint(root, &["check", "data", "--fix", "--unsafe-fixes"]);
    assert!(text(&again.stderr).contains("nothing fixed") && content(root) == after);
    for path in changed(&before.0, &after) {
        let (old, new) = (text(&before.0[&path]), text(&after[&path]));
        match path.extension().unwrap().to_str().unwrap() {
            "target" => only_zero_rows_are_gone(&old, &new),
            "mhpose" => assert_eq!(old.replace("\"licence\"", "\"license\""), new),
            "mhw" => only_numbers_of_weights_differ(&old, &new),
            other => panic!("{}: nothing to mend in .{other}", path.display()),
        }
    }
    for (old, new) in before.1.iter().zip(evaluated(root)) {
        let worst = old
            .iter()
            .zip(&new)
            .map(|(a, b)| (a - b).abs())
            .fold(0.0, f64::max);
        assert!(
            old.len() == new.len() && worst < 1e-5,
            "{} and {} numbers, {worst}",
            old.len(),
            new.len()
        );
    }
}

fn only_zero_rows_are_gone(old: &str, new: &str) {
    let is_zero = |line: &&str| {
        let words: Vec<&str> = line.split_whitespace().collect();
        matches!(words.as_slice(), [_, deltas @ ..] if deltas.len() == 3 && deltas.iter().all(|word| word.parse() == Ok(0.0)))
    };
    let kept: Vec<&str> = old
        .split_inclusive('\n')
        .filter(|line| !is_zero(line))
        .collect();
    assert_eq!(kept.concat(), new);
}

fn only_numbers_of_weights_differ(old: &str, new: &str) {
    let frame = |text: &str| -> String {
        text.split(']')
            .map(|part| part.rsplit_once(", ").map_or(part, |(frame, _)| frame))
            .collect::<Vec<_>>()
            .join("]")
    };
    assert_eq!(frame(old), frame(new));
    assert!(
        old.lines().zip(new.lines()).any(|(a, b)| a == b),
        "lines without a fault stay"
    );
}

/// Bones turned by a right angle: enough that a weight counts.
const POSED: [&str; 4] = ["upperarm01.L", "upperleg01.R", "spine02", "head"];
const POSED_BOT: [&str; 3] = ["forearm.L", "lowerleg.L", "head"];
/// Sliders at which targets with zero rows and their neighbours are applied.
const SLIDERS: [&str; 4] = [
    "macrodetails/Gender=0.7",
    "macrodetails/Age=0.8",
    "macrodetails-universal/Weight=0.9",
    "macrodetails-proportions/BodyProportions=0.9",
];

/// Numbers of the mesh, of the posed mesh, and of the bones of both bases.
fn evaluated(root: &Path) -> Vec<Vec<f64>> {
    let mut all = Vec::new();
    for (base, sliders, posed) in [
        ("hm08", &SLIDERS[..], &POSED[..]),
        ("mh2bot", &SLIDERS[..0], &POSED_BOT[..]),
    ] {
        let pose = tempfile::NamedTempFile::new().unwrap();
        let bones = posed
            .iter()
            .map(|bone| format!("\"{bone}\": [[0, -1, 0], [1, 0, 0], [0, 0, 1]]"));
        fs::write(
            pose.path(),
            format!("{{{}}}", bones.collect::<Vec<_>>().join(", ")),
        )
        .unwrap();
        let set: Vec<&str> = sliders
            .iter()
            .flat_map(|slider| ["--set", slider])
            .collect();
        let eval = |what: &[&str]| {
            let output = mhlint(
                root,
                &[
                    &["eval", what[0], "data", "--base", base],
                    &what[1..],
                    &set[..],
                ]
                .concat(),
            );
            assert!(
                output.status.success(),
                "{what:?}: {}",
                text(&output.stderr)
            );
            output
        };
        let obj = root.join("evaluated.obj");
        let out = ["-o", obj.to_str().unwrap()];
        for what in [
            vec!["mesh"],
            vec!["skin", "--pose", pose.path().to_str().unwrap()],
        ] {
            eval(&[what.as_slice(), &out].concat());
            let lines = fs::read_to_string(&obj).unwrap();
            let vertices = lines.lines().filter_map(|line| line.strip_prefix("v "));
            all.push(
                vertices
                    .flat_map(str::split_whitespace)
                    .map(|word| word.parse().unwrap())
                    .collect(),
            );
            fs::remove_file(&obj).unwrap();
        }
        let bones: Value = serde_json::from_slice(&eval(&["skeleton"]).stdout).unwrap();
        all.push(numbers_in(&bones["outputs"]));
    }
    assert!(all.iter().all(|numbers: &Vec<f64>| numbers.len() > 1000));
    all
}

fn numbers_in(value: &Value) -> Vec<f64> {
    match value {
        Value::Number(number) => vec![number.as_f64().unwrap()],
        Value::Array(values) => values.iter().flat_map(numbers_in).collect(),
        Value::Object(members) => members.values().flat_map(numbers_in).collect(),
        _ => Vec::new(),
    }
}
