//! The report for people: findings by file, then notes, counts and a verdict in one sentence.
//!
//! Long lists are cut with a word on what was left out. Readable at eighty columns and without colour.

mod block;
mod pick;

use std::collections::BTreeSet;
use std::io::{self, Write};

use super::{Paint, View, count, hang, printable, verdict};
use crate::diag::{Break, Finding, Level, Note, Outcome};
use pick::Picked;

/// Writes the report.
pub(super) fn write(outcome: &Outcome, view: &View<'_>, out: &mut dyn Write) -> io::Result<()> {
    let picked = pick::pick(&outcome.findings);
    let mut explained = BTreeSet::new();
    for file in picked.shown.chunk_by(|a, b| a.path == b.path) {
        write_heading(file, outcome, view, out)?;
        write_findings(file, &picked, &mut explained, view, out)?;
    }
    if !view.quiet {
        write_notes(&outcome.notes, view, out)?;
        writeln!(out, "{}", verdict::counts(outcome, view))?;
    }
    writeln!(out, "{}", verdict::sentence(outcome, view))?;
    let errors = verdict::first_errors(outcome);
    errors.iter().try_for_each(|line| writeln!(out, "{}", hang("  ", line, view.width)))?;
    match super::unchecked_line(outcome) {
        Some(line) => writeln!(out, "{}", hang("", &printable(&line), view.width)),
        None => Ok(()),
    }
}

fn write_heading(file: &[&Finding], outcome: &Outcome, view: &View<'_>, out: &mut dyn Write) -> io::Result<()> {
    let path = file.first().map_or("", |first| first.path.as_str());
    let all: Vec<&Finding> = outcome.findings.iter().filter(|finding| finding.path == path).collect();
    let paint = Paint { color: view.color };
    let shown = if path.is_empty() { ".".to_owned() } else { printable(path) };
    writeln!(out, "{}{}", paint.bold(&shown), paint.dim(&tally(&all)))
}

fn write_findings(
    file: &[&Finding],
    picked: &Picked<'_>,
    explained: &mut BTreeSet<&'static str>,
    view: &View<'_>,
    out: &mut dyn Write,
) -> io::Result<()> {
    let paint = Paint { color: view.color };
    let mut before: Option<&Finding> = None;
    for finding in file {
        let repeats = before.is_some_and(|before| before.rule == finding.rule && same_effects(before, finding));
        out.write_all(block::render(finding, repeats, view).as_bytes())?;
        if explained.insert(finding.rule) && !view.quiet {
            writeln!(out, "  {}", paint.dim(&format!("more: mhlint explain {}", finding.rule)))?;
        }
        if let Some(more) = picked.more_like(finding) {
            writeln!(out, "  {}", paint.bold(&more))?;
        }
        before = Some(finding);
        writeln!(out)?;
    }
    match file.first().and_then(|first| picked.more_in(&first.path)) {
        Some(more) => writeln!(out, "  {}\n", paint.bold(&more)),
        None => Ok(()),
    }
}

fn same_effects(one: &Finding, other: &Finding) -> bool {
    let same = |(one, other): (&Break, &Break)| one.application == other.application && one.effect == other.effect;
    one.breaks.len() == other.breaks.len() && one.breaks.iter().zip(&other.breaks).all(same)
}

/// `: 2 errors, 1 warning` behind the name of a file with more than one finding.
fn tally(findings: &[&Finding]) -> String {
    if findings.len() < 2 {
        return String::new();
    }
    let parts = [Level::Error, Level::Warning, Level::Info].map(|level| {
        let number = findings.iter().filter(|finding| finding.level == level).count();
        (number > 0).then(|| count(number, level.word()))
    });
    format!(": {}", parts.into_iter().flatten().collect::<Vec<_>>().join(", "))
}

fn write_notes(notes: &[Note], view: &View<'_>, out: &mut dyn Write) -> io::Result<()> {
    for note in notes {
        writeln!(out, "{}", hang("note: ", &printable(&super::note(note)), view.width))?;
    }
    if notes.is_empty() { Ok(()) } else { writeln!(out) }
}
