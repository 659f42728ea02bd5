//! SARIF 2.1.0, as the standard says and as code scanning on GitHub accepts it.

use std::io::{self, Write};

use percent_encoding::{AsciiSet, NON_ALPHANUMERIC, utf8_percent_encode};
use serde::{Serialize, Serializer};
use serde_json::{Map, Value, json};

use super::matrix::{Tally, tallies};
use super::note::step;
use super::standing::{Standing, folder};
use super::{View, phrase, printable, unchecked_line};
use mhlint_diag::{
    Application, AssetGroup, Finding, Fix, Level, Location, Outcome, Related, Replaced, RuleInfo,
};

/// Results that GitHub accepts in one run; it refuses the whole file beyond.
const RESULTS: usize = 25_000;

/// Places of one result that GitHub shows.
const PLACES: usize = 100;

/// What may stand in a path of a URI as it is.
const PATH: &AsciiSet = &NON_ALPHANUMERIC
    .remove(b'/')
    .remove(b'-')
    .remove(b'.')
    .remove(b'_')
    .remove(b'~');

/// Writes the log with its one run.
pub(super) fn write(outcome: &Outcome, view: &View<'_>, out: &mut dyn Write) -> io::Result<()> {
    let findings = gravest(&outcome.findings);
    let rules = used(&findings, view.rules);
    let head = json!({
        "tool": { "driver": {
            "name": crate::NAME,
            "semanticVersion": env!("CARGO_PKG_VERSION"),
            "shortDescription": { "text": crate::DESCRIPTION },
            "rules": rules.iter().map(|rule| descriptor(rule)).collect::<Vec<_>>(),
        }},
        "invocations": [{
            "executionSuccessful": outcome.is_whole(),
            "toolExecutionNotifications": notifications(outcome, findings.len()),
        }],
        "properties": { "consumers": consumers(outcome) },
        "columnKind": "unicodeCodePoints",
        // As Python counts lines, and with it the applications.
        "newlineSequences": ["\r\n", "\n", "\r"],
        "originalUriBaseIds": { "%SRCROOT%": {
            "description": { "text": "The top of the repository where the CI system names it, the \
                folder in which mhlint was run elsewhere." },
        }},
    });
    let runs = [Run {
        head,
        results: Results { findings, rules },
    }];
    let log = Log {
        schema: "https://json.schemastore.org/sarif-2.1.0.json",
        version: "2.1.0",
        runs,
    };
    serde_json::to_writer_pretty(&mut *out, &log)?;
    writeln!(out)
}

#[derive(Serialize)]
struct Log<'a> {
    #[serde(rename = "$schema")]
    schema: &'static str,
    version: &'static str,
    runs: [Run<'a>; 1],
}

#[derive(Serialize)]
struct Run<'a> {
    #[serde(flatten)]
    head: Value,
    results: Results<'a>,
}

/// Made one by one while they are written: all at once take more room than everything that was
/// checked.
struct Results<'a> {
    findings: Vec<&'a Finding>,
    rules: Vec<&'a RuleInfo>,
}

impl Serialize for Results<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_seq(
            self.findings
                .iter()
                .map(|finding| result(finding, &self.rules)),
        )
    }
}

/// All findings, or the gravest where there are more than may be uploaded.
fn gravest(findings: &[Finding]) -> Vec<&Finding> {
    let mut kept: Vec<&Finding> = findings.iter().collect();
    if kept.len() > RESULTS {
        kept.sort_by_key(|finding| std::cmp::Reverse(finding.level));
        kept.truncate(RESULTS);
    }
    kept
}

/// The rules that found something, in the order of the table.
fn used<'a>(findings: &[&Finding], rules: &[&'a RuleInfo]) -> Vec<&'a RuleInfo> {
    rules
        .iter()
        .filter(|rule| findings.iter().any(|finding| finding.rule == rule.id))
        .copied()
        .collect()
}

fn descriptor(rule: &RuleInfo) -> Value {
    let effects = rule
        .breaks
        .iter()
        .map(|(application, effect)| (application.title(), *effect));
    let plain: Vec<String> = effects
        .clone()
        .map(|(title, effect)| format!("{title}: {effect}."))
        .collect();
    let listed: Vec<String> = effects
        .map(|(title, effect)| format!("- **{title}:** {effect}"))
        .collect();
    let own = rule.documentation();
    let first = own.split("\n\n").next().filter(|text| !text.is_empty());
    let described = first.unwrap_or(rule.summary);
    let docs = [&*own, &plain.join("\n")].join("\n\n");
    let markdown = [
        &*own,
        &listed.join("\n"),
        &format!("`mhlint explain {}` shows examples.", rule.id),
    ];
    json!({
        "id": rule.id,
        "shortDescription": { "text": text(rule.summary) },
        "fullDescription": { "text": text(described) },
        "help": { "text": text(docs.trim()), "markdown": braces(markdown.join("\n\n").trim()) },
        "defaultConfiguration": { "level": level(rule.level) },
        "properties": { "tags": [rule.family()], "problem.severity": severity(rule.level) },
    })
}

fn result(finding: &Finding, rules: &[&RuleInfo]) -> Value {
    let mut result = json!({
        "ruleId": finding.rule,
        "level": level(finding.level),
        "message": { "text": message(finding) },
        "locations": [standing_place(finding)],
        "partialFingerprints": fingerprints(finding),
        "properties": { "confidence": finding.confidence },
    });
    if let Some(index) = rules.iter().position(|rule| rule.id == finding.rule) {
        result["ruleIndex"] = json!(index);
    }
    if !finding.related.is_empty() {
        let related = finding.related.iter().take(PLACES).enumerate();
        result["relatedLocations"] = related
            .map(|(id, related)| related_place(id, related))
            .collect();
    }
    if let Some(fix) = finding.fix.as_ref().filter(|fix| !fix.replaced.is_empty()) {
        result["fixes"] = json!([as_fix(fix)]);
    }
    result
}

/// The edits of a fix, file by file.
fn as_fix(fix: &Fix) -> Value {
    let files = fix.replaced.chunk_by(|a, b| a.path == b.path);
    let changes = files.filter_map(|file| {
        let path = &file.first()?.path;
        let replacements: Vec<Value> = file.iter().map(replacement).collect();
        Some(json!({ "artifactLocation": artifact(path, false), "replacements": replacements }))
    });
    json!({
        "description": { "text": text(&printable(&fix.title)) },
        "artifactChanges": changes.collect::<Vec<_>>(),
    })
}

fn replacement(replaced: &Replaced) -> Value {
    let Replaced {
        from: [line, column],
        to: [end_line, end_column],
        text,
        ..
    } = replaced;
    let region = json!({
        "startLine": line, "startColumn": column,
        "endLine": end_line, "endColumn": end_column,
    });
    if text.is_empty() {
        return json!({ "deletedRegion": region });
    }
    json!({ "deletedRegion": region, "insertedContent": { "text": text } })
}

/// Message, consequences, evidence and help. Other places have their own member.
fn message(finding: &Finding) -> String {
    let said = printable(&phrase::message(finding));
    let mut parts = vec![format!(
        "{}{said}{}",
        folder(finding),
        phrase::doubt(finding.confidence)
    )];
    let lines = phrase::lines(finding)
        .into_iter()
        .filter(|line| line.label != "see");
    parts.extend(lines.map(|line| format!("{}: {}", line.label, line.text)));
    text(&parts.join(".\n"))
}

/// GitHub tells alerts apart by `primaryLocationLineHash` and computes it from the line on upload;
/// where there is no line it cannot, so there ours stands in.
fn fingerprints(finding: &Finding) -> Value {
    let mut fingerprints = Map::new();
    fingerprints.insert("mhlint/v1".to_owned(), json!(finding.fingerprint));
    if Standing::of(finding).location.line.is_none() {
        fingerprints.insert(
            "primaryLocationLineHash".to_owned(),
            json!(finding.fingerprint),
        );
    }
    Value::Object(fingerprints)
}

/// The place of a finding; code scanning shows alerts at files only.
fn standing_place(finding: &Finding) -> Value {
    match Standing::of(finding) {
        Standing {
            file: Some(file),
            location,
        } => place(file, location),
        Standing {
            file: None,
            location,
        } => place(&finding.path, location),
    }
}

fn related_place(id: usize, related: &Related) -> Value {
    let mut value = place(&related.path, &related.location);
    value["id"] = json!(id);
    value["message"] = json!({ "text": text(&printable(&related.message)) });
    value
}

fn place(path: &str, location: &Location) -> Value {
    let mut physical = json!({ "artifactLocation": artifact(path, location.folder.is_some()) });
    if let Some(region) = region(location) {
        physical["region"] = region;
    }
    let mut value = json!({ "physicalLocation": physical });
    let element = location
        .element
        .map(|one| json!({ "name": format!("{} {}", one.kind, one.index), "kind": one.kind }));
    let pointer = location
        .pointer
        .as_ref()
        .filter(|pointer| !pointer.is_empty());
    let pointer = pointer.map(|pointer| json!({ "fullyQualifiedName": pointer }));
    let logical: Vec<Value> = [pointer, element].into_iter().flatten().collect();
    if !logical.is_empty() {
        value["logicalLocations"] = json!(logical);
    }
    value
}

/// Absolute paths are outside of the repository and stand for themselves.
fn artifact(path: &str, is_folder: bool) -> Value {
    let path = if path.is_empty() { "." } else { path };
    let slash = if is_folder && !path.ends_with('/') {
        "/"
    } else {
        ""
    };
    let encoded = format!("{}{slash}", utf8_percent_encode(path, PATH));
    let has_drive = path.as_bytes().get(1) == Some(&b':');
    match (path.starts_with('/'), has_drive) {
        (true, _) => json!({ "uri": format!("file://{encoded}") }),
        (_, true) => json!({ "uri": format!("file:///{encoded}") }),
        _ => json!({ "uri": encoded, "uriBaseId": "%SRCROOT%" }),
    }
}

fn region(location: &Location) -> Option<Value> {
    let line = location.line?;
    let mut region = json!({ "startLine": line });
    if let Some(column) = location.column {
        region["startColumn"] = json!(column);
        let marked = location
            .excerpt
            .as_ref()
            .and_then(|excerpt| excerpt.text.get(excerpt.mark.clone()));
        if let Some(marked) = marked {
            region["endLine"] = json!(line);
            region["endColumn"] = json!(column as usize + marked.chars().count());
        }
    }
    Some(region)
}

fn notifications(outcome: &Outcome, shown: usize) -> Vec<Value> {
    let note = |text: String, level: &str| json!({ "level": level, "message": { "text": text } });
    let mut notes: Vec<Value> = outcome
        .notes
        .iter()
        .map(|one| note(text(&printable(&super::note(one))), "note"))
        .collect();
    notes.extend(unchecked_line(outcome).map(|line| note(text(&printable(&line)), "note")));
    let left = outcome.findings.len() - shown;
    if left > 0 {
        notes.push(note(
            format!("{left} findings are left out: code scanning accepts {RESULTS}"),
            "warning",
        ));
    }
    let steps = outcome.failed_steps.iter().map(step).collect();
    let failed = [
        ("the rule", &outcome.failed_rules),
        ("the reader of", &outcome.failed_files),
        ("the step", &steps),
    ];
    for (what, names) in failed {
        let said =
            |name: &String| format!("{what} {} failed, a bug in mhlint", text(&printable(name)));
        notes.extend(names.iter().map(|name| note(said(name), "error")));
    }
    notes
}

/// Who loads how many files of each group, and how they fare. The standard has no place for it but
/// this one.
fn consumers(outcome: &Outcome) -> Vec<Value> {
    let row = |((group, application), tally): ((AssetGroup, Application), Tally)| {
        json!({
            "group": group,
            "application": application,
            "files": tally.files,
            "error": tally.error,
            "warning": tally.warning,
            "info": tally.info,
            "notChecked": tally.not_checked,
        })
    };
    tallies(outcome).into_iter().map(row).collect()
}

const fn level(level: Level) -> &'static str {
    match level {
        Level::Error => "error",
        Level::Warning => "warning",
        Level::Info => "note",
    }
}

/// What GitHub sorts alerts by.
const fn severity(level: Level) -> &'static str {
    match level {
        Level::Error => "error",
        Level::Warning => "warning",
        Level::Info => "recommendation",
    }
}

/// Text of a message: brackets would begin a link and braces a placeholder (SARIF 3.11.5, 3.11.6).
fn text(text: &str) -> String {
    braces(
        &text
            .replace('\\', "\\\\")
            .replace('[', "\\[")
            .replace(']', "\\]"),
    )
}

fn braces(text: &str) -> String {
    text.replace('{', "{{").replace('}', "}}")
}

#[cfg(test)]
mod tests {
    use super::*;
    use mhlint_diag::{Excerpt, Place};

    const RULE: RuleInfo = RuleInfo::new("a-rule", Level::Info, "a fault");

    #[test]
    fn a_run_that_misses_a_file_was_not_successful() {
        let invocation = |outcome: &Outcome| {
            let mut text = Vec::new();
            write(outcome, &View::PLAIN, &mut text).unwrap();
            let log: Value = serde_json::from_slice(&text).unwrap();
            log["runs"][0]["invocations"][0].clone()
        };
        assert_eq!(invocation(&Outcome::default())["executionSuccessful"], true);
        let missing = invocation(&Outcome {
            failed_files: vec!["a.target".to_owned()],
            ..Outcome::default()
        });
        assert_eq!(missing["executionSuccessful"], false);
        let said = &missing["toolExecutionNotifications"][0];
        assert_eq!(
            said["message"]["text"],
            "the reader of a.target failed, a bug in mhlint"
        );
    }

    #[test]
    fn paths_become_uris() {
        assert_eq!(
            artifact("a b/\u{e4}#%.x", false)["uri"],
            "a%20b/%C3%A4%23%25.x"
        );
        assert_eq!(artifact("/tmp/x", false), json!({ "uri": "file:///tmp/x" }));
        assert_eq!(artifact("C:/x", false)["uri"], "file:///C%3A/x");
        assert_eq!(
            (&artifact("", true)["uri"], &artifact("a", true)["uri"]),
            (&json!("./"), &json!("a/"))
        );
    }

    #[test]
    fn the_marked_text_is_the_region() {
        let excerpt = Excerpt {
            text: "\u{e4}bc".to_owned(),
            first_line: 3,
            mark: 0..3,
        };
        let location = Location {
            line: Some(3),
            column: Some(1),
            excerpt: Some(excerpt),
            ..Location::default()
        };
        let expected = json!({ "startLine": 3, "startColumn": 1, "endLine": 3, "endColumn": 3 });
        assert_eq!(region(&location), Some(expected));
    }

    #[test]
    fn links_and_placeholders_in_names_are_no_such() {
        assert_eq!(text("[x](1) {0} \\"), "\\[x\\](1) {{0}} \\\\");
    }

    #[test]
    fn more_results_than_github_takes_are_cut_gravest_first() {
        let finding = |number: usize| {
            let level = if number == RESULTS + 4 {
                Level::Error
            } else {
                Level::Info
            };
            Finding::new(&RULE, "a", Place::File, "it").level(level)
        };
        let findings: Vec<Finding> = (0..RESULTS + 5).map(finding).collect();
        let kept = gravest(&findings);
        assert_eq!((kept.len(), kept[0].level), (RESULTS, Level::Error));
        let outcome = Outcome {
            findings: findings.clone(),
            ..Outcome::default()
        };
        let notes = notifications(&outcome, kept.len());
        assert_eq!(
            notes[0]["message"]["text"],
            "5 findings are left out: code scanning accepts 25000"
        );
    }
}
