//! What is known of a rule without running it: id, level, consequences, texts.

use serde::Serialize;

use super::{Application, Grows, Level};

/// The declared half of a rule; everything public (table, `explain`, reports) is derived from it.
#[derive(Debug, Clone, Copy)]
#[expect(
    clippy::struct_excessive_bools,
    reason = "each is a declared property of its own, most of them rare"
)]
pub struct RuleInfo {
    /// `family-fault`, kebab-case; never reused, never renamed without an alias.
    pub id: &'static str,
    /// The bad state in a few words: "allow `summary`" must make sense.
    pub summary: &'static str,
    /// The usual (worst) level.
    pub level: Level,
    /// The usual level in applications where it is another one.
    pub levels: &'static [(Application, Level)],
    /// Whether and how it can be repaired automatically.
    pub fix: FixKind,
    /// Cannot be ignored or lowered: a matter of safety.
    pub cannot_be_ignored: bool,
    /// A fingerprint names the file at which a finding stands in place of its asset: several
    /// findings may have one asset and key, and are told apart by their parts.
    pub told_apart: bool,
    /// Says how things stand in a library or a data folder: it is not asked of assets that lie in
    /// none.
    pub of_library: bool,
    /// Takes the data of a program for a whole: it is not asked of a part of them.
    pub of_whole: bool,
    /// Is asked of a part of a program's data, too, although its family is about the whole.
    pub of_pieces: bool,
    /// What each application does with it.
    pub breaks: &'static [(Application, &'static str)],
    /// What the worst value of its evidence measures, and which way that is worse.
    pub grows: Option<Grows>,
    /// What its evidence counts, in the plural; empty where findings of it count different things.
    pub counts: &'static str,
    /// Typed options with their defaults.
    pub options: &'static [OptionInfo],
    /// What it means, why it matters, what to do: paragraphs as they lie in a file beside the rule,
    /// lines wrapped.
    pub docs: &'static str,
}

/// What a case of a rule comes to where that is not what the rule says in general: in these
/// applications alone, so that no other one is told their words.
pub type Case = &'static [(Application, Level, &'static str)];

/// Whether a rule can repair what it finds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FixKind {
    /// Only a person can.
    None,
    /// `--fix`.
    Safe,
    /// `--fix --unsafe-fixes`.
    Unsafe,
}

impl FixKind {
    /// The word in lists and reports.
    pub const fn word(self) -> &'static str {
        match self {
            Self::None => "none",
            Self::Safe => "safe",
            Self::Unsafe => "unsafe",
        }
    }
}

/// One numeric option of a rule.
#[derive(Debug, Clone, Copy, Serialize)]
pub struct OptionInfo {
    /// Key in `[rule.<id>]`.
    pub name: &'static str,
    /// Value when nobody sets it.
    pub default: f64,
    /// Meaning and unit.
    pub docs: &'static str,
}

impl RuleInfo {
    /// What the rule reports and why, in paragraphs of one line each; lists and tables keep their
    /// lines.
    pub fn documentation(&self) -> String {
        let is_kept = |line: &str| line.starts_with(['-', '|']);
        let unwrapped = |paragraph: &str| {
            if paragraph.lines().any(is_kept) {
                paragraph.to_owned()
            } else {
                paragraph.replace('\n', " ")
            }
        };
        self.docs
            .split("\n\n")
            .map(unwrapped)
            .collect::<Vec<_>>()
            .join("\n\n")
    }

    /// A rule with nothing but the obligatory parts; the rest by struct update.
    pub const fn new(id: &'static str, level: Level, summary: &'static str) -> Self {
        let (fix, cannot_be_ignored, told_apart) = (FixKind::None, false, false);
        let (of_library, of_whole, of_pieces) = (false, false, false);
        let (levels, breaks, options, counts) = (&[], &[], &[], "");
        Self {
            id,
            summary,
            level,
            levels,
            fix,
            cannot_be_ignored,
            told_apart,
            of_library,
            of_whole,
            of_pieces,
            breaks,
            grows: None,
            counts,
            options,
            docs: "",
        }
    }

    /// The usual level in an application.
    pub fn level_in(&self, application: Application) -> Level {
        let own = self.levels.iter().find(|(other, _)| *other == application);
        own.map_or(self.level, |(_, level)| *level)
    }

    /// The part of the id before the first dash.
    pub fn family(&self) -> &'static str {
        self.id.split('-').next().unwrap_or(self.id)
    }
}

/// A rule that is an error for one application and an info for another one, for tests.
#[cfg(test)]
pub(crate) const OF_TWO: RuleInfo = RuleInfo {
    breaks: &[
        (Application::Makehuman2, "stops"),
        (Application::Mpfb, "ignores it"),
    ],
    levels: &[(Application::Mpfb, Level::Info)],
    ..RuleInfo::new("a-rule", Level::Error, "a fault")
};
