//! How far a rule sees from the file at which it reports, besides what that file names.

use crate::diag::{Finding, Level};
use crate::discover::{Kind, kind_of};
use crate::rules::{Check, RULES};

/// The files of its base mesh that a finding can come from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Sight {
    /// The one that it stands at.
    File,
    /// Those in the same folder and below.
    Folder,
    /// Skeletons and weights.
    Rigs,
    /// Skeletons and weights, and files in the same folder.
    FolderAndRigs,
    /// All.
    Base,
}

/// Families that judge a file by itself, by what it names, and by the files that decide over a base mesh.
const BY_THEMSELVES: [&str; 7] = ["file-", "json-", "macro-", "mesh-", "modelling-", "skeleton-", "weights-"];

/// Rules of these families that look for files that nothing names, or for what is not there.
const LOOKING_FURTHER: [&str; 6] = [
    "file-unreferenced",
    "macro-folder-missing",
    "macro-missing-combination",
    "macro-missing-target",
    "macro-unreferenced-target",
    "modelling-no-effect",
];

/// Rules that ask of a target whether something names it; files with names decide over the base mesh.
const OF_ONE_TARGET: [&str; 3] = ["target-breaks-start", "target-oversized-delta", "target-unreferenced"];

/// How far the rule of a finding at `rel` sees.
pub(super) fn sight(finding: &Finding, rel: &str) -> Sight {
    let rule = finding.rule;
    let kind = kind_of(rel).0;
    let checks = RULES.iter().find(|known| known.info.id == rule).map(|known| &known.check);
    match checks {
        // The archive stands for all targets beside and below it.
        Some(Check::Layer(_) | Check::Repository(_)) if kind == Kind::TargetArchive => Sight::Folder,
        Some(Check::Numeric(_)) if kind == Kind::Target && rule.starts_with("target-") => Sight::FolderAndRigs,
        // Old remarks on evaluated shapes are many, and no gate hangs on them.
        Some(Check::Numeric(_)) if finding.level == Level::Info => Sight::Rigs,
        Some(Check::Numeric(_)) => Sight::Base,
        _ if LOOKING_FURTHER.contains(&rule) => Sight::Base,
        Some(Check::Layer(_) | Check::Repository(_)) => Sight::File,
        _ if OF_ONE_TARGET.contains(&rule) => Sight::File,
        _ if BY_THEMSELVES.iter().any(|family| rule.starts_with(family)) => own_sight(kind),
        _ if kind == Kind::Target && rule.starts_with("target-") => Sight::Folder,
        _ => Sight::Base,
    }
}

/// Skeletons and weights are judged together.
fn own_sight(kind: Kind) -> Sight {
    if matches!(kind, Kind::Skeleton | Kind::Weights) { Sight::Rigs } else { Sight::File }
}
