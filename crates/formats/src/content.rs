//! What is kept of a file's content.

use super::asset_mesh::AssetMesh;
use super::base_json::BaseJson;
use super::bvh::Motion;
use super::face_expression::FaceExpression;
use super::face_units::FaceUnits;
use super::geometry::Geometry;
use super::human_preset::HumanPreset;
use super::importer_preset::Makeup;
use super::index_table::IndexTable;
use super::ink_layer::InkLayer;
use super::json_file::JsonFault;
use super::macro_json::MacroFile;
use super::macro_parts::MacroParts;
use super::mesh_metadata::{BodyDimensions, MirrorTable, VertexGroups};
use super::meta::Meta;
use super::mhbin::MeshFault;
use super::mhclo::Clothes;
use super::mhm::Model;
use super::mhmat::Material;
use super::mhpose::Pose;
use super::mhskel::Skeleton;
use super::mhw::Weights;
use super::modelling::Modelling;
use super::npz::Archive;
use super::obj::Mesh;
use super::outdated::{Alpha, Outdated};
use super::pack_metadata::PackMetadata;
use super::pickle::Danger;
use super::picture::Picture;
use super::picture_list::PictureList;
use super::pose_units::PoseUnits;
use super::program::{Shaders, Version};
use super::proxy_corrections::ProxyCorrections;
use super::randomization::Randomization;
use super::rig::Rig;
use super::scene::Scene;
use super::selection_filter::SelectionFilter;
use super::shader_source::ShaderSource;
use super::stored_pose::StoredPose;
use super::target::TargetFacts;
use super::target_cat::TargetCategories;
use super::target_catalog::TargetCatalog;
use super::unfit::LoaderFaults;
use super::uv_layer::UvLayer;
use super::uv_map::UvMap;
use crate::modifiers::file::ModifierFile;
use crate::modifiers::mapping::ModifierMapping;
use crate::modifiers::sliders::ModifierSliders;
use crate::modifiers::texts::ModifierTexts;
use crate::npz::targets::TargetsNpz;
use crate::packed::asset::Packed;

/// Content of a file as rules need it.
#[derive(Debug, Clone, Default)]
pub enum Content {
    /// Not read: of no interest, or unreadable.
    #[default]
    Unread,
    /// A JSON that the application cannot read.
    Broken(JsonFault),
    /// A JSON without a model of its own.
    Json,
    /// `base.json`.
    BaseJson(Box<BaseJson>),
    /// `geometry.json`.
    Geometry(Box<Geometry>),
    /// `macro.json`.
    Macro(Box<MacroFile>),
    /// `modelling.json`.
    Modelling(Box<Modelling>),
    /// `*_modifiers.json` of MakeHuman 1.
    Modifiers(Box<ModifierFile>),
    /// `*_modifiers_desc.json` of MakeHuman 1.
    ModifierTexts(Box<ModifierTexts>),
    /// `*_sliders.json` of MakeHuman 1.
    Sliders(Box<ModifierSliders>),
    /// `mh_1-0_modifier_mapping.csv`.
    Mapping(Box<ModifierMapping>),
    /// `face-poseunits.json`.
    FaceUnits(Box<FaceUnits>),
    /// `target_cat.json`.
    Categories(Box<TargetCategories>),
    /// `target.json`.
    Catalog(Box<TargetCatalog>),
    /// `macro.json` of MPFB.
    Parts(Box<MacroParts>),
    /// An expression of MPFB.
    FaceExpression(Box<FaceExpression>),
    /// `human.*.json`.
    HumanPreset(Box<HumanPreset>),
    /// A saved character that is called something else.
    StrayCharacter,
    /// `makeup.*.json`.
    Makeup(Box<Makeup>),
    /// `basemesh_vertex_groups.json`.
    VertexGroups(Box<VertexGroups>),
    /// `hm08_config.json`.
    BodyDimensions(Box<BodyDimensions>),
    /// `proxy_corrective.json`.
    ProxyCorrections(Box<ProxyCorrections>),
    /// `hm08.mirror`.
    MirrorTable(Box<MirrorTable>),
    /// A table of faces or vertices of MPFB's base mesh.
    IndexTable(Box<IndexTable>),
    /// `poses/*/*.json` of MPFB.
    StoredPose(Box<StoredPose>),
    /// `uv_layers/*.json.gz`.
    UvLayer(Box<UvLayer>),
    /// `ink_layers/*.json`.
    InkLayer(Box<InkLayer>),
    /// `packs/*.json`.
    PackMetadata(Box<PackMetadata>),
    /// A JSON of which nothing matters but what its loader cannot take.
    Loaded(Box<LoaderFaults>),
    /// A preset of the randomizer of MPFB.
    Randomization(Box<Randomization>),
    /// A rig of MPFB.
    Rig(Box<Rig>),
    /// `.mhskel`.
    Skeleton(Box<Skeleton>),
    /// `.mhw`.
    Weights(Box<Weights>),
    /// `.obj` of a base mesh.
    Mesh(Box<Mesh>),
    /// `.obj` of an asset, without its vertices.
    AssetMesh(Box<AssetMesh>),
    /// `base.mhbin`: its mesh, or why it cannot be loaded.
    MeshArchive(Box<Result<Mesh, MeshFault>>),
    /// `.target`.
    Target(Box<TargetFacts>),
    /// `.mhclo`, `.proxy`, without the rows themselves.
    Clothes(Box<Clothes>),
    /// An archive that is neither a base mesh nor one of targets: of an asset, say.
    Packed(Box<Packed>),
    /// `.mhmat`.
    Material(Box<Material>),
    /// A source of a shader.
    ShaderSource(Box<ShaderSource>),
    /// `.mhuv`.
    UvMap(Box<UvMap>),
    /// `targets.npz`.
    TargetsNpz(Box<TargetsNpz>),
    /// `images.list`.
    PictureList(Box<PictureList>),
    /// `.mhscene`.
    Scene(Box<Scene>),
    /// `cache/*.mhc`: what in it imports or calls.
    LibraryCache(Vec<Danger>),
    /// `.mhpose`.
    Pose(Box<Pose>),
    /// `body-poses.json`, `face-poses.json`.
    PoseUnits(Box<PoseUnits>),
    /// `selection_filter.json`.
    Filter(Box<SelectionFilter>),
    /// `makehuman2_version.json`.
    Version(Box<Version>),
    /// `shaders/shader.json`.
    Shaders(Box<Shaders>),
    /// `.mhm`.
    Model(Box<Model>),
    /// `.meta`.
    Meta(Box<Meta>),
    /// A picture, as far as its ends show it.
    Picture(Box<Picture>),
    /// `.bvh`.
    Motion(Box<Motion>),
    /// `compressedtargets.npz`.
    Archive(Box<Archive>),
    /// A file of an older version that no program opens any more.
    Outdated(Outdated),
}

impl Content {
    /// The format of an older version that the file has instead of its own.
    pub fn outdated(&self) -> Option<Outdated> {
        match self {
            Self::Outdated(outdated) => Some(*outdated),
            Self::Clothes(clothes) => clothes.outdated,
            Self::Model(model) => model.outdated,
            // Rows tell nothing: every number is one of a vertex of today's mesh as well.
            Self::Target(target) => {
                let (_, named) = target.basemesh.as_ref()?;
                Alpha::of_basemesh(named).map(Outdated::Target)
            }
            _ => None,
        }
    }
}
