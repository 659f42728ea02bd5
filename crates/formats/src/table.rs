//! The table of formats: what is to be known of each kind of file before and while it is read.

use super::picture::{HEAD, TAIL};
use super::readers::{
    archive, asset_mesh, base_zip, clothes, index_table, library_cache, material, mesh,
    mesh_archive, meta, mirror_table, model, modifier_mapping, motion, packed, picture,
    picture_list, pose, scene, shader_source, stored_pose, target, targets_archive, unlisted,
    uv_layer, uv_map, weights, zip,
};
use super::{
    Content, Input, Parsed, base_json, face_expression, face_units, geometry, human_preset,
    importer_preset, ink_layer, look_settings, macro_json, macro_parts, mesh_metadata, mhskel,
    modelling, modifiers, node_tree, outdated, pack_metadata, pose_units, program,
    proxy_corrections, randomization, rig, selection_filter, target_cat, target_catalog,
};
use mhlint_discover::Kind;
use mhlint_json::Document;

/// What there is to know of a kind of files.
pub struct Format {
    /// The kind that it is the format of.
    pub kind: Kind,
    /// What people call it.
    pub title: &'static str,
    /// What its bytes are.
    pub syntax: Syntax,
    /// Name of its schema.
    pub schema: Option<&'static str>,
    /// What comments begin with, where they may hold ignores.
    pub comments: &'static [&'static str],
    /// Makes a model of it. A format without one gets the rules on any file, and on any JSON.
    pub reader: Option<Reader>,
    /// What has to be read before it.
    pub needs: Needs,
}

/// What the bytes of a file are.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Syntax {
    /// JSON.
    Json,
    /// Other text.
    Text,
    /// No text.
    Binary,
}

/// How a model is made.
#[derive(Clone, Copy)]
pub enum Reader {
    /// From the tree of a JSON.
    Tree(fn(&Document) -> Content),
    /// From the bytes.
    Bytes(fn(&Input<'_>) -> Parsed),
    /// From the first and the last bytes: what is between does not matter.
    Ends(fn(&Input<'_>) -> Parsed),
}

/// What has to be read before a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Needs {
    /// Nothing.
    Nothing,
    /// The mesh that it is measured against.
    Mesh,
    /// The mesh; and of all that is bulk, one base mesh is in memory at a time.
    MeshInTurn,
}

/// A format of which nothing but the syntax is known.
const fn plain(kind: Kind, title: &'static str, syntax: Syntax) -> Format {
    Format {
        kind,
        title,
        syntax,
        schema: None,
        comments: &[],
        reader: None,
        needs: Needs::Nothing,
    }
}

/// A JSON with a schema and a model.
const fn json(
    kind: Kind,
    title: &'static str,
    schema: &'static str,
    model: fn(&Document) -> Content,
) -> Format {
    Format {
        schema: Some(schema),
        ..tree(kind, title, model)
    }
}

/// A JSON with a model alone.
const fn tree(kind: Kind, title: &'static str, model: fn(&Document) -> Content) -> Format {
    Format {
        reader: Some(Reader::Tree(model)),
        ..plain(kind, title, Syntax::Json)
    }
}

/// A format with a reader of its bytes.
const fn read(
    kind: Kind,
    title: &'static str,
    syntax: Syntax,
    reader: fn(&Input<'_>) -> Parsed,
) -> Format {
    Format {
        reader: Some(Reader::Bytes(reader)),
        ..plain(kind, title, syntax)
    }
}

/// A rig of MPFB, whatever it is added to.
const fn rig_of(kind: Kind) -> Format {
    json(kind, "rig", "mpfb_rig", |json| {
        Content::Rig(Box::new(rig::read(json)))
    })
}

/// Weights, of whatever mesh.
const fn mhw(kind: Kind, needs: Needs) -> Format {
    Format {
        schema: Some("mhw"),
        needs,
        ..read(kind, "weights", Syntax::Json, weights)
    }
}

/// All formats, one a kind, in the order of [`Kind`].
pub static FORMATS: [Format; 70] = [
    json(Kind::BaseJson, "base.json", "base", |json| {
        Content::BaseJson(Box::new(base_json::read(json)))
    }),
    read(Kind::BaseMesh, "base mesh", Syntax::Text, mesh),
    read(
        Kind::MeshArchive,
        "packed base mesh",
        Syntax::Binary,
        mesh_archive,
    ),
    read(
        Kind::PackedBaseMesh,
        "packed base mesh",
        Syntax::Binary,
        base_zip,
    ),
    json(Kind::Geometry, "geometry.json", "geometry", |json| {
        Content::Geometry(Box::new(geometry::read(json)))
    }),
    json(Kind::MacroJson, "macro.json", "macro", |json| {
        Content::Macro(Box::new(macro_json::read(json)))
    }),
    json(Kind::ModellingJson, "modelling.json", "modelling", |json| {
        Content::Modelling(Box::new(modelling::read(json)))
    }),
    json(
        Kind::ModifierFile,
        "list of modifiers",
        "mh1_modifiers",
        |json| Content::Modifiers(Box::new(modifiers::file::read(json))),
    ),
    json(
        Kind::ModifierTexts,
        "descriptions of modifiers",
        "mh1_descriptions",
        |json| Content::ModifierTexts(Box::new(modifiers::texts::read(json))),
    ),
    json(
        Kind::ModifierSliders,
        "list of sliders",
        "mh1_sliders",
        |json| Content::Sliders(Box::new(modifiers::sliders::read(json))),
    ),
    read(
        Kind::ModifierMapping,
        "table of older names",
        Syntax::Text,
        modifier_mapping,
    ),
    json(Kind::FaceUnits, "face units", "mh1_units", |json| {
        Content::FaceUnits(Box::new(face_units::read(json)))
    }),
    json(Kind::Language, "language", "mh1_language", |_| {
        Content::Json
    }),
    json(
        Kind::TargetCategories,
        "target_cat.json",
        "target_cat",
        |json| Content::Categories(Box::new(target_cat::read(json))),
    ),
    json(Kind::TargetCatalog, "target.json", "mpfb_catalog", |json| {
        Content::Catalog(Box::new(target_catalog::read(json)))
    }),
    json(Kind::MacroParts, "macro.json", "mpfb_macro", |json| {
        Content::Parts(Box::new(macro_parts::read(json)))
    }),
    json(
        Kind::FaceExpression,
        "expression",
        "mpfb_expression",
        |json| Content::FaceExpression(Box::new(face_expression::read(json))),
    ),
    json(Kind::HumanPreset, "saved character", "mpfb_human", |json| {
        Content::HumanPreset(Box::new(human_preset::read(json)))
    }),
    json(
        Kind::ImporterPreset,
        "importer preset",
        "mpfb_importer",
        |json| Content::Loaded(Box::new(importer_preset::importer(json))),
    ),
    json(Kind::MakeupPreset, "makeup preset", "mpfb_makeup", |json| {
        Content::Makeup(Box::new(importer_preset::makeup(json)))
    }),
    json(
        Kind::RandomizationPreset,
        "randomization preset",
        "mpfb_randomization",
        |json| Content::Randomization(Box::new(randomization::read(json))),
    ),
    json(Kind::EyeSettings, "eye settings", "mpfb_eyes", |json| {
        Content::Loaded(Box::new(look_settings::eyes(json)))
    }),
    json(Kind::SkinSettings, "skin settings", "mpfb_skin", |json| {
        Content::Loaded(Box::new(look_settings::skin(json)))
    }),
    tree(Kind::ConfigJson, "JSON", |json| {
        match json.root.get("phenotype") {
            Some(_) => Content::StrayCharacter,
            None => Content::Json,
        }
    }),
    json(Kind::InkLayer, "ink layer", "mpfb_ink", |json| {
        Content::InkLayer(Box::new(ink_layer::read(json)))
    }),
    json(Kind::PackMetadata, "list of a pack", "mpfb_pack", |json| {
        Content::PackMetadata(Box::new(pack_metadata::read(json)))
    }),
    Format {
        schema: Some("mpfb_pose"),
        ..read(Kind::StoredPose, "pose", Syntax::Json, stored_pose)
    },
    Format {
        schema: Some("mpfb_uv_layer"),
        ..read(Kind::UvLayer, "UV layer", Syntax::Binary, uv_layer)
    },
    json(Kind::VertexGroups, "vertex groups", "mpfb_groups", |json| {
        Content::VertexGroups(Box::new(mesh_metadata::groups(json)))
    }),
    json(
        Kind::BodyDimensions,
        "dimensions of the body",
        "mpfb_dimensions",
        |json| Content::BodyDimensions(Box::new(mesh_metadata::dimensions(json))),
    ),
    json(
        Kind::ProxyCorrections,
        "corrections of proxies",
        "mpfb_corrections",
        |json| Content::ProxyCorrections(Box::new(proxy_corrections::read(json))),
    ),
    read(
        Kind::MirrorTable,
        "mirror table",
        Syntax::Text,
        mirror_table,
    ),
    Format {
        schema: Some("mpfb_table"),
        ..read(
            Kind::FaceTable,
            "table of faces",
            Syntax::Binary,
            index_table,
        )
    },
    Format {
        schema: Some("mpfb_table"),
        ..read(
            Kind::VertexTable,
            "table of vertices",
            Syntax::Binary,
            index_table,
        )
    },
    rig_of(Kind::Rig),
    // Where a user of MPFB has rigs MakeHuman 1 once had some, too.
    json(
        Kind::CustomRig,
        "rig",
        "mpfb_rig",
        |json| match outdated::of_json(json) {
            Some(outdated) => Content::Outdated(outdated),
            None => Content::Rig(Box::new(rig::read(json))),
        },
    ),
    rig_of(Kind::SubRig),
    json(Kind::NodeTree, "node tree", "mpfb_nodes", |json| {
        Content::Loaded(Box::new(node_tree::read(json)))
    }),
    Format {
        needs: Needs::MeshInTurn,
        ..read(Kind::Target, "target", Syntax::Text, target)
    },
    Format {
        needs: Needs::MeshInTurn,
        ..read(Kind::PackedTarget, "packed target", Syntax::Binary, packed)
    },
    read(Kind::PartTarget, "target of a part", Syntax::Text, target),
    read(
        Kind::PackedPartTarget,
        "packed target of a part",
        Syntax::Binary,
        packed,
    ),
    read(
        Kind::TargetArchive,
        "target archive",
        Syntax::Binary,
        archive,
    ),
    read(
        Kind::TargetsNpz,
        "target archive",
        Syntax::Binary,
        targets_archive,
    ),
    read(
        Kind::PictureList,
        "list of pictures",
        Syntax::Binary,
        picture_list,
    ),
    plain(Kind::TargetIcon, "icon", Syntax::Binary),
    json(Kind::Skeleton, "skeleton", "mhskel", |json| {
        Content::Skeleton(Box::new(mhskel::read(json)))
    }),
    mhw(Kind::Weights, Needs::Mesh),
    mhw(Kind::AssetWeights, Needs::Nothing),
    Format {
        schema: Some("mhpose"),
        ..read(Kind::Pose, "pose", Syntax::Json, pose)
    },
    json(Kind::PoseUnits, "pose units", "pose_units", |json| {
        Content::PoseUnits(Box::new(pose_units::read(json)))
    }),
    json(
        Kind::SelectionFilter,
        "selection filter",
        "selection_filter",
        |json| Content::Filter(Box::new(selection_filter::read(json))),
    ),
    json(
        Kind::Version,
        "makehuman2_version.json",
        "version",
        |json| Content::Version(Box::new(program::version(json))),
    ),
    json(Kind::Shaders, "shader.json", "shader", |json| {
        Content::Shaders(Box::new(program::shaders(json)))
    }),
    Format {
        comments: &["#"],
        needs: Needs::Mesh,
        ..read(Kind::Clothes, "text asset", Syntax::Text, clothes)
    },
    Format {
        comments: &["#", "//"],
        ..read(Kind::Material, "text asset", Syntax::Text, material)
    },
    Format {
        comments: &["#"],
        ..read(Kind::Model, "model", Syntax::Text, model)
    },
    read(Kind::Motion, "motion", Syntax::Text, motion),
    read(
        Kind::MotionMeta,
        "description of a motion",
        Syntax::Text,
        meta,
    ),
    read(Kind::AssetMesh, "mesh", Syntax::Text, asset_mesh),
    read(Kind::ShaderSource, "shader", Syntax::Text, shader_source),
    read(
        Kind::UvMap,
        "map of texture coordinates",
        Syntax::Text,
        uv_map,
    ),
    json(
        Kind::ProgramSettings,
        "settings of the program",
        "mh1_settings",
        |_| Content::Json,
    ),
    read(Kind::Scene, "scene", Syntax::Binary, scene),
    read(
        Kind::LibraryCache,
        "list of a library",
        Syntax::Binary,
        library_cache,
    ),
    Format {
        needs: Needs::Mesh,
        ..read(Kind::Packed, "file", Syntax::Binary, zip)
    },
    read(
        Kind::Unlisted,
        "asset that no list shows",
        Syntax::Binary,
        unlisted,
    ),
    tree(Kind::Json, "JSON", |json| {
        outdated::of_json(json).map_or(Content::Json, Content::Outdated)
    }),
    Format {
        reader: Some(Reader::Ends(picture)),
        ..plain(Kind::Image, "picture", Syntax::Binary)
    },
    OTHER,
];

/// What nobody knows.
const OTHER: Format = plain(Kind::Other, "file", Syntax::Binary);

impl Format {
    /// What there is to know of files of a kind.
    pub fn of(kind: Kind) -> &'static Self {
        static UNKNOWN: Format = OTHER;
        FORMATS.get(kind as usize).unwrap_or(&UNKNOWN)
    }

    /// Whether the file is JSON.
    pub fn is_json(&self) -> bool {
        self.syntax == Syntax::Json
    }

    /// Whether the file is text in which an encoding matters.
    pub fn is_text(&self) -> bool {
        self.syntax != Syntax::Binary
    }

    /// Whether the content matters, not only the size.
    pub fn is_read(&self) -> bool {
        self.syntax != Syntax::Binary
            || matches!(self.reader, Some(Reader::Tree(_) | Reader::Bytes(_)))
    }

    /// How much of the beginning and of the end is enough.
    pub fn ends(&self) -> Option<(usize, usize)> {
        matches!(self.reader, Some(Reader::Ends(_))).then_some((HEAD, TAIL))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_kind_has_its_row() {
        assert!(
            FORMATS
                .iter()
                .all(|format| std::ptr::eq(Format::of(format.kind), format))
        );
        assert_eq!(FORMATS.len(), Kind::Other as usize + 1);
    }

    #[test]
    fn every_schema_is_there() {
        let is_there = |name| mhlint_json::schema_names().any(|known| known == name);
        assert!(
            FORMATS
                .iter()
                .filter_map(|format| format.schema)
                .all(is_there)
        );
    }
}
