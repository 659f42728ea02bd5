//! What MakeHuman 1 does with a file that it cannot read or find.
//!
//! From `docs/loaders/makehuman1/text-and-json.md#encodings`,
//! `docs/loaders/makehuman1/libraries.md#why-a-library-is-empty`,
//! `docs/loaders/makehuman1/program.md#files-that-the-start-needs`, and the faults of each format
//! beside these.

use super::table::At::{self, Scanned};
use super::table::{
    Cell, LOST, LOST_WHOLE, Row, Table, UNREAD, anywhere, cell, cells, nothing, row,
};
use super::{Consequence, Damage, Moment};
use Damage::{
    Closed, Dangling, Empty, MarkedComment, MarkedRow, MarkedWord, NotUtf8, Pointer, Special,
    TooDeep,
};
use Moment::{Scan, Start, Use};
use mhlint_diag::Level::{Error, Info, Warning};
use mhlint_discover::{Kind, Single};
use mhlint_repo::ReferenceKind::{
    AssetMaterial, AssetMesh, AssetWeights, ModelExpression, ModelMaterial, ModelPose,
    ModelSkeleton, Skin, Texture, UvMap, WeightsFile,
};

pub(super) static TABLE: Table = Table {
    rows: ROWS,
    at_moment: AT_MOMENT,
    in_general: LOST,
    unfound: UNFOUND,
};

pub(crate) const STOPS_AT_START: &str =
    "stops at start: only the splash picture stays on the screen";
const NOT_WORN: &str = "lists the asset and does not put it on";
const WHITE: &str = "draws the surface with the default white material";
const NO_SKINS: &str = "lists no skin at all: one file that cannot be read empties the list";
const NO_POSES: &str = "lists no pose at all: one file that cannot be read empties the list";
const NO_POSE: &str = "lists the pose and does not show it";
const NO_SHADER: &str = "logs an error and draws the surface without a shader";
const NO_MAP: &str = "fails when the material is used";
pub(crate) const NO_FRAME: &str =
    "stops drawing each frame at the default skin, which blends this picture";
const NO_THUMBNAIL: &str = "shows an empty picture in the library";
const PLACEHOLDER: &str = "shows a placeholder instead of the picture";

const INERT: &str = "logs \"Unable to open\", and the target moves nothing";
const SILENT: &str = "loads it as an empty target without a message: it moves nothing";
const NO_SET: &str = "fails at start: none of the tabs of this set is shown";
const NO_TEXTS: &str = "fails at start: the modifiers of this set have no tabs";
const NO_TABS: &str = "fails at start: none of its tabs is shown";
const NO_OLD: &str = "fails when it loads a model of version 1.0";
const NO_RIGS: &str = "lists no skeleton at all: one file that cannot be read empties the list";
const NO_RIG: &str = "fails when the skeleton with these weights is chosen";
const ENGLISH: &str = "logs an error and stays English";
const NO_EXPRESSION: &str = "lists the expressions and shows none of them";
pub(super) const NO_EXPRESSIONS: &str =
    "lists no expression at all: one file that cannot be read empties the list";

const FROM_TEXTS: &str = "takes its targets from the texts";
const MADE_AGAIN: &str = "makes it again";
/// It is read while Python imports the program, before anything catches what is wrong
/// (`docs/loaders/makehuman1/program.md#settings`).
pub(super) const NO_PROGRAM: &str = "does not start: it reads the settings before anything else";
const BESIDE: &str = "reads the text beside it, with a warning in the log";
const NO_PICTURES: &str = "shows its sliders without pictures";
const NO_SCENE: &str = "fails with `AttributeError` when the scene is chosen";
const NO_MODELS: &str = "lists no model at all: one file that cannot be read empties the list";
pub(super) const RESET: &str = "fails because the version is missing, and leaves the default human";

const COMMENT: Cell = cell(
    MarkedComment,
    Info,
    "ignores the first line, which is only a comment",
);
const KEYWORD: Cell = cell(
    MarkedWord,
    Warning,
    "does not recognise the first keyword and ignores its line",
);

#[rustfmt::skip]
const ROWS: &[Row] = &[
    anywhere(Kind::BaseMesh, Start, &[
        cells(LOST_WHOLE, Error, STOPS_AT_START),
        cell(NotUtf8, Error, STOPS_AT_START),
        cell(MarkedWord, Error, "drops the first vertex, and stops at start"),
        COMMENT,
    ]),
    row(Kind::Target, At::Single(Single::OwnTarget), Start, &[
        cell(Dangling, Error, INERT),
        cell(Closed, Error, INERT),
        cell(Pointer, Warning, SILENT),
        cell(Empty, Warning, SILENT),
        cell(NotUtf8, Error, INERT),
        cell(MarkedRow, Error, INERT),
        cell(MarkedWord, Info, "skips the first line"),
        cell(MarkedComment, Info, "skips the first line, which is only a comment"),
    ]),
    anywhere(Kind::Target, Start, &[
        cell(Dangling, Info, "finds a target of this name that moves nothing"),
        cell(Closed, Error, INERT),
        cell(Pointer, Warning, SILENT),
        cell(Empty, Warning, SILENT),
        cell(NotUtf8, Error, INERT),
        cell(MarkedRow, Error, INERT),
        cell(MarkedWord, Info, "skips the first line"),
        cell(MarkedComment, Info, "skips the first line, which is only a comment"),
    ]),
    anywhere(Kind::ModifierFile, Start, &[
        cells(UNREAD, Error, NO_SET),
        cell(TooDeep, Error, NO_SET),
        nothing(Special),
    ]),
    anywhere(Kind::ModifierTexts, Start, &[
        cells(UNREAD, Error, NO_TEXTS),
        cell(TooDeep, Error, NO_TEXTS),
        nothing(Special),
    ]),
    anywhere(Kind::ModifierSliders, Start, &[
        cells(UNREAD, Error, NO_TABS),
        cell(TooDeep, Error, NO_TABS),
        nothing(Special),
    ]),
    anywhere(Kind::ModifierMapping, Use, &[
        cells(LOST_WHOLE, Warning, NO_OLD),
        cell(NotUtf8, Warning, NO_OLD),
        nothing(MarkedWord),
    ]),
    row(Kind::Skeleton, At::Single(Single::FirstRig), Start, &[
        cells(UNREAD, Error, STOPS_AT_START),
    ]),
    anywhere(Kind::Skeleton, Scan, &[
        cell(Dangling, Error, NO_RIGS),
        cells(UNREAD, Error, NO_RIGS),
    ]),
    row(Kind::Weights, At::Single(Single::FirstRig), Start, &[
        cells(UNREAD, Error, STOPS_AT_START),
        nothing(Special),
    ]),
    anywhere(Kind::Weights, Use, &[
        cells(UNREAD, Error, NO_RIG),
        nothing(Special),
    ]),
    anywhere(Kind::FaceUnits, Use, &[
        cells(UNREAD, Error, NO_EXPRESSION),
    ]),
    anywhere(Kind::Pose, Scan, &[
        cells(UNREAD, Error, NO_EXPRESSIONS),
        cell(TooDeep, Error, NO_EXPRESSIONS),
        // A NaN in a value has a finding of its own; anywhere else nobody calculates with it.
        nothing(Special),
    ]),
    anywhere(Kind::TargetsNpz, Start, &[
        cell(Dangling, Info, FROM_TEXTS),
        cells(LOST_WHOLE, Info, FROM_TEXTS),
    ]),
    anywhere(Kind::PictureList, Start, &[
        cell(Dangling, Info, FROM_TEXTS),
        cell(Closed, Info, FROM_TEXTS),
        cell(Pointer, Warning, NO_PICTURES),
        cell(Empty, Warning, NO_PICTURES),
    ]),
    anywhere(Kind::PackedBaseMesh, Start, &[
        cell(Dangling, Info, BESIDE),
        cells(LOST_WHOLE, Info, BESIDE),
    ]),
    anywhere(Kind::Packed, Scan, &[
        cell(Dangling, Info, BESIDE),
        cells(LOST_WHOLE, Info, BESIDE),
    ]),
    row(Kind::Scene, At::Single(Single::FirstScene), Start, &[
        cell(Dangling, Error, STOPS_AT_START),
        cells(LOST_WHOLE, Error, STOPS_AT_START),
    ]),
    anywhere(Kind::Scene, Use, &[
        cell(Dangling, Error, NO_SCENE),
        cells(LOST_WHOLE, Error, NO_SCENE),
    ]),
    anywhere(Kind::ProgramSettings, Start, &[
        cells(UNREAD, Error, NO_PROGRAM),
        cell(Empty, Error, NO_PROGRAM),
        cell(TooDeep, Error, NO_PROGRAM),
        nothing(Special),
    ]),
    row(Kind::LibraryCache, At::Single(Single::CacheFolder), Use, &[
        cell(Closed, Error, "fails with `FileExistsError` for each library when it ends: no list \
            is ever stored"),
    ]),
    anywhere(Kind::LibraryCache, Start, &[
        cell(Dangling, Info, MADE_AGAIN),
        cells(LOST_WHOLE, Info, MADE_AGAIN),
    ]),
    anywhere(Kind::Model, Scan, &[
        cell(Closed, Error, NO_MODELS),
        cell(Pointer, Error, RESET),
        cell(Empty, Error, RESET),
        cell(NotUtf8, Error, NO_MODELS),
        KEYWORD,
        COMMENT,
    ]),
    anywhere(Kind::Language, Use, &[
        cells(UNREAD, Warning, ENGLISH),
    ]),
    anywhere(Kind::Clothes, Scan, &[
        cells(LOST_WHOLE, Error, NOT_WORN),
        cell(NotUtf8, Warning, "drops the bytes that are not UTF-8"),
        KEYWORD,
        COMMENT,
    ]),
    row(Kind::Material, At::Single(Single::FirstSkin), Start, &[
        cell(NotUtf8, Error, STOPS_AT_START),
        cell(Closed, Error, STOPS_AT_START),
        cell(Pointer, Warning, WHITE),
        cell(Empty, Warning, WHITE),
        KEYWORD,
        COMMENT,
    ]),
    row(Kind::Material, Scanned, Scan, &[
        cell(NotUtf8, Error, NO_SKINS),
        cell(Closed, Error, NO_SKINS),
        cell(Pointer, Warning, WHITE),
        cell(Empty, Warning, WHITE),
        KEYWORD,
        COMMENT,
    ]),
    anywhere(Kind::Material, Use, &[
        cell(NotUtf8, Error, "lists no materials for the assets that it is offered for, and does \
            not put on one that names it"),
        cell(Pointer, Warning, WHITE),
        cell(Empty, Warning, WHITE),
        KEYWORD,
        COMMENT,
    ]),
    anywhere(Kind::AssetMesh, Use, &[
        cells(LOST_WHOLE, Error, NOT_WORN),
        cell(NotUtf8, Error, "does not put the asset on: the mesh is not UTF-8"),
        // Glued to a vertex it drops that one, and the rows of the asset fit no longer.
        cell(MarkedWord, Error, "drops the first line, and does not put the asset on if that is a \
            vertex"),
        COMMENT,
    ]),
    anywhere(Kind::AssetWeights, Use, &[
        cells(UNREAD, Error, NOT_WORN),
        nothing(Special),
    ]),
    anywhere(Kind::Motion, Scan, &[
        cell(Closed, Error, NO_POSES),
        cell(Pointer, Error, NO_POSE),
        cell(Empty, Error, NO_POSE),
        cell(NotUtf8, Error, "does not show the pose; without a `.meta` beside it, lists no pose \
            at all"),
        cell(MarkedWord, Error, NO_POSE),
        cell(MarkedComment, Error, NO_POSE),
    ]),
    anywhere(Kind::MotionMeta, Scan, &[
        cell(Closed, Error, NO_POSES),
        cell(NotUtf8, Error, NO_POSES),
        cell(Pointer, Warning, "shows the pose without its tags and description"),
        cell(Empty, Info, "shows the pose without tags and description"),
        KEYWORD,
        COMMENT,
    ]),
    anywhere(Kind::ShaderSource, Use, &[
        cells(LOST_WHOLE, Warning, NO_SHADER),
        // How the compiler of a graphics card takes them is not known.
        nothing(NotUtf8),
        nothing(MarkedWord),
        nothing(MarkedComment),
    ]),
    anywhere(Kind::UvMap, Use, &[
        cell(Closed, Error, NO_MAP),
        cell(Pointer, Error, NO_MAP),
        // One without faces fits no mesh, and `uvs/default.mhuv` is meant to be empty.
        nothing(Empty),
        cell(NotUtf8, Error, NO_MAP),
        cell(MarkedWord, Warning, "drops the first line, and counts the coordinates behind it \
            from another one"),
        COMMENT,
    ]),
    row(Kind::Image, At::Single(Single::SkinPicture), Use, &[
        cells(LOST_WHOLE, Error, NO_FRAME),
    ]),
    row(Kind::Image, At::Single(Single::Thumbnail), Use, &[
        cells(LOST_WHOLE, Warning, NO_THUMBNAIL),
    ]),
    anywhere(Kind::Image, Use, &[
        cells(LOST_WHOLE, Warning, PLACEHOLDER),
    ]),
];

const AT_MOMENT: &[(Moment, Cell)] = &[
    (
        Scan,
        cell(
            Dangling,
            Error,
            "lists nothing of this library: a link to nothing empties the list",
        ),
    ),
    // Nothing names it.
    (Use, cell(Dangling, Info, "never opens it")),
];

#[rustfmt::skip]
const UNFOUND: &[(&[mhlint_repo::ReferenceKind], Consequence)] = &[
    (&[AssetMesh], Consequence::new(Error, "does not put the asset on")),
    (&[AssetWeights], Consequence::new(Error, "does not put the asset on")),
    (&[WeightsFile], Consequence::new(Error, "fails with `FileNotFoundError` when the skeleton is \
        chosen")),
    (&[AssetMaterial], Consequence::new(Warning, "draws the asset with the default white material")),
    (&[Texture], Consequence::new(Warning, "logs an error and shows a placeholder instead of the \
        picture")),
    (&[Skin], Consequence::new(Warning, "loads the model with the default skin")),
    (&[ModelSkeleton], Consequence::new(Warning, "loads the model without a skeleton")),
    (&[ModelPose], Consequence::new(Warning, "logs an error, and loads the model without its pose \
        and in another shape")),
    (&[ModelExpression], Consequence::new(Warning, "loads the model without the expression")),
    (&[ModelMaterial], Consequence::new(Warning, "logs an error, and shows the asset with the \
        default white material")),
    (&[UvMap], Consequence::new(Error, "fails with `FileNotFoundError` when the material is used")),
];
