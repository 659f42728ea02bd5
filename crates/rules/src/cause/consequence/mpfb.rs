//! What MPFB does with a file that it cannot read or find
//! (`docs/loaders/mpfb/sliders.md#faults-of-the-catalogue`,
//! `docs/loaders/mpfb/macros.md#faults-of-macros`,
//! `docs/loaders/mpfb/expressions.md#faults-of-expressions`,
//! `docs/loaders/mpfb/models.md#saved-characters`,
//! `docs/loaders/mpfb/materials.md#settings-of-skins`).

use super::table::{Cell, LOST, Table, anywhere, cell, nothing};
use super::{Consequence, Damage, Moment};
use mhlint_diag::Application::Mpfb;
use mhlint_diag::Case;
use mhlint_diag::Level::{Error, Info, Warning};
use mhlint_discover::Kind;
use mhlint_json::{Found, SchemaFault};
use mhlint_repo::FileFacts;
use mhlint_repo::ReferenceKind::{
    AssetMaterial, AssetMesh, SkinTexture, SliderName, Slot, Texture,
};

pub(super) static TABLE: Table = Table {
    rows: &[
        anywhere(Kind::TargetCatalog, Moment::Start, REFUSED),
        anywhere(Kind::MacroParts, Moment::Start, REFUSED),
        anywhere(Kind::FaceExpression, Moment::Use, SKIPPED),
        anywhere(Kind::HumanPreset, Moment::Use, NO_CHARACTER),
        anywhere(Kind::ImporterPreset, Moment::Use, NO_PRESET),
        anywhere(Kind::MakeupPreset, Moment::Use, NO_PRESET),
        anywhere(Kind::RandomizationPreset, Moment::Use, NO_PRESET),
        anywhere(Kind::EyeSettings, Moment::Use, NO_LOOK),
        anywhere(Kind::SkinSettings, Moment::Use, NO_LOOK),
        anywhere(Kind::BaseMesh, Moment::Use, NO_BODY),
        anywhere(Kind::Target, Moment::Use, NO_SHAPE),
        anywhere(Kind::PackedTarget, Moment::Use, NO_SHAPE),
        anywhere(Kind::PartTarget, Moment::Use, NOT_LOADED),
        anywhere(Kind::PackedPartTarget, Moment::Use, NOT_LOADED),
        anywhere(Kind::Model, Moment::Use, MODEL),
        anywhere(Kind::NodeTree, Moment::Use, NO_MATERIAL),
        anywhere(Kind::VertexGroups, Moment::Start, REFUSED),
        anywhere(Kind::BodyDimensions, Moment::Use, NO_DIMENSIONS),
        anywhere(Kind::ProxyCorrections, Moment::Use, NO_CORRECTIONS),
        anywhere(Kind::MirrorTable, Moment::Use, NO_MIRROR),
        anywhere(Kind::Rig, Moment::Use, NO_RIG),
        anywhere(Kind::CustomRig, Moment::Use, NOT_A_LISTED_RIG),
        anywhere(Kind::SubRig, Moment::Use, NO_SUBRIG),
        anywhere(Kind::Weights, Moment::Use, NO_WEIGHTS),
        anywhere(Kind::FaceTable, Moment::Use, NO_DELETE_GROUP),
        anywhere(Kind::VertexTable, Moment::Use, NO_DELETE_GROUP),
        anywhere(Kind::StoredPose, Moment::Use, NO_POSE),
        anywhere(Kind::UvLayer, Moment::Use, NO_UV_LAYER),
        anywhere(Kind::Motion, Moment::Use, NO_MOTION),
        anywhere(Kind::InkLayer, Moment::Use, NO_INK),
        anywhere(Kind::PackMetadata, Moment::Use, NO_PACKS),
        anywhere(Kind::Clothes, Moment::Use, NOT_WORN),
        anywhere(Kind::AssetMesh, Moment::Use, NO_MESH),
        anywhere(Kind::Material, Moment::Use, NO_SURFACE),
        anywhere(Kind::Image, Moment::Use, NO_PICTURE),
        // Notes and the like, which nobody loads.
        anywhere(Kind::Other, Moment::Use, &[nothing(Damage::Empty)]),
    ],
    at_moment: &[],
    in_general: LOST,
    unfound: &[
        (
            &[Slot, SliderName],
            Consequence::new(
                Error,
                "does not find the target and fails when its slider moves",
            ),
        ),
        (
            &[AssetMesh],
            Consequence::new(Error, "fails with `OSError` when the asset is loaded"),
        ),
        (
            &[AssetMaterial],
            Consequence::new(
                Error,
                "fails with `FileNotFoundError` when it puts the asset on",
            ),
        ),
        (
            &[Texture],
            Consequence::new(Warning, "makes the material without this picture"),
        ),
        (
            &[SkinTexture],
            Consequence::new(Error, "fails when the skin is used as a layered one"),
        ),
    ],
};

/// Blender imports the add-on, which reads the file at once and catches nothing.
const STOPS: &str = "fails while the add-on is imported: MPFB cannot be enabled";

const REFUSED: &[Cell] = &stopped(STOPS);

/// Each file of the library is read on its own.
const NOT_LISTED: &str = "skips the file with a message in the log: the expression is not listed";

const SKIPPED: &[Cell] = &[
    cell(Damage::Pointer, Warning, NOT_LISTED),
    cell(Damage::Refused, Warning, NOT_LISTED),
    cell(Damage::NotUtf8, Warning, NOT_LISTED),
    cell(Damage::Syntax, Warning, NOT_LISTED),
];

/// The cells of a file at which an action stops.
const fn stopped(effect: &'static str) -> [Cell; 5] {
    [
        cell(Damage::Closed, Error, effect),
        cell(Damage::Pointer, Error, effect),
        cell(Damage::Refused, Error, effect),
        cell(Damage::NotUtf8, Error, effect),
        cell(Damage::Syntax, Error, effect),
    ]
}

/// Files are not parsed when they are listed (`docs/loaders/mpfb/libraries.md#sections`).
const NOT_LOADED_ASSET: &str = "lists the asset, and fails with an exception when it is loaded";
/// An asset without a mesh.
pub(crate) const NO_MESH_NAMED: &str =
    "fails with `ValueError` when the asset is loaded: no mesh is named";

const NOT_WORN: &[Cell] = &[
    cell(Damage::Closed, Error, NOT_LOADED_ASSET),
    cell(Damage::Pointer, Error, NOT_LOADED_ASSET),
    cell(Damage::Empty, Error, NOT_LOADED_ASSET),
    cell(
        Damage::NotUtf8,
        Error,
        "fits the asset, and fails with an exception where the bytes are in the author or the \
            description",
    ),
    cell(
        Damage::MarkedWord,
        Warning,
        "does not recognise the first keyword and ignores its line",
    ),
    cell(
        Damage::MarkedComment,
        Info,
        "ignores the first line, which is only a comment",
    ),
];
const NO_MESH: &[Cell] = &[
    cell(Damage::Closed, Error, NOT_LOADED_ASSET),
    cell(Damage::Pointer, Error, NOT_LOADED_ASSET),
    cell(Damage::Empty, Error, NOT_LOADED_ASSET),
    // Names alone can have such bytes, and names in it are not used.
    cell(
        Damage::NotUtf8,
        Info,
        "reads the mesh all the same: names in it are not used",
    ),
    cell(
        Damage::MarkedWord,
        Warning,
        "does not recognise the first line",
    ),
    cell(
        Damage::MarkedComment,
        Info,
        "ignores the first line, which is only a comment",
    ),
];
const BROKEN: &str = "loads it as a broken picture, without a message";
const NO_PICTURE: &[Cell] = &[
    cell(Damage::Closed, Warning, BROKEN),
    cell(Damage::Pointer, Warning, BROKEN),
    cell(Damage::Empty, Warning, BROKEN),
];
const NO_SURFACE: &[Cell] = &[
    cell(
        Damage::Closed,
        Error,
        "fails with an exception when the material is used",
    ),
    cell(
        Damage::Pointer,
        Warning,
        "makes a material without any picture or colour of its own",
    ),
    cell(
        Damage::Empty,
        Warning,
        "makes a material without any picture or colour of its own",
    ),
    cell(
        Damage::NotUtf8,
        Error,
        "fails with `UnicodeDecodeError` when the material is used",
    ),
    cell(
        Damage::MarkedWord,
        Warning,
        "does not recognise the first keyword and ignores its line",
    ),
    cell(
        Damage::MarkedComment,
        Info,
        "does not recognise the first line, which it does not need",
    ),
];

const NO_CHARACTER: &[Cell] =
    &stopped("lists the character, and fails with an exception when it is loaded");
const NO_PRESET: &[Cell] =
    &stopped("lists the preset, and fails with an exception when it is loaded");
const NO_LOOK: &[Cell] =
    &stopped("fails with an exception when it makes a material with these settings");
const NO_MATERIAL: &[Cell] =
    &stopped("fails with an exception when it makes a material of this kind");

const NO_DIMENSIONS: &[Cell] = &stopped(
    "fails with an exception after it fits an asset that has a scale: this one is left half-made",
);
const NO_CORRECTIONS: &[Cell] = &stopped(
    "fails with an exception when a saved character with a topology is loaded: the character is \
        left half-made",
);
const NO_MIRROR: &[Cell] = &stopped("fails with an exception when a target is made symmetric");
const NO_INK: &[Cell] = &stopped("fails with an exception when the layer is put on");
const NO_RIG: &[Cell] = &stopped("fails with an exception when the rig is added");
const NOT_A_LISTED_RIG: &[Cell] =
    &stopped("skips the file with a line in the log: the rig is not listed");
const NO_SUBRIG: &[Cell] =
    &stopped("fails with an exception when the asset is added: it stays without its own rig");
const NO_WEIGHTS: &[Cell] =
    &stopped("fails with an exception after the rig is made: it has no weights at all");
const NO_POSE: &[Cell] = &stopped("lists the pose, and fails with an exception when it is loaded");
const NO_UV_LAYER: &[Cell] =
    &unpacked("fails with an exception when an ink layer with this `focus` is put on");
const NO_DELETE_GROUP: &[Cell] =
    &unpacked("fails with an exception when an asset that hides vertices is put on");

const NO_MOTION: &[Cell] = &[
    cell(Damage::Closed, Error, NOT_SHOWN),
    cell(Damage::Pointer, Error, NOT_SHOWN),
    cell(Damage::Empty, Error, NOT_SHOWN),
    cell(Damage::NotUtf8, Error, NOT_SHOWN),
    cell(Damage::MarkedWord, Error, NOT_SHOWN),
];
const NOT_SHOWN: &str = "lists the pose, and rejects the file with a message when it is chosen";

/// The cells of a packed file at which an action stops.
const fn unpacked(effect: &'static str) -> [Cell; 4] {
    [
        cell(Damage::Closed, Error, effect),
        cell(Damage::Pointer, Error, effect),
        cell(Damage::Empty, Error, effect),
        cell(Damage::Packed, Error, effect),
    ]
}

/// The first query raises, later ones know what the disk listed before the file.
const NO_PACKS: &[Cell] = &stopped(
    "fails with an exception in the pack filter and in the randomizer, and later knows only the \
     packs that the disk lists before this one",
);

const NO_BODY: &[Cell] =
    &stopped("fails with an exception whenever a character is made: none can be made");

/// All macro targets are set to 0 before the first one is loaded
/// (`docs/loaders/mpfb/macros.md#faults-of-macros`).
const MACRO_LOST: &str = "fails where a setting comes near the target: the whole macro shape \
    disappears, and no such character can be made";
/// What a macro target comes to whose rows cannot be read.
pub(crate) const MACRO_ROWS: Case = &[(Mpfb, Error, MACRO_LOST)];

/// A value of gender or age that no part has.
pub(crate) const NO_PART: Case = &[(
    Mpfb,
    Error,
    "makes the character without any shape key: no part of the setting has this value",
)];

/// What becomes of a macro target; of an empty one nothing.
pub(super) fn of_macro_target(damage: Damage) -> Option<Consequence> {
    let is_read = matches!(damage, Damage::Empty | Damage::Absent | Damage::Needless);
    (!is_read).then_some(Consequence::new(Error, MACRO_LOST))
}

/// The shape key is made before the rows are read.
const NOT_A_ROW: &str = "fails when its slider moves first and does nothing afterwards; saved \
    characters with it load only in part";
const UNDECODABLE: &str =
    "fails whenever its slider moves; saved characters with it load only in part";

/// What becomes of rows of a target that is loaded by hand
/// (`docs/loaders/mpfb/targets.md#proxy-targets`).
pub(crate) const BY_HAND: Case = &[(
    Mpfb,
    Error,
    "fails when it is loaded by hand, and leaves an empty shape key behind",
)];
const NOT_LOADED: &[Cell] = &stopped("fails when it is loaded by hand");

const NO_SHAPE: &[Cell] = &[
    cell(Damage::Closed, Error, UNDECODABLE),
    cell(Damage::Pointer, Error, NOT_A_ROW),
    cell(Damage::MarkedRow, Error, NOT_A_ROW),
    cell(Damage::MarkedWord, Error, NOT_A_ROW),
    cell(Damage::MarkedComment, Error, NOT_A_ROW),
    cell(Damage::NotUtf8, Error, UNDECODABLE),
    cell(
        Damage::Empty,
        Warning,
        "makes a slider that changes nothing",
    ),
];

const MODEL: &[Cell] = &[cell(
    Damage::MarkedComment,
    Info,
    "does not recognise the first line, which it does not need",
)];

const NO_FIGURE: &str = "crashes whenever a character is made: none can be made";
const NO_NAME: &str =
    "crashes where a setting comes into the part; if that is 0.5, no character can be made";

/// What a value of the macro settings comes to: beginning of its place in the schema; the first
/// that fits counts.
pub(super) static MACRO_PARTS: [(&str, Consequence); 2] = [
    (
        "/$defs/part/properties/low/",
        Consequence::new(Error, NO_NAME),
    ),
    (
        "/$defs/part/properties/high/",
        Consequence::new(Error, NO_NAME),
    ),
];

/// What a value of the catalogue comes to where it does not stop the add-on, likewise.
pub(super) static CATALOG: [(&str, Consequence); 4] = [
    (
        "/$defs/category/properties/targets/",
        Consequence::new(Error, NO_PANEL),
    ),
    (
        "/$defs/category/properties/full_path/",
        Consequence::new(Error, DEAD),
    ),
    ("/$defs/opposites/", Consequence::new(Error, DEAD)),
    ("/$defs/slot/", Consequence::new(Error, DEAD)),
];

const NO_PANEL: &str = "fails with an exception whenever the panel of the slider is drawn";
const DEAD: &str =
    "fails with an exception, on the console alone, when the slider is shown or moved";

/// What a value comes to that does not fit its schema.
pub(super) fn of_value(file: &FileFacts, fault: &SchemaFault) -> Option<Consequence> {
    let begins = |row: &&(&str, Consequence)| fault.keyword.starts_with(row.0);
    match file.kind {
        Kind::MacroParts => {
            let row = MACRO_PARTS.iter().find(begins);
            Some(row.map_or_else(|| usual_part(fault), |(_, consequence)| *consequence))
        }
        Kind::Weights => Some(match fault.found() {
            Some(Found::Null) if fault.pointer.starts_with("/weights/") => Consequence::new(
                Warning,
                "silently makes no group for the bone: it moves nothing",
            ),
            _ => Consequence::new(
                Error,
                "fails with an exception after the rig is made: weights are missing",
            ),
        }),
        Kind::TargetCatalog => Some(match (CATALOG.iter().find(begins), fault.missing()) {
            (Some((_, consequence)), _) => *consequence,
            (None, Some("targets")) => Consequence::new(Error, NO_PANEL),
            (None, Some(slot)) if slot.contains('-') => Consequence::new(Error, DEAD),
            _ => Consequence::new(Error, STOPS),
        }),
        _ => None,
    }
}

fn usual_part(fault: &SchemaFault) -> Consequence {
    match fault.found() {
        Some(Found::Bool(_)) if fault.keyword.starts_with("/$defs/part/properties/") => {
            Consequence::new(Info, "takes `true` for 1 and `false` for 0")
        }
        _ => Consequence::new(Error, NO_FIGURE),
    }
}
