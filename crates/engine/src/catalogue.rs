//! What this version checks, and its rules as data, for whoever lists, explains or configures them.

use mhlint_diag::{Application, RuleInfo};
use mhlint_discover::Kind;
use mhlint_repo::makehuman1::is_checked;
use mhlint_rules::{Check, RULES, Rule};

/// Whether rules are about what is in files of this kind, for an application. Of other files only
/// the name, the encoding and the syntax are checked.
pub(super) const fn has_rules(application: Application, kind: Kind) -> bool {
    match application {
        Application::Makehuman2 => matches!(
            kind,
            Kind::BaseJson
                | Kind::BaseMesh
                | Kind::MeshArchive
                | Kind::Geometry
                | Kind::MacroJson
                | Kind::ModellingJson
                | Kind::TargetCategories
                | Kind::Target
                | Kind::TargetArchive
                | Kind::TargetIcon
                | Kind::Skeleton
                | Kind::Pose
                | Kind::PoseUnits
                | Kind::SelectionFilter
                | Kind::Version
                | Kind::Shaders
                | Kind::Model
                | Kind::Motion
                | Kind::MotionMeta
                | Kind::Weights
                | Kind::AssetWeights
                | Kind::Clothes
                | Kind::Material
                | Kind::AssetMesh
                | Kind::Packed
                | Kind::Image
        ),
        Application::Mpfb => {
            kind.is_judged_by_loader()
                || matches!(
                    kind,
                    Kind::BaseMesh
                        | Kind::Weights
                        | Kind::AssetWeights
                        | Kind::TargetCatalog
                        | Kind::MacroParts
                        | Kind::Model
                        | Kind::Target
                        | Kind::PackedTarget
                        | Kind::PartTarget
                        | Kind::PackedPartTarget
                        | Kind::TargetIcon
                        | Kind::MirrorTable
                        | Kind::FaceTable
                        | Kind::VertexTable
                        | Kind::UvLayer
                        | Kind::Motion
                        | Kind::Image
                        | Kind::Clothes
                        | Kind::AssetMesh
                        | Kind::Material
                )
        }
        Application::Makehuman1 => is_checked(kind) || matches!(kind, Kind::Unlisted),
    }
}

/// The rule of that id.
pub(super) fn named(id: &str) -> Option<&'static Rule> {
    RULES.iter().copied().find(|rule| rule.info.id == id)
}

/// The declared halves of the rules, sorted by id.
pub fn rule_infos() -> Vec<&'static RuleInfo> {
    RULES.iter().map(|rule| &rule.info).collect()
}

/// Whether a rule is about ignores, settings and the baseline, and about no asset.
pub(super) fn is_upkeep(rule: &str) -> bool {
    named(rule).is_some_and(|known| matches!(known.check, Check::Upkeep(_)))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Sound and broken data of an application without rules would pass alike.
    #[test]
    fn what_is_checked_has_rules_on_its_files_and_on_its_data() {
        for application in Application::ALL {
            let own = || RULES.iter().filter(|rule| rule.concerns(application));
            assert!(
                own().any(|rule| matches!(rule.check, Check::File(_))),
                "{application:?}"
            );
            assert!(
                own().any(|rule| matches!(rule.check, Check::Body(_) | Check::Repository(_))),
                "{application:?}"
            );
            assert!(own().count() > 20, "{application:?}");
        }
    }
}
