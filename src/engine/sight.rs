//! How far a rule sees from the file at which it reports, besides what that file names: as it declares, or as is usual
//! with the kind of its check.

use crate::diag::{Finding, Level, Sight};
use crate::discover::Kind;
use crate::rules::{Check, RULES, Rule};

/// How far the rule of a finding on a file of this kind sees.
pub(super) fn sight(finding: &Finding, kind: Kind) -> Sight {
    let Some(rule) = rule_of(finding) else { return Sight::Base };
    match (rule.info.sight, &rule.check) {
        // The archive stands for all targets beside and below it.
        (_, Check::File(_) | Check::Repository(_)) if kind == Kind::TargetArchive => Sight::Folder,
        // Told of a folder, a finding has no neighbours.
        (Some(Sight::Folder | Sight::FolderAndRigs), check) if kind == Kind::Other => usual(check, finding, kind),
        (Some(declared), _) => declared,
        (None, check) => usual(check, finding, kind),
    }
}

fn usual(check: &Check, finding: &Finding, kind: Kind) -> Sight {
    match check {
        Check::File(_) | Check::Repository(_) => Sight::File,
        // Skeletons and weights are judged together.
        Check::Body(_) if matches!(kind, Kind::Skeleton | Kind::Weights) => Sight::Rigs,
        Check::Body(_) | Check::Makehuman2(_) | Check::Makehuman1(_) | Check::Mpfb(_) => Sight::File,
        // Old remarks on evaluated shapes are many, and no gate hangs on them.
        Check::Numeric(_) if finding.level == Level::Info => Sight::Rigs,
        Check::Numeric(_) | Check::Upkeep(_) => Sight::Base,
    }
}

/// Whether a finding is on evaluated shapes.
pub(super) fn is_numeric(finding: &Finding) -> bool {
    rule_of(finding).is_some_and(|rule| matches!(rule.check, Check::Numeric(_)))
}

fn rule_of(finding: &Finding) -> Option<&'static Rule> {
    RULES.iter().find(|rule| rule.info.id == finding.rule).copied()
}
