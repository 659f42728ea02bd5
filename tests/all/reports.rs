//! The reports: JSON and SARIF against their schemas, the others as their readers take them apart,
//! and names from assets that try to get out of each format.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;
use std::process::Command;

use crate::scratch::{
    assert_refused, command, edit, example, lose_a_step, mhlint, project, stderr, stdout,
};
use serde_json::Value;

const FOLDER: &str = "data/target/figure/head/";

/// A copy of the example repository with two errors in two files.
fn broken() -> tempfile::TempDir {
    let repository = crate::scratch::broken();
    edit(
        repository.path(),
        "data/target/figure/head/head-oval.target",
        "339 0 .001 .001",
        "339 0 0,001 .001",
    );
    add_unchecked(repository.path());
    repository
}

/// A file of a kind that no rule is about.
fn add_unchecked(root: &Path) {
    fs::write(root.join("data/models/figure/visitor.blend"), "").unwrap();
}

fn run(root: &Path, args: &[&str]) -> String {
    stdout(&mhlint(root, args))
}

#[test]
fn json_reports_fit_their_schema() {
    let schema: Value =
        serde_json::from_str(&fs::read_to_string(project("schemas/report.schema.json")).unwrap())
            .unwrap();
    let validator = jsonschema::validator_for(&schema).unwrap();
    let other = example();
    fs::create_dir_all(other.path().join("other/targets")).unwrap();
    fs::write(other.path().join("other/targets/target.json"), "{}").unwrap();
    let empty = tempfile::tempdir().unwrap();
    for root in [
        broken().path(),
        other.path(),
        empty.path(),
        &project("fixtures/makehuman2"),
    ] {
        let report: Value = serde_json::from_str(&run(root, &["--report", "json"])).unwrap();
        let faults: Vec<String> = validator
            .iter_errors(&report)
            .map(|fault| format!("{}: {fault}", fault.instance_path()))
            .collect();
        assert_eq!(faults, Vec::<String>::new());
    }
}

#[test]
fn json_has_a_verdict_for_what_was_checked_and_names_what_was_not() {
    let repository = broken();
    // Without meshes and settings: with less it would be a copy of some files.
    for path in [
        "targets/target.json",
        "mesh_metadata/hm08_config.json",
        "node_trees/a.json",
        "rigs/standard/rig.a.json",
    ] {
        let path = repository.path().join("other").join(path);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, "{}").unwrap();
    }
    let report: Value =
        serde_json::from_str(&run(repository.path(), &["--report", "json"])).unwrap();
    let verdict = |name: &str| serde_json::json!({ "application": name, "verdict": "fail" });
    assert_eq!(
        report["applications"],
        serde_json::json!([verdict("makehuman2"), verdict("mpfb")])
    );
    let [kinds] = report["not_checked"].as_array().unwrap().as_slice() else {
        panic!("{report}")
    };
    assert_eq!(
        (&kinds["application"], &kinds["what"]),
        (&Value::from("makehuman2"), &Value::from("kind"))
    );
    for finding in report["findings"].as_array().unwrap() {
        let levels: Vec<&Value> = finding["breaks"]
            .as_array()
            .unwrap()
            .iter()
            .map(|one| &one["level"])
            .collect();
        assert_eq!(levels, [&finding["level"]], "one application, one level");
    }
}

#[test]
fn json_counts_what_it_lists() {
    let report: Value = serde_json::from_str(&run(broken().path(), &["--report", "json"])).unwrap();
    let listed = report["findings"].as_array().unwrap();
    for level in ["error", "warning", "info"] {
        let count = listed
            .iter()
            .filter(|finding| finding["level"] == level)
            .count() as u64;
        assert_eq!(report["summary"][level].as_u64(), Some(count), "{level}");
    }
    assert_eq!(report["verdict"], "fail");
}

#[test]
fn all_reports_tell_the_same_findings() {
    let repository = broken();
    let report: Value =
        serde_json::from_str(&run(repository.path(), &["--report", "json"])).unwrap();
    let concise = run(repository.path(), &["--report", "concise"]);
    let human = run(repository.path(), &[]);
    let findings = report["findings"].as_array().unwrap();
    assert_eq!(concise.lines().count(), findings.len() + 1);
    for finding in findings {
        let rule = finding["rule"].as_str().unwrap();
        assert!(
            concise.contains(&format!("[{rule}]")) && human.contains(&format!("[{rule}]")),
            "{rule}"
        );
    }
}

#[test]
fn human_report_shows_source_consequence_and_help() {
    let text = run(broken().path(), &["--only", "macro-steps-length"]);
    for part in [
        "data/target/figure/macro.json\n",
        "  error[macro-steps-length] component `age` has 4 values but 5 steps",
        "MakeHuman 2: crashes with `IndexError`",
        "[data/target/figure/macro.json:11:22]",
        "11 |",
        "^^^^",
        "  help: add a value for every step",
        "  more: mhlint explain macro-steps-length",
        "1 error, 0 warnings, 0 infos in ",
        "Failed: 1 error. MakeHuman 2 would",
    ] {
        assert!(text.contains(part), "no `{part}` in:\n{text}");
    }
}

#[test]
fn human_report_fits_eighty_columns_and_ascii_when_piped() {
    let text = run(broken().path(), &[]);
    assert!(text.is_ascii(), "{text}");
    let wide: Vec<&str> = text.lines().filter(|line| line.len() > 80).collect();
    assert_eq!(wide, Vec::<&str>::new());
}

#[test]
fn human_report_begins_with_the_gravest_and_ends_with_a_line_for_each_info() {
    let repository = broken();
    edit(
        repository.path(),
        "data/target/figure/head/head-oval.target",
        "340 -.001 .001 .001",
        "340 0 0 0",
    );
    let text = run(repository.path(), &[]);
    let at = |part: &str| {
        text.find(part)
            .unwrap_or_else(|| panic!("no `{part}` in:\n{text}"))
    };
    assert!(at("error[macro-steps-length]") < at("1 info (no visible effect today;"));
    assert!(
        text.contains("\n  data/target/figure/head/head-oval.target:6:1: info[target-zero-delta] "),
        "{text}"
    );
    assert!(!text.contains("explain target-zero-delta"), "{text}");
    let full = run(repository.path(), &["--full"]);
    assert!(
        full.contains("explain target-zero-delta") && !full.contains("no visible effect today;"),
        "{full}"
    );
}

#[test]
fn infos_of_one_rule_in_a_folder_share_a_line() {
    let repository = many(14);
    let args = [
        "--only",
        "target-breaks-start",
        "--level",
        "target-breaks-start=info",
    ];
    let text = run(repository.path(), &args);
    let names: Vec<String> = [1, 10, 11, 12, 13]
        .map(|number| format!("`broken{number}.target`"))
        .into();
    let first = format!("  {FOLDER}broken0.target:1:5: info[target-breaks-start] ");
    let rest = format!("; 13 more like it: {} and 8 more\n", names.join(", "));
    assert!(
        text.contains(&first)
            && text.contains(&rest)
            && text.contains("14 infos (no visible effect today;"),
        "{text}"
    );
    assert_eq!(text.matches("info[").count(), 1, "{text}");
    let full = run(repository.path(), &[&args[..], &["--full"]].concat());
    assert_eq!(
        full.matches("info[target-breaks-start]").count(),
        14,
        "{full}"
    );
}

#[test]
fn statistics_count_the_findings_of_each_rule() {
    let text = run(broken().path(), &["--statistics"]);
    let row = text
        .lines()
        .find(|line| line.contains("macro-steps-length"))
        .unwrap();
    let words: Vec<&str> = row.split_whitespace().take(3).collect();
    assert_eq!(words, ["1", "error", "macro-steps-length"]);
    assert!(
        !text.contains("help:") && text.contains("Failed: "),
        "{text}"
    );
    let refused = mhlint(broken().path(), &["--statistics", "--report", "json"]);
    assert_refused(&refused, &["--statistics", "--report human"]);
}

#[test]
fn markdown_folds_infos() {
    let repository = broken();
    edit(
        repository.path(),
        "data/target/figure/head/head-oval.target",
        "340 -.001 .001 .001",
        "340 0 0 0",
    );
    let text = run(repository.path(), &["--report", "markdown"]);
    let (loud, folded) = text
        .split_once("<details><summary>1 info</summary>\n")
        .unwrap();
    assert!(
        loud.contains("macro-steps-length") && !loud.contains("target-zero-delta"),
        "{text}"
    );
    assert!(
        folded.contains("target-zero-delta") && folded.contains("</details>"),
        "{text}"
    );
}

#[test]
fn markdown_marks_the_place_and_names_explain() {
    let text = run(
        broken().path(),
        &["--report", "markdown", "--only", "macro-steps-length"],
    );
    let marked = "     11 |             \"steps\": [0.0, 0.25, 0.5, 0.75, 1.0],\n        |                      ^^^^^^^^^^";
    assert!(text.contains(marked), "{text}");
    assert!(
        text.ends_with("\n`mhlint explain RULE` explains a rule.\n"),
        "{text}"
    );
    assert!(!run(&project("fixtures/makehuman2"), &["--report", "markdown"]).contains("explain"));
}

#[test]
fn human_report_names_what_passes() {
    let level = "macro-steps-length=warning";
    let text = run(
        broken().path(),
        &["--only", "macro-steps-length", "--level", level],
    );
    assert!(text.contains("Passed with 1 warning:"), "{text}");
}

#[test]
fn names_in_assets_cannot_steer_the_terminal() {
    let repository = example();
    let hostile = "\\u001b]0;owned\\u0007\\u001b[2Jage\\u202e";
    let macros = "data/target/figure/macro.json";
    lose_a_step(repository.path());
    edit(
        repository.path(),
        macros,
        "\"age\"",
        &format!("\"{hostile}\""),
    );
    edit(
        repository.path(),
        "data/target/figure/head/head-oval.target",
        "339 0 .001 .001",
        "339 0 \u{1b}[31mred .001",
    );
    for format in ["human", "concise"] {
        let text = run(repository.path(), &["--report", format]);
        assert!(
            text.contains("owned") && text.contains("red"),
            "{format} must show the name:\n{text}"
        );
        let steering = text
            .chars()
            .find(|c| (c.is_control() && *c != '\n') || *c == '\u{202e}');
        assert_eq!(steering, None, "{format}:\n{text}");
    }
}

#[test]
fn long_lists_are_cut_with_a_word_on_the_rest() {
    let repository = example();
    let folder = repository.path().join("data/target/figure/head");
    for number in 0..14 {
        fs::write(folder.join(format!("broken{number}.target")), "1 2 x 4\n").unwrap();
    }
    let text = run(repository.path(), &["--only", "target-breaks-start"]);
    assert_eq!(
        text.matches("error[target-breaks-start]").count(),
        10,
        "{text}"
    );
    assert!(
        text.contains("and 4 more like it; `--only target-breaks-start --full` shows all"),
        "{text}"
    );
    assert!(text.contains("14 errors, "), "{text}");
}

/// Tries to end a script, an element, a string, a section, a code span, a line; to be a command, a
/// link, a colour, a placeholder; to turn the direction of writing.
const NAME: &str = "</script><img src=x onerror=alert(1)>]]>\"'&amp;\u{1b}[31m\u{202e}gnp.\n::error::owned\n\
    ##[error]x `|**b** [l](x) http://x.org @me {0}";

/// The same as the name of a file, which cannot hold a slash.
const FILE: &str = "]]>\"'&<b>%0A,line=1\u{202e}\u{1b}[2J\n::warning::x`y.target";

const FORMATS: [&str; 9] = [
    "human", "concise", "json", "sarif", "github", "gitlab", "junit", "markdown", "html",
];

/// Names of a bone, a component and a target file that try to get out of every format.
fn hostile() -> tempfile::TempDir {
    let repository = broken();
    let root = repository.path();
    let name = serde_json::to_string(NAME).unwrap();
    edit(
        root,
        "data/rigs/figure/default.mhskel",
        "\"parent\": \"root\"",
        &format!("\"parent\": {name}"),
    );
    edit(
        root,
        "data/target/figure/macro.json",
        "\"age\": {",
        &format!("{name}: {{"),
    );
    let file = root.join("data/target/figure/head").join(FILE);
    fs::write(file, "1 2 </script>::error::x]]> 4\n").unwrap();
    repository
}

fn json(root: &Path, format: &str) -> Value {
    serde_json::from_str(&run(root, &["--report", format])).unwrap()
}

fn findings(root: &Path) -> Vec<Value> {
    json(root, "json")["findings"].as_array().unwrap().clone()
}

#[test]
fn nothing_from_an_asset_steers_a_terminal_or_a_ci_system() {
    let repository = hostile();
    let rules: BTreeSet<String> = findings(repository.path())
        .iter()
        .map(|finding| finding["rule"].as_str().unwrap().to_owned())
        .collect();
    for rule in [
        "skeleton-unknown-parent",
        "macro-steps-length",
        "target-breaks-start",
    ] {
        assert!(rules.contains(rule), "{rules:?}");
    }
    for format in FORMATS {
        let text = run(repository.path(), &["--report", format]);
        let steering = text.chars().find(|c| c.is_control() && *c != '\n');
        assert_eq!(steering, None, "{format}");
        // Programs that read these three know how to show a name, and have to find the file by its
        // own.
        if !["json", "sarif", "gitlab"].contains(&format) {
            assert!(!text.contains('\u{202e}'), "{format}");
            assert!(!text.contains("##["), "{format}");
        }
        if format != "github" {
            assert!(
                !text.lines().any(|line| line.trim_start().starts_with("::")),
                "{format}:\n{text}"
            );
        }
        assert!(text.contains("owned"), "{format} has to show the name");
    }
}

#[test]
fn json_keeps_names_as_they_are() {
    let repository = hostile();
    let all = findings(repository.path());
    assert!(
        all.iter()
            .any(|one| one["message"].as_str().unwrap().contains(NAME))
    );
    assert!(
        all.iter()
            .any(|one| one["path"].as_str().unwrap().ends_with(FILE))
    );
}

#[test]
fn sarif_fits_its_schema_and_refers_to_its_rules() {
    // The published pattern of a language has a bracket too many, which strict readers refuse.
    let text = fs::read_to_string(project("tests/schemas/sarif-2.1.0.json"))
        .unwrap()
        .replace("]?$\"", "$\"");
    let validator = jsonschema::validator_for(&serde_json::from_str(&text).unwrap()).unwrap();
    let empty = tempfile::tempdir().unwrap();
    let fixable = example();
    edit(
        fixable.path(),
        "data/target/figure/head/head-oval.target",
        "339 0 .001 .001",
        "339 0 0 0",
    );
    for root in [
        broken().path(),
        hostile().path(),
        fixable.path(),
        empty.path(),
        &project("fixtures/makehuman2"),
    ] {
        let log = json(root, "sarif");
        let faults: Vec<String> = validator
            .iter_errors(&log)
            .map(|fault| format!("{}: {fault}", fault.instance_path()))
            .collect();
        assert_eq!(faults, Vec::<String>::new());
        let run = &log["runs"][0];
        let results = run["results"].as_array().unwrap();
        assert_eq!(results.len(), findings(root).len());
        for result in results {
            let index = usize::try_from(result["ruleIndex"].as_u64().unwrap()).unwrap();
            let rule = &run["tool"]["driver"]["rules"][index];
            assert_eq!(rule["id"], result["ruleId"]);
            assert!(["error", "warning", "note"].contains(&result["level"].as_str().unwrap()));
            assert!(!rule["help"]["markdown"].as_str().unwrap().is_empty());
            assert_eq!(
                result["partialFingerprints"]["mhlint/v1"]
                    .as_str()
                    .unwrap()
                    .len(),
                32
            );
        }
    }
}

#[test]
fn a_sarif_uri_leads_back_to_the_file() {
    let repository = hostile();
    let log = json(repository.path(), "sarif");
    for (result, finding) in log["runs"][0]["results"]
        .as_array()
        .unwrap()
        .iter()
        .zip(findings(repository.path()))
    {
        let place = &result["locations"][0]["physicalLocation"]["artifactLocation"];
        assert_eq!(place["uriBaseId"], "%SRCROOT%");
        let path = percent_encoding::percent_decode_str(place["uri"].as_str().unwrap())
            .decode_utf8()
            .unwrap();
        assert_eq!(path, finding["path"].as_str().unwrap());
        assert!(repository.path().join(&*path).exists(), "{path}");
    }
}

#[test]
fn github_annotations_are_commands_and_nothing_else_is() {
    let repository = hostile();
    let text = run(repository.path(), &["--report", "github"]);
    let (mut commands, rest): (Vec<&str>, Vec<&str>) =
        text.lines().partition(|line| line.starts_with("::"));
    assert!(
        commands
            .pop()
            .unwrap()
            .starts_with("::notice title=mhlint::Not checked: "),
        "{text}"
    );
    assert_eq!(commands.len(), findings(repository.path()).len());
    for command in commands {
        let (head, message) = command[2..].split_once("::").unwrap();
        let (word, properties) = head.split_once(' ').unwrap();
        assert!(["error", "warning", "notice"].contains(&word), "{command}");
        let names: Vec<&str> = properties
            .split(',')
            .map(|part| part.split('=').next().unwrap())
            .collect();
        assert!(matches!(
            names.as_slice(),
            ["file", "title"] | ["file", "line", "title"] | ["file", "line", "col", "title"]
        ));
        assert!(
            !properties.contains(':') && !message.is_empty(),
            "{command}"
        );
    }
    assert_eq!(rest.len(), 2, "{rest:?}");
}

#[test]
fn the_verdict_on_settings_says_nothing_of_an_application() {
    let repository = example();
    let ignore = "[[ignore]]\nrule = \"macro-steps-length\"\npath = \"**\"\nreason = \"once\"\n";
    fs::write(repository.path().join("mhlint.toml"), ignore).unwrap();
    let verdict = |text: &str| {
        text.lines()
            .find(|line| line.starts_with("Failed: "))
            .unwrap()
            .to_owned()
    };
    let last = |args: &[&str]| verdict(&run(repository.path(), args));
    let text = "Failed: 1 warning about mhlint's settings; no findings.";
    assert_eq!(last(&["--fail-on", "warning"]), text);
    edit(
        repository.path(),
        "data/target/figure/head/head-oval.target",
        "339 0 .001 .001",
        "339 0 0 0",
    );
    let text = run(repository.path(), &[]).replace('\n', " ");
    assert!(
        text.contains("1 info: MakeHuman 2 shows the right result today. Also 1 warning about mhlint's settings."),
        "{text}"
    );
}

/// A copy of the example repository with `count` targets that cannot be read.
fn many(count: usize) -> tempfile::TempDir {
    let repository = example();
    for number in 0..count {
        let file = format!("data/target/figure/head/broken{number}.target");
        fs::write(repository.path().join(file), "1 2 x 4\n").unwrap();
    }
    add_unchecked(repository.path());
    repository
}

#[test]
fn github_annotations_are_capped_with_a_word_on_the_rest() {
    let text = run(
        many(14).path(),
        &["--report", "github", "--only", "target-breaks-start"],
    );
    assert_eq!(text.matches("::error file=").count(), 10, "{text}");
    assert!(
        text.contains("\n4 errors more: GitHub shows 10 of each level"),
        "{text}"
    );
}

fn github_step(root: &Path, summary: &Path) -> std::process::Output {
    command(root, &["--report", "github"])
        .env("GITHUB_STEP_SUMMARY", summary)
        .output()
        .unwrap()
}

#[test]
fn the_summary_of_a_github_step_is_appended() {
    let repository = broken();
    let summary = repository.path().join("summary.md");
    fs::write(&summary, "from before").unwrap();
    assert_eq!(
        github_step(repository.path(), &summary).status.code(),
        Some(1)
    );
    let text = fs::read_to_string(&summary).unwrap();
    assert!(
        text.starts_with("from before\n## mhlint: failed\n"),
        "{text}"
    );
    assert!(
        text.contains("component `age` has 4 values but 5 steps"),
        "{text}"
    );
    github_step(repository.path(), &summary);
    assert_eq!(
        fs::read_to_string(&summary)
            .unwrap()
            .matches("## mhlint: failed")
            .count(),
        2
    );
    let output = github_step(repository.path(), &repository.path().join("no/summary.md"));
    assert_eq!(output.status.code(), Some(2));
    assert!(stderr(&output).contains("GITHUB_STEP_SUMMARY"));
}

#[test]
fn the_summary_of_a_github_step_stays_below_its_limit() {
    let repository = many(60);
    let summary = repository.path().join("summary.md");
    let before = (1 << 20) - 8_000;
    fs::write(&summary, "x".repeat(before)).unwrap();
    github_step(repository.path(), &summary);
    let text = fs::read_to_string(&summary).unwrap();
    assert!(
        text.len() > before + 4_000 && text.len() <= 1 << 20,
        "{}",
        text.len()
    );
    assert!(
        text.contains("more findings** do not fit here"),
        "{}",
        &text[before..]
    );
}

#[test]
fn gitlab_issues_have_the_required_members() {
    let repository = hostile();
    let issues = json(repository.path(), "gitlab");
    let issues = issues.as_array().unwrap();
    let all = findings(repository.path());
    assert_eq!(issues.len(), all.len());
    for (issue, finding) in issues.iter().zip(&all) {
        assert_eq!(
            (&issue["check_name"], &issue["location"]["path"]),
            (&finding["rule"], &finding["path"])
        );
        assert!(["info", "major", "critical"].contains(&issue["severity"].as_str().unwrap()));
        assert!(issue["location"]["lines"]["begin"].as_u64().unwrap() > 0);
        assert!(!issue["description"].as_str().unwrap().is_empty());
    }
    assert_eq!(
        run(&project("fixtures/makehuman2"), &["--report", "gitlab"]),
        "[]\n"
    );
}

#[test]
fn gitlab_tells_the_same_fault_in_two_roots_apart() {
    let repository = broken();
    let second = repository.path().join("other");
    crate::scratch::copy_folder(&repository.path().join("data"), &second);
    let issues = json(repository.path(), "gitlab");
    let fingerprints: BTreeSet<&str> = issues
        .as_array()
        .unwrap()
        .iter()
        .map(|issue| issue["fingerprint"].as_str().unwrap())
        .collect();
    assert!(fingerprints.len() >= 4);
    assert_eq!(fingerprints.len(), issues.as_array().unwrap().len());
}

/// Names of the test cases and the number of failed ones, as an XML parser sees them.
fn junit(root: &Path, args: &[&str]) -> (Vec<String>, usize, String) {
    use quick_xml::events::Event;
    let text = run(root, &[&["--report", "junit"], args].concat());
    let mut reader = quick_xml::Reader::from_str(&text);
    let (mut names, mut failed, mut words) = (Vec::new(), 0, String::new());
    loop {
        match reader.read_event().unwrap() {
            Event::Start(start) if start.name().as_ref() == "testcase" => {
                let name = start.try_get_attribute("name").unwrap().unwrap();
                names.push(name.value.into_owned());
            }
            Event::Start(start) if start.name().as_ref() == "failure" => failed += 1,
            Event::Text(found) => words.push_str(&found),
            Event::Eof => return (names, failed, words),
            _ => {}
        }
    }
}

#[test]
fn junit_fails_what_fails_the_run() {
    let repository = hostile();
    let all = findings(repository.path());
    let errors = all
        .iter()
        .filter(|finding| finding["level"] == "error")
        .count();
    let (names, failed, words) = junit(repository.path(), &[]);
    assert_eq!((names.len(), failed), (all.len() + 1, errors));
    assert_eq!(names[0], "run");
    assert!(words.contains("owned") && !words.contains('<'));
    assert_eq!(junit(repository.path(), &["--fail-on", "never"]).1, 0);
    assert_eq!(
        junit(repository.path(), &["--fail-on", "info"]).1,
        all.len()
    );
    let too_many = [
        "--only",
        "macro-steps-length",
        "--level",
        "macro-steps-length=warning",
        "--max-warnings",
        "0",
    ];
    assert_eq!(junit(broken().path(), &too_many).1, 1);
    assert_eq!(junit(&project("fixtures/makehuman2"), &[]).1, 0);
}

#[test]
fn markdown_holds_no_markup_from_assets() {
    use pulldown_cmark::{Event, Options, Parser, Tag};
    let repository = hostile();
    let text = run(repository.path(), &["--report", "markdown"]);
    let (mut shown, mut headings) = (String::new(), 0);
    for event in Parser::new_ext(&text, Options::all()) {
        match event {
            // The one fold is ours.
            Event::Html(html)
                if ["<details><summary>2 infos</summary>\n", "</details>\n"].contains(&&*html) => {}
            Event::Html(html) | Event::InlineHtml(html) => panic!("{html} in:\n{text}"),
            Event::Start(Tag::Link { .. } | Tag::Image { .. } | Tag::Emphasis) => {
                panic!("{event:?} in:\n{text}")
            }
            Event::Start(Tag::Heading { .. }) => headings += 1,
            Event::Text(words) | Event::Code(words) => shown.push_str(&words),
            _ => {}
        }
    }
    let files: BTreeSet<String> = findings(repository.path())
        .iter()
        .map(|one| one["path"].to_string())
        .collect();
    assert_eq!(
        headings,
        files.len() + 3,
        "the title, what was not checked, and macro.json once more for infos: {text}"
    );
    assert!(
        shown.contains("</script><img src=x onerror=alert(1)>]]>\"'&amp;"),
        "{shown}"
    );
    assert!(shown.contains("**b** [l](x) http://x.org"), "{shown}");
}

#[test]
fn html_holds_one_script_and_no_markup_from_assets() {
    let page = run(hostile().path(), &["--report", "html"]);
    assert_eq!(
        (
            page.matches("<script").count(),
            page.matches("</script").count()
        ),
        (1, 1)
    );
    assert_eq!(
        (page.matches("<img").count(), page.matches("<b>").count()),
        (0, 0)
    );
    assert!(
        page.contains("&lt;/script&gt;&lt;img src=x onerror=alert(1)&gt;]]&gt;&quot;'&amp;amp;")
    );
    for target in page.split("href=\"").skip(1) {
        assert!(
            target.starts_with('#') || target.starts_with("data:,\""),
            "{}",
            &target[..40]
        );
    }
    for outside in ["url(", "@import", "src=\"", "<link rel=\"stylesheet"] {
        assert!(!page.contains(outside), "the page refers to {outside}");
    }
}

#[test]
fn html_shows_verdict_consequence_source_and_help() {
    let page = run(
        broken().path(),
        &["--report", "html", "--only", "macro-steps-length"],
    );
    for part in [
        "<h1>Failed: 1 error. MakeHuman 2 would",
        "component <code>age</code> has 4 values but 5 steps",
        "<dt>MakeHuman 2</dt><dd>crashes with <code>IndexError</code>",
        "<mark>[0.0, 0.25, 0.5, 0.75, 1.0]</mark>",
        "<dt>What to do</dt><dd>add a value for every step",
        "data/target/figure/macro.json:11:22",
        "id=\"rule-macro-steps-length\"",
    ] {
        assert!(page.contains(part), "no `{part}`");
    }
    let clean = run(&project("fixtures/makehuman2"), &["--report", "html"]);
    assert!(clean.contains("<h1>Passed: no findings") && clean.contains("There are no findings."));
}

#[test]
fn html_shows_the_fix() {
    let repository = example();
    let file = "data/target/figure/head/head-oval.target";
    edit(repository.path(), file, "339 0 .001 .001", "339 0 0 0");
    let page = run(
        repository.path(),
        &["--report", "html", "--only", "target-zero-delta"],
    );
    assert!(
        page.contains("<dt>Fix</dt><dd>remove the rows (<code>--fix</code>)</dd>"),
        "{page}"
    );
}

#[test]
fn the_end_of_a_long_report_names_the_first_errors() {
    let last = |count: usize| {
        let text = run(many(count).path(), &["--only", "target-breaks-start"]);
        let (found, _) = text.split_once("\nNot checked: ").unwrap();
        found
            .split_once("\nFailed: ")
            .unwrap()
            .1
            .lines()
            .skip(1)
            .map(str::to_owned)
            .collect::<Vec<_>>()
    };
    assert_eq!(last(3), Vec::<String>::new());
    let place = |number| {
        format!("  data/target/figure/head/broken{number}.target:1:5: target-breaks-start")
    };
    assert_eq!(
        last(4),
        [
            place("0"),
            place("1"),
            place("2"),
            "  and 1 more error".to_owned()
        ]
    );
}

#[test]
fn names_of_files_are_not_broken_at_their_hyphens() {
    let repository = example();
    let name = "head-oval-with-a-name-of-many-words-and-a-hyphen-between-each-two-of-them";
    edit(
        repository.path(),
        "data/target/figure/modelling.json",
        "\"head/head-oval\"",
        &format!("\"head/{name}\""),
    );
    let found = findings(repository.path());
    assert!(
        found
            .iter()
            .any(|one| one["message"].as_str().unwrap().contains(name)),
        "{found:?}"
    );
    let text = run(repository.path(), &[]);
    let words: BTreeSet<&str> = text.split_whitespace().collect();
    for finding in &found {
        let message = finding["message"].as_str().unwrap();
        let broken: Vec<&str> = message
            .split_whitespace()
            .filter(|word| !words.contains(word))
            .collect();
        assert_eq!(broken, Vec::<&str>::new(), "{text}");
    }
}

#[test]
fn all_reports_of_one_run_are_those_of_single_runs() {
    let repository = hostile();
    let folder = tempfile::tempdir().unwrap();
    let file = |format: &str| folder.path().join(format);
    let wanted = FORMATS.map(|format| format!("{format}={}", file(format).display()));
    let mut args: Vec<&str> = wanted
        .iter()
        .flat_map(|target| ["--report", target.as_str()])
        .collect();
    args.extend(["--report", "concise"]);
    let output = mhlint(repository.path(), &args);
    assert_eq!(output.status.code(), Some(1), "{}", stderr(&output));
    assert_eq!(output.stdout, fs::read(file("concise")).unwrap());
    for format in FORMATS {
        let alone = run(repository.path(), &["--report", format]);
        assert_eq!(fs::read_to_string(file(format)).unwrap(), alone, "{format}");
    }
}

#[test]
#[ignore = "needs Chromium; tests/browser/run.sh prepares it"]
fn html_works_in_a_browser() {
    let mut script = Command::new(project("tests/browser/run.sh"));
    assert!(
        script
            .env("MHLINT", env!("CARGO_BIN_EXE_mhlint"))
            .status()
            .unwrap()
            .success()
    );
}
