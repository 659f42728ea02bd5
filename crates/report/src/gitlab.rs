//! The code quality report of GitLab: shown in merge requests, with what is new and what is gone.

use std::collections::BTreeSet;
use std::io::{self, Write};

use serde_json::{Value, json};

use super::phrase;
use super::standing::{Standing, folder};
use mhlint_diag::{Finding, Level, Outcome, fingerprint};

/// Writes the list of issues, an empty one if there are none.
pub(super) fn write(outcome: &Outcome, out: &mut dyn Write) -> io::Result<()> {
    let mut seen = BTreeSet::new();
    let issues: Vec<Value> = outcome
        .findings
        .iter()
        .map(|finding| issue(finding, &mut seen))
        .collect();
    serde_json::to_writer_pretty(&mut *out, &issues)?;
    writeln!(out)
}

fn issue(finding: &Finding, seen: &mut BTreeSet<String>) -> Value {
    let Standing { file, location } = Standing::of(finding);
    json!({
        "description": format!("{}{}", folder(finding), phrase::plain(finding).replace('\n', ". ")),
        "check_name": finding.rule,
        "fingerprint": unique(finding, seen),
        "severity": severity(finding.level),
        "location": {
            "path": file.map_or_else(|| phrase::path_of(finding), str::to_owned),
            "lines": { "begin": location.line.unwrap_or(1) },
        },
    })
}

/// GitLab shows one issue for a fingerprint, and two data roots may hold the same asset with the
/// same fault.
fn unique(finding: &Finding, seen: &mut BTreeSet<String>) -> String {
    let own = finding.fingerprint.clone();
    if seen.insert(own.clone()) {
        return own;
    }
    let other = fingerprint(finding.rule, &finding.path, &own, 0);
    seen.insert(other.clone());
    other
}

const fn severity(level: Level) -> &'static str {
    match level {
        Level::Error => "critical",
        Level::Warning => "major",
        Level::Info => "info",
    }
}
