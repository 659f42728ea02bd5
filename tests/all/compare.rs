//! `--since`, `--staged` and `--against`: what a change brings, and nothing else. On the real
//! binary, with real git.

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

use crate::scratch::{assert_refused, edit, example, lose_a_step, mhlint, stderr, stdout};

fn git(folder: &Path, arguments: &[&str]) {
    let output = try_git(folder, arguments);
    assert!(
        output.status.success(),
        "git {arguments:?}: {}",
        stderr(&output)
    );
}

fn try_git(folder: &Path, arguments: &[&str]) -> Output {
    let identity = [
        "-c",
        "user.name=t",
        "-c",
        "user.email=t@example.org",
        "-c",
        "commit.gpgsign=false",
    ];
    Command::new("git")
        .current_dir(folder)
        .args(identity)
        .args(arguments)
        .output()
        .unwrap()
}

/// The example in a git repository, with an error in `macro.json` that was there before.
fn repository() -> tempfile::TempDir {
    let repository = example();
    lose_a_step(repository.path());
    commit_all(repository.path());
    repository
}

/// Makes a git repository that holds everything.
pub(crate) fn commit_all(root: &Path) {
    git(root, &["init", "-q", "-b", "main"]);
    git(root, &["add", "-A"]);
    git(root, &["commit", "-q", "-m", "before the change"]);
}

/// A target that a slider of the example names, relative to the repository.
fn named_target(root: &Path) -> String {
    let modelling = fs::read_to_string(root.join("data/target/figure/modelling.json")).unwrap();
    let (_, rest) = modelling.split_once("\"incr\": \"").unwrap();
    let (name, _) = rest.split_once('"').unwrap();
    format!("data/target/figure/{name}.target")
}

fn check(root: &Path, more: &[&str]) -> Output {
    mhlint(
        root,
        &[&["check", ".", "--no-eval", "--report", "concise"], more].concat(),
    )
}

/// Gives a target a row that makes it useless.
fn ruin(root: &Path, target: &str) {
    let path = root.join(target);
    let sound = fs::read_to_string(&path).unwrap_or_default();
    fs::write(path, format!("{sound}1 nan 0 0\n")).unwrap();
}

#[track_caller]
fn assert_shown(output: &Output, code: i32, shown: &[&str], silent: &[&str]) {
    let text = stdout(output);
    assert_eq!(output.status.code(), Some(code), "{text}{}", stderr(output));
    for words in shown {
        assert!(text.contains(words), "no `{words}` in: {text}");
    }
    for words in silent {
        assert!(!text.contains(words), "`{words}` in: {text}");
    }
}

const OLD: &str = "macro-steps-length";
const OVAL: &str = "data/target/figure/head/head-oval.target";
const SIDE: &str = "data/target/figure/head/head-side-in.target";

/// The JSON report.
fn report(root: &Path, more: &[&str]) -> serde_json::Value {
    let output = mhlint(
        root,
        &[&["check", ".", "--no-eval", "--report", "json"], more].concat(),
    );
    serde_json::from_slice(&output.stdout)
        .unwrap_or_else(|error| panic!("{error}: {}", stderr(&output)))
}

#[test]
fn what_was_there_before_is_not_shown() {
    let repository = repository();
    let root = repository.path();
    assert_shown(&check(root, &[]), 1, &[OLD], &[]);
    fs::write(root.join("notes.txt"), "nothing to do with the data").unwrap();
    assert_shown(&check(root, &["--since", "HEAD"]), 0, &[], &[OLD]);
    let human = mhlint(root, &["check", ".", "--no-eval", "--since", "HEAD"]);
    assert!(
        stdout(&human).contains("no new findings, compared with `HEAD`."),
        "{}",
        stdout(&human)
    );
    assert_eq!(
        report(root, &["--since", "HEAD"])["compared"],
        serde_json::json!({"with": "HEAD", "gone": 0})
    );
    assert_eq!(report(root, &[])["compared"], serde_json::Value::Null);
}

#[test]
fn what_is_gone_is_counted() {
    let repository = repository();
    let root = repository.path();
    git(root, &["checkout", "-q", "-b", "mine"]);
    let sound = example();
    fs::copy(sound.path().join(MACROS), root.join(MACROS)).unwrap();
    let compared = &report(root, &["--since", "main"])["compared"];
    assert_eq!(*compared, serde_json::json!({"with": "main", "gone": 1}));
    let human = mhlint(root, &["check", ".", "--no-eval", "--since", "main"]);
    let said = "no new findings, compared with `main`. 1 finding no longer occurs.";
    assert!(stdout(&human).contains(said), "{}", stdout(&human));
}

#[test]
fn a_change_is_seen_from_inside_the_data_folder() {
    let repository = example();
    let root = repository.path();
    commit_all(root);
    lose_a_step(root);
    let output = check(&root.join("data"), &["--since", "HEAD"]);
    assert!(
        stdout(&output).contains("target/figure/macro.json:11:22: error[macro-steps-length]"),
        "{}",
        stdout(&output)
    );
}

#[test]
fn a_fault_in_a_changed_file_is_new() {
    let repository = repository();
    let root = repository.path();
    ruin(root, OVAL);
    assert_shown(
        &check(root, &["--since", "HEAD"]),
        1,
        &[OVAL, "[target-non-finite]"],
        &[OLD],
    );
}

#[test]
fn a_deleted_or_renamed_file_is_missed_where_it_was_named() {
    let repository = repository();
    let root = repository.path();
    let target = named_target(root);
    git(
        root,
        &["mv", &target, "data/target/figure/elsewhere.target"],
    );
    let output = check(root, &["--since", "HEAD"]);
    let text = stdout(&output);
    assert!(
        text.contains("modelling.json") && text.contains("[modelling-missing-target]"),
        "{text}"
    );
    assert!(!text.contains("macro-steps-length"), "{text}");
}

#[test]
fn the_point_where_a_branch_left_is_what_counts() {
    let repository = repository();
    let root = repository.path();
    git(root, &["checkout", "-q", "-b", "mine"]);
    let target = named_target(root);
    fs::write(root.join(&target), "1 nan 0 0\n").unwrap();
    git(root, &["commit", "-q", "-a", "-m", "mine"]);
    git(root, &["checkout", "-q", "main"]);
    edit(
        root,
        "data/target/figure/macro.json",
        "\"name\"",
        "\"name\" ",
    );
    git(root, &["commit", "-q", "-a", "-m", "theirs"]);
    git(root, &["checkout", "-q", "mine"]);
    let output = check(root, &["--since", "main"]);
    assert!(
        stdout(&output).contains("target-non-finite"),
        "{}",
        stdout(&output)
    );
    assert!(
        !stdout(&output).contains("macro-steps-length"),
        "{}",
        stdout(&output)
    );
}

#[test]
fn what_git_cannot_tell_is_refused_with_the_remedy() {
    let repository = repository();
    let root = repository.path();
    assert_refused(
        &check(root, &["--since", "nowhere"]),
        &["unknown revision `nowhere`", "use a commit"],
    );
    assert_refused(
        &check(root, &["--against", "nowhere"]),
        &["`nowhere` does not exist", "use an existing folder or zip"],
    );
    let both = check(root, &["--since", "HEAD", "--against", "data"]);
    assert_eq!(both.status.code(), Some(2));
    let several = mhlint(root, &["check", "data", "user", "--against", "data"]);
    assert_refused(
        &several,
        &[
            "`--against` compares one PATH with",
            "run mhlint once for each PATH",
        ],
    );
    assert_eq!(
        check(
            root,
            &[
                "--since",
                "HEAD",
                "--write-baseline",
                "--baseline",
                "b.json"
            ]
        )
        .status
        .code(),
        Some(2)
    );
    let outside = example();
    for option in [&["--since", "HEAD"][..], &["--staged"]] {
        assert_refused(
            &check(outside.path(), option),
            &[option[0], "is not in a git repository", "--against"],
        );
        let mut lonely = Command::new(env!("CARGO_BIN_EXE_mhlint"));
        let output = lonely
            .current_dir(root)
            .arg("check")
            .args(option)
            .env("PATH", "")
            .output()
            .unwrap();
        assert_refused(
            &output,
            &[option[0], "cannot start git", "install git", "--against"],
        );
    }
}

#[test]
fn a_shallow_clone_is_named_as_the_reason() {
    let repository = repository();
    let root = repository.path();
    git(root, &["commit", "-q", "--allow-empty", "-m", "second"]);
    let clone = tempfile::tempdir().unwrap();
    let url = format!("file://{}", root.display());
    git(
        clone.path(),
        &["clone", "-q", "--depth", "1", &url, "shallow"],
    );
    let output = check(&clone.path().join("shallow"), &["--since", "HEAD~1"]);
    assert_refused(
        &output,
        &[
            "use a commit, a tag or a branch",
            "shallow clone",
            "fetch-depth: 0",
        ],
    );
}

#[test]
fn only_what_is_staged_counts() {
    let repository = repository();
    let root = repository.path();
    ruin(root, OVAL);
    ruin(root, SIDE);
    git(root, &["add", OVAL]);
    let output = check(root, &["--staged"]);
    assert_shown(&output, 1, &[OVAL, "target-non-finite"], &[OLD, SIDE]);
    // From inside of the repository, and of a part of the data.
    let folder = root.join("data/target/figure");
    let part = mhlint(
        &folder,
        &[
            "check",
            "head",
            "--staged",
            "--no-eval",
            "--report",
            "concise",
        ],
    );
    assert_shown(
        &part,
        1,
        &["head/head-oval.target"],
        &[OLD, "head-side-in.target:"],
    );
}

/// The index is what is committed, whatever lies in the folder by now.
#[test]
fn the_staged_content_is_checked_and_not_that_of_the_folder() {
    let repository = repository();
    let root = repository.path();
    let sound = fs::read(root.join(OVAL)).unwrap();
    ruin(root, OVAL);
    git(root, &["add", OVAL]);
    fs::write(root.join(OVAL), sound).unwrap();
    fs::write(
        root.join("data/target/figure/head/untracked.target"),
        "1 nan 0 0\n",
    )
    .unwrap();
    assert_shown(
        &check(root, &["--staged"]),
        1,
        &[OVAL, "target-non-finite"],
        &[OLD, "untracked"],
    );
    assert_shown(
        &check(root, &["--since", "HEAD"]),
        1,
        &["untracked"],
        &[OLD, OVAL],
    );
}

#[test]
fn with_nothing_staged_everything_is_shown_and_that_is_said() {
    let repository = repository();
    let root = repository.path();
    ruin(root, OVAL);
    let output = check(root, &["--staged"]);
    assert_shown(&output, 1, &[OLD, OVAL], &[]);
    assert_eq!(
        stderr(&output),
        "mhlint: nothing is staged; reporting all findings\n"
    );
    assert_eq!(stderr(&check(root, &["--staged", "--quiet"])), "");
}

#[test]
fn before_the_first_commit_everything_is_shown() {
    let repository = example();
    let root = repository.path();
    ruin(root, OVAL);
    git(root, &["init", "-q", "-b", "main"]);
    git(root, &["add", OVAL]);
    let output = check(root, &["--staged"]);
    assert_shown(&output, 1, &[OVAL], &[]);
    assert_eq!(
        stderr(&output),
        "mhlint: the repository has no commits yet; reporting all findings\n"
    );
    assert_refused(
        &check(root, &["--since", "HEAD"]),
        &["unknown revision `HEAD`"],
    );
}

#[test]
fn a_staged_deletion_or_renaming_is_missed_where_the_file_was_named() {
    let repository = repository();
    let root = repository.path();
    git(root, &["rm", "-q", OVAL]);
    assert_shown(
        &check(root, &["--staged"]),
        1,
        &["[modelling-missing-target]", "head-oval"],
        &[OLD],
    );
    git(root, &["reset", "-q", "--hard"]);
    git(
        root,
        &["mv", SIDE, "data/target/figure/head/elsewhere.target"],
    );
    assert_shown(
        &check(root, &["--staged"]),
        1,
        &["[modelling-missing-target]", "head-side-in"],
        &[OLD],
    );
}

#[test]
fn a_merge_counts_with_all_that_it_brings() {
    let repository = repository();
    let root = repository.path();
    git(root, &["checkout", "-q", "-b", "theirs"]);
    ruin(root, OVAL);
    git(root, &["commit", "-q", "-a", "-m", "theirs"]);
    git(root, &["checkout", "-q", "main"]);
    ruin(root, SIDE);
    git(root, &["commit", "-q", "-a", "-m", "mine"]);
    git(root, &["merge", "-q", "--no-commit", "theirs"]);
    assert_shown(&check(root, &["--staged"]), 1, &[OVAL], &[OLD, SIDE]);
}

#[test]
fn conflicts_are_refused_until_they_are_resolved() {
    let repository = repository();
    let root = repository.path();
    for (branch, name) in [("theirs", "\"name\" "), ("mine", "\"name\"  ")] {
        git(root, &["checkout", "-q", "-b", branch, "main"]);
        edit(root, MACROS, "\"name\"", name);
        git(root, &["commit", "-q", "-a", "-m", branch]);
    }
    assert!(!try_git(root, &["merge", "-q", "theirs"]).status.success());
    assert_refused(
        &check(root, &["--staged"]),
        &["has unresolved merge conflicts", "macro.json", "git add"],
    );
    git(root, &["checkout", "-q", "--theirs", MACROS]);
    git(root, &["add", MACROS]);
    assert_shown(&check(root, &["--staged"]), 0, &[], &[OLD]);
}

/// Git hands its hooks the index of the commit by variables, which may be relative.
#[cfg(unix)]
#[test]
fn a_hook_checks_the_commit_that_is_made() {
    use std::os::unix::fs::PermissionsExt;
    let repository = repository();
    let root = repository.path();
    let hook = root.join(".git/hooks/pre-commit");
    let binary = env!("CARGO_BIN_EXE_mhlint");
    fs::write(
        &hook,
        format!("#!/bin/sh\nexec '{binary}' data --staged --no-eval --report concise 2>&1 >&2\n"),
    )
    .unwrap();
    fs::set_permissions(&hook, fs::Permissions::from_mode(0o755)).unwrap();
    let below = root.join("data/target");
    let refused = |folder: &Path, arguments: &[&str], shown: &str| {
        let output = try_git(folder, arguments);
        let said = stderr(&output);
        assert_eq!(output.status.code(), Some(1), "{arguments:?}: {said}");
        assert!(
            said.contains(&format!("{shown}:")) && !said.contains(OLD),
            "{arguments:?}: {said}"
        );
        said
    };
    ruin(root, OVAL);
    ruin(root, SIDE);
    let said = refused(
        &below,
        &["commit", "-m", "one", "--", "figure/head/head-oval.target"],
        OVAL,
    );
    assert!(!said.contains(SIDE), "{said}");
    let said = refused(&below, &["commit", "-a", "-m", "all"], OVAL);
    assert!(said.contains(SIDE), "{said}");
    git(root, &["add", SIDE]);
    let said = refused(&below, &["commit", "-m", "staged"], SIDE);
    assert!(!said.contains(OVAL), "{said}");
    fs::write(root.join("notes.txt"), "nothing to do with the data").unwrap();
    git(root, &["add", "notes.txt"]);
    git(
        &below,
        &["commit", "-q", "-m", "notes", "--", "../../notes.txt"],
    );
    // In a second working tree git also hands over the folder of the repository.
    let second = tempfile::tempdir().unwrap();
    let tree = second.path().join("tree");
    git(
        root,
        &[
            "worktree",
            "add",
            "-q",
            "-b",
            "second",
            tree.to_str().unwrap(),
        ],
    );
    ruin(&tree, OVAL);
    let said = refused(&tree.join("data"), &["commit", "-a", "-m", "there"], OVAL);
    assert!(!said.contains(SIDE), "{said}");
}

#[cfg(target_os = "linux")]
#[test]
fn names_may_hold_anything() {
    use std::os::unix::ffi::OsStrExt;
    let repository = repository();
    let root = repository.path();
    let folder = root.join("data/target/figure/head");
    let names: [&[u8]; 4] = [
        b"a b.target",
        b"'c\".target",
        b"d\\e.target",
        b"f\xff.target",
    ];
    for name in names {
        fs::write(
            folder.join(std::ffi::OsStr::from_bytes(name)),
            "1 nan 0 0\n",
        )
        .unwrap();
    }
    git(root, &["add", "-A"]);
    let shown: Vec<String> = names
        .iter()
        .map(|name| {
            format!(
                "head/{}:1:1: error[target-non-finite]",
                String::from_utf8_lossy(name)
            )
        })
        .collect();
    let shown: Vec<&str> = shown.iter().map(String::as_str).collect();
    for option in [&["--staged"][..], &["--since", "HEAD"]] {
        assert_shown(&check(root, option), 1, &shown, &[OLD]);
    }
}

#[cfg(unix)]
#[test]
fn a_link_is_checked_under_its_own_name() {
    let repository = repository();
    let root = repository.path();
    ruin(root, OVAL);
    git(root, &["commit", "-q", "-a", "-m", "an old fault"]);
    std::os::unix::fs::symlink(
        "head-oval.target",
        root.join("data/target/figure/head/link.target"),
    )
    .unwrap();
    git(root, &["add", "-A"]);
    assert_shown(
        &check(root, &["--staged"]),
        1,
        &["head/link.target:", "target-non-finite"],
        &[OLD],
    );
}

#[cfg(unix)]
#[test]
fn what_is_gone_from_a_folder_is_missed_behind_a_link_to_it() {
    let repository = repository();
    let root = repository.path();
    fs::create_dir(root.join("shared")).unwrap();
    fs::rename(root.join(OVAL), root.join("shared/a.target")).unwrap();
    fs::copy(root.join(SIDE), root.join("shared/b.target")).unwrap();
    std::os::unix::fs::symlink("../../../shared", root.join("data/target/figure/extra")).unwrap();
    edit(
        root,
        "data/target/figure/modelling.json",
        "head/head-oval",
        "extra/a",
    );
    git(root, &["add", "-A"]);
    git(root, &["commit", "-q", "-m", "a folder behind a link"]);
    fs::remove_file(root.join("shared/a.target")).unwrap();
    assert_shown(
        &check(root, &["--since", "HEAD"]),
        1,
        &["[modelling-missing-target]", "extra/a"],
        &[OLD],
    );
}

#[test]
fn the_later_of_staged_and_another_option_wins() {
    let repository = repository();
    let root = repository.path();
    ruin(root, OVAL);
    ruin(root, SIDE);
    git(root, &["add", OVAL]);
    assert_shown(
        &check(root, &["--staged", "--since", "HEAD"]),
        1,
        &[OVAL, SIDE],
        &[OLD],
    );
    assert_shown(
        &check(root, &["--since", "HEAD", "--staged"]),
        1,
        &[OVAL],
        &[OLD, SIDE],
    );
}

/// Gives targets a row that says nothing.
fn add_zero_row(root: &Path, targets: &[&str]) {
    for target in targets {
        let sound = fs::read_to_string(root.join(target)).unwrap();
        fs::write(root.join(target), format!("{sound}5 0 0 0\n")).unwrap();
    }
}

const MACROS: &str = "data/target/figure/macro.json";
const EMPTY: &str = "data/target/figure/macro_build/teen-maxmuscle.target";

/// What git says has changed in the working tree.
fn written(root: &Path) -> Vec<String> {
    let output = try_git(root, &["status", "--porcelain"]);
    stdout(&output)
        .lines()
        .map(|line| line.split_at(3).1.to_owned())
        .collect()
}

#[test]
fn a_fix_writes_changed_files_only() {
    let repository = repository();
    let root = repository.path();
    add_zero_row(
        root,
        &[OVAL, "data/target/figure/legs/l-foot-trans-forward.target"],
    );
    git(root, &["commit", "-q", "-a", "-m", "what can be fixed"]);
    add_zero_row(root, &[SIDE]);
    let output = check(root, &["--since", "HEAD", "--fix"]);
    assert_eq!(written(root), [""; 0], "{}", stderr(&output));
    assert!(
        stderr(&output).contains("1 fixed in 1 file: target-zero-delta (1)"),
        "{}",
        stderr(&output)
    );
    assert_shown(&output, 0, &[], &["target-zero-delta"]);
}

#[test]
fn what_belongs_together_is_not_fixed_by_halves() {
    let repository = repository();
    let root = repository.path();
    fs::write(root.join(EMPTY), "0 0 0 0\n").unwrap();
    let fix = [
        "--since",
        "HEAD",
        "--fix",
        "--unsafe-fixes",
        "--only",
        "macro-empty-target",
    ];
    let output = check(root, &fix);
    assert_eq!(written(root), [EMPTY]);
    assert_shown(&output, 0, &["macro-empty-target"], &[]);
    let said = "1 fixable finding not fixed: the fix is for files that have not changed; \
        to fix all, run without `--since`";
    assert!(stderr(&output).contains(said), "{}", stderr(&output));
    // With macro.json in the change the fix is whole.
    edit(root, MACROS, "\"name\"", "\"name\" ");
    assert_shown(&check(root, &fix), 0, &[], &["macro-empty-target"]);
    assert!(!root.join(EMPTY).exists());
}

#[test]
fn a_fix_leaves_alone_what_is_staged_otherwise() {
    let repository = repository();
    let root = repository.path();
    add_zero_row(root, &[OVAL, SIDE]);
    git(root, &["add", OVAL, SIDE]);
    let later = fs::read_to_string(root.join(SIDE)).unwrap() + "# later\n";
    fs::write(root.join(SIDE), &later).unwrap();
    let output = check(root, &["--staged", "--fix"]);
    assert!(
        !fs::read_to_string(root.join(OVAL))
            .unwrap()
            .contains("5 0 0 0"),
        "{}",
        stderr(&output)
    );
    assert_eq!(fs::read_to_string(root.join(SIDE)).unwrap(), later);
    let said = stderr(&output);
    assert!(
        said.contains("differ from their staged versions: ")
            && said.contains("head-side-in.target"),
        "{said}"
    );
}

/// A finding that speaks for several files shows what is new of it, where that is.
#[test]
fn of_a_group_only_the_new_part_is_shown_at_its_file() {
    let repository = repository();
    let root = repository.path();
    add_zero_row(root, &[OVAL]);
    git(
        root,
        &["commit", "-q", "-a", "-m", "a row that says nothing"],
    );
    add_zero_row(root, &[SIDE]);
    let only = ["--since", "HEAD", "--only", "target-zero-delta"];
    assert_shown(
        &check(root, &only),
        0,
        &[&format!("{SIDE}:"), "1 of these 2 is new"],
        &[OVAL],
    );
    let row = fs::read_to_string(root.join(SIDE)).unwrap();
    let ignored = format!("# mhlint: ignore target-zero-delta on purpose\n{row}");
    fs::write(root.join(SIDE), ignored).unwrap();
    assert_shown(&check(root, &only), 0, &["0 infos"], &["target-zero-delta"]);
}

/// A comment that ignored a part of a group, and goes, brings that part.
#[test]
fn a_part_of_a_group_that_is_ignored_no_more_is_new() {
    let repository = repository();
    let root = repository.path();
    add_zero_row(root, &[OVAL, SIDE]);
    let comment = "# mhlint: ignore target-zero-delta on purpose\n";
    let plain = fs::read_to_string(root.join(SIDE)).unwrap();
    fs::write(root.join(SIDE), format!("{comment}{plain}")).unwrap();
    git(root, &["commit", "-q", "-a", "-m", "rows that say nothing"]);
    let only = ["--since", "HEAD", "--only", "target-zero-delta"];
    assert_shown(&check(root, &only), 0, &["0 infos"], &["target-zero-delta"]);
    fs::write(root.join(SIDE), plain).unwrap();
    assert_shown(
        &check(root, &only),
        0,
        &[&format!("{SIDE}:"), "1 of these 2 is new"],
        &[OVAL],
    );
}

/// What several files have between them is told at the new one, with the others beside it.
#[test]
fn another_copy_is_shown_at_its_own_file() {
    let repository = repository();
    let root = repository.path();
    let picture = |name: &str| {
        let path = root.join("data/skins/figure").join(name);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, [7; 4096]).unwrap();
    };
    ["a.png", "b.png"].into_iter().for_each(picture);
    git(root, &["add", "-A"]);
    git(root, &["commit", "-q", "-m", "a picture twice"]);
    picture("c.png");
    let only = ["--since", "HEAD", "--only", "file-duplicate-content"];
    assert_shown(
        &check(root, &only),
        0,
        &[
            "data/skins/figure/c.png: info",
            "3 files have the same picture",
        ],
        &[],
    );
    let findings = &report(root, &only)["findings"];
    let related = findings[0]["related"]
        .as_array()
        .unwrap()
        .iter()
        .map(|one| one["path"].as_str().unwrap());
    assert_eq!(
        related.collect::<Vec<_>>(),
        ["data/skins/figure/b.png", "data/skins/figure/a.png"]
    );
}

#[test]
fn a_worktree_has_its_own_folder_and_index() {
    let repository = repository();
    let root = repository.path();
    let beside = tempfile::tempdir().unwrap();
    let other = beside.path().join("other");
    git(
        root,
        &[
            "worktree",
            "add",
            "-q",
            "-b",
            "mine",
            other.to_str().unwrap(),
        ],
    );
    ruin(&other, OVAL);
    assert_shown(&check(root, &["--since", "main"]), 0, &[], &[OVAL, OLD]);
    assert_shown(&check(&other, &["--since", "main"]), 1, &[OVAL], &[OLD]);
    git(&other, &["add", "-A"]);
    assert_shown(&check(&other, &["--staged"]), 1, &[OVAL], &[OLD]);
    let from_outside = mhlint(
        root,
        &[
            "check",
            other.to_str().unwrap(),
            "--no-eval",
            "--since",
            "main",
        ],
    );
    assert!(
        stdout(&from_outside).contains("target-non-finite"),
        "{}",
        stdout(&from_outside)
    );
}

#[test]
fn a_submodule_counts_with_all_that_is_in_it() {
    let above = tempfile::tempdir().unwrap();
    let module = example();
    commit_all(&module.path().join("data"));
    let root = above.path();
    git(root, &["init", "-q", "-b", "main"]);
    let url = module.path().join("data");
    git(
        root,
        &[
            "-c",
            "protocol.file.allow=always",
            "submodule",
            "--quiet",
            "add",
            url.to_str().unwrap(),
            "data",
        ],
    );
    git(root, &["commit", "-q", "-m", "before the change"]);
    lose_a_step(root);
    git(&root.join("data"), &["commit", "-qam", "a step less"]);
    git(root, &["add", "data"]);
    assert_shown(
        &check(root, &["--staged"]),
        1,
        &["[macro-steps-length]"],
        &[],
    );
    // Inside of the submodule nothing differs from its HEAD; around it the commit does.
    let output = mhlint(
        root,
        &[
            "check",
            "data",
            "--no-eval",
            "--report",
            "concise",
            "--since",
            "HEAD",
        ],
    );
    assert_shown(&output, 1, &["[macro-steps-length]"], &[]);
}

/// Of data behind a link that led elsewhere nothing is known as it was: all of it is shown, and
/// that is said.
#[cfg(unix)]
#[test]
fn what_a_changed_link_to_a_folder_brings_is_not_compared() {
    let repository = example();
    let root = repository.path();
    let lead = |to: &str| {
        let link = root.join("data");
        if link.is_symlink() {
            fs::remove_file(&link).unwrap();
        }
        std::os::unix::fs::symlink(to, link).unwrap();
    };
    fs::rename(root.join("data"), root.join("v2")).unwrap();
    crate::scratch::copy_folder(&root.join("v2"), &root.join("v1"));
    lead("v2");
    lose_a_step(root);
    lead("v1");
    commit_all(root);
    lead("v2");
    let not_checked = &report(root, &["--since", "HEAD"])["not_checked"];
    assert!(
        not_checked.to_string().contains("not-compared"),
        "{not_checked}"
    );
    assert_shown(
        &check(root, &["--since", "HEAD"]),
        1,
        &["[macro-steps-length]"],
        &[],
    );
}

#[test]
fn a_loose_target_that_is_gone_is_missed_by_its_partner() {
    let repository = example();
    let root = repository.path();
    fs::create_dir_all(root.join("pack/feet")).unwrap();
    for side in ["l", "r"] {
        fs::write(
            root.join(format!("pack/feet/{side}-foot-big-incr.target")),
            "337 .1 0 0\n",
        )
        .unwrap();
        fs::write(
            root.join(format!("pack/feet/{side}-foot-big-decr.target")),
            "337 -.1 0 0\n",
        )
        .unwrap();
    }
    commit_all(root);
    git(root, &["rm", "-q", "pack/feet/r-foot-big-incr.target"]);
    let check = |more: &[&str]| {
        let args = [
            "check",
            "pack",
            "--system",
            "data",
            "--no-eval",
            "--report",
            "concise",
        ];
        mhlint(root, &[&args, more].concat())
    };
    assert_shown(
        &check(&[]),
        0,
        &["[target-missing-side]", "[target-missing-opposite]"],
        &[],
    );
    assert_shown(
        &check(&["--staged"]),
        0,
        &["[target-missing-side]", "[target-missing-opposite]"],
        &[],
    );
}

#[test]
fn line_ends_that_git_makes_are_no_change() {
    let repository = repository();
    let root = repository.path();
    git(root, &["config", "core.autocrlf", "true"]);
    git(root, &["rm", "-q", "-r", "--cached", "."]);
    git(root, &["reset", "-q", "--hard"]);
    assert!(
        fs::read_to_string(root.join(OVAL))
            .unwrap()
            .contains("\r\n")
    );
    ruin(root, OVAL);
    assert_shown(&check(root, &["--since", "HEAD"]), 1, &[OVAL], &[OLD]);
    assert_eq!(
        report(root, &["--since", "HEAD"])["findings"]
            .as_array()
            .unwrap()
            .len(),
        1
    );
}

/// Of a content that was not fetched nothing is known: it is no old finding, and what is there now
/// is shown.
#[test]
fn a_pointer_in_the_object_is_not_compared() {
    let repository = repository();
    let root = repository.path();
    let content = fs::read_to_string(root.join(OVAL)).unwrap();
    let pointer = format!(
        "version https://git-lfs.github.com/spec/v1\noid sha256:{}\nsize 9\n",
        "ab".repeat(32)
    );
    fs::write(root.join(OVAL), &pointer).unwrap();
    git(root, &["commit", "-q", "-a", "-m", "a pointer"]);
    fs::write(root.join(OVAL), format!("{content}1 nan 0 0\n")).unwrap();
    let report_of = report(root, &["--since", "HEAD"]);
    assert_eq!(
        report_of["findings"].as_array().unwrap().len(),
        1,
        "{report_of}"
    );
    assert_eq!(report_of["not_checked"][0]["what"], "not-compared");
    assert_eq!(report_of["not_checked"][0]["examples"][0], OVAL);
    // What was fetched once lies beside the objects.
    let objects = root.join(format!(".git/lfs/objects/ab/ab/{}", "ab".repeat(32)));
    fs::create_dir_all(objects.parent().unwrap()).unwrap();
    fs::write(objects, content).unwrap();
    assert_shown(
        &check(root, &["--since", "HEAD"]),
        1,
        &[OVAL, "target-non-finite"],
        &["lfs"],
    );
}

#[test]
fn changed_settings_are_said_and_count_for_both_sides() {
    let repository = repository();
    let root = repository.path();
    fs::write(
        root.join("mhlint.toml"),
        "[level]\n\"macro-*\" = \"warning\"\n",
    )
    .unwrap();
    git(root, &["add", "-A"]);
    let output = mhlint(root, &["check", ".", "--no-eval", "--since", "HEAD"]);
    let text = stdout(&output);
    assert!(
        text.contains("`mhlint.toml` changed; both sides were checked with it")
            && !text.contains(OLD),
        "{text}"
    );
}

#[test]
fn two_folders_are_compared() {
    let repository = repository();
    let root = repository.path();
    let other = example();
    let before = other.path().to_str().unwrap();
    assert_shown(&check(root, &["--against", before]), 1, &[OLD], &[]);
    assert_shown(
        &mhlint(
            root,
            &[
                "check",
                "data",
                "--no-eval",
                "--report",
                "concise",
                "--against",
                &format!("{before}/data"),
            ],
        ),
        1,
        &[OLD],
        &[],
    );
    ruin(other.path(), OVAL);
    lose_a_step(other.path());
    assert_shown(&check(root, &["--against", before]), 0, &[], &[OLD, OVAL]);
    assert_eq!(report(root, &["--against", before])["compared"]["gone"], 1);
}

#[test]
fn paths_of_two_repositories_are_refused() {
    let (one, other) = (repository(), repository());
    let args = ["check", "data", other.path().to_str().unwrap(), "--no-eval"];
    for option in [&["--since", "HEAD"][..], &["--staged"]] {
        let output = mhlint(one.path(), &[&args[..], option].concat());
        assert_refused(
            &output,
            &[
                "and `data` are in different repositories",
                "run mhlint once for each",
            ],
        );
    }
}

/// Git lists a repository that lies in another one without being a part of it as one folder.
#[test]
fn a_repository_inside_of_another_one_is_new_as_a_whole() {
    let repository = example();
    let root = repository.path();
    commit_all(root);
    let inner = example();
    lose_a_step(inner.path());
    crate::scratch::copy_folder(inner.path(), &root.join("nested"));
    commit_all(&root.join("nested"));
    assert_shown(
        &check(root, &["--since", "HEAD"]),
        1,
        &["nested/data/", OLD],
        &[],
    );
}

#[test]
fn a_file_that_git_ignores_is_no_part_of_a_commit() {
    let repository = repository();
    let root = repository.path();
    fs::write(root.join(".gitignore"), "build-*\n").unwrap();
    let built = "data/target/figure/head/build-oval.target";
    fs::rename(root.join(OVAL), root.join(built)).unwrap();
    edit(
        root,
        "data/target/figure/modelling.json",
        "head/head-oval",
        "head/build-oval",
    );
    git(root, &["add", "-A"]);
    assert_shown(
        &check(root, &["--staged"]),
        1,
        &["[modelling-missing-target]"],
        &[OLD],
    );
    assert_shown(
        &check(root, &["--since", "HEAD"]),
        0,
        &[],
        &["[modelling-missing-target]"],
    );
}
