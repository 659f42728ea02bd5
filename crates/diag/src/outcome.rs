//! What a run gives back: plain data, made for several applications.

use std::collections::BTreeSet;
use std::path::PathBuf;
use std::time::Duration;

use serde::Serialize;

use super::{Application, Baseline, Consumed, EXAMPLES, Finding, Identity, Level, Note};

/// Result of a run.
#[derive(Debug, Clone, Default)]
pub struct Outcome {
    /// The applications whose data were looked for.
    pub looked_for: Vec<Application>,
    /// The data roots that were found.
    pub roots: Vec<RootSummary>,
    /// How the run ended for each application of which something was checked.
    pub applications: Vec<ApplicationVerdict>,
    /// The files that some application loads, by path, and how they fare in each: the matrix of
    /// consumers.
    pub consumers: Vec<Consumed>,
    /// What was not checked, and why.
    pub not_checked: Vec<NotChecked>,
    /// The PATHs of which nothing was checked.
    pub nothing_in: Vec<Untouched>,
    /// Findings, sorted by path, place and rule.
    pub findings: Vec<Finding>,
    /// What a reader should know besides findings.
    pub notes: Vec<Note>,
    /// Journals of runs that fix, or that were ended while they did.
    pub journals: Vec<PathBuf>,
    /// Counts.
    pub summary: Summary,
    /// Time per phase and rule, in order of the run.
    pub timings: Vec<Timing>,
    /// The baseline to write, where one was asked for: `Config::write_baseline`.
    pub baseline: Option<Baseline>,
    /// What [`Outcome::baseline`] changes, where there was one before.
    pub taken_over: Option<TakenOver>,
    /// Findings that the baseline hides; [`Summary::suppressed`] counts them with the ignored ones.
    pub in_baseline: usize,
    /// What the data were compared with: findings are what is new or worse.
    pub compared: Option<Compared>,
    /// The same for the baseline.
    pub compared_with_baseline: Option<Compared>,
    /// What alone was reported on.
    pub scope: Scope,
    /// Rules that panicked: bugs of ours, whose findings are missing.
    pub failed_rules: Vec<String>,
    /// Files on which a reader of ours panicked, by path: bugs of ours, whose findings are missing.
    pub failed_files: Vec<String>,
    /// Other work that panicked: bugs of ours.
    pub failed_steps: Vec<FailedStep>,
}

/// What the data were compared with.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Compared {
    /// A revision, a folder, a baseline.
    pub with: String,
    /// How many findings no longer occur.
    pub gone: usize,
    /// How many there are less of than before.
    #[serde(skip_serializing_if = "is_none")]
    pub smaller: usize,
}

/// Whether there are none.
#[expect(clippy::trivially_copy_pass_by_ref, reason = "serde asks by reference")]
const fn is_none(count: &usize) -> bool {
    *count == 0
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
    /// What it was taken for, and why.
    #[serde(flatten)]
    pub identity: Identity,
}

/// How a run ended for one application.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub struct ApplicationVerdict {
    /// Whose data were checked.
    pub application: Application,
    /// Whether its own findings reach the limits of the run.
    pub verdict: Verdict,
}

/// How a run ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Verdict {
    /// No limit was reached.
    Pass,
    /// A limit was reached, or something is missing because of a bug of ours.
    Fail,
}

/// What was not checked, for one reason.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct NotChecked {
    /// The application that it was not checked for; none where that is not known.
    pub application: Option<Application>,
    /// What was not checked, and why.
    pub what: Unchecked,
    /// How many files, or names of files, it concerns.
    pub count: usize,
    /// The first few, by path.
    pub examples: Vec<String>,
    /// All of them.
    #[serde(skip)]
    pub paths: BTreeSet<String>,
}

/// What was not checked of a file, and why.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Unchecked {
    /// What is in it: no rule is about files of its kind.
    Kind,
    /// What is in it: files of its kind are checked as parts of others, and none of these names it.
    Unused,
    /// What is in it: it lies in no data folder.
    Outside,
    /// Anything: they are tables of an add-on that makes assets, no assets.
    Helpers,
    /// Anything: they are test data, broken on purpose.
    Tests,
    /// Vertex numbers: the base mesh is not known.
    NoBaseMesh,
    /// Vertex numbers: the system data that were given have no base mesh of that name.
    BaseNotInSystem,
    /// Vertex numbers: nothing says which of the base meshes it is for.
    BaseNotKnown,
    /// Whether the file of this name exists: no system data were given.
    NoSystem,
    /// What is in a folder: it could not be listed.
    Closed,
    /// Whether what is found is new: contents to compare with are not at hand.
    NotCompared,
    /// All of what is in it: there is more than is kept of a file of its kind.
    Part,
    /// What is in a member of a zip: it is packed in a way that the applications read and this
    /// program does not.
    Packed,
    /// What all of the macros do: there are more, or more settings of them, than are looked at.
    TooManyMacros,
    /// All that a base mesh comes to: there are more settings of its sliders, or joints, than are
    /// evaluated.
    Evaluation,
}

/// What alone was reported on, where that is not all of the data. Empty lists narrow nothing.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Scope {
    /// Parts of data roots that alone were asked for, as printed.
    pub paths: Vec<String>,
    /// Globs of paths that are excluded.
    pub excluded: Vec<String>,
    /// Base meshes that alone were asked for.
    pub bases: Vec<String>,
    /// Rules that alone were asked for, by what they were named with.
    pub rules: Vec<String>,
    /// Rules that are off, by what they were named with.
    pub without: Vec<String>,
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
    /// Findings that were ignored, or are in the baseline.
    pub suppressed: usize,
    /// Files that were checked.
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
    /// What.
    pub what: Timed,
    /// How long, added up over threads for rules.
    pub time: Duration,
}

/// What time was spent on.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Timed {
    /// A phase of the run.
    Phase(Phase),
    /// The rule of this id.
    Rule(&'static str),
}

/// A phase of a run. `report` has the words.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Phase {
    /// Finding and reading everything but targets.
    Read,
    /// Reading targets, and measuring base meshes with them.
    Evaluation,
    /// The rules, and what becomes of their findings.
    Rules,
    /// Lines and columns of findings.
    Places,
}

/// Work besides files and rules. `report` has the words.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum FailedStep {
    /// Measuring a base mesh.
    Evaluation {
        /// Its name.
        base: String,
    },
    /// Finding the lines and columns of findings.
    Places,
}

/// A PATH of which nothing was checked.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Untouched {
    /// As printed.
    pub path: String,
    /// Why, if anything of ours is there.
    pub what: Option<Unchecked>,
}

impl NotChecked {
    /// An entry for these files, or names of files.
    pub fn of(application: Option<Application>, what: Unchecked, paths: BTreeSet<String>) -> Self {
        let examples = paths.iter().take(EXAMPLES).cloned().collect();
        Self {
            application,
            what,
            count: paths.len(),
            examples,
            paths,
        }
    }
}

impl Outcome {
    /// Whether something at or above `limit` was found.
    pub fn has_at_least(&self, limit: Level) -> bool {
        self.findings.iter().any(|finding| finding.level >= limit)
    }

    /// Whether all of the work was done: no bug of ours took a file, a rule or a step away.
    pub fn is_whole(&self) -> bool {
        self.failed_rules.is_empty() && self.failed_files.is_empty() && self.failed_steps.is_empty()
    }

    /// Takes over what failed in another run.
    pub fn take_failures(&mut self, other: Self) {
        self.failed_rules.extend(other.failed_rules);
        self.failed_files.extend(other.failed_files);
        self.failed_steps.extend(other.failed_steps);
    }

    /// Whether any root was checked.
    pub fn checked_anything(&self) -> bool {
        !self.roots.is_empty()
    }
}
