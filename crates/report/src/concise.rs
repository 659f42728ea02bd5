//! A line a finding: `path:line:column: level[rule] message`.

use std::io::{self, Write};

use super::phrase;
use super::unchecked::unchecked;
use super::{View, count, printable};
use mhlint_diag::{ApplicationVerdict, Outcome, Verdict};

/// Writes the findings, then a line of counts and what was not checked unless quiet.
pub(super) fn write(outcome: &Outcome, view: &View<'_>, out: &mut dyn Write) -> io::Result<()> {
    for finding in &outcome.findings {
        writeln!(out, "{}", phrase::one_line(finding))?;
    }
    if !view.quiet {
        let summary = &outcome.summary;
        let unchecked: Vec<String> = unchecked(outcome).collect();
        let unchecked = if unchecked.is_empty() {
            String::new()
        } else {
            format!("; not checked: {}", unchecked.join("; "))
        };
        writeln!(
            out,
            "{}: {}, {}, {} in {}{}{}",
            if view.pass { "pass" } else { "fail" },
            count(summary.error, "error"),
            count(summary.warning, "warning"),
            count(summary.info, "info"),
            count(summary.files, "file"),
            endings(outcome),
            printable(&unchecked)
        )?;
    }
    Ok(())
}

/// `; MakeHuman 2: pass, MPFB: fail`: the verdict for each of several applications.
fn endings(outcome: &Outcome) -> String {
    let word = |verdict| {
        if verdict == Verdict::Pass {
            "pass"
        } else {
            "fail"
        }
    };
    let ending = |one: &ApplicationVerdict| format!("{}: {}", one.application, word(one.verdict));
    match outcome.applications.as_slice() {
        [] | [_] => String::new(),
        several => format!(
            "; {}",
            several.iter().map(ending).collect::<Vec<_>>().join(", ")
        ),
    }
}
