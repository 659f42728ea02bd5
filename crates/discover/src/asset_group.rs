//! Which group of assets the files of a kind belong to, for counting assets.

use super::Kind;
use mhlint_diag::AssetGroup;

impl Kind {
    /// The group of assets that files of this kind belong to; `None` for files that no application
    /// is known to load.
    pub const fn group(self) -> Option<AssetGroup> {
        Some(match self {
            Self::BaseJson
            | Self::BaseMesh
            | Self::MeshArchive
            | Self::PackedBaseMesh
            | Self::Geometry
            | Self::VertexGroups
            | Self::BodyDimensions
            | Self::MirrorTable
            | Self::FaceTable
            | Self::VertexTable => AssetGroup::BaseMesh,
            Self::Target
            | Self::PackedTarget
            | Self::PartTarget
            | Self::PackedPartTarget
            | Self::TargetArchive
            | Self::TargetsNpz => AssetGroup::Targets,
            Self::MacroJson
            | Self::ModellingJson
            | Self::ModifierFile
            | Self::ModifierTexts
            | Self::ModifierSliders
            | Self::ModifierMapping
            | Self::TargetCategories
            | Self::TargetCatalog
            | Self::MacroParts => AssetGroup::Sliders,
            Self::Skeleton | Self::Rig | Self::CustomRig | Self::Weights => AssetGroup::Rigs,
            Self::FaceUnits
            | Self::FaceExpression
            | Self::StoredPose
            | Self::Pose
            | Self::PoseUnits
            | Self::Motion
            | Self::MotionMeta => AssetGroup::Poses,
            Self::Clothes
            | Self::AssetMesh
            | Self::AssetWeights
            | Self::SubRig
            | Self::UvMap
            | Self::Packed
            | Self::ProxyCorrections => AssetGroup::Clothes,
            Self::Material
            | Self::ShaderSource
            | Self::Shaders
            | Self::SkinSettings
            | Self::EyeSettings
            | Self::InkLayer
            | Self::UvLayer
            | Self::NodeTree => AssetGroup::Materials,
            Self::Image | Self::TargetIcon | Self::PictureList => AssetGroup::Pictures,
            Self::Model
            | Self::HumanPreset
            | Self::ImporterPreset
            | Self::MakeupPreset
            | Self::RandomizationPreset => AssetGroup::Models,
            Self::Language
            | Self::SelectionFilter
            | Self::Version
            | Self::ProgramSettings
            | Self::Scene
            | Self::LibraryCache
            | Self::PackMetadata => AssetGroup::Program,
            Self::ConfigJson | Self::Unlisted | Self::Json | Self::Other => return None,
        })
    }
}
