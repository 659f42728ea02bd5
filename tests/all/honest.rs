//! What is said of what was not checked: green covers only what was.

use std::fs;
use std::path::Path;
use std::process::Output;

use serde_json::Value;

use crate::scratch::{assert_refused, example, mhlint, project, stderr, stdout};

const TARGET: &str = "# basemesh figure\n1 0.1 0.2 0.3\n99999 0 0 1\n";

fn code(output: &Output) -> Option<i32> {
    output.status.code()
}

fn report(folder: &Path, args: &[&str]) -> Value {
    let output = mhlint(folder, &[args, &["--report", "json"]].concat());
    serde_json::from_slice(&output.stdout)
        .unwrap_or_else(|error| panic!("{error}: {}", stderr(&output)))
}

/// The rules of what was found.
fn rules(report: &Value) -> Vec<&str> {
    report["findings"]
        .as_array()
        .unwrap()
        .iter()
        .map(|finding| finding["rule"].as_str().unwrap())
        .collect()
}

/// What was not checked: application, reason, number.
fn unchecked(report: &Value) -> Vec<(&str, &str, u64)> {
    let entry = |one: &'_ Value| {
        let text = |key: &str| one[key].as_str().unwrap_or_default().to_owned();
        (
            text("application"),
            text("what"),
            one["count"].as_u64().unwrap(),
        )
    };
    let all = report["not_checked"].as_array().unwrap();
    all.iter()
        .for_each(|one| assert!(!one["examples"].as_array().unwrap().is_empty(), "{one}"));
    let leak = |text: String| -> &'static str { Box::leak(text.into_boxed_str()) };
    all.iter()
        .map(entry)
        .map(|(application, what, count)| (leak(application), leak(what), count))
        .collect()
}

fn write(folder: &Path, path: &str, text: &str) {
    let path = folder.join(path);
    fs::create_dir_all(path.parent().unwrap()).unwrap();
    fs::write(path, text).unwrap();
}

fn system() -> String {
    project("fixtures/makehuman2/data")
        .to_str()
        .unwrap()
        .to_owned()
}

/// Sliders that are all set after a reset make settings of thousands of values each.
#[test]
fn settings_that_are_left_out_are_said() {
    let folder = tempfile::tempdir().unwrap();
    write(
        folder.path(),
        "data/base/b/base.obj",
        "v -1 0 0\nv 1 0 0\nv 1 1 0\ng body\nf 1 2 3\n",
    );
    write(
        folder.path(),
        "data/base/b/base.json",
        "{\"visible groups\": [\"body\"]}",
    );
    write(folder.path(), "data/target/b/t/a.target", "0 .1 0 0\n");
    let sliders = |count: usize| {
        let slider = |at: usize| format!("\"s{at}\": {{\"incr\": \"t/a\", \"default\": 0.5}}");
        let all: Vec<String> = (0..count).map(slider).collect();
        write(
            folder.path(),
            "data/target/b/modelling.json",
            &format!("{{{}}}", all.join(",")),
        );
        unchecked(&report(folder.path(), &["."]))
            .iter()
            .filter(|(_, what, _)| *what == "evaluation")
            .count()
    };
    assert_eq!((sliders(100), sliders(3000)), (0, 1));
}

#[test]
fn a_loose_target_is_checked_however_deep_it_lies() {
    let folder = tempfile::tempdir().unwrap();
    write(folder.path(), "a/b/c/d.target", "99999 0 0 1\n");
    // Folders are joined, and these two become one.
    write(
        folder.path(),
        "a_b/c/d.target",
        "99999 0 0 1\n88888 0 0 1\n",
    );
    let found = report(
        folder.path(),
        &[".", "--system", &system(), "--base", "figure"],
    );
    assert_eq!(rules(&found), ["target-vertex-out-of-range"; 2]);
    assert_eq!(
        (found["summary"]["files"].as_u64(), unchecked(&found)),
        (Some(2), vec![])
    );
}

#[test]
fn a_loose_target_belongs_to_the_base_mesh_in_its_header() {
    let folder = tempfile::tempdir().unwrap();
    write(folder.path(), "one.target", TARGET);
    // The header goes before the only base mesh of the system, and `--base` before the header.
    write(
        folder.path(),
        "other.target",
        &TARGET.replace("figure", "other"),
    );
    let found = report(folder.path(), &[".", "--system", &system()]);
    assert_eq!(rules(&found), ["target-vertex-out-of-range"]);
    assert_eq!(unchecked(&found), [("makehuman2", "base-not-in-system", 1)]);
    let asked = report(
        folder.path(),
        &[".", "--system", &system(), "--base", "figure"],
    );
    assert_eq!(
        rules(&asked),
        [
            "target-vertex-out-of-range",
            "target-basemesh-mismatch",
            "target-vertex-out-of-range"
        ]
    );
    let alone = report(folder.path(), &["."]);
    assert_eq!(
        (rules(&alone), unchecked(&alone)),
        (vec![], vec![("makehuman2", "no-base-mesh", 2)])
    );
    let output = mhlint(folder.path(), &["."]);
    assert_eq!(code(&output), Some(0));
    assert!(
        stdout(&output).contains("Passed: no findings"),
        "{}",
        stdout(&output)
    );
    assert!(
        stdout(&output).contains("Not checked: vertex numbers in 2 .target"),
        "{}",
        stdout(&output)
    );
}

#[test]
fn what_is_too_large_to_be_kept_is_said() {
    let repository = example();
    let skin = "data/skins/figure/clay.mhmat";
    assert_eq!(unchecked(&report(repository.path(), &["."])), []);
    let text = fs::read_to_string(repository.path().join(skin)).unwrap();
    write(
        repository.path(),
        skin,
        &(text + &"shaderParam sheen 1\n".repeat(2000)),
    );
    let tree = format!(
        "{}[\"left\"]{}",
        "{\"a long label\": ".repeat(90),
        "}".repeat(90)
    );
    write(
        repository.path(),
        "data/clothes/figure/selection_filter.json",
        &format!("{{\"Slot\": {tree}}}"),
    );
    assert_eq!(
        unchecked(&report(repository.path(), &["."])),
        [("makehuman2", "part", 2)]
    );
    let output = mhlint(repository.path(), &[skin]);
    assert!(
        stdout(&output)
            .contains("Not checked: parts of `data/skins/figure/clay.mhmat` (too large).")
    );
}

#[test]
fn loose_files_take_one_base() {
    let folder = tempfile::tempdir().unwrap();
    write(folder.path(), "one.target", TARGET);
    let args = [
        ".",
        "--system",
        &system(),
        "--base",
        "figure",
        "--base",
        "imp",
    ];
    assert_refused(
        &mhlint(folder.path(), &args),
        &["`one.target`", "use `--base` once"],
    );
    assert_refused(
        &mhlint(
            folder.path(),
            &[".", "--system", &system(), "--base", "nobody"],
        ),
        &["nobody"],
    );
}

#[test]
fn loose_files_beside_a_data_folder_are_checked_too() {
    let repository = example();
    write(repository.path(), "drafts/deep/one.target", TARGET);
    let found = report(repository.path(), &["."]);
    assert_eq!(rules(&found), ["target-vertex-out-of-range"]);
    assert_eq!(found["findings"][0]["path"], "drafts/deep/one.target");
}

#[test]
fn files_of_other_programs_get_no_finding() {
    let folder = tempfile::tempdir().unwrap();
    write(
        folder.path(),
        "systemd/basic.target",
        "[Unit]\nDescription=Basic System\n",
    );
    std::os::unix::fs::symlink("/nowhere", folder.path().join("systemd/dead.target")).unwrap();
    std::os::unix::fs::symlink("/etc/hostname", folder.path().join("systemd/out")).unwrap();
    let output = mhlint(folder.path(), &["."]);
    assert_eq!(
        (code(&output), stdout(&output).as_str()),
        (Some(3), ""),
        "{}",
        stderr(&output)
    );
    assert!(
        stderr(&output).contains("nothing was checked in `.`"),
        "{}",
        stderr(&output)
    );
    // Who names a file wants to hear of it.
    let named = report(folder.path(), &["systemd/basic.target"]);
    assert_eq!(rules(&named), ["target-field-count"]);
}

#[test]
fn a_path_of_which_nothing_was_checked_is_named() {
    let repository = example();
    write(repository.path(), "notes/todo.txt", "x");
    let output = mhlint(repository.path(), &["data", "notes", "--report", "concise"]);
    assert_eq!(code(&output), Some(3), "{}", stdout(&output));
    assert!(
        stderr(&output).contains(
            "nothing was checked in `notes`: no data of MakeHuman 2, MakeHuman 1 or MPFB found"
        ),
        "{}",
        stderr(&output)
    );
    assert!(
        stdout(&output).contains("0 errors"),
        "what was checked is reported: {}",
        stdout(&output)
    );
    // Findings outweigh it.
    write(
        repository.path(),
        "data/target/figure/head/bad.target",
        "x y z w\n",
    );
    assert_eq!(
        code(&mhlint(repository.path(), &["data", "notes"])),
        Some(1)
    );
}

#[test]
fn files_that_nothing_reads_do_not_count() {
    let repository = example();
    let before = report(repository.path(), &["data"]);
    for path in [
        "clothes/figure/a/a.blend",
        "models/figure/walk.blend",
        "expressions/figure/smile.blend",
        "skins/a.blend",
    ] {
        write(repository.path(), &format!("data/{path}"), "name a\n");
    }
    let found = report(repository.path(), &["data", "--only", "macro-*"]);
    assert_eq!(found["summary"]["files"], before["summary"]["files"]);
    let [(application, what, count)] = unchecked(&found)[..] else {
        panic!("{found}")
    };
    assert_eq!(unchecked(&before), []);
    assert_eq!((application, what, count), ("makehuman2", "kind", 4));
    let human =
        stdout(&mhlint(repository.path(), &["data", "--only", "macro-*"])).replace('\n', " ");
    assert!(
        human.contains("Not checked: ") && human.contains("(no rules yet)"),
        "{human}"
    );
    let alone = mhlint(repository.path(), &["data/models/figure/walk.blend"]);
    assert_eq!(code(&alone), Some(3), "{}", stdout(&alone));
    assert!(
        stderr(&alone).contains("there are no rules for files of these kinds yet"),
        "{}",
        stderr(&alone)
    );
    let loose = tempfile::tempdir().unwrap();
    write(loose.path(), "shirt/a.mhuv", "x\n");
    write(loose.path(), "shirt/a.mhbin", "x\n");
    let alone = mhlint(loose.path(), &["shirt"]);
    assert_eq!(code(&alone), Some(3));
    assert!(
        stderr(&alone).contains("Not checked: 1 .mhbin (not in a data folder)"),
        "{}",
        stderr(&alone)
    );
}

#[test]
fn a_path_counts_what_is_below_it() {
    let repository = example();
    let of = |path: &str| {
        report(repository.path(), &[path])["summary"]["files"]
            .as_u64()
            .unwrap()
    };
    assert_eq!(of("data/target/figure/head/head-oval.target"), 1);
    assert!(
        of("data/target/figure/head") < of("data/target/figure")
            && of("data/target/figure") < of("data")
    );
}

#[test]
fn a_user_folder_alone_says_what_needs_the_system_data() {
    let repository = example();
    let sliders =
        fs::read_to_string(repository.path().join("data/target/figure/modelling.json")).unwrap();
    write(
        repository.path(),
        "user/contarget/figure/modelling.json",
        &sliders,
    );
    let found = report(repository.path(), &["user"]);
    let unchecked = unchecked(&found);
    assert!(
        unchecked
            .iter()
            .any(|(_, what, count)| *what == "no-system" && *count > 0),
        "{unchecked:?}"
    );
    assert!(
        unchecked
            .iter()
            .any(|(_, what, count)| *what == "no-base-mesh" && *count > 0),
        "{unchecked:?}"
    );
    assert_eq!(rules(&found), Vec::<&str>::new());
    let whole = report(repository.path(), &["."]);
    assert!(
        unchecked_of(&whole).iter().all(|what| what == "kind"),
        "{:?}",
        unchecked_of(&whole)
    );
}

fn unchecked_of(report: &Value) -> Vec<String> {
    unchecked(report)
        .into_iter()
        .map(|(_, what, _)| what.to_owned())
        .collect()
}

#[test]
fn every_report_says_what_was_not_checked() {
    let folder = tempfile::tempdir().unwrap();
    write(folder.path(), "one.target", "1 0.1 0.2 0.3\n");
    for format in [
        "human", "concise", "json", "sarif", "github", "junit", "markdown", "html",
    ] {
        let text = stdout(&mhlint(folder.path(), &[".", "--report", format])).replace('\n', " ");
        let said = if format == "json" {
            "\"no-base-mesh\""
        } else {
            "vertex numbers in 1 .target"
        };
        assert!(text.contains(said), "{format}: {text}");
    }
    // Its format has no room for it.
    let output = mhlint(folder.path(), &[".", "--report", "gitlab"]);
    assert!(
        stderr(&output).contains("vertex numbers in 1 .target"),
        "{}",
        stderr(&output)
    );
}
