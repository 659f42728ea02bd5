//! What became of the ignores of a run: facts for the rules that check them.

use super::Place;

/// Ignores, settings and baseline after everything was checked.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Upkeep {
    /// Every ignore, of the configuration and in the assets.
    pub ignores: Vec<IgnoreUse>,
    /// Settings for rules that do not exist.
    pub unknown: Vec<UnknownRule>,
    /// Globs of the configuration that fit nothing.
    pub idle: Vec<IdleGlob>,
    /// The baseline, if there is one.
    pub baseline: Option<BaselineUse>,
    /// Whether errors were found that neither an ignore nor the baseline hides. A file that cannot
    /// be read hides what else was found in it and of it, so what is not found any more need not be
    /// fixed.
    pub errors: bool,
}

/// One ignore: an `[[ignore]]` of the configuration, or a comment in an asset.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct IgnoreUse {
    /// The file that it stands in.
    pub path: String,
    /// Where in it.
    pub place: Place,
    /// The rule, or a glob of rules.
    pub rule: String,
    /// The files that it is for, where it does not stand in one of them.
    pub covers: Option<String>,
    /// What became of it.
    pub state: IgnoreState,
}

/// What became of an ignore.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum IgnoreState {
    /// It hides something.
    Used,
    /// There is nothing that it could hide.
    Unused,
    /// This run did not look at all of what it is for.
    NotChecked,
    /// Without a reason it does not count.
    NoReason,
    /// Its last day is over.
    Expired {
        /// That day.
        until: String,
    },
    /// The comment is not written as an ignore has to be.
    Malformed {
        /// What it says.
        words: String,
    },
    /// The rule is a matter of safety.
    CannotBeIgnored,
    /// There is no such rule.
    UnknownRule {
        /// One that may be meant.
        nearest: Option<&'static str>,
    },
}

/// A setting of the configuration for a rule that does not exist.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct UnknownRule {
    /// The configuration file.
    pub path: String,
    /// Where in it.
    pub place: Place,
    /// What the setting is: `skip`, `level`.
    pub setting: String,
    /// The name or glob that fits no rule.
    pub rule: String,
    /// One that may be meant.
    pub nearest: Option<&'static str>,
}

/// A glob of the configuration that fits no file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct IdleGlob {
    /// The configuration file.
    pub path: String,
    /// Where in it.
    pub place: Place,
    /// What the glob stands in: `exclude`, `[[path]]`.
    pub setting: &'static str,
    /// As written.
    pub glob: String,
    /// A glob that fits something and may be meant.
    pub meant: Option<String>,
}

/// What became of the entries of a baseline.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct BaselineUse {
    /// The file.
    pub path: String,
    /// Entries that this run could have found again.
    pub checked: usize,
    /// Those of them that it did not find, as `path: rule key`.
    pub stale: Vec<String>,
}
