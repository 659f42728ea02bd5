//! How far a rule reaches from the file at which it reports, besides what that file names: as it declares, or as is usual
//! with the kind of its check.

use super::catalogue::named;
use crate::diag::{Extent, Finding, Level};
use crate::discover::Kind;
use crate::rules::Check;

/// How far the rule of a finding on a file of this kind reaches.
pub(super) fn extent(finding: &Finding, kind: Kind) -> Extent {
    let Some(rule) = named(finding.rule) else { return Extent::Base };
    match (rule.info.extent, &rule.check) {
        // The archive stands for all targets beside and below it.
        (_, Check::File(_) | Check::Repository(_)) if kind == Kind::TargetArchive => Extent::Folder,
        // Told of a folder, a finding has no neighbours.
        (Some(Extent::Folder | Extent::FolderAndRigs), check) if kind == Kind::Other => usual(check, finding, kind),
        (Some(declared), _) => declared,
        (None, check) => usual(check, finding, kind),
    }
}

fn usual(check: &Check, finding: &Finding, kind: Kind) -> Extent {
    match check {
        Check::File(_) | Check::Repository(_) => Extent::File,
        // Skeletons and weights are checked together.
        Check::Body(_) if matches!(kind, Kind::Skeleton | Kind::Weights) => Extent::Rigs,
        Check::Body(_) | Check::Makehuman2(_) | Check::Makehuman1(_) | Check::Mpfb(_) => Extent::File,
        // Old remarks on evaluated shapes are many, and no gate hangs on them.
        Check::Numeric(_) if finding.level == Level::Info => Extent::Rigs,
        Check::Numeric(_) | Check::Upkeep(_) => Extent::Base,
    }
}

/// Whether a finding is on evaluated shapes.
pub(super) fn is_numeric(finding: &Finding) -> bool {
    named(finding.rule).is_some_and(|rule| matches!(rule.check, Check::Numeric(_)))
}
