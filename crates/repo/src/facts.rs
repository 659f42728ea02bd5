//! What is kept of a file when its bytes are gone.

use std::sync::Arc;

use mhlint_diag::Application;
use mhlint_discover::{Kind, Use, kind_in, owner_of};
use mhlint_formats::asset_mesh::AssetMesh;
use mhlint_formats::bvh::Motion;
use mhlint_formats::face_expression::FaceExpression;
use mhlint_formats::face_units::FaceUnits;
use mhlint_formats::human_preset::HumanPreset;
use mhlint_formats::importer_preset::Makeup;
use mhlint_formats::index_table::IndexTable;
use mhlint_formats::ink_layer::InkLayer;
use mhlint_formats::inline_ignore::InlineIgnore;
use mhlint_formats::json_file::JsonFacts;
use mhlint_formats::macro_parts::MacroParts;
use mhlint_formats::mesh_metadata::{BodyDimensions, MirrorTable, VertexGroups};
use mhlint_formats::meta::Meta;
use mhlint_formats::mhbin::MeshFault;
use mhlint_formats::mhclo::Clothes;
use mhlint_formats::mhm::Model;
use mhlint_formats::mhmat::Material;
use mhlint_formats::mhpose::Pose;
use mhlint_formats::mhskel::Skeleton;
use mhlint_formats::mhw::Weights;
use mhlint_formats::modifiers::file::ModifierFile;
use mhlint_formats::modifiers::mapping::ModifierMapping;
use mhlint_formats::modifiers::sliders::ModifierSliders;
use mhlint_formats::modifiers::texts::ModifierTexts;
use mhlint_formats::npz::Archive;
use mhlint_formats::npz::targets::TargetsNpz;
use mhlint_formats::obj::Mesh;
use mhlint_formats::pack_metadata::PackMetadata;
use mhlint_formats::packed::asset::Packed;
use mhlint_formats::pickle::Danger;
use mhlint_formats::picture::Picture;
use mhlint_formats::picture_list::PictureList;
use mhlint_formats::pose_units::PoseUnits;
use mhlint_formats::program::{Shaders, Version};
use mhlint_formats::proxy_corrections::ProxyCorrections;
use mhlint_formats::rig::Rig;
use mhlint_formats::scene::Scene;
use mhlint_formats::selection_filter::SelectionFilter;
use mhlint_formats::shader_source::ShaderSource;
use mhlint_formats::stored_pose::StoredPose;
use mhlint_formats::target::TargetFacts;
use mhlint_formats::target_catalog::TargetCatalog;
use mhlint_formats::unfit::LoaderFaults;
use mhlint_formats::uv_layer::UvLayer;
use mhlint_formats::uv_map::UvMap;
use mhlint_formats::{Content, Format, Needs};
use mhlint_json::SchemaFaults;
use mhlint_source::{Encoding, GzipFault, ReadFault, file_name, parent, without_extension};

/// Facts of one file.
#[derive(Debug, Clone)]
pub struct FileFacts {
    /// Path as reports print it: relative to the working directory.
    pub path: String,
    /// Path relative to the data root.
    pub rel: String,
    /// Whether the file lies elsewhere than the application would keep it: [`rel`](Self::rel) is
    /// only supposed.
    pub is_loose: bool,
    /// Path relative to the data root of the file that this one is through a link, if that is in
    /// the root, too.
    pub link_to: Option<String>,
    /// What it is read as.
    pub kind: Kind,
    /// What it is for, to each application.
    pub uses: Vec<Use>,
    /// Size in bytes as stored.
    pub size: u64,
    /// Why its bytes could not be had.
    pub unreadable: Option<ReadFault>,
    /// Whether a reader of ours failed on it: a bug, for which nothing is known of what is in it.
    pub failed: bool,
    /// Why it could not be unpacked.
    pub gzip_fault: Option<GzipFault>,
    /// Encoding of the text.
    pub encoding: Encoding,
    /// Facts on the text of a JSON.
    pub json: JsonFacts,
    /// What the schema of its format says.
    pub schema: SchemaFaults,
    /// Mutes in its comments.
    pub ignores: Vec<InlineIgnore>,
    /// Hash of the decoded content where equal content matters.
    pub content_hash: Option<u64>,
    /// What was in it.
    pub content: Arc<Content>,
}

impl FileFacts {
    /// What it is for to one application.
    pub fn kind_in(&self, application: Application) -> Kind {
        kind_in(&self.uses, application)
    }

    /// The base mesh that it belongs to as what it is read as.
    pub fn base(&self) -> Option<&str> {
        owner_of(&self.uses)
    }

    /// The base mesh that it belongs to in one application.
    pub fn base_in(&self, application: Application) -> Option<&str> {
        self.uses
            .iter()
            .find(|one| one.application == application)?
            .owner
            .as_deref()
    }

    /// Path of the data root as reports print it.
    pub fn root(&self) -> &str {
        self.path
            .strip_suffix(self.rel.as_str())
            .unwrap_or_default()
            .trim_end_matches('/')
    }

    /// The path to show where one below the data root is wanted. A loose file has only a supposed
    /// place there, so it is shown where it lies.
    pub fn shown(&self) -> &str {
        if self.is_loose { &self.path } else { &self.rel }
    }

    /// Path of the folder as reports print it.
    pub fn folder(&self) -> &str {
        parent(&self.path)
    }

    /// File name without folders.
    pub fn file_name(&self) -> &str {
        file_name(&self.rel)
    }

    /// File name without folders and extension.
    pub fn stem(&self) -> &str {
        let name = self.file_name();
        without_extension(name)
    }

    /// Whether the top level of a JSON is of a wrong type, or lacks a section without which nothing
    /// is read.
    pub fn is_misshapen(&self) -> bool {
        self.schema
            .faults
            .iter()
            .any(|fault| fault.pointer.is_empty())
    }

    /// Whether it names vertices of a base mesh.
    pub fn names_vertices(&self) -> bool {
        let names_some = match &*self.content {
            Content::Target(facts) => facts.rows > 0,
            Content::Skeleton(skeleton) => {
                skeleton.joints.iter().any(|joint| joint.vertices.is_some())
            }
            Content::Weights(weights) => weights.bones.iter().any(|bone| bone.listed > 0),
            Content::Clothes(clothes) => clothes.rows.count > 0,
            _ => false,
        };
        names_some && Format::of(self.kind).needs != Needs::Nothing
    }

    /// Whether there is more in it than is kept.
    pub fn is_kept_in_part(&self) -> bool {
        match &*self.content {
            Content::Material(material) => material.left_out > 0,
            Content::Filter(filter) => filter.is_cut,
            _ => false,
        }
    }

    /// The target facts, if it is a target that could be read.
    pub fn target(&self) -> Option<&TargetFacts> {
        if let Content::Target(facts) = &*self.content {
            Some(facts)
        } else {
            None
        }
    }

    /// The catalogue of sliders, if it is one that could be read.
    pub fn catalog(&self) -> Option<&TargetCatalog> {
        if let Content::Catalog(catalog) = &*self.content {
            Some(catalog)
        } else {
            None
        }
    }

    /// The modifiers of `MakeHuman` 1, if they could be read.
    pub fn modifier_file(&self) -> Option<&ModifierFile> {
        if let Content::Modifiers(file) = &*self.content {
            Some(file)
        } else {
            None
        }
    }

    /// What is said of modifiers of `MakeHuman` 1, if it could be read.
    pub fn modifier_texts(&self) -> Option<&ModifierTexts> {
        if let Content::ModifierTexts(texts) = &*self.content {
            Some(texts)
        } else {
            None
        }
    }

    /// The sliders of `MakeHuman` 1, if they could be read.
    pub fn modifier_sliders(&self) -> Option<&ModifierSliders> {
        if let Content::Sliders(sliders) = &*self.content {
            Some(sliders)
        } else {
            None
        }
    }

    /// Older names of modifiers of `MakeHuman` 1, if it is the table of these.
    pub fn modifier_mapping(&self) -> Option<&ModifierMapping> {
        if let Content::Mapping(mapping) = &*self.content {
            Some(mapping)
        } else {
            None
        }
    }

    /// The names of frames that expressions of `MakeHuman` 1 are made of, if they could be read.
    pub fn face_units(&self) -> Option<&FaceUnits> {
        if let Content::FaceUnits(units) = &*self.content {
            Some(units)
        } else {
            None
        }
    }

    /// The parts of the macro settings, if they could be read.
    pub fn macro_parts(&self) -> Option<&MacroParts> {
        if let Content::Parts(parts) = &*self.content {
            Some(parts)
        } else {
            None
        }
    }

    /// The expression of MPFB, if it is one that could be read.
    pub fn face_expression(&self) -> Option<&FaceExpression> {
        if let Content::FaceExpression(expression) = &*self.content {
            Some(expression)
        } else {
            None
        }
    }

    /// The saved character of MPFB, if it is one that could be read.
    pub fn human_preset(&self) -> Option<&HumanPreset> {
        if let Content::HumanPreset(preset) = &*self.content {
            Some(preset)
        } else {
            None
        }
    }

    /// The ink layer, if it is one that could be read.
    pub fn ink_layer(&self) -> Option<&InkLayer> {
        if let Content::InkLayer(layer) = &*self.content {
            Some(layer)
        } else {
            None
        }
    }

    /// The rig, if it is one of MPFB that could be read.
    pub fn rig(&self) -> Option<&Rig> {
        if let Content::Rig(rig) = &*self.content {
            Some(rig)
        } else {
            None
        }
    }

    /// The vertex groups of MPFB's base mesh, if they could be read.
    pub fn vertex_groups(&self) -> Option<&VertexGroups> {
        if let Content::VertexGroups(groups) = &*self.content {
            Some(groups)
        } else {
            None
        }
    }

    /// The dimensions of MPFB's body, if they could be read.
    pub fn body_dimensions(&self) -> Option<&BodyDimensions> {
        if let Content::BodyDimensions(dimensions) = &*self.content {
            Some(dimensions)
        } else {
            None
        }
    }

    /// What MPFB corrects of proxies, if it could be read.
    pub fn proxy_corrections(&self) -> Option<&ProxyCorrections> {
        if let Content::ProxyCorrections(corrections) = &*self.content {
            Some(corrections)
        } else {
            None
        }
    }

    /// The mirror table of MPFB's base mesh.
    pub fn mirror_table(&self) -> Option<&MirrorTable> {
        if let Content::MirrorTable(table) = &*self.content {
            Some(table)
        } else {
            None
        }
    }

    /// A table of faces or vertices of MPFB's base mesh.
    pub fn index_table(&self) -> Option<&IndexTable> {
        if let Content::IndexTable(table) = &*self.content {
            Some(table)
        } else {
            None
        }
    }

    /// The pose of MPFB, if it is one that could be read.
    pub fn stored_pose(&self) -> Option<&StoredPose> {
        if let Content::StoredPose(pose) = &*self.content {
            Some(pose)
        } else {
            None
        }
    }

    /// The UV layer of MPFB.
    pub fn uv_layer(&self) -> Option<&UvLayer> {
        if let Content::UvLayer(layer) = &*self.content {
            Some(layer)
        } else {
            None
        }
    }

    /// The assets of a pack, if it could be read.
    pub fn pack_metadata(&self) -> Option<&PackMetadata> {
        if let Content::PackMetadata(pack) = &*self.content {
            Some(pack)
        } else {
            None
        }
    }

    /// The makeup, if it is one that could be read.
    pub fn makeup(&self) -> Option<&Makeup> {
        if let Content::Makeup(makeup) = &*self.content {
            Some(makeup)
        } else {
            None
        }
    }

    /// What the loader of a JSON cannot take, where nothing else of it matters.
    pub fn loader_faults(&self) -> Option<&LoaderFaults> {
        if let Content::Loaded(faults) = &*self.content {
            Some(faults)
        } else {
            None
        }
    }

    /// The archive, if it is one that was read.
    pub fn archive(&self) -> Option<&Archive> {
        if let Content::Archive(archive) = &*self.content {
            Some(archive)
        } else {
            None
        }
    }

    /// The weights, if it is a weights file that could be read.
    pub fn weights(&self) -> Option<&Weights> {
        if let Content::Weights(weights) = &*self.content {
            Some(weights)
        } else {
            None
        }
    }

    /// The skeleton, if it is one that could be read.
    pub fn skeleton(&self) -> Option<&Skeleton> {
        if let Content::Skeleton(skeleton) = &*self.content {
            Some(skeleton)
        } else {
            None
        }
    }

    /// An archive other than of targets or a base mesh, if it is one.
    pub fn packed(&self) -> Option<&Packed> {
        if let Content::Packed(packed) = &*self.content {
            Some(packed)
        } else {
            None
        }
    }

    /// The mesh of an asset, if it is one that could be read.
    pub fn asset_mesh(&self) -> Option<&AssetMesh> {
        if let Content::AssetMesh(mesh) = &*self.content {
            Some(mesh)
        } else {
            None
        }
    }

    /// What is worn, if it is that and could be read.
    pub fn clothes(&self) -> Option<&Clothes> {
        if let Content::Clothes(clothes) = &*self.content {
            Some(clothes)
        } else {
            None
        }
    }

    /// The material, if it is one that could be read.
    pub fn material(&self) -> Option<&Material> {
        if let Content::Material(material) = &*self.content {
            Some(material)
        } else {
            None
        }
    }

    /// The source of a shader, if it is one.
    pub fn shader_source(&self) -> Option<&ShaderSource> {
        if let Content::ShaderSource(source) = &*self.content {
            Some(source)
        } else {
            None
        }
    }

    /// The map of texture coordinates, if it is one.
    pub fn uv_map(&self) -> Option<&UvMap> {
        if let Content::UvMap(map) = &*self.content {
            Some(map)
        } else {
            None
        }
    }

    /// The picture, as far as its ends show it.
    pub fn picture(&self) -> Option<&Picture> {
        if let Content::Picture(picture) = &*self.content {
            Some(picture)
        } else {
            None
        }
    }

    /// The archive of all targets of MakeHuman 1, or why it is none.
    pub fn targets_npz(&self) -> Option<&TargetsNpz> {
        if let Content::TargetsNpz(archive) = &*self.content {
            Some(archive)
        } else {
            None
        }
    }

    /// The pictures of sliders that go with it.
    pub fn picture_list(&self) -> Option<&PictureList> {
        if let Content::PictureList(list) = &*self.content {
            Some(list)
        } else {
            None
        }
    }

    /// The scene, or why it is none.
    pub fn scene(&self) -> Option<&Scene> {
        if let Content::Scene(scene) = &*self.content {
            Some(scene)
        } else {
            None
        }
    }

    /// What imports or calls in the list of a library.
    pub fn library_cache(&self) -> Option<&[Danger]> {
        if let Content::LibraryCache(dangers) = &*self.content {
            Some(dangers)
        } else {
            None
        }
    }

    /// The motion, as far as it could be read.
    pub fn motion(&self) -> Option<&Motion> {
        if let Content::Motion(motion) = &*self.content {
            Some(motion)
        } else {
            None
        }
    }

    /// The pose, if it is one that could be read.
    pub fn pose(&self) -> Option<&Pose> {
        if let Content::Pose(pose) = &*self.content {
            Some(pose)
        } else {
            None
        }
    }

    /// The pose units, if they could be read.
    pub fn pose_units(&self) -> Option<&PoseUnits> {
        if let Content::PoseUnits(pose_units) = &*self.content {
            Some(pose_units)
        } else {
            None
        }
    }

    /// The selection filter, if it could be read.
    pub fn filter(&self) -> Option<&SelectionFilter> {
        if let Content::Filter(filter) = &*self.content {
            Some(filter)
        } else {
            None
        }
    }

    /// The version of the program, if it could be read.
    pub fn version(&self) -> Option<&Version> {
        if let Content::Version(version) = &*self.content {
            Some(version)
        } else {
            None
        }
    }

    /// What is known of shaders, if it could be read.
    pub fn shaders(&self) -> Option<&Shaders> {
        if let Content::Shaders(shaders) = &*self.content {
            Some(shaders)
        } else {
            None
        }
    }

    /// The model, if it is one that was read.
    pub fn model(&self) -> Option<&Model> {
        if let Content::Model(model) = &*self.content {
            Some(model)
        } else {
            None
        }
    }

    /// What is said of a motion, if it could be read.
    pub fn meta(&self) -> Option<&Meta> {
        if let Content::Meta(meta) = &*self.content {
            Some(meta)
        } else {
            None
        }
    }

    /// The mesh, if it is one that could be read, as text or packed.
    pub fn mesh(&self) -> Option<&Mesh> {
        match &*self.content {
            Content::Mesh(mesh) => Some(mesh),
            Content::MeshArchive(packed) => packed.as_ref().as_ref().ok(),
            Content::Packed(packed) => match &**packed {
                Packed::Mesh(Ok(mesh)) => mesh.whole.as_deref(),
                _ => None,
            },
            _ => None,
        }
    }

    /// Why a packed mesh cannot be loaded.
    pub fn mesh_fault(&self) -> Option<&MeshFault> {
        if let Content::MeshArchive(packed) = &*self.content {
            packed.as_ref().as_ref().err()
        } else {
            None
        }
    }
}
