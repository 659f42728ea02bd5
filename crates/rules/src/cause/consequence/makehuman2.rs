//! What MakeHuman 2 does with a file that it cannot read or find.
//!
//! `docs/loaders/makehuman2/folders.md#overlays`, `docs/loaders/makehuman2/text-and-json.md#json`,
//! `docs/loaders/makehuman2/macros.md#special-cases`,
//! `docs/loaders/makehuman2/sliders.md#faults-of-sliders`,
//! `docs/loaders/makehuman2/user-targets.md#scan-of-the-folder`,
//! `docs/loaders/makehuman2/base.md#keys`, `docs/loaders/makehuman2/base.md#geometryjson`,
//! `docs/loaders/makehuman2/base-mesh.md#which-file-is-read`,
//! `docs/loaders/makehuman2/skeletons.md#faults-of-skeletons`,
//! `docs/loaders/makehuman2/weights.md#faults-of-weights`,
//! `docs/loaders/makehuman2/poses.md#pose-units`, `docs/loaders/makehuman2/materials.md#lines`,
//! `docs/loaders/makehuman2/libraries.md#scan`, `docs/loaders/makehuman2/libraries.md#filters`,
//! `docs/loaders/makehuman2/program.md#version-and-settings`,
//! `docs/loaders/makehuman2/program.md#sky-boxes`,
//! `docs/loaders/makehuman2/program.md#lamp-symbol`,
//! `docs/loaders/makehuman2/program.md#newer-program`.

use super::super::overlay::{SystemFolder, system_folder};
use super::table::At::{self, Generated, Replaced, Scanned};
use super::table::{Cell, LOST_WHOLE, Row, Table, anywhere, cell, cells, level, nothing, row};
use super::{Consequence, Damage, Moment};
use Damage::{
    Absent, Closed, Dangling, Empty, MarkedComment, MarkedRow, MarkedWord, Needless, NotUtf8,
    Packed, Pointer, Refused, Special, Syntax, TooDeep,
};
use Moment::{Never, Scan, Start, Tools, Use};
use ReferenceKind::{
    AssetMaterial, AssetMesh, AssetWeights, Decr, Icon, Incr, MacroTarget, Model, ModelMaterial,
    ModelSkeleton, PoseSkeleton, Skin, Texture, WeightsFile,
};
use Single::{BesideBase, Expressions, LampSymbol, Poses, ScriptedRanges, SkySide, Thumbnail};
use mhlint_diag::Level::{Error, Info, Warning};
use mhlint_diag::{Application::Makehuman2, Case};
use mhlint_discover::{Kind, Layout, Single};
use mhlint_repo::ReferenceKind;
use mhlint_repo::makehuman2::{Base, View};

pub(super) static TABLE: Table = Table {
    rows: ROWS,
    at_moment: AT_MOMENT,
    in_general: IN_GENERAL,
    unfound: UNFOUND,
};

/// What a text that crashes the program does while an archive stands for it.
pub(crate) const ARCHIVED: Case = &[(
    Makehuman2,
    Warning,
    "crashes at start once the archive of the folder is deleted and rebuilt",
)];

/// What a mesh does that an archive is read in place of.
pub(crate) const UNREAD_MESH: Case = &[(Makehuman2, Info, UNREAD)];
const UNREAD: &str =
    "reads base.mhbin instead; the fault takes effect once the archive is rebuilt from this mesh";

pub(super) const NOT_READ: &str = "never reads this file; the scripts that align joint cubes crash";
pub(crate) const NEVER_OPENED: &str =
    "never opens it; its scripts open only the geometry.json of `hm08`";
pub(super) const REFUSED_ASSET: &str = "refuses the asset with a message: it cannot be put on";
pub(super) const NO_WEIGHTS_LOADED: &str =
    "loads no weights: in pose mode the mesh collapses to the origin";
/// What becomes of a base without a skeleton for poses.
pub(crate) const NO_POSE_SKELETON: &str = "has no poses and no bone weights for assets, shows a \
    message whenever poses or rigs are opened, and crashes with `AttributeError` in the editors, \
    up to 2026-08-05 also in the glTF export";
const TYPE_ERROR: &str = "crashes at start with `TypeError`";
const NO_BASE: &str = "does not load the base mesh";
/// What becomes of a `.mhskel` or `.mhpose` of which the scan of assets makes nothing; since
/// 08f975c it does not stop there (`docs/loaders/makehuman2/program.md#newer-program`).
pub(crate) const NOT_SCANNED: &str = "up to 2026-08-05 crashes at start with `AttributeError` \
    while scanning the assets; since 2026-08-14 logs a line and does not list the file";
const SCAN_SYNTAX: Cell = cell(Syntax, Error, NOT_SCANNED);
const TOOLS: &str = "never reads it; the tools that read it crash";
const DROPS: Cell = cell(NotUtf8, Warning, "drops the bytes that are not UTF-8");
const NO_EXPRESSIONS: &str = "offers no expressions for the base";
const NO_POSES: &str = "offers no pose editor for the base";
const NO_FILTER: &str =
    "logs a line and uses the filter of the system data; if there is none, tags lead to no label";
const NO_VERSION: &str = "exits at start with code 20";
const NO_SHADERS: &str = "exits at start with code 21";
const NO_WEIGHTS: &[Cell] = &[
    cell(Refused, Error, NO_WEIGHTS_LOADED),
    cell(Syntax, Error, NO_WEIGHTS_LOADED),
    // What `NaN` does to weights is worse, and the business of `weights-non-finite`.
    nothing(Special),
];
const WHITE: &str = "shows the default white material";
const NO_ATTACHMENT: Cell = cell(Empty, Error, "cannot attach the asset");
const EMPTY_ARCHIVE: &str = "crashes at start while scanning the assets; beside a newer text it \
    lists the asset and cannot put it on";
const NO_PICTURE: &[Cell] = &[
    level(Closed, Warning),
    level(Pointer, Warning),
    cell(
        Empty,
        Warning,
        "shows no picture, and copies the broken file into \
    exports if a material names it",
    ),
];
/// The symbol of a lamp is loaded while OpenGL is made ready
/// (`docs/loaders/makehuman2/program.md#lamp-symbol`).
pub(crate) const NO_LAMP: &str = "crashes at every start with a segmentation fault";
/// A side is handed to OpenGL as it is (`docs/loaders/makehuman2/program.md#sky-boxes`).
const NO_SKY: &str = "crashes with a segmentation fault when the skybox is shown, at every start \
    if it is that of `shader.json`";
const NO_USER_ICON: &str =
    "crashes at start with `FileNotFoundError` if the picture is a broken link";
const BINARY: Cell = level(Pointer, Warning);

#[rustfmt::skip]
const ROWS: &[Row] = &[
    anywhere(Kind::BaseJson, Start, &[
        cell(Absent, Error, "crashes with `TypeError` when it loads the base"),
        cell(Refused, Error, NO_BASE),
        cell(Syntax, Error, "does not load the base mesh; the window opens without one"),
    ]),
    row(Kind::BaseMesh, Replaced, Use, &[
        cells(LOST_WHOLE, Info, UNREAD),
        cell(NotUtf8, Info, UNREAD),
        cell(MarkedWord, Info, UNREAD),
    ]),
    anywhere(Kind::BaseMesh, Start,
        &[
            cell(Absent, Error, "crashes with `AttributeError` when it loads the base"),
            cell(Empty, Error, "crashes at start because the base mesh is empty"),
        ]),
    row(Kind::MeshArchive, Replaced, Use,
        &[cell(Closed, Info, "treats it as missing and reads the mesh from another file")]),
    anywhere(Kind::MeshArchive, Start, &[
        cell(Absent, Error, NO_BASE),
        cell(Closed, Error, "crashes at every start: it reads no other mesh while the archive \
            exists"),
        cell(Pointer, Error, "reads the pointer as a mesh and crashes with `ValueError` at every \
            start"),
        cell(Empty, Error, "crashes with `EOFError` at every start until the file is deleted by \
            hand"),
    ]),
    row(Kind::Geometry, At::Single(ScriptedRanges), Tools, &[cell(Syntax, Warning, NOT_READ)]),
    anywhere(Kind::Geometry, Use, &[
        cell(Closed, Info, NEVER_OPENED),
        cell(Pointer, Info, NEVER_OPENED),
        cell(Refused, Info, NEVER_OPENED),
        cell(NotUtf8, Info, NEVER_OPENED),
        cell(Syntax, Info, NEVER_OPENED),
        cell(Special, Info, NEVER_OPENED),
        cell(TooDeep, Info, NEVER_OPENED),
    ]),
    row(Kind::MacroJson, Generated, Never, &[cell(Syntax, Info, "never reads this file")]),
    anywhere(Kind::MacroJson, Start, &[
        cell(Absent, Error, "finds no macros and looks for the targets in the folder of the system \
            data; crashes at start with `FileNotFoundError` if that folder does not exist"),
        cell(Refused, Error, "treats it as missing with only a log line: the base has no macros"),
        cell(Syntax, Error, "treats it as missing with only a log line: the base has no macros"),
        cell(Needless, Info, "treats it as missing, without effect: no slider needs macros"),
    ]),
    row(Kind::ModellingJson, Generated, Start, &[
        cell(Refused, Error, "treats it as missing with only a log line: its sliders disappear"),
        cell(Syntax, Error, "treats it as missing with only a log line: the sliders of the user's \
            targets disappear"),
    ]),
    anywhere(Kind::ModellingJson, Start, &[
        cell(Refused, Error, "treats it as missing with only a log line: its sliders disappear"),
        cell(Syntax, Error, "treats it as missing with only a log line: the base has no sliders"),
    ]),
    row(Kind::TargetCategories, Generated, Start,
        &[cell(Refused, Error, TYPE_ERROR), cell(Syntax, Error, TYPE_ERROR)]),
    anywhere(Kind::TargetCategories, Start, &[
        cell(Refused, Error, "treats it as missing with only a log line: no slider can be reached"),
        cell(Syntax, Error, "treats it as missing with only a log line: no slider can be reached"),
    ]),
    row(Kind::Target, Generated, Start, &[
        cell(Dangling, Error, "crashes at start with `FileNotFoundError` while it looks for user \
            targets"),
        cell(Empty, Warning, "loads the target, which moves nothing"),
    ]),
    anywhere(Kind::Target, Start, &[
        cell(Dangling, Info, "skips it when it packs the targets of the folder"),
        cell(Empty, Warning, "loads the target, which moves nothing"),
    ]),
    // There is no gzip in it at all.
    anywhere(Kind::PackedTarget, Never, &[nothing(Pointer)]),
    anywhere(Kind::TargetArchive, Start,
        &[cell(Pointer, Error, "crashes with `ValueError` at every start: a pointer is not an \
            archive")]),
    row(Kind::TargetIcon, Generated, Start, &[
        cell(Closed, Error, NO_USER_ICON),
        level(Pointer, Warning),
        cell(Empty, Warning, "shows no picture"),
    ]),
    anywhere(Kind::TargetIcon, Use, NO_PICTURE),
    anywhere(Kind::Skeleton, Scan, &[SCAN_SYNTAX]),
    anywhere(Kind::Weights, Start, NO_WEIGHTS),
    anywhere(Kind::AssetWeights, Use, &[
        cell(Refused, Error, REFUSED_ASSET),
        cell(Syntax, Error, REFUSED_ASSET),
        nothing(Special),
    ]),
    // What `NaN` does to a pose is worse, and the business of `pose-non-finite`.
    row(Kind::Pose, Scanned, Scan, &[SCAN_SYNTAX, nothing(Special)]),
    anywhere(Kind::Pose, Use, &[]),
    row(Kind::PoseUnits, At::Single(Expressions), Start, &[
        cell(Absent, Warning, NO_EXPRESSIONS),
        cell(Refused, Error, NO_EXPRESSIONS),
        cell(Syntax, Error, NO_EXPRESSIONS),
        nothing(Special),
    ]),
    row(Kind::PoseUnits, At::Single(Poses), Start, &[
        cell(Absent, Error, NO_POSES),
        cell(Refused, Error, NO_POSES),
        cell(Syntax, Error, NO_POSES),
        nothing(Special),
    ]),
    anywhere(Kind::PoseUnits, Start, &[]),
    anywhere(Kind::SelectionFilter, Start, &[
        cell(Absent, Warning, NO_FILTER),
        cell(Closed, Warning, NO_FILTER),
        cell(Pointer, Warning, NO_FILTER),
        cell(Refused, Warning, NO_FILTER),
        cell(Syntax, Warning, NO_FILTER),
    ]),
    anywhere(Kind::Version, Start, &[
        cell(Closed, Error, NO_VERSION),
        cell(Pointer, Error, NO_VERSION),
        cell(Refused, Error, NO_VERSION),
        cell(Syntax, Error, NO_VERSION),
    ]),
    anywhere(Kind::Shaders, Start, &[
        cell(Closed, Error, NO_SHADERS),
        cell(Pointer, Error, NO_SHADERS),
        cell(Refused, Error, NO_SHADERS),
        cell(Syntax, Error, NO_SHADERS),
    ]),
    row(Kind::Json, At::Single(BesideBase), Start, &[]),
    anywhere(Kind::Json, Use, &[]),
    anywhere(Kind::Clothes, Scan, &[DROPS, NO_ATTACHMENT]),
    anywhere(Kind::Material, Use, &[
        DROPS,
        cells(LOST_WHOLE, Warning, WHITE),
    ]),
    row(Kind::Model, Scanned, Scan, &[
        DROPS,
        cell(Empty, Error, "silently loads the naked default figure"),
        cell(Pointer, Error, "silently loads the naked default figure"),
    ]),
    anywhere(Kind::Model, Scan, &[DROPS, cell(Empty, Warning, "loads a model without any settings")]),
    anywhere(Kind::Motion, Use, &[
        cell(Empty, Error, "crashes with `IndexError` when the pose is used"),
        cell(MarkedWord, Error, "rejects the file: it must begin with `HIERARCHY`"),
        cell(MarkedComment, Error, "rejects the file: it must begin with `HIERARCHY`"),
    ]),
    anywhere(Kind::MotionMeta, Scan, &[DROPS, cell(Empty, Warning, "names the pose after its file")]),
    row(Kind::AssetMesh, At::Single(LampSymbol), Start, &[
        cells(LOST_WHOLE, Error, NO_LAMP),
        cell(NotUtf8, Error, NO_LAMP),
    ]),
    anywhere(Kind::AssetMesh, Use, &[NO_ATTACHMENT]),
    row(Kind::Packed, Scanned, Scan, &[
        cell(Pointer, Error, "crashes at start with `BadZipFile` while scanning the assets; the \
            next start has no assets at all"),
        cell(Empty, Error, EMPTY_ARCHIVE),
        cell(Closed, Error, "takes the folder for the archive of the asset beside it, which is no \
            longer listed"),
    ]),
    anywhere(Kind::Packed, Use, &[BINARY]),
    row(Kind::Image, At::Single(Thumbnail), Use, &[
        level(Closed, Warning),
        cell(Pointer, Warning, "shows an empty picture in the list"),
        cell(Empty, Warning, "shows an empty picture in the list"),
    ]),
    row(Kind::Image, At::Single(SkySide), Use, &[
        cells(LOST_WHOLE, Error, NO_SKY),
    ]),
    anywhere(Kind::Image, Use, NO_PICTURE),
    anywhere(Kind::Other, Use, &[BINARY, cell(Dangling, Info, "passes over it")]),
];

const AT_MOMENT: &[(Moment, Cell)] = &[
    (
        Start,
        cell(NotUtf8, Error, "crashes at start with `UnicodeDecodeError`"),
    ),
    (
        Scan,
        cell(
            NotUtf8,
            Error,
            "crashes at start with `UnicodeDecodeError` while scanning the assets",
        ),
    ),
    (
        Scan,
        cell(
            Dangling,
            Error,
            "crashes at start with `FileNotFoundError` while scanning the assets",
        ),
    ),
    (Scan, cell(Refused, Error, NOT_SCANNED)),
    (Tools, cell(NotUtf8, Warning, TOOLS)),
    (Tools, cell(Refused, Warning, TOOLS)),
];

const IN_GENERAL: &[Cell] = &[
    level(Closed, Error),
    level(Pointer, Error),
    cell(
        Refused,
        Warning,
        "treats it as missing, if it reads it at all",
    ),
    cell(
        MarkedRow,
        Error,
        "reads the first line as a row and crashes at start with `ValueError`",
    ),
    cell(
        MarkedWord,
        Warning,
        "does not recognise the first word and ignores its line",
    ),
    cell(
        MarkedComment,
        Info,
        "ignores the first line, which is only a comment",
    ),
    cell(
        NotUtf8,
        Error,
        "crashes with `UnicodeDecodeError` when the file is used",
    ),
    cell(
        Syntax,
        Warning,
        "treats it as missing, if it reads it at all",
    ),
    cell(Special, Warning, "accepts it and calculates with it"),
    level(TooDeep, Error),
    cell(Packed, Info, "never opens it"),
];

#[rustfmt::skip]
const UNFOUND: &[(&[ReferenceKind], Consequence)] = &[
    (&[MacroTarget], Consequence::new(Error,
        "does not find the target and crashes with `AttributeError` as soon as the sliders reach \
         the combination, or at start if the default character uses it")),
    (&[Incr, Decr], Consequence::new(Error,
        "does not find the target and crashes with `AttributeError` when its slider moves, or at \
         start if the start model sets it")),
    (&[Icon], Consequence::new(Warning, "shows a button of zero size, which cannot be clicked")),
    (&[WeightsFile], Consequence::new(Error, "rejects the skeleton and logs a line")),
    (&[PoseSkeleton], Consequence::new(Error, NO_POSE_SKELETON)),
    (&[Model], Consequence::new(Error, TYPE_ERROR)),
    (&[Skin], Consequence::new(Warning, "silently shows the default skin")),
    (&[ModelSkeleton], Consequence::new(Warning, "silently loads the model without a skeleton")),
    (&[ModelMaterial], Consequence::new(Warning, "silently shows the asset with its default \
        material")),
    (&[AssetMesh], Consequence::new(Error, REFUSED_ASSET)),
    (&[AssetWeights], Consequence::new(Warning, "puts the asset on without bone weights: in a \
        pose it collapses to the origin")),
    (&[AssetMaterial], Consequence::new(Warning, "silently shows the asset in plain white")),
    (&[Texture], Consequence::new(Warning, "silently shows the material without this texture")),
];

/// Whether the scripts that align joint cubes open this `geometry.json`: they know one base mesh.
pub(crate) fn is_opened_by_scripts(rel: &str) -> bool {
    (Layout::of(Makehuman2).single)(rel) == Some(ScriptedRanges)
}

/// What becomes of a base whose override of this name is ignored, with or without a file of the
/// system's behind it.
pub(crate) fn ignored_override(
    view: &View<'_>,
    base: &Base<'_>,
    name: &str,
    has_system: bool,
) -> String {
    let folder = system_folder(view, base);
    let instead = match (has_system, folder) {
        (true, _) => {
            "ignores the override with only a log line, and uses the file of the system data"
        }
        (false, SystemFolder::Unknown) => {
            "ignores the override with only a log line, and uses the file of the system data if \
                it exists"
        }
        (false, _) => "ignores the override with only a log line, and goes on without such a file",
    };
    match (name, folder) {
        ("macro.json", SystemFolder::Absent) => format!(
            "{instead}; then crashes with `FileNotFoundError`: it looks for the targets in \
                `target/{}` of the system data",
            base.name
        ),
        ("macro.json", _) => format!(
            "{instead}; looks for all targets of the base in the system data, and crashes with \
             `AttributeError` if one is missing there"
        ),
        ("target_cat.json", _) if !has_system => format!("{instead}; no slider can be reached"),
        _ => instead.to_owned(),
    }
}
