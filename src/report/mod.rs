//! An outcome as text. One file a format; no writer computes, sorts or reads anything.

mod concise;
mod json;

use std::io::{self, Write};

use crate::diag::RuleInfo;
use crate::engine::Outcome;

/// What a report writer may know besides the outcome.
#[derive(Debug, Clone, Copy)]
pub struct View<'a> {
    /// Whether the run passes at the level it was asked to fail on.
    pub pass: bool,
    /// Whether escape sequences for colour may be written.
    pub color: bool,
    /// Leave out everything but findings and verdict.
    pub quiet: bool,
    /// Declared halves of all rules.
    pub rules: &'a [&'a RuleInfo],
}

/// The formats of `--report`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Format {
    /// A line a finding.
    Concise,
    /// `mhlint-report/1`.
    Json,
}

impl Format {
    /// All formats with their names on the command line.
    pub const ALL: &'static [(&'static str, Self)] = &[("concise", Self::Concise), ("json", Self::Json)];
}

/// Writes a report.
///
/// # Errors
/// Those of `out`.
pub fn write(format: Format, outcome: &Outcome, view: &View<'_>, out: &mut dyn Write) -> io::Result<()> {
    match format {
        Format::Concise => concise::write(outcome, view, out),
        Format::Json => json::write(outcome, view, out),
    }
}

/// Text of an asset made harmless for a terminal: control characters become visible.
pub(crate) fn printable(text: &str) -> String {
    text.chars()
        .map(|character| match character {
            '\n' | '\r' | '\t' => ' ',
            other if other.is_control() || matches!(other, '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}') => {
                '\u{fffd}'
            }
            other => other,
        })
        .collect()
}
