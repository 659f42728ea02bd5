//! An outcome as text. One file a format; no writer computes, sorts or reads anything.

// Only a few modules may use files, streams and the environment, and they allow this lint
// themselves; tests may use everything.
#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

mod concise;
mod files;
mod github;
mod gitlab;
mod html;
mod human;
mod json;
mod junit;
mod markdown;
mod matrix;
mod note;
mod paint;
mod phrase;
mod printable;
mod sarif;
mod snippet;
mod standing;
mod taken;
mod unchecked;
mod verdict;
mod wrap;

use std::io::{self, Write};

use mhlint_diag::{Level, Outcome, RuleInfo};

pub use markdown::summary;
pub use note::{note, phase};
pub use paint::Paint;
pub use printable::printable;
pub use unchecked::unchecked_line;
pub use verdict::why_nothing;
pub use wrap::{count, hang, paragraphs};

/// The tool that reports name: that of the command.
pub const NAME: &str = "mhlint";
/// What it is, in a sentence.
pub const DESCRIPTION: &str = "Checks and evaluates the assets of MakeHuman 2, MakeHuman 1 and \
    MPFB: targets, macros, meshes, rigs, weights, clothes";

/// What a report writer may know besides the outcome.
#[derive(Debug, Clone, Copy)]
#[expect(
    clippy::struct_excessive_bools,
    reason = "switches that have nothing to do with each other"
)]
pub struct View<'a> {
    /// Whether the run passes at the level it was asked to fail on.
    pub pass: bool,
    /// The level from which on a finding fails the run; `None` for never.
    pub fail_on: Option<Level>,
    /// How many warnings are allowed, where somebody set a bound.
    pub max_warnings: Option<usize>,
    /// Whether escape sequences for colour may be written.
    pub color: bool,
    /// Whether lines may be drawn with characters beyond ASCII.
    pub unicode: bool,
    /// Columns of the terminal.
    pub width: usize,
    /// Leave out everything but findings and verdict.
    pub quiet: bool,
    /// Show every finding with everything that is known of it, in the report for people.
    pub full: bool,
    /// Show how many findings each rule has instead of the findings, in the report for people.
    pub statistics: bool,
    /// Declared halves of all rules.
    pub rules: &'a [&'a RuleInfo],
}

#[cfg(test)]
impl View<'static> {
    /// A failed run on a narrow page without colour.
    const PLAIN: Self = Self {
        pass: false,
        fail_on: Some(Level::Error),
        max_warnings: None,
        color: false,
        unicode: false,
        width: 80,
        quiet: false,
        full: false,
        statistics: false,
        rules: &[],
    };
}

/// The formats of `--report`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Format {
    /// For people: grouped by file, with source text, consequence and help.
    Human,
    /// A line a finding.
    Concise,
    /// `mhlint-report/1`.
    Json,
    /// SARIF 2.1.0, for code scanning.
    Sarif,
    /// Workflow commands of GitHub, which become annotations.
    Github,
    /// Code quality report of GitLab.
    Gitlab,
    /// `JUnit` XML, for every other CI system.
    Junit,
    /// For pull requests and summaries.
    Markdown,
    /// One page for a browser.
    Html,
}

impl Format {
    /// All formats with their names on the command line.
    pub const ALL: &'static [(&'static str, Self)] = &[
        ("human", Self::Human),
        ("concise", Self::Concise),
        ("json", Self::Json),
        ("sarif", Self::Sarif),
        ("github", Self::Github),
        ("gitlab", Self::Gitlab),
        ("junit", Self::Junit),
        ("markdown", Self::Markdown),
        ("html", Self::Html),
    ];

    /// Whether the notes of a run are part of the format.
    pub const fn shows_notes(self) -> bool {
        matches!(self, Self::Human)
    }

    /// Whether the format holds what fixes replace.
    pub const fn shows_replacements(self) -> bool {
        matches!(self, Self::Sarif)
    }

    /// Whether the format has room for what was not checked.
    pub const fn shows_unchecked(self) -> bool {
        !matches!(self, Self::Gitlab)
    }
}

/// Writes a report.
///
/// # Errors
/// Those of `out`.
pub fn write(
    format: Format,
    outcome: &Outcome,
    view: &View<'_>,
    out: &mut dyn Write,
) -> io::Result<()> {
    match format {
        Format::Human => human::write(outcome, view, out),
        Format::Concise => concise::write(outcome, view, out),
        Format::Json => json::write(outcome, view, out),
        Format::Sarif => sarif::write(outcome, view, out),
        Format::Github => github::write(outcome, view, out),
        Format::Gitlab => gitlab::write(outcome, out),
        Format::Junit => junit::write(outcome, view, out),
        Format::Markdown => markdown::write(outcome, view, out),
        Format::Html => html::write(outcome, view, out),
    }
}
