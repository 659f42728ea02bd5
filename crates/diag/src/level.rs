//! The fixed vocabularies of a finding: how bad, how sure, for whom.

use std::fmt;

use serde::{Deserialize, Serialize};

/// How bad a finding is. Follows from the consequence in the applications, never from taste.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Level {
    /// Harmless today: waste, or a trap for the next change.
    Info,
    /// It loads, but what the author wrote is not what happens.
    Warning,
    /// An application crashes on it, refuses it, or loses the asset.
    Error,
}

/// How certain a finding is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Confidence {
    /// A guess that people should look at.
    Low,
    /// A heuristic that is usually right.
    Medium,
    /// Follows from what the loader does.
    High,
}

/// The applications of the family.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Application {
    /// `MakeHuman` 2.
    Makehuman2,
    /// `MakeHuman` 1.x.
    Makehuman1,
    /// MPFB, the Blender add-on.
    Mpfb,
}

impl Level {
    /// The word used on the command line and in every report.
    pub const fn word(self) -> &'static str {
        match self {
            Self::Info => "info",
            Self::Warning => "warning",
            Self::Error => "error",
        }
    }
}

impl Application {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Makehuman2, Self::Makehuman1, Self::Mpfb];

    /// The word used on the command line and in the JSON report.
    pub const fn word(self) -> &'static str {
        match self {
            Self::Makehuman2 => "makehuman2",
            Self::Makehuman1 => "makehuman1",
            Self::Mpfb => "mpfb",
        }
    }

    /// The name as people write it.
    pub const fn title(self) -> &'static str {
        match self {
            Self::Makehuman2 => "MakeHuman 2",
            Self::Makehuman1 => "MakeHuman 1",
            Self::Mpfb => "MPFB",
        }
    }
}

impl fmt::Display for Level {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.word())
    }
}

impl fmt::Display for Application {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.title())
    }
}
