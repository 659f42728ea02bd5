//! `--staged`, `--since` and `--changed-files`: the report is narrowed to what a change can affect. On the real binary,
//! with real git.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may stop where it fails")]

mod scratch;

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

use scratch::{assert_refused, edit, example, lose_a_step, mhlint, stderr, stdout};

fn git(folder: &Path, arguments: &[&str]) {
    let output = try_git(folder, arguments);
    assert!(output.status.success(), "git {arguments:?}: {}", stderr(&output));
}

fn try_git(folder: &Path, arguments: &[&str]) -> Output {
    let identity = ["-c", "user.name=t", "-c", "user.email=t@example.org", "-c", "commit.gpgsign=false"];
    Command::new("git").current_dir(folder).args(identity).args(arguments).output().unwrap()
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
    for option in [&["--since", "HEAD"][..], &["--staged"]] {
        assert_refused(&check(outside.path(), option), &[option[0], "in no git repository", "--changed-files"]);
        let mut lonely = Command::new(env!("CARGO_BIN_EXE_mhlint"));
        let output = lonely.current_dir(root).arg("check").args(option).env("PATH", "").output().unwrap();
        assert_refused(&output, &[option[0], "git cannot be started", "install git", "--changed-files"]);
    }
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
    assert_refused(&output, &["name a commit, a tag or a branch", "shallow clone", "fetch-depth: 0"]);
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

#[test]
fn only_what_is_staged_counts() {
    let repository = repository();
    let root = repository.path();
    ruin(root, OVAL);
    ruin(root, SIDE);
    git(root, &["add", OVAL]);
    let output = check(root, &["--staged"]);
    assert_shown(&output, 1, &[OVAL, "target-non-finite"], &[OLD, SIDE]);
    assert!(stderr(&output).contains("narrowed to what 1 changed file can affect; 2 other findings"));
    // From inside of the repository, and of a part of the data.
    let folder = root.join("data/target/figure");
    let part = mhlint(&folder, &["check", "head", "--staged", "--no-eval", "--report", "concise"]);
    assert_shown(&part, 1, &["head/head-oval.target"], &[OLD, "head-side-in.target:"]);
}

#[test]
fn with_nothing_staged_everything_is_shown_and_that_is_said() {
    let repository = repository();
    let root = repository.path();
    ruin(root, OVAL);
    let output = check(root, &["--staged"]);
    assert_shown(&output, 1, &[OLD, OVAL], &[]);
    assert_eq!(stderr(&output), "mhlint: nothing is staged: the whole report\n");
    assert_eq!(stderr(&check(root, &["--staged", "--quiet"])), "");
}

#[test]
fn before_the_first_commit_everything_staged_is_new() {
    let repository = example();
    let root = repository.path();
    ruin(root, OVAL);
    ruin(root, SIDE);
    git(root, &["init", "-q", "-b", "main"]);
    assert_shown(&check(root, &["--staged"]), 1, &[OVAL, SIDE], &[]);
    git(root, &["add", OVAL]);
    assert_shown(&check(root, &["--staged"]), 1, &[OVAL], &[SIDE]);
}

#[test]
fn a_staged_deletion_or_renaming_is_missed_where_the_file_was_named() {
    let repository = repository();
    let root = repository.path();
    git(root, &["rm", "-q", OVAL]);
    assert_shown(&check(root, &["--staged"]), 1, &["[modelling-missing-target]", "head-oval"], &[OLD]);
    git(root, &["reset", "-q", "--hard"]);
    git(root, &["mv", SIDE, "data/target/figure/head/elsewhere.target"]);
    assert_shown(&check(root, &["--staged"]), 1, &["[modelling-missing-target]", "head-side-in"], &[OLD]);
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

/// Git hands its hooks the index of the commit by variables, which may be relative.
#[cfg(unix)]
#[test]
fn a_hook_checks_the_commit_that_is_made() {
    use std::os::unix::fs::PermissionsExt;
    let repository = repository();
    let root = repository.path();
    let hook = root.join(".git/hooks/pre-commit");
    let binary = env!("CARGO_BIN_EXE_mhlint");
    fs::write(&hook, format!("#!/bin/sh\nexec '{binary}' data --staged --no-eval --report concise 2>&1 >&2\n"))
        .unwrap();
    fs::set_permissions(&hook, fs::Permissions::from_mode(0o755)).unwrap();
    let below = root.join("data/target");
    let refused = |folder: &Path, arguments: &[&str], shown: &str| {
        let output = try_git(folder, arguments);
        let said = stderr(&output);
        assert_eq!(output.status.code(), Some(1), "{arguments:?}: {said}");
        assert!(said.contains(&format!("{shown}:")) && !said.contains(OLD), "{arguments:?}: {said}");
        said
    };
    ruin(root, OVAL);
    ruin(root, SIDE);
    let said = refused(&below, &["commit", "-m", "one", "--", "figure/head/head-oval.target"], OVAL);
    assert!(!said.contains(SIDE), "{said}");
    let said = refused(&below, &["commit", "-a", "-m", "all"], OVAL);
    assert!(said.contains(SIDE), "{said}");
    git(root, &["add", SIDE]);
    let said = refused(&below, &["commit", "-m", "staged"], SIDE);
    assert!(!said.contains(OVAL), "{said}");
    fs::write(root.join("notes.txt"), "nothing to do with the data").unwrap();
    git(root, &["add", "notes.txt"]);
    git(&below, &["commit", "-q", "-m", "notes", "--", "../../notes.txt"]);
    // In a second working tree git also hands over the folder of the repository.
    let second = tempfile::tempdir().unwrap();
    let tree = second.path().join("tree");
    git(root, &["worktree", "add", "-q", "-b", "second", tree.to_str().unwrap()]);
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
    let names: [&[u8]; 4] = [b"a b.target", b"'c\".target", b"d\\e.target", b"f\xff.target"];
    for name in names {
        fs::write(folder.join(std::ffi::OsStr::from_bytes(name)), "1 nan 0 0\n").unwrap();
    }
    git(root, &["add", "-A"]);
    let shown: Vec<String> = names
        .iter()
        .map(|name| format!("head/{}:1:1: error[target-non-finite]", String::from_utf8_lossy(name)))
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
    std::os::unix::fs::symlink("head-oval.target", root.join("data/target/figure/head/link.target")).unwrap();
    git(root, &["add", "-A"]);
    assert_shown(&check(root, &["--staged"]), 1, &["head/link.target:", "target-non-finite"], &[OLD]);
}

#[test]
fn the_later_of_staged_and_another_option_wins() {
    let repository = repository();
    let root = repository.path();
    ruin(root, OVAL);
    ruin(root, SIDE);
    git(root, &["add", OVAL]);
    fs::write(root.join("changed.txt"), format!("{SIDE}\n")).unwrap();
    assert_shown(&check(root, &["--staged", "--since", "HEAD"]), 1, &[OVAL, SIDE], &[OLD]);
    assert_shown(&check(root, &["--since", "HEAD", "--staged"]), 1, &[OVAL], &[OLD, SIDE]);
    assert_shown(&check(root, &["--staged", "--changed-files", "changed.txt"]), 1, &[SIDE], &[OLD, OVAL]);
}

/// Three targets with zero rows, one finding at the first of them, and a macro target that moves nothing.
fn fixable(root: &Path) {
    for target in [OVAL, SIDE, "data/target/figure/legs/l-foot-trans-forward.target"] {
        let sound = fs::read_to_string(root.join(target)).unwrap();
        fs::write(root.join(target), format!("{sound}5 0 0 0\n")).unwrap();
    }
    fs::write(root.join(EMPTY), "0 0 0 0\n").unwrap();
    git(root, &["commit", "-q", "-a", "-m", "what can be mended"]);
}

const EMPTY: &str = "data/target/figure/macro_build/teen-maxmuscle.target";

/// What git says has changed in the working tree.
fn written(root: &Path) -> Vec<String> {
    let output = try_git(root, &["status", "--porcelain"]);
    stdout(&output).lines().map(|line| line.split_at(3).1.to_owned()).collect()
}

#[test]
fn a_narrowed_fix_writes_changed_files_only() {
    let repository = repository();
    let root = repository.path();
    fixable(root);
    let sound = fs::read_to_string(root.join(SIDE)).unwrap();
    fs::write(root.join(SIDE), sound.replacen("5 0 0 0", "5 0 0 0.0", 1)).unwrap();
    let output = check(root, &["--since", "HEAD", "--fix"]);
    assert_eq!(written(root), [SIDE]);
    assert!(!fs::read_to_string(root.join(SIDE)).unwrap().contains("5 0 0 0"));
    assert!(stderr(&output).contains("1 fixed in 1 file: target-zero-delta (1)"), "{}", stderr(&output));
    // The rest of the finding is a matter of the other files, and shown no more.
    assert_shown(&output, 0, &[], &["target-zero-delta"]);
}

#[test]
fn what_belongs_together_is_not_fixed_by_halves() {
    let repository = repository();
    let root = repository.path();
    fixable(root);
    fs::write(root.join(EMPTY), "0 0 0 0\n1 0 0 0\n").unwrap();
    let fix = ["--since", "HEAD", "--fix", "--unsafe-fixes", "--only", "macro-empty-target"];
    let output = check(root, &fix);
    assert_eq!(written(root), [EMPTY]);
    assert_shown(&output, 0, &["macro-empty-target"], &[]);
    let said = "1 finding would be mended in files that have not changed; those stay as they are; \
        run without --since to mend them";
    assert!(stderr(&output).contains(said), "{}", stderr(&output));
    // With macro.json in the change the fix is whole.
    edit(root, "data/target/figure/macro.json", "\"name\"", "\"name\" ");
    assert_shown(&check(root, &fix), 0, &[], &["macro-empty-target"]);
    assert!(!root.join(EMPTY).exists());
}

#[test]
fn a_list_that_cannot_be_meant_is_no_pass() {
    let repository = repository();
    let root = repository.path();
    let shown = |folder: &Path, list: &str, said: &str| {
        fs::write(root.join("list"), list).unwrap();
        let list = root.join("list");
        let output = check(folder, &["--changed-files", list.to_str().unwrap()]);
        assert_shown(&output, 1, &[OLD], &[]);
        assert!(
            stderr(&output).contains(said) && stderr(&output).contains(": the whole report"),
            "{}",
            stderr(&output)
        );
        assert_eq!(stderr(&check(folder, &["--quiet", "--changed-files", list.to_str().unwrap()])), "");
    };
    shown(root, "", "--changed-files lists no file");
    shown(root, "elsewhere/a\nelsewhere/b\n", "`elsewhere/a` is not here, nor is any other of the 2 listed files");
    // What git lists from the top of the repository, whatever folder it is asked in.
    let data = root.join("data");
    let inside = format!("`{OVAL}` is not here, but in `..`; list paths relative to where mhlint runs");
    shown(&data, &format!("README.md\n{OVAL}\n"), &inside);
    fs::remove_file(root.join(OVAL)).unwrap();
    shown(&data, &format!("{OVAL}\n"), &inside);
}

#[test]
fn a_list_of_deleted_files_and_files_beside_the_data_narrows() {
    let repository = repository();
    let root = repository.path();
    fs::remove_dir_all(root.join("data/target/figure/head")).unwrap();
    fs::write(root.join("notes.txt"), "").unwrap();
    for list in [format!("{OVAL}\nnotes.txt\n"), "notes.txt\ndocs/gone.md\n".to_owned(), "gone.txt\n".to_owned()] {
        fs::write(root.join("list"), &list).unwrap();
        let output = check(root, &["--changed-files", "list"]);
        assert!(
            stderr(&output).contains("narrowed to what") && !stdout(&output).contains(OLD),
            "{list}: {}",
            stdout(&output)
        );
    }
    fs::write(root.join("list"), format!("../{OVAL}\n")).unwrap();
    let output = check(&root.join("user"), &["--changed-files", "../list"]);
    assert!(stderr(&output).contains("narrowed to what"), "{}", stderr(&output));
}

#[cfg(target_os = "linux")]
#[test]
fn a_backslash_in_the_name_of_a_folder_is_no_separator() {
    let repository = example();
    let root = repository.path();
    fs::create_dir(root.join("k\\b")).unwrap();
    fs::rename(root.join("data"), root.join("k\\b/data")).unwrap();
    let target = format!("k\\b/{OVAL}");
    fs::write(root.join(&target), "1 nan 0 0\n").unwrap();
    fs::write(root.join("list"), format!("{target}\n")).unwrap();
    let report = ["--no-eval", "--report", "concise"];
    let narrowed = mhlint(root, &[&["k\\b/data", "--changed-files", "list"], &report[..]].concat());
    assert_shown(&narrowed, 1, &[&format!("{target}:1:1: error[target-non-finite]")], &[]);
    let part = mhlint(root, &[&[target.as_str()], &report[..]].concat());
    assert_shown(&part, 1, &["target-non-finite", "in 86 files"], &["(loose)"]);
    fs::write(root.join("k\\b/mhlint.toml"), "[[path]]\nglob = \"data\"\nskip = [\"target-*\"]\n").unwrap();
    let skipped = mhlint(root, &[&["k\\b/data"], &report[..]].concat());
    assert_shown(&skipped, 0, &[], &["target-non-finite"]);
}

/// Of a submodule or a link git lists the folder alone.
#[test]
fn a_folder_that_changed_as_a_whole_counts_with_all_that_is_in_it() {
    let repository = repository();
    let root = repository.path();
    for listed in ["data", ".", "data/", "data/target", "data/target/figure"] {
        fs::write(root.join("list"), listed).unwrap();
        let output = check(root, &["--changed-files", "list"]);
        assert_shown(&output, 1, &["[macro-steps-length]"], &[]);
    }
    fs::write(root.join("list"), "data/target/figure/head").unwrap();
    assert_shown(&check(root, &["--changed-files", "list"]), 0, &[], &["[macro-steps-length]"]);
}

#[test]
fn a_submodule_counts_with_all_that_is_in_it() {
    let above = tempfile::tempdir().unwrap();
    let module = example();
    commit_all(&module.path().join("data"));
    let root = above.path();
    git(root, &["init", "-q", "-b", "main"]);
    let url = module.path().join("data");
    git(root, &["-c", "protocol.file.allow=always", "submodule", "--quiet", "add", url.to_str().unwrap(), "data"]);
    git(root, &["commit", "-q", "-m", "before the change"]);
    lose_a_step(root);
    git(&root.join("data"), &["commit", "-qam", "a step less"]);
    git(root, &["add", "data"]);
    assert_shown(&check(root, &["--staged"]), 1, &["[macro-steps-length]"], &[]);
    // Inside of the submodule nothing differs from its HEAD; around it the commit does.
    let output = mhlint(root, &["check", "data", "--no-eval", "--report", "concise", "--since", "HEAD"]);
    assert_shown(&output, 1, &["[macro-steps-length]"], &[]);
}

#[cfg(unix)]
#[test]
fn a_link_that_leads_elsewhere_counts_with_all_that_is_there() {
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
    scratch::copy_folder(&root.join("v2"), &root.join("v1"));
    lead("v2");
    lose_a_step(root);
    lead("v1");
    commit_all(root);
    lead("v2");
    let output = mhlint(root, &["check", "data", "--no-eval", "--report", "concise", "--since", "HEAD"]);
    assert_shown(&output, 1, &["[macro-steps-length]"], &[]);
}

#[test]
fn settings_in_a_folder_that_changed_as_a_whole_count() {
    let repository = repository();
    let root = repository.path();
    fs::create_dir(root.join("shared")).unwrap();
    fs::write(root.join("shared/mhlint.toml"), "").unwrap();
    fs::write(root.join("list"), "shared").unwrap();
    let output = check(root, &["--config", "shared/mhlint.toml", "--changed-files", "list"]);
    assert_shown(&output, 1, &["[macro-steps-length]"], &[]);
    assert!(stderr(&output).contains("the change touches the configuration"), "{}", stderr(&output));
}

#[test]
fn what_decides_which_data_lie_over_which_affects_all() {
    let repository = example();
    let root = repository.path();
    commit_all(root);
    let all = || mhlint(root, &["check", ".", "--no-eval", "--report", "concise"]);
    git(root, &["rm", "-rq", "user/contarget"]);
    assert_eq!(stdout(&check(root, &["--staged"])), stdout(&all()));
}

#[test]
fn a_list_in_utf_16_is_refused() {
    let repository = repository();
    let root = repository.path();
    let wide = |text: &str| text.encode_utf16().flat_map(u16::to_le_bytes).collect::<Vec<u8>>();
    fs::write(root.join("list"), [&[0xff, 0xfe][..], &wide("data/target/figure/macro.json\n")].concat()).unwrap();
    assert_refused(&check(root, &["--changed-files", "list"]), &["is UTF-16; write it as UTF-8"]);
    fs::write(root.join("list"), "\u{feff}data/target/figure/macro.json\n").unwrap();
    assert_shown(&check(root, &["--changed-files", "list"]), 1, &["[macro-steps-length]"], &[]);
}

#[test]
fn a_loose_target_that_is_gone_is_missed_by_its_partner() {
    let repository = example();
    let root = repository.path();
    fs::create_dir_all(root.join("pack/feet")).unwrap();
    for side in ["l", "r"] {
        fs::write(root.join(format!("pack/feet/{side}-foot-big-incr.target")), "337 .1 0 0\n").unwrap();
        fs::write(root.join(format!("pack/feet/{side}-foot-big-decr.target")), "337 -.1 0 0\n").unwrap();
    }
    commit_all(root);
    git(root, &["rm", "-q", "pack/feet/r-foot-big-incr.target"]);
    let check = |more: &[&str]| {
        let args = ["check", "pack", "--system", "data", "--no-eval", "--report", "concise"];
        mhlint(root, &[&args, more].concat())
    };
    assert_shown(&check(&[]), 0, &["[target-missing-side]", "[target-missing-opposite]"], &[]);
    assert_shown(&check(&["--staged"]), 0, &["[target-missing-side]", "[target-missing-opposite]"], &[]);
}
