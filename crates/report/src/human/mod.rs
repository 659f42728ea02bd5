//! The report for people: findings by file, the gravest files first, infos a line each, then notes,
//! counts and a verdict in one sentence.
//!
//! Long lists are cut with a word on what was left out. Readable at eighty columns and without
//! colour.

mod block;
mod groups;
mod pick;
mod statistics;

use std::cmp::Reverse;
use std::collections::{BTreeMap, BTreeSet};
use std::io::{self, Write};

use super::files::by_file;
use super::matrix::Matrix;
use super::{Paint, View, count, hang, phrase, printable, taken, verdict};
use groups::Group;
use mhlint_diag::{Application, Break, Finding, Level, Note, Outcome};
use pick::Picked;

/// Writes the report.
pub(super) fn write(outcome: &Outcome, view: &View<'_>, out: &mut dyn Write) -> io::Result<()> {
    if view.statistics {
        statistics::write(outcome, view, out)?;
    } else {
        write_findings(outcome, view, out)?;
    }
    if !view.quiet {
        write_notes(&outcome.notes, view, out)?;
        write_matrix(outcome, out)?;
        for line in taken::lines(outcome, view.full) {
            writeln!(out, "{}", hang("", &printable(&line), view.width))?;
        }
        writeln!(out, "{}", verdict::counts(outcome, view))?;
    }
    writeln!(out, "{}", verdict::sentence(outcome, view))?;
    let errors = verdict::first_errors(outcome);
    errors
        .iter()
        .try_for_each(|line| writeln!(out, "{}", hang("  ", line, view.width)))?;
    match super::unchecked_line(outcome) {
        Some(line) => writeln!(out, "{}", hang("", &printable(&line), view.width)),
        None => Ok(()),
    }
}

/// Files with errors, files with warnings, infos.
fn write_findings(outcome: &Outcome, view: &View<'_>, out: &mut dyn Write) -> io::Result<()> {
    let picked = pick::pick(&outcome.findings, view.full);
    let is_block = |group: &&Group<'_>| view.full || group.first.level > Level::Info;
    let (blocks, infos): (Vec<&Group<'_>>, Vec<&Group<'_>>) =
        picked.shown.iter().partition(is_block);
    let blocks: Vec<&Finding> = blocks.iter().map(|group| group.first).collect();
    let mut explained = BTreeSet::new();
    let tallies = tallies(&outcome.findings, view);
    for file in by_file(&blocks) {
        write_heading(&file, &tallies, view, out)?;
        write_file(&file, &picked, &mut explained, view, out)?;
    }
    write_infos(&infos, &blocks, &picked, view, out)
}

fn write_heading(
    file: &[&Finding],
    tallies: &BTreeMap<&str, Tally>,
    view: &View<'_>,
    out: &mut dyn Write,
) -> io::Result<()> {
    let path = file.first().map_or("", |first| first.path.as_str());
    let words = tallies.get(path).map(tally).unwrap_or_default();
    let paint = Paint { color: view.color };
    let path = file
        .first()
        .map(|first| phrase::path_of(first))
        .unwrap_or_default();
    writeln!(out, "{}{}", paint.bold(&path), paint.dim(&words))
}

/// Numbers of findings, by level.
type Tally = BTreeMap<Reverse<Level>, usize>;

/// What stands below the headings of the files, shown or left out.
fn tallies<'f>(findings: &'f [Finding], view: &View<'_>) -> BTreeMap<&'f str, Tally> {
    let mut tallies: BTreeMap<&str, Tally> = BTreeMap::new();
    for finding in findings
        .iter()
        .filter(|finding| view.full || finding.level > Level::Info)
    {
        *tallies
            .entry(&finding.path)
            .or_default()
            .entry(Reverse(finding.level))
            .or_default() += 1;
    }
    tallies
}

/// What was said of a file already and is not said again.
#[derive(Default)]
struct Said<'a> {
    effects: BTreeSet<(Application, &'a str)>,
    helps: BTreeSet<&'a str>,
}

fn write_file(
    file: &[&Finding],
    picked: &Picked<'_>,
    explained: &mut BTreeSet<&'static str>,
    view: &View<'_>,
    out: &mut dyn Write,
) -> io::Result<()> {
    let paint = Paint { color: view.color };
    let mut said = Said::default();
    for finding in file {
        let effects = finding
            .breaks
            .iter()
            .filter(|one| said.effects.insert((one.application, &one.effect)));
        let effects: Vec<&Break> = effects.collect();
        let with_help = finding
            .help
            .as_deref()
            .is_some_and(|help| said.helps.insert(help));
        out.write_all(block::render(finding, &effects, with_help, view).as_bytes())?;
        if explained.insert(finding.rule) && !view.quiet {
            writeln!(
                out,
                "  {}",
                paint.dim(&format!("more: mhlint explain {}", finding.rule))
            )?;
        }
        if let Some(more) = picked.more_like(finding) {
            writeln!(out, "  {}", paint.bold(&more))?;
        }
        writeln!(out)?;
    }
    match file.first().and_then(|first| picked.more_in(&first.path)) {
        Some(more) => writeln!(out, "  {}\n", paint.bold(&more)),
        None => Ok(()),
    }
}

/// A line for each info, or for many that say the same. What more there is in a file is said here,
/// unless its findings stand in `blocks`.
fn write_infos(
    infos: &[&Group<'_>],
    blocks: &[&Finding],
    picked: &Picked<'_>,
    view: &View<'_>,
    out: &mut dyn Write,
) -> io::Result<()> {
    if infos.is_empty() {
        return Ok(());
    }
    let paint = Paint { color: view.color };
    let hint = if view.quiet {
        ""
    } else {
        " (no visible effect today; `--full` shows consequences and help)"
    };
    let total = infos.iter().map(|group| group.len()).sum::<usize>() + picked.left(Level::Info);
    writeln!(
        out,
        "{}{}",
        paint.bold(&count(total, "info")),
        paint.dim(hint)
    )?;
    for file in infos.chunk_by(|a, b| a.first.path == b.first.path) {
        for group in file {
            writeln!(out, "  {}", group.line())?;
            if let Some(more) = picked.more_like(group.first) {
                writeln!(out, "  {}", paint.bold(&more))?;
            }
        }
        let path = file.first().map_or("", |group| group.first.path.as_str());
        if let Some(more) = picked
            .more_in(path)
            .filter(|_| !blocks.iter().any(|finding| finding.path == path))
        {
            writeln!(out, "  {}", paint.bold(&more))?;
        }
    }
    writeln!(out)
}

/// `: 2 errors, 1 warning` behind the name of a file with more than one finding.
fn tally(numbers: &Tally) -> String {
    if numbers.values().sum::<usize>() < 2 {
        return String::new();
    }
    let parts: Vec<String> = numbers
        .iter()
        .map(|(Reverse(level), number)| count(*number, level.word()))
        .collect();
    format!(": {}", parts.join(", "))
}

/// Who loads what, where several applications do.
fn write_matrix(outcome: &Outcome, out: &mut dyn Write) -> io::Result<()> {
    let Some(matrix) = Matrix::of(outcome) else {
        return Ok(());
    };
    matrix
        .lines()
        .iter()
        .try_for_each(|line| writeln!(out, "{line}"))?;
    writeln!(out)
}

fn write_notes(notes: &[Note], view: &View<'_>, out: &mut dyn Write) -> io::Result<()> {
    for note in notes {
        writeln!(
            out,
            "{}",
            hang("note: ", &printable(&super::note(note)), view.width)
        )?;
    }
    if notes.is_empty() {
        Ok(())
    } else {
        writeln!(out)
    }
}
