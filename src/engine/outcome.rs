//! What a run gives back.

use std::path::Path;
use std::time::Duration;

use serde::Serialize;

use super::settle::Baseline;
use crate::config::Config;
use crate::diag::{Application, Finding, Level};
use crate::discover::{Kind, kind_of, loose_place, root_above};
use crate::source::{resolved, slashed};

/// Result of a run.
#[derive(Debug, Clone, Default)]
pub struct Outcome {
    /// The data roots that were looked at.
    pub roots: Vec<RootSummary>,
    /// Findings, sorted by path, place and rule.
    pub findings: Vec<Finding>,
    /// What a reader should know besides findings: what was not judged and why.
    pub notes: Vec<String>,
    /// Counts.
    pub summary: Summary,
    /// Time per phase and rule, in order of the run.
    pub timings: Vec<Timing>,
    /// The baseline to write, where one was asked for: [`Config::write_baseline`].
    pub baseline: Option<Baseline>,
    /// What [`Outcome::baseline`] changes, where there was one before.
    pub taken_over: Option<TakenOver>,
    /// Findings that the baseline hides; [`Summary::suppressed`] counts them with the muted ones.
    pub in_baseline: usize,
    /// Findings that are not shown because the change cannot affect them.
    pub left_out: usize,
    /// What alone was reported on, where that is not all of the data: `in ...`, `on ...`, `by ...`.
    pub only: Vec<String>,
    /// Rules that panicked: bugs of ours, whose findings are missing.
    pub failed_rules: Vec<String>,
    /// Files on which a reader of ours panicked, by path: bugs of ours, whose findings are missing.
    pub failed_files: Vec<String>,
    /// Other work that panicked, such as the evaluation of a base mesh.
    pub failed_steps: Vec<String>,
}

/// A data root.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct RootSummary {
    /// Its path as printed.
    pub path: String,
    /// Whose data it is.
    pub application: Application,
    /// Base meshes in it.
    pub bases: Vec<String>,
    /// Whether this version judges it.
    #[serde(skip)]
    pub judged: bool,
}

/// Counts of a run.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize)]
pub struct Summary {
    /// Findings of level error.
    pub error: usize,
    /// Findings of level warning.
    pub warning: usize,
    /// Findings of level info.
    pub info: usize,
    /// Findings that were muted.
    pub suppressed: usize,
    /// Files of the judged roots.
    pub files: usize,
    /// Their size in bytes.
    pub bytes: u64,
}

/// How a new baseline differs from the one that it takes the place of.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct TakenOver {
    /// Findings that were not in the old one.
    pub new: usize,
    /// Those of them that are errors.
    pub errors: usize,
    /// Entries of the old one that were not found again.
    pub gone: usize,
}

/// Time spent on something.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Timing {
    /// Phase or rule.
    pub what: String,
    /// How long, added up over threads for rules.
    pub time: Duration,
}

/// Why a run could not be done at all.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Error {
    /// A PATH or `--system` that cannot be read.
    Path {
        /// As given.
        path: String,
        /// Why.
        reason: String,
    },
    /// `--base` that no root has.
    UnknownBase {
        /// As given.
        name: String,
        /// The bases there are.
        known: Vec<String>,
    },
    /// A selector that matches no rule, or no glob at all.
    Selector {
        /// As given.
        text: String,
        /// Why.
        reason: String,
    },
    /// A baseline that cannot be read.
    Baseline {
        /// The file.
        path: String,
        /// Why, and what to do.
        reason: String,
    },
}

impl Outcome {
    /// Counts the findings by level.
    pub(super) fn count(&mut self) {
        let of = |level| self.findings.iter().filter(|finding| finding.level == level).count();
        (self.summary.error, self.summary.warning, self.summary.info) =
            (of(Level::Error), of(Level::Warning), of(Level::Info));
    }

    /// Whether something at or above `limit` was found.
    pub fn has_at_least(&self, limit: Level) -> bool {
        self.findings.iter().any(|finding| finding.level >= limit)
    }

    /// Whether the run passes: nothing at or above [`Config::fail_on`], no more warnings than
    /// [`Config::max_warnings`], and all of the work was done.
    pub fn passes(&self, config: &Config) -> bool {
        let graded = config.fail_on.is_some_and(|level| self.has_at_least(level));
        let too_many = config.max_warnings.is_some_and(|limit| self.summary.warning > limit);
        self.is_whole() && !graded && !too_many
    }

    /// Whether all of the work was done: no bug of ours took a file, a rule or a step away.
    pub fn is_whole(&self) -> bool {
        [&self.failed_rules, &self.failed_files, &self.failed_steps].iter().all(|failed| failed.is_empty())
    }

    /// Whether a file lies where a judged data root or the system data have their assets, or is a loose one of them.
    pub fn has_asset(&self, file: &Path, system: Option<&Path>) -> bool {
        let place = resolved(file);
        let is_asset_in = |root: &Path| {
            let rel = place.strip_prefix(resolved(root)).map(slashed).unwrap_or_default();
            let (folder, _) = rel.rsplit_once('/').unwrap_or_default();
            root_above(folder).is_some() && kind_of(&rel).0 != Kind::Other || loose_place(&rel, None).is_some()
        };
        let judged = self.roots.iter().filter(|root| root.judged).map(|root| Path::new(root.path.as_str()));
        judged.chain(system).any(is_asset_in)
    }

    /// Whether any root was judged.
    pub fn judged_anything(&self) -> bool {
        self.roots.iter().any(|root| root.judged)
    }
}

impl std::fmt::Display for Error {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Path { path, reason } => write!(f, "cannot read `{path}`: {reason}"),
            Self::UnknownBase { name, known } if known.is_empty() => write!(f, "there is no base mesh `{name}`"),
            Self::UnknownBase { name, known } => {
                write!(f, "there is no base mesh `{name}`; known: {}", known.join(", "))
            }
            Self::Baseline { path, reason } => write!(f, "the baseline `{path}` {reason}"),
            Self::Selector { text, reason } => write!(f, "`{text}`: {reason}"),
        }
    }
}

impl std::error::Error for Error {}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_run_that_misses_something_does_not_pass() {
        let what = || vec!["something".to_owned()];
        let config = Config { fail_on: None, ..Config::default() };
        assert!(Outcome::default().passes(&config));
        for missing in [
            Outcome { failed_rules: what(), ..Outcome::default() },
            Outcome { failed_files: what(), ..Outcome::default() },
            Outcome { failed_steps: what(), ..Outcome::default() },
        ] {
            assert!(!missing.passes(&config) && !missing.is_whole());
        }
    }
}
