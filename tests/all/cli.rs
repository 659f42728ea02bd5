//! What the command promises: exit codes, streams, arguments. One function a promise, on the real
//! binary.

use std::fs;
use std::io::Read;
use std::path::Path;
use std::process::{Command, Output, Stdio};

use crate::scratch::{assert_refused, broken, example, mhlint, project, stderr, stdout};

fn code(output: &Output) -> Option<i32> {
    output.status.code()
}

#[test]
fn a_faultless_repository_exits_0_and_says_nothing_on_stderr() {
    let output = mhlint(&project("fixtures/makehuman2"), &[]);
    assert_eq!((code(&output), stderr(&output).as_str()), (Some(0), ""));
    assert!(
        stdout(&output).contains("Passed: no findings"),
        "{}",
        stdout(&output)
    );
}

#[test]
fn an_error_exits_1_and_goes_to_stdout() {
    let output = mhlint(broken().path(), &["check", "."]);
    assert_eq!((code(&output), stderr(&output).as_str()), (Some(1), ""));
    assert!(stdout(&output).contains("error[macro-steps-length]"));
}

#[test]
fn fail_on_moves_the_limit() {
    let repository = broken();
    let exit = |args: &[&str]| code(&mhlint(repository.path(), args));
    let only = ["--only", "macro-steps-length"];
    assert_eq!(
        exit(&[&only[..], &["--fail-on", "never"]].concat()),
        Some(0)
    );
    let info = [&only[..], &["--level", "macro-steps-length=info"]].concat();
    assert_eq!(exit(&info), Some(0));
    assert_eq!(exit(&[&info[..], &["--fail-on", "info"]].concat()), Some(1));
    assert_eq!(
        exit(&[&info[..], &["--fail-on", "warning"]].concat()),
        Some(0)
    );
}

#[test]
fn max_warnings_bounds_the_warnings() {
    let repository = broken();
    let args = [
        "--only",
        "macro-steps-length",
        "--level",
        "macro-steps-length=warning",
        "--max-warnings",
    ];
    assert_eq!(
        code(&mhlint(repository.path(), &[&args[..], &["1"]].concat())),
        Some(0)
    );
    let output = mhlint(repository.path(), &[&args[..], &["0"]].concat());
    assert_eq!(code(&output), Some(1));
    assert!(
        stdout(&output).contains("`max-warnings` allows 0."),
        "{}",
        stdout(&output)
    );
}

#[test]
fn only_skip_and_level_off_silence_a_rule() {
    let repository = broken();
    for args in [
        ["--only", "target-syntax"],
        ["--skip", "macro-*"],
        ["--level", "macro-steps-length=off"],
    ] {
        let output = mhlint(
            repository.path(),
            &[&args[..], &["--report", "concise"]].concat(),
        );
        assert!(
            !stdout(&output).contains("macro-steps-length"),
            "{args:?}: {}",
            stdout(&output)
        );
    }
}

#[test]
fn a_family_is_named_by_its_name() {
    let repository = broken();
    let found = |args: &[&str]| {
        stdout(&mhlint(
            repository.path(),
            &[args, &["--report", "concise"]].concat(),
        ))
    };
    assert!(found(&["--only", "macro"]).contains("[macro-steps-length]"));
    assert!(!found(&["--skip", "macro"]).contains("[macro-"));
    assert!(found(&["--level", "macro=info"]).contains("info[macro-steps-length]"));
    assert_refused(&mhlint(repository.path(), &["--only", "makro"]), &["makro"]);
}

#[test]
fn options_of_other_linters_are_answered_with_ours() {
    for (args, own) in [
        (&["--json"][..], "--report json"),
        (&["--format", "json"], "--report FORMAT"),
        (&["--output", "x"], "--report FORMAT=FILE"),
        (&["--select", "macro"], "--only RULE"),
    ] {
        assert_refused(&mhlint(&project("fixtures/makehuman2"), args), &[own]);
    }
}

#[test]
#[cfg(unix)]
fn behind_a_link_into_a_data_root_files_have_their_real_names() {
    let repository = broken();
    let root = repository.path();
    fs::create_dir(root.join("sub")).unwrap();
    std::os::unix::fs::symlink("../data/target", root.join("sub/link")).unwrap();
    fs::write(root.join("data/mhlint.toml"), "skip = [\"json\"]\n").unwrap();
    let text = stdout(&mhlint(root, &["sub/link", "--report", "concise"]));
    assert!(
        text.contains("\ndata/target/figure/macro.json:")
            || text.starts_with("data/target/figure/"),
        "{text}"
    );
    let settings = stdout(&mhlint(root, &["config", "sub/link"]));
    assert!(
        settings.starts_with("# ") && settings.contains("/data/mhlint.toml"),
        "{settings}"
    );
}

#[test]
fn help_is_short_or_long() {
    let [short, long] =
        ["-h", "--help"].map(|option| stdout(&mhlint(&project("fixtures"), &[option])));
    for heading in [
        "Input:",
        "Rules:",
        "Only new findings:",
        "Fixes:",
        "Output:",
    ] {
        assert!(
            short.contains(heading) && long.contains(heading),
            "{heading}\n{short}"
        );
    }
    assert!(long.lines().count() > short.lines().count() + 20);
    assert!(long.contains("Exit codes:") && !short.contains("Exit codes:"));
    let wide: Vec<&str> = short.lines().filter(|line| line.len() > 110).collect();
    assert_eq!(wide, Vec::<&str>::new());
}

#[test]
fn nothing_to_check_exits_3_and_says_what_to_give() {
    let folder = tempfile::tempdir().unwrap();
    let output = mhlint(folder.path(), &[]);
    assert_eq!((code(&output), stdout(&output).as_str()), (Some(3), ""));
    assert!(
        stderr(&output).contains("nothing was checked in `.`"),
        "{}",
        stderr(&output)
    );
    assert!(
        stderr(&output).contains("name the data folder"),
        "{}",
        stderr(&output)
    );
}

#[test]
fn nothing_to_check_is_no_pass_for_programs() {
    let folder = tempfile::tempdir().unwrap();
    let output = mhlint(folder.path(), &["--report", "json"]);
    assert_eq!(code(&output), Some(3));
    assert!(
        stdout(&output).contains("\"verdict\": \"fail\""),
        "{}",
        stdout(&output)
    );
}

#[test]
fn loose_assets_are_checked_alone_and_against_the_system_data() {
    let folder = tempfile::tempdir().unwrap();
    fs::create_dir(folder.path().join("mine")).unwrap();
    fs::write(
        folder.path().join("mine/wide.target"),
        "1 0.1 0.2 0.3\n99999 0 0 1\n2 0.1\n",
    )
    .unwrap();
    let alone = mhlint(folder.path(), &["mine/wide.target", "--report", "concise"]);
    assert_eq!(code(&alone), Some(0), "{}", stderr(&alone));
    assert!(
        stdout(&alone).contains("mine/wide.target:3:1: warning[target-field-count]"),
        "{}",
        stdout(&alone)
    );
    assert!(!stdout(&alone).contains("target-vertex-out-of-range"));
    let unmeasured = "vertex numbers in 1 .target (no base mesh; use `--system`";
    assert!(stdout(&alone).contains(unmeasured), "{}", stdout(&alone));
    let system = project("fixtures/makehuman2/data");
    let against = mhlint(
        folder.path(),
        &[
            ".",
            "--system",
            system.to_str().unwrap(),
            "--report",
            "concise",
        ],
    );
    assert_eq!((code(&against), stderr(&against).as_str()), (Some(1), ""));
    assert!(
        stdout(&against).contains("mine/wide.target:2:1: error[target-vertex-out-of-range]"),
        "{}",
        stdout(&against)
    );
}

#[test]
fn loose_assets_are_named_as_they_lie() {
    let folder = tempfile::tempdir().unwrap();
    let rows = "1 0.1 0.2 0.3\n".repeat(40);
    for name in ["a", "b"] {
        fs::write(
            folder.path().join(format!("{name}.target")),
            format!("# basemesh other\n{rows}"),
        )
        .unwrap();
    }
    let system = project("fixtures/makehuman2/data");
    let system = system.to_str().unwrap();
    let args = [
        ".",
        "--system",
        system,
        "--base",
        "figure",
        "--only",
        "file-*",
        "--only",
        "target-basemesh-mismatch",
    ];
    let output = stdout(&mhlint(folder.path(), &args));
    assert!(
        output.contains("the same displacements as `b.target`"),
        "{output}"
    );
    assert!(
        output.contains("2 targets made for base mesh `other`"),
        "{output}"
    );
    assert!(
        !output.contains("loose/"),
        "a place that is only supposed is named: {output}"
    );
}

#[test]
fn system_data_given_to_be_checked_are_checked() {
    let output = mhlint(
        &project("fixtures/makehuman2"),
        &["data", "--system", "./data/"],
    );
    assert_eq!(code(&output), Some(0), "{}", stderr(&output));
    assert!(
        stdout(&output).contains("names the checked folder itself"),
        "{}",
        stdout(&output)
    );
}

#[test]
fn a_missing_path_exits_2_and_is_named() {
    assert_refused(
        &mhlint(&project("."), &["nowhere"]),
        &["nowhere", "No such file"],
    );
    assert_refused(
        &mhlint(&project("fixtures"), &["makehuman2", "--system", "nowhere"]),
        &["nowhere"],
    );
}

#[test]
fn a_misspelt_command_gets_a_suggestion() {
    assert_refused(
        &mhlint(&project("."), &["explan"]),
        &["did you mean the command `explain`"],
    );
}

#[test]
fn unknown_names_get_the_nearest_one() {
    let repository = project("fixtures/makehuman2");
    assert_refused(
        &mhlint(&repository, &["--only", "macro-step-length"]),
        &["did you mean `macro-steps-length`"],
    );
    assert_refused(
        &mhlint(&repository, &["--level", "macro-steps-length=fatal"]),
        &["error, warning, info, off"],
    );
    assert_refused(
        &mhlint(&repository, &["--level", "macro-steps-length"]),
        &["RULE=LEVEL"],
    );
    assert_refused(
        &mhlint(&repository, &["--app", "makehuman3"]),
        &["makehuman2"],
    );
    assert_refused(&mhlint(&repository, &["--base", "figur"]), &["figure"]);
    assert_refused(
        &mhlint(&repository, &["--report", "jsom"]),
        &["did you mean `json`"],
    );
    assert_refused(&mhlint(&repository, &["--quite"]), &["--quiet"]);
    assert_refused(
        &mhlint(&repository, &["explain", "macro-step-length"]),
        &["did you mean `macro-steps-length`"],
    );
    assert_refused(
        &mhlint(&repository, &["schema", "macros"]),
        &["did you mean `macro`"],
    );
}

#[test]
fn a_report_goes_to_a_file_and_leaves_stdout_empty() {
    let repository = broken();
    let output = mhlint(repository.path(), &["--report", "json=out.json"]);
    assert_eq!(
        (
            code(&output),
            stdout(&output).as_str(),
            stderr(&output).as_str()
        ),
        (Some(1), "", "")
    );
    let report: serde_json::Value =
        serde_json::from_slice(&fs::read(repository.path().join("out.json")).unwrap()).unwrap();
    assert_eq!(report["format"], "mhlint-report/1");
    assert_eq!(leftovers(repository.path()), Vec::<String>::new());
}

/// Hidden files in a folder: what an interrupted write would leave.
fn leftovers(folder: &Path) -> Vec<String> {
    let names = fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap());
    names.filter(|name| name.starts_with('.')).collect()
}

#[test]
fn a_full_disk_is_named_with_a_remedy() {
    let repository = broken();
    assert_refused(
        &mhlint(repository.path(), &["--report", "json=/dev/full"]),
        &["cannot write the report to `/dev/full`", "free some space"],
    );
    assert!(
        !fs::metadata("/dev/full").unwrap().is_file(),
        "a device is written to, not replaced"
    );
    let mut command = Command::new(env!("CARGO_BIN_EXE_mhlint"));
    let full = fs::OpenOptions::new()
        .write(true)
        .open("/dev/full")
        .unwrap();
    let output = command
        .current_dir(repository.path())
        .stdout(full)
        .output()
        .unwrap();
    assert_eq!(code(&output), Some(2));
    assert!(
        stderr(&output).contains("cannot write to standard output"),
        "{}",
        stderr(&output)
    );
}

#[test]
fn a_failed_write_leaves_nothing_behind() {
    let repository = broken();
    let folder = repository.path().join("locked");
    fs::create_dir(&folder).unwrap();
    // A name longer than names may be: the report waits beside it and cannot take its place.
    let long = folder.join("n".repeat(256));
    let target = format!("json={}", long.display());
    assert_refused(
        &mhlint(repository.path(), &["--report", &target]),
        &["cannot write the report", "name"],
    );
    assert_eq!(
        (leftovers(&folder), long.exists()),
        (Vec::<String>::new(), false)
    );
    let longest = folder.join("n".repeat(255));
    mhlint(
        repository.path(),
        &["--report", &format!("json={}", longest.display())],
    );
    assert!(longest.exists());
}

#[test]
fn a_report_takes_the_place_of_an_older_one() {
    use std::os::unix::fs::PermissionsExt;
    let repository = broken();
    let [real, link] = ["real.json", "link.json"].map(|name| repository.path().join(name));
    fs::write(&real, "x".repeat(1 << 20)).unwrap();
    fs::set_permissions(&real, fs::Permissions::from_mode(0o640)).unwrap();
    std::os::unix::fs::symlink("real.json", &link).unwrap();
    mhlint(repository.path(), &["--report", "json=link.json"]);
    assert!(fs::symlink_metadata(&link).unwrap().is_symlink());
    assert_eq!(
        fs::metadata(&real).unwrap().permissions().mode() & 0o777,
        0o640
    );
    let report: serde_json::Value = serde_json::from_slice(&fs::read(&real).unwrap()).unwrap();
    assert_eq!(report["format"], "mhlint-report/1");
    assert_eq!(leftovers(repository.path()), Vec::<String>::new());
}

#[test]
fn a_reader_that_goes_away_neither_hides_the_verdict_nor_the_other_reports() {
    let repository = broken();
    let mut command = Command::new(env!("CARGO_BIN_EXE_mhlint"));
    command
        .current_dir(repository.path())
        .args(["--report", "human", "--report", "json=out.json"]);
    let mut child = command
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    drop(child.stdout.take());
    let output = child.wait_with_output().unwrap();
    assert_eq!((code(&output), stderr(&output).as_str()), (Some(1), ""));
    assert!(repository.path().join("out.json").exists());
}

#[test]
fn two_reports_one_to_a_file() {
    let repository = broken();
    let output = mhlint(
        repository.path(),
        &["--report", "human", "--report", "concise=out.txt"],
    );
    assert_eq!(code(&output), Some(1));
    assert!(stdout(&output).contains("Failed:"));
    let file = fs::read_to_string(repository.path().join("out.txt")).unwrap();
    assert!(
        file.contains("error[macro-steps-length]") && file.contains("fail: "),
        "{file}"
    );
}

#[test]
fn reports_that_would_collide_are_refused() {
    let repository = project("fixtures/makehuman2");
    assert_refused(
        &mhlint(&repository, &["--report", "json", "--report", "human"]),
        &["--report FORMAT=FILE"],
    );
    let same = ["--report", "json=/tmp/x", "--report", "human=/tmp/x"];
    assert_refused(
        &mhlint(&repository, &same),
        &["use a different file for each"],
    );
    let spelt = ["--report", "json=x", "--report", "human=./x"];
    assert_refused(
        &mhlint(&repository, &spelt),
        &["use a different file for each"],
    );
}

#[test]
fn a_report_that_cannot_be_written_is_refused_before_the_run() {
    let repository = example();
    assert_refused(
        &mhlint(repository.path(), &["--report", "json=no/such/r.json"]),
        &["folder `no/such` does not exist", "create it"],
    );
    assert_refused(
        &mhlint(repository.path(), &["--report", "json=data"]),
        &["is a folder", "use a file in it"],
    );
    assert_refused(
        &mhlint(repository.path(), &["--report", "json="]),
        &["json=report.txt"],
    );
}

#[cfg(unix)]
#[test]
fn a_report_goes_to_where_a_link_leads_even_if_nothing_is_there_yet() {
    use std::os::unix::fs::symlink;
    let repository = example();
    let at = |name: &str| repository.path().join(name);
    for (link, target) in [
        ("new.json", "user/report.json"),
        ("gone.json", "no/such/r.json"),
        ("round.json", "round.json"),
    ] {
        symlink(target, at(link)).unwrap();
    }
    assert_eq!(
        code(&mhlint(repository.path(), &["--report", "json=new.json"])),
        Some(0)
    );
    assert!(at("new.json").is_symlink() && at("user/report.json").is_file());
    assert_refused(
        &mhlint(repository.path(), &["--report", "json=gone.json"]),
        &["which the link leads to"],
    );
    assert!(at("gone.json").is_symlink());
    assert_refused(
        &mhlint(repository.path(), &["--report", "json=round.json"]),
        &["leads back to itself"],
    );
}

#[test]
fn bent_quotes_get_their_remedy() {
    let repository = example();
    let file = repository.path().join("data/base/figure/base.json");
    let text = fs::read_to_string(&file).unwrap();
    fs::write(
        &file,
        text.replace("\"numverts\"", "\u{201c}numverts\u{201d}"),
    )
    .unwrap();
    let output = stdout(&mhlint(repository.path(), &["--only", "json-syntax"]));
    assert!(output.contains("replace the curly quotes"), "{output}");
}

#[test]
fn notes_go_to_stderr_for_programs_and_into_the_human_report() {
    let repository = example();
    fs::write(
        repository.path().join("data/models/figure/visitor.blend"),
        "",
    )
    .unwrap();
    let human = mhlint(repository.path(), &[]);
    let text = stdout(&human).replace('\n', " ");
    assert!(text.contains(".blend (no rules yet)"), "{text}");
    assert_eq!(stderr(&human), "");
    let gitlab = mhlint(repository.path(), &["--report", "gitlab"]);
    assert!(
        stderr(&gitlab).contains(".blend (no rules yet)"),
        "{}",
        stderr(&gitlab)
    );
    assert!(!stdout(&gitlab).contains("no rules yet"));
    let concise = mhlint(repository.path(), &["--report", "concise"]);
    assert_eq!(stderr(&concise), "");
    assert!(
        stdout(&concise).contains("; not checked: ")
            && stdout(&concise).contains(".blend (no rules yet)"),
        "{}",
        stdout(&concise)
    );
    assert_eq!(
        stderr(&mhlint(
            repository.path(),
            &["--report", "concise", "--quiet"]
        )),
        ""
    );
}

#[test]
fn quiet_leaves_findings_and_verdict() {
    let output = mhlint(
        broken().path(),
        &["--quiet", "--only", "macro-steps-length"],
    );
    let text = stdout(&output);
    assert!(
        text.contains("error[macro-steps-length]") && text.contains("Failed:"),
        "{text}"
    );
    assert!(
        !text.contains("more: mhlint explain") && !text.contains(" infos in "),
        "{text}"
    );
}

#[test]
fn timings_go_to_stderr() {
    let output = mhlint(
        &project("fixtures"),
        &["makehuman2", "makehuman1", "mpfb", "--timings"],
    );
    assert!(!stdout(&output).contains(" ms  "));
    let text = stderr(&output);
    let lines: Vec<(f64, &str)> = text
        .lines()
        .filter_map(|line| line.split_once(" ms  "))
        .map(|(time, what)| (time.trim().parse().unwrap(), what))
        .collect();
    let steps = ["places", "read", "rules", "targets and evaluation"];
    let (total, rest) = lines.split_first().unwrap();
    let (timed, rules): (Vec<_>, Vec<_>) = rest.iter().partition(|(_, what)| steps.contains(what));
    assert_eq!((total.1, timed.len()), ("total", steps.len()), "{text}");
    assert!(
        (timed.iter().map(|(time, _)| time).sum::<f64>() - total.0).abs() < 0.01,
        "{text}"
    );
    for times in [&timed, &rules] {
        assert!(times.is_sorted_by(|one, next| one.0 >= next.0), "{text}");
    }
    // Those that take no time are counted.
    let left = text
        .lines()
        .last()
        .filter(|line| line.ends_with(" below 1 ms"));
    let left = left.map_or(0, |line| {
        line.trim()
            .split(' ')
            .next()
            .unwrap()
            .parse::<usize>()
            .unwrap()
    });
    let known = stdout(&mhlint(&project("."), &["rules", "--format", "json"]));
    let known: serde_json::Value = serde_json::from_str(&known).unwrap();
    assert_eq!(
        rules.len() + left,
        known.as_array().unwrap().len(),
        "{text}"
    );
}

#[test]
fn piped_output_has_no_escape_sequences_unless_asked_for() {
    let repository = broken();
    let has_escapes = |args: &[&str]| mhlint(repository.path(), args).stdout.contains(&0x1b);
    assert!(!has_escapes(&[]));
    assert!(has_escapes(&["--color", "always"]));
    assert!(!has_escapes(&["--color", "never"]));
    assert!(has_escapes(&[
        "explain",
        "macro-steps-length",
        "--color",
        "always"
    ]));
    assert!(!has_escapes(&["explain", "macro-steps-length"]));
}

#[test]
fn the_environment_decides_on_colour_and_the_option_over_it() {
    let repository = broken();
    let has_escapes = |name: &str, args: &[&str]| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_mhlint"));
        command
            .env_clear()
            .env(name, "1")
            .current_dir(repository.path())
            .args(args);
        command.output().unwrap().stdout.contains(&0x1b)
    };
    assert!(has_escapes("CLICOLOR_FORCE", &[]));
    assert!(!has_escapes("CLICOLOR_FORCE", &["--color", "never"]));
    assert!(!has_escapes("NO_COLOR", &[]));
    assert!(has_escapes("NO_COLOR", &["--color", "always"]));
    assert!(!has_escapes("CI", &[]));
}

#[test]
fn a_report_in_a_file_has_no_colour() {
    let repository = broken();
    mhlint(
        repository.path(),
        &["--color", "always", "--report", "human=out.txt"],
    );
    assert!(
        !fs::read(repository.path().join("out.txt"))
            .unwrap()
            .contains(&0x1b)
    );
}

#[test]
fn a_closed_pipe_is_no_error() {
    let mut command = Command::new(env!("CARGO_BIN_EXE_mhlint"));
    command
        .current_dir(project("fixtures/makehuman2"))
        .args(["rules", "--format", "json"]);
    let mut child = command
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    drop(child.stdout.take());
    let mut text = String::new();
    child
        .stderr
        .take()
        .unwrap()
        .read_to_string(&mut text)
        .unwrap();
    let status = child.wait().unwrap();
    assert_eq!((status.code(), text.as_str()), (Some(0), ""));
}

#[test]
fn every_rule_can_be_explained_by_its_fixtures() {
    let output = mhlint(&project("."), &["rules", "--format", "json"]);
    let rules: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    for rule in rules.as_array().unwrap() {
        let id = rule["id"].as_str().unwrap();
        let output = mhlint(&project("."), &["explain", id]);
        let text = stdout(&output);
        assert_eq!(code(&output), Some(0), "{id}");
        for part in ["Bad: ", "  reports", &format!("[{id}]"), "Good: "] {
            assert!(
                text.contains(part),
                "no `{part}` in the page of {id}:\n{text}"
            );
        }
        let (_, good) = text.split_once("Good: ").unwrap();
        assert!(
            good.contains("  reports nothing") && !good.contains(&format!("[{id}]")),
            "{id}:\n{good}"
        );
    }
}

#[test]
fn explain_shows_the_change_and_the_finding() {
    let page = stdout(&mhlint(&project("."), &["explain", "macro-steps-length"]));
    let text = page.replace("\n    `age`", " `age`");
    for line in [
        "    - \"steps\": [0.0, 0.25, 0.5, 1.0]",
        "    + \"steps\": [0.0, 0.25, 0.5, 0.75, 1.0]",
        "MakeHuman 2: crashes with `IndexError`",
        "component `age` has 4 values but 5 steps",
    ] {
        assert!(text.contains(line), "no `{line}` in:\n{text}");
    }
}

#[test]
fn explain_lists_a_family() {
    for name in ["macro", "macro-", "macro-*"] {
        let output = mhlint(&project("."), &["explain", name]);
        assert_eq!(code(&output), Some(0));
        assert!(
            stdout(&output).contains("macro-steps-length")
                && !stdout(&output).contains("target-syntax")
        );
    }
}

#[test]
fn rules_come_as_table_json_and_markdown() {
    let list = |format| stdout(&mhlint(&project("."), &["rules", "--format", format]));
    assert!(
        list("table")
            .lines()
            .any(|line| line.starts_with("macro-steps-length") && line.contains("error"))
    );
    assert!(list("markdown").contains("| `macro-steps-length` | error |"));
    let json: serde_json::Value = serde_json::from_str(&list("json")).unwrap();
    let rules = json.as_array().unwrap();
    assert!(rules.is_sorted_by_key(|rule| rule["id"].as_str().unwrap()));
    for key in [
        "id",
        "family",
        "level",
        "summary",
        "fix",
        "unmutable",
        "breaks",
        "options",
    ] {
        assert!(rules.iter().all(|rule| !rule[key].is_null()), "{key}");
    }
}

#[test]
fn schemas_are_listed_and_printed() {
    let names = stdout(&mhlint(&project("."), &["schema"]));
    assert!(names.lines().any(|name| name == "report"));
    for name in names.lines() {
        let text = stdout(&mhlint(&project("."), &["schema", name]));
        let schema: serde_json::Value = serde_json::from_str(&text).unwrap();
        assert_eq!(
            schema["$schema"], "https://json-schema.org/draft/2020-12/schema",
            "{name}"
        );
    }
}

#[test]
fn completions_know_commands_and_options() {
    for (shell, words) in [
        ("bash", ["complete -F _mhlint", "--max-warnings", "explain"]),
        ("zsh", ["#compdef mhlint", "--max-warnings", "explain"]),
        ("fish", ["complete -c mhlint", "-l max-warnings", "explain"]),
        (
            "powershell",
            ["Register-ArgumentCompleter", "--max-warnings", "explain"],
        ),
        ("elvish", ["edit:completion", "--max-warnings", "explain"]),
    ] {
        let output = mhlint(&project("."), &["completions", shell]);
        assert_eq!(
            (code(&output), stderr(&output).as_str()),
            (Some(0), ""),
            "{shell}"
        );
        for word in words {
            assert!(stdout(&output).contains(word), "{shell}: no `{word}`");
        }
    }
    assert_refused(&mhlint(&project("."), &["completions", "bsh"]), &["bash"]);
}

#[test]
fn bash_completes_what_is_typed() {
    let script = stdout(&mhlint(&project("."), &["completions", "bash"]));
    for (words, answer) in [
        (["--max"].as_slice(), "--max-warnings"),
        (&["explain", "base-mis"], "base-missing-file"),
        (&["--only", "macro-steps-l"], "macro-steps-length"),
        (&["check", "--skip", "json-sy"], "json-syntax"),
    ] {
        let (last, before) = (
            words.last().unwrap(),
            words.iter().rev().nth(1).unwrap_or(&"mhlint"),
        );
        let ask = format!(
            "\nCOMP_WORDS=(mhlint {})\nCOMP_CWORD={}\n_mhlint mhlint {last} {before}\necho \"${{COMPREPLY[@]}}\"\n",
            words.join(" "),
            words.len()
        );
        let Ok(output) = Command::new("bash")
            .args(["-c", &(script.clone() + &ask)])
            .output()
        else {
            println!("left out: no bash");
            return;
        };
        assert_eq!(stdout(&output).trim(), answer, "{}", stderr(&output));
    }
}

#[test]
fn man_pages_of_the_command_and_its_commands() {
    let page = |words: &[&str]| {
        let output = mhlint(&project("."), &[&["man"], words].concat());
        assert_eq!(
            (code(&output), stderr(&output).as_str()),
            (Some(0), ""),
            "{words:?}"
        );
        stdout(&output)
    };
    let whole = page(&[]);
    for part in [
        ".TH mhlint 1",
        ".SH NAME",
        ".SH OPTIONS",
        "\\-\\-max\\-warnings",
        "mhlint\\-eval(1)",
        "Exit codes",
    ] {
        assert!(whole.contains(part), "no `{part}` in:\n{whole}");
    }
    assert!(page(&["check"]).contains(".TH mhlint-check 1"));
    assert!(page(&["eval", "mesh"]).contains("mhlint\\-eval\\-mesh"));
    assert_refused(
        &mhlint(&project("."), &["man", "chek"]),
        &["did you mean `check`"],
    );
}

#[test]
fn help_and_version_go_to_stdout() {
    for (args, words) in [
        (["--help"], "Exit codes"),
        (["--version"], env!("CARGO_PKG_VERSION")),
    ] {
        let output = mhlint(&project("."), &args);
        assert_eq!((code(&output), stderr(&output).as_str()), (Some(0), ""));
        assert!(stdout(&output).contains(words));
    }
}

/// No line that a CI system takes for a command, nothing that steers a terminal.
#[track_caller]
fn assert_harmless(output: &Output) {
    let text = stdout(output) + &stderr(output);
    assert!(
        !text.contains('\u{1b}') && text.lines().all(|line| !line.starts_with("::")),
        "{text}"
    );
    assert!(text.contains("\u{fffd}::error::pwned"), "{text}");
}

#[cfg(unix)]
#[test]
fn names_in_errors_steer_neither_terminal_nor_ci() {
    let repository = example();
    let root = repository.path();
    fs::create_dir(root.join("data/base/evil\n::error::pwned")).unwrap();
    fs::write(root.join("data/base/evil\n::error::pwned/base.json"), "{}").unwrap();
    fs::write(
        root.join("data/base/evil\n::error::pwned/base.obj"),
        "v 0 0 0\n",
    )
    .unwrap();
    assert_harmless(&mhlint(root, &["data", "--base", "nope"]));
    assert_harmless(&mhlint(root, &["x\n::error::pwned\u{1b}[31m"]));
    let case = r#"{"kind": "mh2_macro_weights", "cases": [{"name": "a\n::error::pwned\u001b[31m", "inputs": {"modifiers": 1}}]}"#;
    fs::write(root.join("cases.json"), case).unwrap();
    assert_harmless(&mhlint(
        root,
        &[
            "eval",
            "cases",
            "cases.json",
            "--compare",
            "--root",
            "makehuman2=data",
        ],
    ));
    assert_harmless(&mhlint(
        root,
        &[
            "eval",
            "mesh",
            "data",
            "--base",
            "x\n::error::pwned\u{1b}[31m",
        ],
    ));
    fs::write(
        root.join("mhlint.toml"),
        "\"a\\n::error::pwned\\u001b[31m\" = 1\n",
    )
    .unwrap();
    let output = mhlint(root, &["data"]);
    assert_harmless(&output);
    assert!(
        stderr(&output).starts_with("mhlint: mhlint.toml:1:1: unknown key `a \u{fffd}::"),
        "{}",
        stderr(&output)
    );
}

#[test]
fn a_report_does_not_take_the_place_of_an_asset() {
    let repository = broken();
    let root = repository.path();
    let asset = "data/target/figure/macro.json";
    let before = fs::read(root.join(asset)).unwrap();
    for path in [".", "data", "data/target", "user"] {
        let checked = if path == "user" {
            "user/target/figure/macro.json"
        } else {
            asset
        };
        fs::create_dir_all(root.join("user/target/figure")).unwrap();
        fs::write(root.join("user/target/figure/macro.json"), &before).unwrap();
        let output = mhlint(root, &[path, "--report", &format!("json={checked}")]);
        assert_refused(
            &output,
            &[checked, "is an asset", "use a file outside the data"],
        );
    }
    assert_eq!(fs::read(root.join(asset)).unwrap(), before);
    fs::write(root.join("loose.target"), "1 0.1 0.2 0.3\n").unwrap();
    assert_refused(
        &mhlint(root, &["loose.target", "--report", "json=loose.target"]),
        &["is an asset"],
    );
    let in_system = format!("json={asset}");
    assert_refused(
        &mhlint(root, &["user", "--system", "data", "--report", &in_system]),
        &["is an asset"],
    );
    // Beside the assets a report is welcome, again and again.
    for file in [
        "r.json",
        "data/r.json",
        "data/target/figure/r.html",
        "r.json",
        "data/r.json",
    ] {
        assert_eq!(
            code(&mhlint(root, &[".", "--report", &format!("json={file}")])),
            Some(1),
            "{file}"
        );
    }
}

#[test]
fn a_report_follows_a_link_to_a_file_that_is_not_there_yet() {
    let repository = broken();
    let link = repository.path().join("link.json");
    fs::create_dir(repository.path().join("reports")).unwrap();
    std::os::unix::fs::symlink("reports/new.json", &link).unwrap();
    mhlint(repository.path(), &["--report", "json=link.json"]);
    assert!(fs::symlink_metadata(&link).unwrap().is_symlink());
    assert!(repository.path().join("reports/new.json").is_file());
}

#[test]
fn options_that_would_be_swallowed_are_refused() {
    let repository = broken();
    for fixing in ["--diff", "--fix"] {
        let output = mhlint(
            repository.path(),
            &["--baseline", "b.json", "--write-baseline", fixing],
        );
        assert_refused(
            &output,
            &["--write-baseline", fixing, "cannot be used with"],
        );
    }
    assert!(!repository.path().join("b.json").exists());
    let quiet = mhlint(repository.path(), &["--fix", "--quiet"]);
    assert_eq!((code(&quiet), stderr(&quiet).as_str()), (Some(1), ""));
    let timed = mhlint(repository.path(), &["--diff", "--timings"]);
    assert!(stderr(&timed).contains(" ms  read"), "{}", stderr(&timed));
}

#[test]
fn every_refused_write_names_a_remedy() {
    let repository = example();
    let root = repository.path();
    let long = "n".repeat(256);
    let baseline = ["--baseline", long.as_str(), "--write-baseline"];
    assert_refused(
        &mhlint(root, &baseline),
        &["cannot write the baseline", "use another file"],
    );
    let mesh = |file: &str| mhlint(root, &["eval", "mesh", "data", "-o", file]);
    assert_refused(
        &mesh(&long),
        &["cannot write the result", "use another file"],
    );
    assert_refused(
        &mesh("no/such.obj"),
        &["folder `no` does not exist", "create it first"],
    );
    assert_refused(&mesh("data"), &["it is a folder", "use a file in it"]);
    if Path::new("/proc/self").is_dir() {
        assert_refused(
            &mhlint(root, &["init", "/proc/self"]),
            &["/proc/self/mhlint.toml", "; use "],
        );
    }
}

#[test]
fn an_unknown_option_is_not_taken_for_a_value() {
    let repository = example();
    for args in [
        &["--lvl"][..],
        &[
            "eval", "skeleton", "data", "--base", "figure", "--rig", "foo",
        ],
    ] {
        let output = mhlint(repository.path(), args);
        assert_refused(&output, &["unexpected argument", "--help"]);
        assert!(
            !stderr(&output).contains("as a value"),
            "{}",
            stderr(&output)
        );
    }
}

#[test]
fn the_verdict_claims_no_more_than_was_reported() {
    let repository = broken();
    let verdict = |args: &[&str]| {
        let output = mhlint(repository.path(), &[&["--quiet"], args].concat());
        assert_eq!(code(&output), Some(0), "{args:?}: {}", stdout(&output));
        stdout(&output).replace('\n', " ")
    };
    for (args, said) in [
        (
            &["data/target/figure/head"][..],
            "Passed: no findings in `data/target/figure/head`; everything else was left out.",
        ),
        (
            &["--only", "json-*"],
            "Passed: no findings from the rules `json-*`; everything else was left out.",
        ),
        (
            &["--skip", "macro-*"],
            "Passed: no findings without the rules `macro-*`; everything else was left out.",
        ),
        (
            &["--level", "macro-*=off"],
            "Passed: no findings without the rules `macro-*`; everything else was left out.",
        ),
        (
            &["data/rigs", "--base", "figure", "--only", "json-*"],
            "Passed: no findings in `data/rigs` for the base mesh `figure` from the rules `json-*`; everything else was left out.",
        ),
    ] {
        assert!(
            verdict(args).starts_with(said),
            "{args:?}: {}",
            verdict(args)
        );
    }
    fs::write(
        repository.path().join("mhlint.toml"),
        "select = [\"json-*\"]\n",
    )
    .unwrap();
    assert!(verdict(&[]).contains("Passed: no findings from the rules `json-*`;"));
}

/// Applies what `--diff` shows in `folder` with a program that reads patches from standard input.
fn apply(program: &[&str], folder: &Path, diff: &[u8]) -> bool {
    use std::io::Write;
    let mut command = Command::new(program[0]);
    command
        .args(&program[1..])
        .current_dir(folder)
        .stdin(Stdio::piped())
        .stdout(Stdio::null())
        .stderr(Stdio::null());
    // A machine without the program shows nothing; the other one is asked as well.
    let Ok(mut child) = command.spawn() else {
        return true;
    };
    child.stdin.take().unwrap().write_all(diff).unwrap();
    child.wait().unwrap().success()
}

#[test]
fn what_diff_shows_is_a_patch() {
    let repository = example();
    let root = repository.path();
    let oval = "da ta/target/figure/head/head-oval.target";
    fs::rename(root.join("data"), root.join("da ta")).unwrap();
    crate::scratch::edit(root, oval, "339 0 .001 .001", "339 0 0 0");
    let whole = root.join("da ta");
    for (from, path, said) in [
        ("", "da ta", ""),
        ("", ".", ""),
        ("user", "../da ta", "the patch is for the folder `..`"),
        ("", whole.to_str().unwrap(), ""),
        ("da ta/target", ".", ""),
    ] {
        let folder = root.join(from);
        let output = mhlint(&folder, &[path, "--diff"]);
        assert_eq!(code(&output), Some(1), "{}", stderr(&output));
        assert!(
            stderr(&output).contains(said),
            "{from} {path}: {}",
            stderr(&output)
        );
        let above = folder.join(if stderr(&output).contains("the folder `..`") {
            ".."
        } else {
            ""
        });
        for program in [
            &["patch", "-p1", "--dry-run"][..],
            &["git", "apply", "--check"],
        ] {
            assert!(
                apply(program, &above, &output.stdout),
                "{program:?} {from} {path}: {}",
                stdout(&output)
            );
        }
    }
}
