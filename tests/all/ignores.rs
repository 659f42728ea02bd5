//! Ignores and findings over several files, through the real binary: what is ignored is neither
//! told nor fixed.

use std::fs;
use std::path::Path;

use crate::scratch::{edit, example, findings, mhlint, stderr, stdout};

const A: &str = "data/target/figure/head/head-oval.target";
const B: &str = "data/target/figure/torso/belly-trans-in.target";
const COMMENT: &str = "# mhlint: ignore target-zero-delta kept as markers\n";

/// The example with a zero row in two targets, which one finding tells, at the first of them.
fn repository(config: &str, commented: &[&str]) -> tempfile::TempDir {
    let repository = example();
    let root = repository.path();
    fs::write(root.join("mhlint.toml"), config).unwrap();
    for (path, row) in [(A, "600 0 0 0\n"), (B, "601 0 0 0\n")] {
        let comment = if commented.contains(&path) {
            COMMENT
        } else {
            ""
        };
        let text = format!(
            "{comment}{}{row}",
            fs::read_to_string(root.join(path)).unwrap()
        );
        fs::write(root.join(path), text).unwrap();
    }
    repository
}

fn told(root: &Path) -> Vec<String> {
    let found = findings(&mhlint(root, &["data", "--report", "concise"]));
    found
        .into_iter()
        .filter(|line| line.contains("[target-zero-delta]") || line.contains("[config-"))
        .collect()
}

/// Whether the zero rows are still there.
fn rows(root: &Path) -> [bool; 2] {
    [(A, "600 0 0 0"), (B, "601 0 0 0")]
        .map(|(path, row)| fs::read_to_string(root.join(path)).unwrap().contains(row))
}

fn config_for(path: &str) -> String {
    format!("[[path]]\nglob = \"{path}\"\nskip = [\"target-zero-delta\"]\n")
}

fn ignore_of(path: &str) -> String {
    format!(
        "[[ignore]]\nrule = \"target-zero-delta\"\npath = \"{path}\"\nreason = \"kept as markers\"\n"
    )
}

#[test]
fn a_fix_leaves_out_the_files_for_which_the_rule_is_ignored() {
    for config in [
        ignore_of(B),
        config_for("data/target/figure/torso/**"),
        format!("exclude = [\"{B}\"]\n"),
    ] {
        let repository = repository(&config, &[]);
        let output = mhlint(
            repository.path(),
            &["data", "--fix", "--only", "target-zero-delta"],
        );
        let is_left_out = !config.contains("[[path]]");
        // `--only` goes before `[[path]]`.
        assert_eq!(
            rows(repository.path()),
            [false, is_left_out],
            "{config}{}",
            stderr(&output)
        );
        let repository = self::repository(&config, &[]);
        let output = mhlint(repository.path(), &["data", "--fix"]);
        assert_eq!(
            rows(repository.path()),
            [false, true],
            "{config}{}",
            stderr(&output)
        );
        assert!(
            stderr(&output).contains("1 fixed in 1 file"),
            "{}",
            stderr(&output)
        );
    }
    let repository = repository("", &[B]);
    mhlint(repository.path(), &["data", "--fix"]);
    assert_eq!(rows(repository.path()), [false, true]);
    let repository = self::repository("", &[A]);
    mhlint(repository.path(), &["data", "--fix"]);
    assert_eq!(
        rows(repository.path()),
        [true, false],
        "what stands at a muted file is told of the others, too"
    );
}

#[test]
fn a_fix_writes_nothing_beside_the_paths() {
    let repository = repository("", &[]);
    mhlint(repository.path(), &["data/target/figure/head", "--fix"]);
    assert_eq!(rows(repository.path()), [false, true]);
}

#[test]
fn who_names_one_of_several_files_is_told_and_gets_it_fixed() {
    let repository = repository("", &[]);
    let found = findings(&mhlint(repository.path(), &[B, "--report", "concise"]));
    assert!(
        matches!(found.as_slice(), [line] if line.contains("[target-zero-delta]")),
        "{found:?}"
    );
    mhlint(repository.path(), &[B, "--fix"]);
    assert_eq!(rows(repository.path()), [true, false]);
    let found = findings(&mhlint(
        repository.path(),
        &["data/target/figure/legs", "--report", "concise"],
    ));
    assert_eq!(found, Vec::<String>::new());
}

#[test]
fn what_several_files_have_is_ignored_when_it_is_for_all_of_them() {
    for one in [A, B] {
        for (config, commented) in [
            (ignore_of(one), vec![]),
            (String::new(), vec![one]),
            (config_for(one), vec![]),
        ] {
            let told = told(repository(&config, &commented).path());
            let [line] = told.as_slice() else {
                panic!("{one} {config}: {told:#?}")
            };
            assert!(line.contains("1 of these 2 files is ignored"), "{line}");
        }
    }
    for (config, commented) in [
        (ignore_of(A), vec![B]),
        (String::new(), vec![A, B]),
        (config_for(B), vec![A]),
    ] {
        assert!(
            told(repository(&config, &commented).path()).is_empty(),
            "{config}"
        );
    }
}

#[test]
fn what_two_files_have_between_them_is_ignored_at_either() {
    let [left, right] =
        ["l", "r"].map(|side| format!("data/target/figure/legs/{side}-foot-trans-forward.target"));
    let pair = |commented: Option<&String>| {
        let repository = example();
        edit(repository.path(), &left, "609 0 0 .12", "609 .3 .3 .12");
        if let Some(path) = commented {
            let text = fs::read_to_string(repository.path().join(path)).unwrap();
            let comment = "# mhlint: ignore target-asymmetric-pair meant\n";
            fs::write(repository.path().join(path), format!("{comment}{text}")).unwrap();
        }
        let found = findings(&mhlint(repository.path(), &["data", "--report", "concise"]));
        found
            .into_iter()
            .filter(|line| line.contains("[target-asymmetric-pair]") || line.contains("[config-"))
            .count()
    };
    assert_eq!(pair(None), 1);
    assert_eq!(pair(Some(&left)), 0);
    assert_eq!(pair(Some(&right)), 0);
}

#[test]
fn a_fix_that_is_one_whole_is_left_out_where_a_file_of_it_is_ignored() {
    let empty = "data/target/figure/macro_build/teen-maxmuscle.target";
    let repository = example();
    let before =
        fs::read_to_string(repository.path().join("data/target/figure/macro.json")).unwrap();
    fs::write(
        repository.path().join(empty),
        "# mhlint: ignore macro-empty-target kept\n0 0 0 0\n",
    )
    .unwrap();
    let output = mhlint(
        repository.path(),
        &[
            "data",
            "--fix",
            "--unsafe-fixes",
            "--only",
            "macro-empty-target",
        ],
    );
    let said =
        "1 fixable finding not fixed: the fix is for files that are ignored or outside the PATHs";
    assert!(stderr(&output).contains(said), "{}", stderr(&output));
    assert!(repository.path().join(empty).exists());
    assert_eq!(
        fs::read_to_string(repository.path().join("data/target/figure/macro.json")).unwrap(),
        before
    );
}

#[test]
fn a_folder_is_ignored_by_its_files() {
    let ignore = "[[ignore]]\nrule = \"target-unreferenced\"\npath = \"data/target/figure/new/*.target\"\nreason = \"later\"\n";
    let comment = "# mhlint: ignore target-unreferenced later\n";
    let told = |config: &str, comments: [&str; 3]| {
        let repository = example();
        let folder = repository.path().join("data/target/figure/new");
        fs::write(repository.path().join("mhlint.toml"), config).unwrap();
        fs::create_dir(&folder).unwrap();
        for (number, comment) in comments.iter().enumerate() {
            let row = number + 601;
            let text = format!("{comment}{row} 0 0 .1\n600 .{row} 0 0\n");
            fs::write(folder.join(format!("n{number}.target")), text).unwrap();
        }
        let found = findings(&mhlint(repository.path(), &["data", "--report", "concise"]));
        found
            .into_iter()
            .filter(|line| line.contains("[target-unreferenced]") || line.contains("[config-"))
            .collect()
    };
    let some: Vec<String> = told("", [comment, "", comment]);
    assert!(
        some.len() == 1 && some[0].ends_with("; 2 of these 3 files are ignored"),
        "{some:#?}"
    );
    assert_eq!(told(ignore, [""; 3]), [""; 0]);
    assert_eq!(told("", [comment; 3]), [""; 0]);
}

/// What is said of a text asset that is no UTF-8, with a comment before it.
fn told_of_text(name: &str, comment: &str) -> Vec<String> {
    let repository = example();
    let folder = repository.path().join("data/clothes/figure/hat");
    fs::create_dir_all(&folder).unwrap();
    let mut text = format!("{comment}\n").into_bytes();
    text.extend(b"name J\xf6rg\n");
    fs::write(folder.join(name), text).unwrap();
    let found = findings(&mhlint(repository.path(), &["data", "--report", "concise"]));
    found
        .into_iter()
        .filter(|line| line.contains("[file-not-utf8]") || line.contains("[config-"))
        .collect()
}

#[test]
fn every_format_with_comments_holds_ignores_of_its_own() {
    for name in ["hat.mhclo", "hat.proxy", "hat.mhmat", "hat.mhm"] {
        let told = |comment: &str| told_of_text(name, comment);
        assert_eq!(
            told("# mhlint: ignore file-not-utf8 an old name"),
            [""; 0],
            "{name}"
        );
        assert!(
            matches!(told("# a hat").as_slice(), [line] if line.contains("[file-not-utf8]")),
            "{name}"
        );
        for (comment, said) in [
            (
                "# mhlint: ignore file-empty not so",
                "[config-unused-ignore] the ignore comment for `file-empty` hides nothing",
            ),
            ("# mhlint: ignore file-not-utf8", "[config-missing-reason]"),
            (
                "# mhlint: ignore file-not-utf9 why",
                "[config-unknown-rule]",
            ),
            (
                "# mhlint: ignore",
                "[config-unused-ignore] the comment `mhlint: ignore` is not a valid ignore",
            ),
        ] {
            let told = told(comment);
            let [upkeep, fault] = told.as_slice() else {
                panic!("{name} {comment}: {told:#?}")
            };
            assert!(
                upkeep.contains(&format!("{name}:1:1: ")) && upkeep.contains(said),
                "{upkeep}"
            );
            assert!(fault.contains("[file-not-utf8]"), "{fault}");
        }
    }
    assert_eq!(
        told_of_text("hat.mhmat", "// mhlint: ignore file-not-utf8 an old name"),
        [""; 0]
    );
    let told = told_of_text(
        "hat.mhclo",
        "// mhlint: ignore file-not-utf8 no comment here",
    );
    assert!(
        matches!(told.as_slice(), [line] if line.contains("[file-not-utf8]")),
        "{told:#?}"
    );
}

#[test]
fn an_ignore_for_nothing_is_reported_in_a_run_over_a_part_of_the_folder_too() {
    let repository = example();
    let ignore = |path: &str| {
        format!("[[ignore]]\nrule = \"target-*\"\npath = \"{path}\"\nreason = \"once\"\n")
    };
    let run = |path: &str| {
        fs::write(repository.path().join("mhlint.toml"), ignore(path)).unwrap();
        stdout(&mhlint(
            repository.path(),
            &["data/target/figure/head", "--report", "concise"],
        ))
    };
    let gone = run("data/target/figure/gone/**");
    assert!(gone.contains("config-unused-ignore"), "{gone}");
    // Whether there is something to hide elsewhere cannot be told, nor what lies in another folder.
    for path in ["data/target/figure/arms/**", "elsewhere/**"] {
        assert!(!run(path).contains("config-unused-ignore"), "{path}");
    }
}
