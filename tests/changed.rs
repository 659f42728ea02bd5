//! `--changed-files` and `--since`: the report is narrowed to what a change can affect. On the real binary, with real git.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may stop where it fails")]

mod scratch;

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

use scratch::{assert_refused, edit, example, lose_a_step, mhlint, stderr, stdout};

fn git(folder: &Path, arguments: &[&str]) {
    let identity = ["-c", "user.name=t", "-c", "user.email=t@example.org", "-c", "commit.gpgsign=false"];
    let output = Command::new("git").current_dir(folder).args(identity).args(arguments).output().unwrap();
    assert!(output.status.success(), "git {arguments:?}: {}", String::from_utf8_lossy(&output.stderr));
}

/// The example in a git repository, with an error in `macro.json` that was there before.
fn repository() -> tempfile::TempDir {
    let repository = example();
    lose_a_step(repository.path());
    commit_all(repository.path());
    repository
}

/// Makes a git repository that holds everything.
fn commit_all(root: &Path) {
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
    mhlint(root, &[&["check", ".", "--no-eval", "--report", "concise"], more].concat())
}

#[test]
fn a_change_is_not_blamed_for_what_it_cannot_affect() {
    let repository = repository();
    let root = repository.path();
    assert_eq!(check(root, &[]).status.code(), Some(1));
    fs::write(root.join("notes.txt"), "nothing to do with the data").unwrap();
    let output = check(root, &["--since", "HEAD"]);
    assert_eq!(output.status.code(), Some(0), "{}", stdout(&output));
    assert!(
        stderr(&output).contains("narrowed to what 1 changed file can affect; 1 other finding"),
        "{}",
        stderr(&output)
    );
    let human = mhlint(root, &["check", ".", "--no-eval", "--since", "HEAD"]);
    assert!(stdout(&human).contains("Nothing found that the change can affect"), "{}", stdout(&human));
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
fn a_changed_file_is_reported_with_the_reason() {
    let repository = repository();
    let root = repository.path();
    let target = named_target(root);
    fs::write(root.join(&target), "1 nan 0 0\n").unwrap();
    let output = check(root, &["--since", "HEAD"]);
    let text = stdout(&output);
    assert!(text.contains(&format!("{target}:1:")) && text.contains("[target-non-finite]"), "{text}");
    assert!(!text.contains("macro-steps-length"), "{text}");
    let human = mhlint(root, &["check", ".", "--no-eval", "--since", "HEAD"]);
    assert!(stdout(&human).contains("shown because: the file changed"), "{}", stdout(&human));
}

#[test]
fn a_deleted_or_renamed_file_is_missed_where_it_was_named() {
    let repository = repository();
    let root = repository.path();
    let target = named_target(root);
    git(root, &["mv", &target, "data/target/figure/elsewhere.target"]);
    let output = check(root, &["--since", "HEAD"]);
    let text = stdout(&output);
    assert!(text.contains("modelling.json") && text.contains("[modelling-missing-target]"), "{text}");
    assert!(!text.contains("macro-steps-length"), "{text}");
}

#[test]
fn a_file_that_decides_over_a_base_affects_all_of_it() {
    let repository = repository();
    let root = repository.path();
    let listed = root.join("changed.txt");
    fs::write(&listed, "data/base/figure/base.json\n").unwrap();
    let output = check(root, &["--changed-files", "changed.txt"]);
    assert!(stdout(&output).contains("macro-steps-length"), "{}", stdout(&output));
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
    edit(root, "data/target/figure/macro.json", "\"name\"", "\"name\" ");
    git(root, &["commit", "-q", "-a", "-m", "theirs"]);
    git(root, &["checkout", "-q", "mine"]);
    let output = check(root, &["--since", "main"]);
    assert!(stdout(&output).contains("target-non-finite"), "{}", stdout(&output));
    assert!(!stdout(&output).contains("macro-steps-length"), "{}", stdout(&output));
}

#[test]
fn what_git_cannot_tell_is_refused_with_the_remedy() {
    let repository = repository();
    let root = repository.path();
    assert_refused(&check(root, &["--since", "nowhere"]), &["git knows no revision `nowhere`", "name a commit"]);
    assert_refused(&check(root, &["--changed-files", "nowhere.txt"]), &["nowhere.txt", "a path a line"]);
    let both = check(root, &["--since", "HEAD", "--changed-files", "x"]);
    assert_eq!(both.status.code(), Some(2));
    let outside = example();
    assert_refused(&check(outside.path(), &["--since", "HEAD"]), &["in no git repository", "--changed-files"]);
}

#[test]
fn a_shallow_clone_is_named_as_the_reason() {
    let repository = repository();
    let root = repository.path();
    git(root, &["commit", "-q", "--allow-empty", "-m", "second"]);
    let clone = tempfile::tempdir().unwrap();
    let url = format!("file://{}", root.display());
    git(clone.path(), &["clone", "-q", "--depth", "1", &url, "shallow"]);
    let output = check(&clone.path().join("shallow"), &["--since", "HEAD~1"]);
    assert_refused(&output, &["shallow clone", "fetch-depth: 0"]);
}
