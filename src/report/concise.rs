//! A line a finding: `path:line:column: level[rule] message`.

use std::io::{self, Write};

use super::{View, count, printable};
use crate::diag::Location;
use crate::engine::Outcome;

/// Writes the findings, then a line of counts unless quiet.
pub(super) fn write(outcome: &Outcome, view: &View<'_>, out: &mut dyn Write) -> io::Result<()> {
    for finding in &outcome.findings {
        writeln!(
            out,
            "{}{}: {}[{}] {}",
            printable(&finding.path),
            place(&finding.location),
            finding.level,
            finding.rule,
            printable(&finding.message)
        )?;
    }
    if !view.quiet {
        let summary = &outcome.summary;
        writeln!(
            out,
            "{}: {}, {}, {} in {}",
            if view.pass { "pass" } else { "fail" },
            count(summary.error, "error"),
            count(summary.warning, "warning"),
            count(summary.info, "info"),
            count(summary.files, "file")
        )?;
    }
    Ok(())
}

fn place(location: &Location) -> String {
    match (location.line, location.column) {
        (Some(line), Some(column)) => format!(":{line}:{column}"),
        (Some(line), None) => format!(":{line}"),
        _ => String::new(),
    }
}
