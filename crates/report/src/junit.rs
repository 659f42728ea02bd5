//! `JUnit` XML, which nearly every CI system can show: a suite for each file, a test case for each
//! finding.
//!
//! A finding that fails the run is a failed case; any other is a passed case with the finding as
//! its output. The first suite holds the run itself, so that a faultless repository still shows a
//! test that passed.

use std::io::{self, Write};

use quick_xml::Writer;
use quick_xml::events::{BytesDecl, BytesText, Event};

use super::matrix::Matrix;
use super::standing::Standing;
use super::{View, phrase, printable, unchecked_line, verdict};
use mhlint_diag::{Finding, Outcome};

/// Writes the report.
pub(super) fn write(outcome: &Outcome, view: &View<'_>, out: &mut dyn Write) -> io::Result<()> {
    let mut writer = Writer::new_with_indent(out, b' ', 2);
    let failed = outcome
        .findings
        .iter()
        .filter(|finding| fails(finding, view))
        .count();
    // The run fails on its own where no single finding does: too many warnings, nothing to check, a
    // bug of ours.
    let run_fails = !view.pass && failed == 0;
    writer.write_event(Event::Decl(BytesDecl::new("1.0", Some("UTF-8"), None)))?;
    writer
        .create_element("testsuites")
        .with_attributes([
            ("name", "mhlint"),
            ("tests", &(outcome.findings.len() + 1).to_string()),
            ("failures", &(failed + usize::from(run_fails)).to_string()),
            ("errors", "0"),
        ])
        .write_inner_content(|writer| {
            write_run(outcome, view, run_fails, writer)?;
            outcome
                .findings
                .chunk_by(|a, b| a.path == b.path)
                .try_for_each(|file| write_file(file, view, writer))
        })?;
    writeln!(writer.into_inner())
}

/// Whether a finding alone makes the exit code 1.
fn fails(finding: &Finding, view: &View<'_>) -> bool {
    view.fail_on.is_some_and(|limit| finding.level >= limit)
}

fn write_run<W: Write>(
    outcome: &Outcome,
    view: &View<'_>,
    run_fails: bool,
    writer: &mut Writer<W>,
) -> io::Result<()> {
    let words = printable(&verdict::words(outcome, view));
    let mut said = vec![format!(
        "{} in {}",
        verdict::tally(outcome),
        verdict::files(&outcome.summary)
    )];
    said.extend(verdict::roots(outcome));
    said.extend(Matrix::of(outcome).iter().flat_map(Matrix::lines));
    said.extend(
        outcome
            .notes
            .iter()
            .map(|note| format!("note: {}", super::note(note))),
    );
    said.extend(unchecked_line(outcome));
    let said: Vec<String> = said.iter().map(|line| printable(line)).collect();
    suite("mhlint", 1, usize::from(run_fails), writer, |writer| {
        let case = writer
            .create_element("testcase")
            .with_attributes([("name", "run"), ("classname", "mhlint")]);
        case.write_inner_content(|writer| {
            if run_fails {
                failure("run", &words, &words, writer)?;
            }
            output(&format!("{words}\n{}", said.join("\n")), writer)
        })?;
        Ok(())
    })
}

fn write_file<W: Write>(
    file: &[Finding],
    view: &View<'_>,
    writer: &mut Writer<W>,
) -> io::Result<()> {
    let path = file.first().map_or_else(String::new, phrase::path_of);
    let failures = file.iter().filter(|finding| fails(finding, view)).count();
    suite(&path, file.len(), failures, writer, |writer| {
        file.iter()
            .try_for_each(|finding| write_finding(finding, &path, view, writer))
    })
}

fn suite<W: Write>(
    name: &str,
    tests: usize,
    failures: usize,
    writer: &mut Writer<W>,
    inner: impl FnOnce(&mut Writer<W>) -> io::Result<()>,
) -> io::Result<()> {
    let (tests, failures) = (tests.to_string(), failures.to_string());
    let counts = [
        ("tests", tests.as_str()),
        ("failures", &failures),
        ("errors", "0"),
        ("skipped", "0"),
    ];
    writer
        .create_element("testsuite")
        .with_attribute(("name", name))
        .with_attributes(counts)
        .write_inner_content(inner)?;
    Ok(())
}

fn write_finding<W: Write>(
    finding: &Finding,
    path: &str,
    view: &View<'_>,
    writer: &mut Writer<W>,
) -> io::Result<()> {
    let place = phrase::bare_place(&finding.location)
        .map_or_else(String::new, |place| format!(" ({place})"));
    let name = format!("{}{}", finding.rule, printable(&place));
    let Standing { file, location } = Standing::of(finding);
    let file = file.map(|file| phrase::path(file, location));
    let line = location
        .line
        .filter(|_| file.is_some())
        .map(|line| line.to_string());
    let attributes = [("name", name.as_str()), ("classname", path)];
    let places = [("file", &file), ("line", &line)].into_iter();
    let places = places.filter_map(|(name, value)| Some((name, value.as_deref()?)));
    let case = writer
        .create_element("testcase")
        .with_attributes(attributes)
        .with_attributes(places);
    let text = phrase::plain(finding);
    case.write_inner_content(|writer| {
        if fails(finding, view) {
            let message = printable(&phrase::message(finding));
            let text = format!(
                "{path}{}: {}\n{text}",
                phrase::colons(&finding.location),
                finding.level
            );
            failure(finding.rule, &message, &text, writer)
        } else {
            output(&format!("{}: {text}", finding.level), writer)
        }
    })?;
    Ok(())
}

fn failure<W: Write>(
    kind: &str,
    message: &str,
    text: &str,
    writer: &mut Writer<W>,
) -> io::Result<()> {
    let element = writer
        .create_element("failure")
        .with_attributes([("type", kind), ("message", message)]);
    element.write_text_content(BytesText::new(text))?;
    Ok(())
}

fn output<W: Write>(text: &str, writer: &mut Writer<W>) -> io::Result<()> {
    writer
        .create_element("system-out")
        .write_text_content(BytesText::new(text))?;
    Ok(())
}
