//! `mhlint-report/1`: everything, for programs. Its schema is `schemas/report.schema.json`.

use std::borrow::Cow;
use std::io::{self, Write};

use serde::ser::{Error, SerializeSeq};
use serde::{Serialize, Serializer};
use serde_json::value::to_raw_value;

use super::View;
use super::phrase::message;
use mhlint_diag::{
    Application, ApplicationVerdict, AssetGroup, Break, Compared, Confidence, Consumed, Consumer,
    Evidence, Fares, Finding, Grown, Level, Location, MeasureKind, NotChecked, Outcome, Related,
    RootSummary, Summary, Verdict,
};

#[derive(Serialize)]
struct Report<'a> {
    format: &'static str,
    tool: Tool,
    verdict: Verdict,
    roots: &'a [RootSummary],
    summary: &'a Summary,
    applications: &'a [ApplicationVerdict],
    consumers: Consumers<'a>,
    not_checked: &'a [NotChecked],
    compared: Option<&'a Compared>,
    findings: Vec<Item<'a>>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    notes: Vec<String>,
}

/// A line for each file: there are many.
struct Consumers<'a>(&'a [Consumed]);

#[derive(Serialize)]
struct Row<'a> {
    path: &'a str,
    group: AssetGroup,
    applications: Vec<Cell<'a>>,
}

#[derive(Serialize)]
struct Cell<'a> {
    application: Application,
    root: &'a str,
    archive: Option<&'a str>,
    fares: Fares,
}

impl Serialize for Consumers<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut rows = serializer.serialize_seq(Some(self.0.len()))?;
        for one in self.0 {
            let line = to_raw_value(&row(one)).map_err(Error::custom)?;
            rows.serialize_element(&line)?;
        }
        rows.end()
    }
}

fn row(one: &Consumed) -> Row<'_> {
    Row {
        path: &one.path,
        group: one.group,
        applications: one.by.iter().map(cell).collect(),
    }
}

fn cell(consumer: &Consumer) -> Cell<'_> {
    Cell {
        application: consumer.application,
        root: &consumer.root,
        archive: consumer.archive.as_deref(),
        fares: consumer.fares,
    }
}

#[derive(Serialize)]
struct Tool {
    name: &'static str,
    version: &'static str,
}

#[derive(Serialize)]
struct Item<'a> {
    rule: &'static str,
    level: Level,
    confidence: Confidence,
    path: &'a str,
    place: &'a Location,
    message: Cow<'a, str>,
    help: Option<&'a str>,
    breaks: &'a [Break],
    evidence: Option<Evidence>,
    #[serde(skip_serializing_if = "Option::is_none")]
    measure: Option<MeasureItem>,
    #[serde(skip_serializing_if = "Option::is_none")]
    grown: Option<Grown>,
    related: &'a [Related],
    fix: Option<FixItem<'a>>,
    fingerprint: &'a str,
}

/// How much of the fault there is.
#[derive(Serialize)]
struct MeasureItem {
    of: MeasureKind,
    value: f64,
}

#[derive(Serialize)]
struct FixItem<'a> {
    kind: &'static str,
    title: &'a str,
}

/// Writes the report, indented, with a newline at the end.
pub(super) fn write(outcome: &Outcome, view: &View<'_>, out: &mut dyn Write) -> io::Result<()> {
    let report = Report {
        format: "mhlint-report/1",
        tool: Tool {
            name: crate::NAME,
            version: env!("CARGO_PKG_VERSION"),
        },
        verdict: if view.pass {
            Verdict::Pass
        } else {
            Verdict::Fail
        },
        roots: &outcome.roots,
        summary: &outcome.summary,
        applications: &outcome.applications,
        consumers: Consumers(&outcome.consumers),
        not_checked: &outcome.not_checked,
        compared: outcome
            .compared
            .as_ref()
            .or(outcome.compared_with_baseline.as_ref()),
        findings: outcome.findings.iter().map(item).collect(),
        notes: outcome.notes.iter().map(super::note).collect(),
    };
    serde_json::to_writer_pretty(&mut *out, &report)?;
    writeln!(out)
}

fn item(finding: &Finding) -> Item<'_> {
    Item {
        rule: finding.rule,
        level: finding.level,
        confidence: finding.confidence,
        path: &finding.path,
        place: &finding.location,
        message: message(finding),
        help: finding.help.as_deref(),
        breaks: &finding.breaks,
        evidence: finding.evidence.clone().map(finite),
        measure: finding.measure().map(|one| MeasureItem {
            of: one.grows.of,
            value: one.value.0,
        }),
        grown: finding.grown,
        related: &finding.related,
        fix: finding.fix.as_ref().map(|fix| FixItem {
            kind: fix.kind.word(),
            title: &fix.title,
        }),
        fingerprint: &finding.fingerprint,
    }
}

/// JSON has no number that is not finite; the message of the finding says it in words.
fn finite(mut evidence: Evidence) -> Evidence {
    evidence.worst = evidence.worst.filter(|worst| worst.value.is_finite());
    evidence
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_worst_value_that_is_no_number_is_left_out() {
        let evidence = |value| finite(Evidence::default().with_worst(value, "vertex 1"));
        assert_eq!(evidence(f64::NAN).worst, None);
        assert_eq!(evidence(f64::INFINITY).worst, None);
        assert!(evidence(0.5).worst.is_some());
    }
}
