//! `mhlint.toml` through the real binary: where it is found, what it does, in which order, and what
//! it refuses.

use std::fs;
use std::path::{Path, PathBuf};

use crate::scratch::{
    assert_refused, content, edit, example, findings, mhlint, project, stderr, stdout,
};
use mhlint::config::TEMPLATE;
use mhlint::eval::settings::DEFAULT_SAMPLES;
use mhlint::{Config, Tree, lint_trees, rule_infos};

const OVAL: &str = "data/target/figure/head/head-oval.target";

/// A copy of the example repository with a zero row (`target-zero-delta`, info) and this
/// configuration.
fn repository(config: &str) -> tempfile::TempDir {
    let repository = example();
    fs::write(repository.path().join("mhlint.toml"), config).unwrap();
    edit(repository.path(), OVAL, "339 0 .001 .001", "339 0 0 0");
    repository
}

fn concise(root: &Path, args: &[&str]) -> Vec<String> {
    let output = mhlint(root, &[args, &["--report", "concise"]].concat());
    assert!(
        matches!(output.status.code(), Some(0 | 1)),
        "{}",
        stderr(&output)
    );
    findings(&output)
}

/// The level at which the zero row is reported, `off` if it is not.
fn level(root: &Path, args: &[&str]) -> String {
    let found = concise(root, args);
    let line = found
        .iter()
        .find_map(|line| line.split_once("[target-zero-delta]"));
    line.map_or_else(
        || "off".to_owned(),
        |(before, _)| before.rsplit(' ').next().unwrap().to_owned(),
    )
}

#[test]
fn each_layer_goes_before_the_one_above_it() {
    let config = "[level]\ntarget-zero-delta = \"warning\"\n";
    let block =
        "\n[[path]]\nglob = \"data/target/**\"\nlevel = { target-zero-delta = \"error\" }\n";
    assert_eq!(level(repository("").path(), &[]), "info");
    assert_eq!(level(repository(config).path(), &[]), "warning");
    let all = repository(&format!("{config}{block}"));
    assert_eq!(level(all.path(), &[]), "error");
    assert_eq!(
        level(all.path(), &["--level", "target-zero-delta=info"]),
        "info"
    );
    assert_eq!(level(all.path(), &["--skip", "target-zero-*"]), "off");
}

#[test]
fn a_path_and_the_command_line_turn_on_what_the_file_turns_off() {
    let off = repository("skip = [\"target-*\"]\n");
    assert_eq!(level(off.path(), &[]), "off");
    assert_eq!(level(off.path(), &["--only", "target-zero-delta"]), "info");
    assert_eq!(
        level(off.path(), &["--level", "target-zero-delta=warning"]),
        "warning"
    );
    let here = "skip = [\"target-*\"]\n[[path]]\nglob = \"data\"\nlevel = { target-zero-delta = \"warning\" }\n";
    assert_eq!(level(repository(here).path(), &[]), "warning");
    let elsewhere = here.replace("\"data\"", "\"user\"");
    assert_eq!(level(repository(&elsewhere).path(), &[]), "off");
    assert_eq!(
        level(repository("select = [\"macro-*\"]\n").path(), &[]),
        "off"
    );
}

#[test]
fn of_several_levels_the_last_that_fits_counts() {
    let levels = "[level]\ntarget-zero-delta = \"error\"\n\"target-*\" = \"warning\"\n";
    assert_eq!(level(repository(levels).path(), &[]), "warning");
    let turned = "[level]\n\"target-*\" = \"warning\"\ntarget-zero-delta = \"error\"\n";
    assert_eq!(level(repository(turned).path(), &[]), "error");
}

#[test]
fn the_file_is_found_above_the_path_and_globs_are_relative_to_it() {
    let config = "[[path]]\nglob = \"data/target/figure/head/*\"\nskip = [\"target-zero-delta\"]\n";
    let repository = repository(config);
    let root = repository.path();
    assert_eq!(level(root, &["data"]), "off");
    assert_eq!(level(&root.join("data/target"), &["figure"]), "off");
    assert_eq!(level(&root.join("user"), &["../data"]), "off");
    assert_eq!(level(root, &[root.join("data").to_str().unwrap()]), "off");
}

#[test]
fn the_search_ends_at_the_top_of_a_git_repository() {
    let repository = repository("skip = [\"target-zero-delta\"]\n");
    fs::create_dir(repository.path().join("data/.git")).unwrap();
    assert_eq!(level(repository.path(), &["data"]), "info");
    assert_eq!(
        level(repository.path(), &["data", "--config", "mhlint.toml"]),
        "off"
    );
}

#[test]
fn fail_on_and_max_warnings_follow_the_same_order() {
    let code = |config: &str, args: &[&str]| mhlint(repository(config).path(), args).status.code();
    assert_eq!(code("", &[]), Some(0));
    assert_eq!(code("fail-on = \"info\"\n", &[]), Some(1));
    assert_eq!(
        code("fail-on = \"info\"\n", &["--fail-on", "never"]),
        Some(0)
    );
    let warning = "max-warnings = 0\n[level]\ntarget-zero-delta = \"warning\"\n";
    assert_eq!(code(warning, &[]), Some(1));
    assert_eq!(code(warning, &["--max-warnings", "1"]), Some(0));
}

#[test]
fn ignored_findings_are_counted() {
    let suppressed = |config: &str| {
        let output = mhlint(repository(config).path(), &["--report", "json"]);
        let report: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
        (
            report["summary"]["suppressed"].as_u64().unwrap(),
            report["findings"].as_array().unwrap().len(),
        )
    };
    let ignore = "[[ignore]]\nrule = \"target-zero-delta\"\npath = \"data\"\nreason = \"so\"\n";
    assert_eq!(suppressed(ignore), (1, 0));
    assert_eq!(
        suppressed("[[path]]\nglob = \"data\"\nskip = [\"target-zero-delta\"]\n"),
        (1, 0)
    );
    assert_eq!(suppressed(""), (0, 1));
}

#[test]
fn excluded_files_are_silent_unless_they_are_named() {
    let excluded = repository("exclude = [\"data/target/figure/head\"]\n");
    assert_eq!(level(excluded.path(), &[]), "off");
    assert_eq!(level(excluded.path(), &["data/target/figure/head"]), "info");
    let roots = |args: &[&str]| {
        let output = mhlint(
            repository("exclude = [\"data\"]\n").path(),
            &[args, &["--report", "json"]].concat(),
        );
        let report: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
        report["roots"]
            .as_array()
            .unwrap()
            .iter()
            .map(|root| root["path"].as_str().unwrap().to_owned())
            .collect()
    };
    let (all, named): (Vec<String>, Vec<String>) = (roots(&[]), roots(&["data"]));
    assert_eq!(
        (all, named),
        (vec!["user".to_owned()], vec!["data".to_owned()])
    );
}

#[test]
fn system_is_relative_to_the_file() {
    let repository = example();
    fs::write(
        repository.path().join("user/mhlint.toml"),
        "system = \"../data\"\n",
    )
    .unwrap();
    assert_eq!(concise(repository.path(), &["user"]), Vec::<String>::new());
    assert_eq!(
        concise(&repository.path().join("user"), &[]),
        Vec::<String>::new()
    );
    fs::write(
        repository.path().join("user/mhlint.toml"),
        "system = \"../gone\"\n",
    )
    .unwrap();
    assert_refused(
        &mhlint(repository.path(), &["user"]),
        &["gone", "`system` is set in user/mhlint.toml:1"],
    );
}

#[test]
fn options_of_rules_are_set() {
    let large = repository("[rule.file-too-large]\ntarget = 0.00001\n");
    assert!(
        concise(large.path(), &[])
            .iter()
            .any(|line| line.contains("[file-too-large]"))
    );
    assert!(
        !concise(repository("").path(), &[])
            .iter()
            .any(|line| line.contains("[file-too-large]"))
    );
}

#[test]
#[expect(clippy::too_many_lines, reason = "a table")]
fn what_is_wrong_with_the_file_is_told_with_place_and_remedy() {
    for (config, words) in [
        (
            "selct = [\"*\"]\n",
            &[
                "mhlint.toml:1:1",
                "unknown key `selct`",
                "did you mean `select`?",
                "^^^^^",
            ][..],
        ),
        (
            "\nfail-on = 3\n",
            &["mhlint.toml:2:11", "the number 3", "\"error\""],
        ),
        (
            "skip = \"macro-*\"\n",
            &["`skip` is the string", "expected a list of strings"],
        ),
        ("skip = [1]\n", &["an element of `skip` is the number 1"]),
        (
            "skip = [\"macro-[\"]\n",
            &["mhlint.toml:1:9", "is not a valid glob"],
        ),
        ("exclude = [\"{a\"]\n", &["is not a valid glob"]),
        ("max-warnings = -1\n", &["a whole number, 0 or more"]),
        (
            "apps = [\"makehumn1\"]\n",
            &[
                "unknown application `makehumn1`",
                "did you mean `makehuman1`?",
            ],
        ),
        (
            "apps = [\"makehuman3\"]\n",
            &[
                "unknown application `makehuman3`",
                "use one of: makehuman2, makehuman1",
            ],
        ),
        ("fail-on =\n", &["mhlint.toml:1:", "not valid TOML"]),
        (
            "skip = []\nskip = []\n",
            &["mhlint.toml:2:1", "not valid TOML"],
        ),
        (
            "[level]\nmacro-steps-length = \"fatal\"\n",
            &["mhlint.toml:2:22", "\"off\""],
        ),
        (
            "[rule.target-oversized-delta]\nration = 1\n",
            &["has no option `ration`", "did you mean `ratio`?"],
        ),
        (
            "[rule.target-oversized-delta]\nratio = \"1\"\n",
            &["`ratio` is the string", "a finite number"],
        ),
        (
            "[rule.target-oversized-delta]\nratio = nan\n",
            &["a finite number"],
        ),
        (
            "[rule.target-oversized-delta]\nratio = -5\n",
            &["mhlint.toml:2:9", "a finite number, 0 or more"],
        ),
        (
            "[rule.target-syntax]\nratio = 1\n",
            &["has no option `ratio`", "the rule has no options"],
        ),
        (
            "[[ignore]]\nrule = \"target-syntax\"\n",
            &["missing key `path` in `[[ignore]]`", "add it"],
        ),
        ("[ignore]\nrule = \"x\"\n", &["`[[ignore]]`"]),
        (
            "[[path]]\nglob = \"a\"\nlevels = {}\n",
            &[
                "unknown key `levels` in `[[path]]`",
                "did you mean `level`?",
            ],
        ),
        (
            "[[ignore]]\nrule = \"a\"\npath = \"b\"\nuntil = \"2030\"\n",
            &["a date without quotes"],
        ),
        (
            "[[ignore]]\nrule = \"a\"\npath = \"b\"\nuntil = 2030-13-01\n",
            &["mhlint.toml:4"],
        ),
        ("[eval]\nsamples = 1.5\n", &["`samples` is the number 1.5"]),
        (
            "[eval]\nsamples = 100001\n",
            &["mhlint.toml:2:11", "a whole number from 0 to 100000"],
        ),
        (
            "[eval]\nsamples = 99999999999999\n",
            &["a whole number from 0 to 100000"],
        ),
        (
            "select = [\"json-sintax\"]\n",
            &["`select` in mhlint.toml:1 selects nothing; did you mean `json-syntax`?"],
        ),
        (
            "select = [\"macros-*\", \"zzz\"]\n",
            &["`macros-*`", "matches no rule"],
        ),
        ("[eval]\nexhaustive = 1\n", &["`true` or `false`"]),
        ("fail-on = \"errors\"\n", &["did you mean \"error\"?"]),
        (
            "[level]\nbaseline = \"b.json\"\n",
            &[
                "mhlint.toml:2:1",
                "`baseline` is a top-level key",
                "above the first",
            ],
        ),
        (
            "[level]\nexclude = [\"a\"]\n",
            &["mhlint.toml:2:1", "`exclude` is a top-level key"],
        ),
        (
            "[eval]\nbaseline = \"b.json\"\n",
            &["unknown key `baseline` in `[eval]`", "is a top-level key"],
        ),
        (
            "[[path]]\nglob = \"a\"\nexclude = []\n",
            &["unknown key `exclude` in `[[path]]`", "is a top-level key"],
        ),
        ("[rule]\nskip = []\n", &["`skip` is a top-level key"]),
        (
            "[rule.target-oversized-delta]\nskip = []\n",
            &["no option `skip`", "`skip` is a top-level key"],
        ),
        ("samples = 3\n", &["`samples` is a key of `[eval]`"]),
        (
            "[eval]\nreason = \"a\"\n",
            &["`reason` is a key of `[[ignore]]`"],
        ),
    ] {
        assert_refused(&mhlint(repository(config).path(), &[]), words);
    }
}

#[test]
fn no_option_is_too_low_at_its_lowest_and_no_number_too_high_at_its_highest() {
    let lowest = repository("[rule.target-asymmetric]\nshare = 0\n[eval]\nsamples = 100_000\n");
    assert_eq!(mhlint(lowest.path(), &["--no-eval"]).status.code(), Some(0));
    let over = mhlint(lowest.path(), &["--samples", "2000000000"]);
    assert_refused(&over, &["--samples", "a whole number from 0 to 100000"]);
}

#[test]
fn what_looks_after_the_settings_is_not_for_select() {
    let ignores = "[[ignore]]\nrule = \"target-zero-delta\"\npath = \"data\"\nreason = \"r\"\nuntil = 2020-01-01\n";
    let settings = format!(
        "select = [\"macro-*\", \"json-sintax\"]\n[level]\n\"no-such\" = \"info\"\n{ignores}"
    );
    let root = repository(&settings);
    let found = |args: &[&str]| concise(root.path(), args).join("\n");
    let all = found(&[]);
    for told in ["`json-sintax`", "`no-such`", "[config-expired-ignore]"] {
        assert!(all.contains(told), "{told}: {all}");
    }
    assert_eq!(all.lines().count(), 3, "{all}");
    assert_eq!(found(&["--only", "macro-*"]), "");
    let typo = repository("select = [\"json-sintax\"]\n");
    assert_eq!(level(typo.path(), &["--only", "target-*"]), "info");
}

#[cfg(unix)]
#[test]
fn a_link_that_leads_nowhere_is_no_lack_of_settings() {
    let repository = example();
    std::os::unix::fs::symlink("nowhere.toml", repository.path().join("mhlint.toml")).unwrap();
    assert_refused(
        &mhlint(repository.path(), &[]),
        &["mhlint.toml: cannot be read", "a broken link"],
    );
    fs::write(repository.path().join("nowhere.toml"), "").unwrap();
    assert_eq!(mhlint(repository.path(), &[]).status.code(), Some(0));
}

#[test]
fn all_that_is_wrong_is_told_at_once() {
    let output = mhlint(repository("selct = []\nfail-on = 3\n").path(), &[]);
    assert_refused(&output, &["mhlint.toml:1:1", "mhlint.toml:2:11"]);
    assert_eq!(stderr(&output).matches("help: ").count(), 2);
}

#[test]
fn a_file_that_cannot_be_read_is_refused() {
    let repository = example();
    let refused =
        |words: &[&str]| assert_refused(&mhlint(repository.path(), &["--config", "c.toml"]), words);
    refused(&["c.toml: cannot be read", "mhlint init"]);
    fs::write(repository.path().join("c.toml"), b"# J\xf6rg\n").unwrap();
    refused(&["not UTF-8"]);
    fs::remove_file(repository.path().join("c.toml")).unwrap();
    fs::create_dir(repository.path().join("c.toml")).unwrap();
    refused(&["is a folder"]);
}

#[test]
fn a_rule_of_safety_refuses_every_way_of_muting() {
    let rule = "file-path-escape";
    for config in [
        format!("skip = [\"{rule}\"]\n"),
        format!("[level]\n{rule} = \"info\"\n"),
        format!("[[path]]\nglob = \"**\"\nskip = [\"{rule}\"]\n"),
        format!("[[path]]\nglob = \"**\"\nlevel = {{ {rule} = \"off\" }}\n"),
        format!("[[ignore]]\nrule = \"{rule}\"\npath = \"**\"\nreason = \"trust me\"\n"),
    ] {
        assert_refused(
            &mhlint(repository(&config).path(), &[]),
            &["cannot be ignored", "remove this entry"],
        );
    }
    assert_refused(
        &mhlint(repository("").path(), &["--skip", rule]),
        &["cannot be ignored"],
    );
    assert_refused(
        &mhlint(repository("").path(), &["--level", &format!("{rule}=off")]),
        &["cannot be ignored"],
    );
}

#[cfg(unix)]
#[test]
fn wide_globs_do_not_reach_a_rule_of_safety() {
    let everything = "select = [\"macro-*\"]\nskip = [\"*\"]\nexclude = [\"**\"]\n[level]\n\"*\" = \"off\"\n\
        [[path]]\nglob = \"**\"\nskip = [\"*\"]\n\
        [[ignore]]\nrule = \"file-*\"\npath = \"**\"\nreason = \"trust me\"\n";
    let repository = repository(everything);
    let inside = |root: &Path| root.join("data/target/figure/head/head-escape.target");
    std::os::unix::fs::symlink("/etc/hostname", inside(repository.path())).unwrap();
    for args in [
        &[][..],
        &["data", "--only", "macro-*"],
        &["data", "--baseline", "b.json", "--write-baseline"],
    ] {
        let found = concise(repository.path(), &[&["data"], args].concat());
        assert!(
            found.iter().any(|line| line.contains("[file-path-escape]")),
            "{args:?}: {found:?}"
        );
    }
    let written = fs::read_to_string(repository.path().join("b.json")).unwrap();
    assert!(!written.contains("file-path-escape"), "{written}");
}

#[test]
fn globs_are_relative_to_trees_in_memory() {
    let all = content(&project("fixtures/makehuman2"));
    let damaged = |(path, bytes): (PathBuf, Vec<u8>)| {
        let path = path.to_str().unwrap().to_owned();
        let text = String::from_utf8_lossy(&bytes).replace("339 0 .001 .001", "339 0 0 0");
        if path == OVAL {
            (path, text.into_bytes())
        } else {
            (path, bytes)
        }
    };
    let found = |config: &str| {
        let config = Config::parse(config, "mhlint.toml", &rule_infos()).unwrap();
        let tree = Tree::in_memory("", all.clone().into_iter().map(damaged));
        let outcome = lint_trees(vec![tree], None, &config).unwrap();
        let rules: Vec<&str> = outcome
            .findings
            .iter()
            .map(|finding| finding.rule)
            .collect();
        (
            rules.join(" "),
            outcome
                .findings
                .first()
                .and_then(|finding| finding.location.line),
        )
    };
    let ignore = |path: &str| {
        format!("[[ignore]]\nrule = 'target-zero-delta'\npath = '{path}'\nreason = 'so'\n")
    };
    assert_eq!(found(&ignore("data/target/**")), (String::new(), None));
    assert_eq!(
        found(&ignore("target/**")),
        ("target-zero-delta config-unused-ignore".to_owned(), Some(5))
    );
}

#[test]
fn init_writes_a_file_that_changes_nothing_and_overwrites_none() {
    let repository = example();
    let made = mhlint(repository.path(), &["init"]);
    assert_eq!((made.status.code(), stderr(&made).as_str()), (Some(0), ""));
    let text = fs::read_to_string(repository.path().join("mhlint.toml")).unwrap();
    assert_eq!(concise(repository.path(), &[]), Vec::<String>::new());
    fs::write(repository.path().join("mhlint.toml"), "# mine\n").unwrap();
    assert_refused(
        &mhlint(repository.path(), &["init"]),
        &["already exists", "was not changed", "remove it first"],
    );
    assert_eq!(
        fs::read_to_string(repository.path().join("mhlint.toml")).unwrap(),
        "# mine\n"
    );
    assert_refused(
        &mhlint(repository.path(), &["init", "no/such"]),
        &["folder `no/such` does not exist", "create it"],
    );
    assert_eq!(
        mhlint(repository.path(), &["init", "data"]).status.code(),
        Some(0)
    );
    assert_eq!(
        fs::read_to_string(repository.path().join("data/mhlint.toml")).unwrap(),
        text
    );
}

#[test]
fn config_shows_each_value_and_where_it_comes_from() {
    let repository =
        repository("fail-on = \"warning\"\nskip = [\"macro-*\"]\n[eval]\nsamples = 7\n");
    let shown = |args: &[&str]| stdout(&mhlint(repository.path(), &[&["config"], args].concat()));
    let has = |text: &str, setting: &str, origin: &str| {
        let mut lines = text.lines().filter_map(|line| line.split_once("  # "));
        assert!(
            lines.any(|(a, b)| (a.trim_end(), b) == (setting, origin)),
            "no `{setting}` of {origin} in:\n{text}"
        );
    };
    let text = shown(&[]);
    has(&text, "fail-on = \"warning\"", "mhlint.toml:1");
    has(&text, "skip = [\"macro-*\"]", "mhlint.toml:2");
    has(&text, "eval.samples = 7", "mhlint.toml:4");
    has(&text, "max-warnings = none", "default");
    has(&text, "rule.target-oversized-delta.ratio = 20", "default");
    let text = shown(&["--fail-on", "never", "--only", "target-*", "data"]);
    has(&text, "fail-on = \"never\"", "command line");
    has(&text, "select = [\"target-*\"]", "command line");
    assert!(
        stdout(&mhlint(example().path(), &["config"]))
            .starts_with("# no mhlint.toml at or above `.`")
    );
}

#[test]
fn config_leaves_out_what_only_stands_in_place_of() {
    let off = "skip = [\"macro-*\"]\n[level]\ntarget-zero-delta = \"off\"\ntarget-syntax = \"info\"\n\
        [[path]]\nglob = \"data\"\nskip = [\"json-*\"]\nlevel = { json-syntax = \"off\", target-syntax = \"error\" }\n";
    let repository = repository(off);
    let shown = |args: &[&str]| stdout(&mhlint(repository.path(), &[&["config"], args].concat()));
    let (all, only) = (shown(&[]), shown(&["--only", "target-*", "--no-eval"]));
    let turned_off = [
        "skip = [\"macro-*\"]",
        "target-zero-delta = \"off\"",
        "skip = [\"json-*\"]",
        "json-syntax = \"off\"",
    ];
    for setting in turned_off {
        assert!(
            all.contains(setting) && !only.contains(setting),
            "{setting}:\n{all}\n{only}"
        );
    }
    for setting in [
        "level.target-syntax = \"info\"",
        "path \"data\": level.target-syntax = \"error\"",
    ] {
        assert!(
            all.contains(setting) && only.contains(setting),
            "{setting}:\n{only}"
        );
    }
    assert!(
        all.contains("eval.samples")
            && !only.contains("eval.samples")
            && only.contains("--no-eval"),
        "{only}"
    );
}

#[test]
fn init_says_which_settings_it_takes_the_place_of() {
    let repository = repository("fail-on = \"info\"\n");
    let root = repository.path();
    let made = mhlint(root, &["init", "data/target"]);
    assert_eq!(made.status.code(), Some(0));
    assert!(
        stderr(&made).contains("`mhlint.toml` no longer applies in `data/target`"),
        "{}",
        stderr(&made)
    );
    let made = mhlint(&root.join("data"), &["init"]);
    assert!(
        stderr(&made).contains("`../mhlint.toml` no longer applies in `.`"),
        "{}",
        stderr(&made)
    );
}

#[test]
fn the_schema_has_the_keys_that_the_reader_knows_and_no_others() {
    let schema: serde_json::Value =
        serde_json::from_str(&fs::read_to_string(project("schemas/config.schema.json")).unwrap())
            .unwrap();
    let keys = |object: &serde_json::Value| -> Vec<String> {
        object["properties"]
            .as_object()
            .unwrap()
            .keys()
            .cloned()
            .collect()
    };
    let top = &schema["properties"];
    let tables = [
        ("[[path]]", &top["path"]["items"]),
        ("[[ignore]]", &top["ignore"]["items"]),
        ("[eval]", &top["eval"]),
    ];
    for (head, object) in [("", &schema)].into_iter().chain(tables) {
        for key in keys(object) {
            let output = mhlint(
                repository(&format!("{head}\n{key} = 1979-05-27T07:32:00\n")).path(),
                &["config"],
            );
            assert!(
                !stderr(&output).contains("unknown key"),
                "{head} {key}: {}",
                stderr(&output)
            );
        }
        // The reader lists all keys where no name is near.
        let output = mhlint(
            repository(&format!("{head}\nqqqqqqqqqqqq = 1\n")).path(),
            &["config"],
        );
        let told = stderr(&output);
        let told = told
            .lines()
            .find_map(|line| line.split_once("use one of: "))
            .unwrap()
            .1;
        assert_eq!(
            told.split(", ").map(str::to_owned).collect::<Vec<_>>(),
            keys(object),
            "{head}"
        );
    }
    let documented = fs::read_to_string(project("docs/configuration.md")).unwrap();
    for key in keys(&schema) {
        assert!(
            documented.contains(&format!("`{key}`")),
            "docs/configuration.md lacks `{key}`"
        );
    }
}

/// The file of `init` with all settings in effect.
fn every_setting() -> String {
    let bare = |line: &str| {
        line.strip_prefix('#')
            .filter(|rest| !rest.starts_with(' '))
            .unwrap_or(line)
            .to_owned()
    };
    TEMPLATE
        .lines()
        .map(bare)
        .collect::<Vec<String>>()
        .join("\n")
}

#[test]
fn the_template_fits_the_schema() {
    let schema: serde_json::Value =
        serde_json::from_str(&fs::read_to_string(project("schemas/config.schema.json")).unwrap())
            .unwrap();
    let validator = jsonschema::validator_for(&schema).unwrap();
    let fits = |text: &str| {
        validator
            .is_valid(&serde_json::to_value(toml::from_str::<toml::Table>(text).unwrap()).unwrap())
    };
    let text = every_setting().replace("2027-06-30", "\"2027-06-30\"");
    assert!(fits(&text));
    assert!(!fits("skip = ['macro-nope']") && !fits("[rule.macro-nope]") && !fits("[[ignore]]"));
}

#[test]
fn the_numbers_in_the_file_of_init_are_the_defaults() {
    let config = Config::parse(&every_setting(), "mhlint.toml", &rule_infos()).unwrap();
    assert_eq!(
        (config.samples, config.rule_options.len()),
        (Some(DEFAULT_SAMPLES), 2)
    );
    for ((rule, name), value) in &config.rule_options {
        let rules = rule_infos();
        let options = rules
            .iter()
            .filter(|known| known.id == rule)
            .flat_map(|known| known.options);
        let defaults: Vec<f64> = options
            .filter(|option| option.name == name.as_str())
            .map(|option| option.default)
            .collect();
        assert_eq!(defaults, [*value], "{rule}.{name}");
    }
}
