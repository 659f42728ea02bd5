//! What a file is: its format, and what an application uses it for.

use mhlint_source::extension;

/// Kinds of files. A kind that says more about a file stands before one that says less. What
/// follows from a kind is in the table of formats.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Kind {
    /// `base.json` of MakeHuman 2: settings of a base mesh.
    BaseJson,
    /// `base.obj`.
    BaseMesh,
    /// `base.mhbin` of MakeHuman 2: the base mesh, packed.
    MeshArchive,
    /// `3dobjs/base.npz` of MakeHuman 1: the base mesh, packed.
    PackedBaseMesh,
    /// `geometry.json` of MakeHuman 2.
    Geometry,
    /// `macro.json` of MakeHuman 2.
    MacroJson,
    /// `modelling.json` of MakeHuman 2.
    ModellingJson,
    /// `*_modifiers.json` of MakeHuman 1: what its sliders move.
    ModifierFile,
    /// `*_modifiers_desc.json` of MakeHuman 1: descriptions of modifiers.
    ModifierTexts,
    /// `*_sliders.json` of MakeHuman 1: the tabs that they are in.
    ModifierSliders,
    /// `mh_1-0_modifier_mapping.csv` of MakeHuman 1: names of modifiers in older models.
    ModifierMapping,
    /// `face-poseunits.json` of MakeHuman 1: the names of the frames that expressions are made of.
    FaceUnits,
    /// `languages/*.json` of MakeHuman 1.
    Language,
    /// `target_cat.json` of MakeHuman 2.
    TargetCategories,
    /// `target.json` of MPFB: its sliders.
    TargetCatalog,
    /// `macro.json` of MPFB: which names a setting stands for, and in which range.
    MacroParts,
    /// A JSON in `expressions/` of MPFB: face units with their strengths.
    FaceExpression,
    /// `human.*.json` of MPFB: a saved character.
    HumanPreset,
    /// `importer_presets.*.json` of MPFB.
    ImporterPreset,
    /// `makeup.*.json` of MPFB.
    MakeupPreset,
    /// `randomization.*.json` of MPFB.
    RandomizationPreset,
    /// `eye_settings.*.json` of MPFB.
    EyeSettings,
    /// `enhanced_settings.*.json` of MPFB: how its skin looks.
    SkinSettings,
    /// Any other JSON in the `config/` of a user of MPFB.
    ConfigJson,
    /// A JSON in `ink_layers/` of MPFB: a picture over the skin.
    InkLayer,
    /// A JSON in `packs/` of MPFB: the assets of a pack.
    PackMetadata,
    /// A JSON in `poses/` of MPFB: rotations of bones.
    StoredPose,
    /// `uv_layers/*.json.gz` of MPFB: texture coordinates for ink layers.
    UvLayer,
    /// `basemesh_vertex_groups.json` of MPFB.
    VertexGroups,
    /// `hm08_config.json` of MPFB: between which vertices parts of the body are measured.
    BodyDimensions,
    /// `proxy_corrective.json` of MPFB: which proxies lose weights on the wrong side.
    ProxyCorrections,
    /// `hm08.mirror` of MPFB: the counterpart of each vertex.
    MirrorTable,
    /// `basemesh_face_to_vertex_table.json.gz` of MPFB: the vertices of each face.
    FaceTable,
    /// `basemesh_vertex_to_face_table.json.gz` of MPFB: the faces of each vertex.
    VertexTable,
    /// `rig.*.json` of MPFB: bones on the base mesh.
    Rig,
    /// A JSON in the `rigs/` of a user of MPFB: a rig of the user.
    CustomRig,
    /// `*.mpfbskel`: bones on an asset, added to the rig of the body.
    SubRig,
    /// A JSON in `node_trees/` of MPFB.
    NodeTree,
    /// `*.target` where targets are loaded from.
    Target,
    /// `*.target.gz` of MPFB: a packed target.
    PackedTarget,
    /// `*.ptarget` of MPFB: for a proxy or clothes, loaded by hand.
    PartTarget,
    /// `*.ptarget.gz` of MPFB.
    PackedPartTarget,
    /// `compressedtargets.npz` of MakeHuman 2: the targets of a base mesh, packed.
    TargetArchive,
    /// `targets.npz` of MakeHuman 1: all its targets, packed.
    TargetsNpz,
    /// `images.list` of MakeHuman 1: the pictures of its sliders.
    PictureList,
    /// A picture of a slider.
    TargetIcon,
    /// `*.mhskel`.
    Skeleton,
    /// `*.mhw` for a base mesh.
    Weights,
    /// `*.mhw` for the mesh of an asset, or an unknown mesh.
    AssetWeights,
    /// `*.mhpose`.
    Pose,
    /// `body-poses.json`, `face-poses.json` of MakeHuman 2: what poses and expressions are made of.
    PoseUnits,
    /// `selection_filter.json` of MakeHuman 2: labels by which assets are chosen.
    SelectionFilter,
    /// `makehuman2_version.json`.
    Version,
    /// `shaders/shader.json` of MakeHuman 2.
    Shaders,
    /// `*.mhclo`, `*.proxy`.
    Clothes,
    /// `*.mhmat`.
    Material,
    /// `*.mhm`.
    Model,
    /// `*.bvh`.
    Motion,
    /// `*.meta`: description of a motion.
    MotionMeta,
    /// `*.obj` of an asset.
    AssetMesh,
    /// `*_fragment_shader.txt` and the like of MakeHuman 1: source of a shader.
    ShaderSource,
    /// `*.mhuv` of MakeHuman 1: texture coordinates for a mesh.
    UvMap,
    /// `settings.ini` of a user of MakeHuman 1, a JSON.
    ProgramSettings,
    /// `*.mhscene` of MakeHuman 1: lights.
    Scene,
    /// `cache/*.mhc` of MakeHuman 1: what is in a library of assets.
    LibraryCache,
    /// `*.mhbin`, `*.mhpxy`, `*.npz` of an asset, `*.zip` of assets.
    Packed,
    /// A file with the extension of clothes or a proxy in a folder that no list looks into; or
    /// `*.mhp`, a pose of older versions.
    Unlisted,
    /// Any other JSON.
    Json,
    /// Any other picture.
    Image,
    /// Anything else.
    Other,
}

/// The kind of a file by its extension, whatever folder it lies in. The hooks for pre-commit start
/// on these extensions.
const BY_EXTENSION: [(Kind, &[&str]); 15] = [
    (Kind::Skeleton, &["mhskel"]),
    (Kind::AssetWeights, &["mhw", "jsonw"]),
    (Kind::Pose, &["mhpose"]),
    (Kind::Json, &["json"]),
    (Kind::Clothes, &["mhclo", "proxy"]),
    (Kind::Material, &["mhmat"]),
    (Kind::Model, &["mhm"]),
    (Kind::Motion, &["bvh"]),
    (Kind::MotionMeta, &["meta"]),
    (Kind::AssetMesh, &["obj"]),
    (Kind::UvMap, &["mhuv"]),
    (Kind::Scene, &["mhscene"]),
    (Kind::LibraryCache, &["mhc"]),
    (Kind::Packed, &["npz", "mhbin", "mhpxy", "zip"]),
    (
        Kind::Image,
        &[
            "png", "jpg", "jpeg", "tif", "tiff", "bmp", "gif", "tga", "webp", "thumb",
        ],
    ),
];

impl Kind {
    /// Whether it is a JSON of MPFB whose loader accepts more than a schema can describe.
    pub const fn is_judged_by_loader(self) -> bool {
        matches!(
            self,
            Self::FaceExpression
                | Self::HumanPreset
                | Self::ImporterPreset
                | Self::MakeupPreset
                | Self::RandomizationPreset
                | Self::EyeSettings
                | Self::SkinSettings
                | Self::NodeTree
                | Self::InkLayer
                | Self::PackMetadata
                | Self::StoredPose
                | Self::VertexGroups
                | Self::BodyDimensions
                | Self::ProxyCorrections
                | Self::Rig
                | Self::CustomRig
                | Self::SubRig
        )
    }

    /// Whether it is a base mesh, in whatever form.
    pub const fn is_base_mesh(self) -> bool {
        matches!(
            self,
            Self::BaseMesh | Self::MeshArchive | Self::PackedBaseMesh
        )
    }

    /// The kind of a file if only its name is known. Extensions are compared as the applications do
    /// it: `X.TARGET` is no target, but `X.OBJ` is a mesh.
    pub fn by_extension(file: &str) -> Self {
        let extension = extension(file);
        let is_own = |kind: Self, own: &str| match kind {
            // Meshes and pictures are opened by the name that another file gives, whatever its
            // capitals.
            Self::AssetMesh | Self::Image if own != "thumb" => own.eq_ignore_ascii_case(extension),
            // The list of scenes ignores capitals, and loads the scene that the user picks.
            Self::Scene => own.eq_ignore_ascii_case(extension),
            _ => own == extension,
        };
        let row = BY_EXTENSION
            .iter()
            .find(|(kind, extensions)| extensions.iter().any(|own| is_own(*kind, own)));
        row.map_or(Self::Other, |(kind, _)| *kind)
    }

    /// The kind of a target, packed or not, by its name; for folders in which an application looks
    /// for targets.
    pub(super) fn of_target(file: &str) -> Option<Self> {
        match extension(file) {
            "target" => Some(Self::Target),
            "gz" if file.ends_with(".target.gz") => Some(Self::PackedTarget),
            _ => None,
        }
    }
}

/// Endings of the names of shader files of MakeHuman 1. A shader has at least one of these files.
pub const SHADER_FILES: [&str; 3] = [
    "_vertex_shader.txt",
    "_fragment_shader.txt",
    "_geometry_shader.txt",
];

/// Whether a file is an asset whatever folder it lies in, because no other program uses its
/// extension.
pub fn is_asset_anywhere(rel: &str) -> bool {
    matches!(
        extension(rel),
        "mhclo" | "mhmat" | "mhm" | "mhpose" | "mhbin" | "mhpxy"
    )
}

/// The extension of an asset as its author meant it: in small letters. No application lists a file
/// with capitals in its extension, but the file is still meant as an asset.
pub fn meant_extension(rel: &str) -> &str {
    const OF_ASSETS: [&str; 7] = ["mhclo", "proxy", "mhskel", "mhpose", "bvh", "mhm", "mhmat"];
    // Windows shows `vest.mhclo.txt` as `vest.mhclo`.
    let shown = rel
        .strip_suffix(".txt")
        .filter(|shown| OF_ASSETS.contains(&extension(shown)));
    let written = extension(shown.unwrap_or(rel));
    OF_ASSETS
        .into_iter()
        .find(|known| known.eq_ignore_ascii_case(written))
        .unwrap_or(written)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Extensions that are checked besides those in `BY_EXTENSION`: of targets, of the
    /// configuration, of shader sources, and of the list of pictures.
    const FURTHER: [&str; 5] = ["target", "gz", "toml", "txt", "list"];

    #[test]
    fn hooks_start_on_every_extension_that_is_checked() {
        let mut checked: Vec<&str> = BY_EXTENSION
            .iter()
            .flat_map(|(_, extensions)| *extensions)
            .copied()
            .collect();
        checked.extend(FURTHER);
        checked.sort_unstable();
        let files = format!("files: '(?i)\\.({})$'", checked.join("|"));
        for (file, hooks, text) in [
            (
                ".pre-commit-hooks.yaml",
                3,
                include_str!("../../../.pre-commit-hooks.yaml"),
            ),
            (
                "mirror",
                1,
                include_str!("../../../packaging/pre-commit-mirror/.pre-commit-hooks.yaml"),
            ),
        ] {
            let lines: Vec<&str> = text
                .lines()
                .map(str::trim)
                .filter(|line| line.starts_with("files:"))
                .collect();
            assert_eq!(lines, vec![files.as_str(); hooks], "{file}");
        }
        // The README repeats the text of `--help`.
        let help: Vec<&str> = include_str!("../../../README.md")
            .split_whitespace()
            .collect();
        assert!(
            help.join(" ")
                .contains(&format!("are read: {}.", checked.join(" "))),
            "`--help` names other extensions"
        );
    }
}
