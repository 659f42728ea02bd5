//! What is said of each sort of old files: what programs of today make of them, and what an author
//! can do (`docs/loaders/versions.md#formats-that-are-gone`).

use mhlint_diag::{
    Application::{Makehuman1, Makehuman2, Mpfb},
    Case, Level,
};
use mhlint_discover::Kind;
use mhlint_formats::outdated::{Alpha, Outdated};
use mhlint_repo::FileFacts;

/// Files with one consequence.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Sort {
    /// Something worn, where a list shows it.
    Worn,
    /// The same in a folder into which no list looks.
    Unlisted,
    Costume,
    Expression,
    Pose,
    Rig,
    VertexGroups,
    Model,
    LaterModel,
    Target,
}

/// What is said.
pub(super) struct Words {
    /// One of them.
    pub(super) noun: &'static str,
    /// What one has of the older version.
    pub(super) one: &'static str,
    /// What several have.
    pub(super) several: &'static str,
    pub(super) case: Case,
    pub(super) help: &'static str,
}

impl Sort {
    pub(super) fn of(found: Outdated, file: &FileFacts) -> Self {
        let is_model = file.rel.starts_with("models/") || file.rel.starts_with("../models/");
        match found {
            Outdated::Costume => Self::Costume,
            Outdated::Worn(_) if file.kind_in(Makehuman1) == Kind::Unlisted => Self::Unlisted,
            Outdated::Worn(_) => Self::Worn,
            Outdated::Expression if !is_model => Self::Expression,
            Outdated::Expression | Outdated::Model => Self::Model,
            Outdated::LaterModel => Self::LaterModel,
            Outdated::QuaternionPose | Outdated::MatrixPose => Self::Pose,
            Outdated::Rig => Self::Rig,
            Outdated::VertexGroups => Self::VertexGroups,
            Outdated::Target(_) => Self::Target,
        }
    }

    /// What tells findings on one folder apart.
    pub(super) const fn key(self) -> &'static str {
        match self {
            Self::Worn | Self::Unlisted => "worn",
            Self::Costume => "costume",
            Self::Expression => "expression",
            Self::Pose => "pose",
            Self::Rig => "rig",
            Self::VertexGroups => "groups",
            Self::Model | Self::LaterModel => "model",
            Self::Target => "target",
        }
    }
}

const WORN: Case = &[
    (
        Makehuman2,
        Level::Error,
        "lists an asset of this format without a name, and crashes with `AttributeError` when it \
            is put on",
    ),
    (
        Makehuman1,
        Level::Error,
        "puts on no asset of this format: keywords behind `#` are comments, so there is no mesh",
    ),
    (
        Mpfb,
        Level::Error,
        "lists an asset of this format, and fails when it is loaded: keywords behind `#` are \
            comments",
    ),
];
const UNLISTED: Case = &[
    (
        Makehuman2,
        Level::Error,
        "lists and puts on no asset of this format",
    ),
    (
        Makehuman1,
        Level::Error,
        "does not look into this folder, and puts on no asset of this format",
    ),
    (
        Mpfb,
        Level::Error,
        "lists and loads no asset of this format",
    ),
];
const COSTUMES: Case = &[
    (
        Makehuman2,
        Level::Error,
        "has no costumes: without a mesh nothing can be put on",
    ),
    (
        Makehuman1,
        Level::Error,
        "has no costumes: without a mesh nothing can be put on",
    ),
    (
        Mpfb,
        Level::Error,
        "has no costumes: without a mesh nothing can be loaded",
    ),
];
const EXPRESSIONS: Case = &[
    (
        Makehuman2,
        Level::Error,
        "lists no expression of this format: they end in `.mhpose`",
    ),
    (
        Makehuman1,
        Level::Error,
        "lists no expression of this format: since 1.1 they end in `.mhpose`",
    ),
    (
        Mpfb,
        Level::Error,
        "lists no expression of this format: they end in `.json`",
    ),
];
const POSES: Case = &[(
    Makehuman1,
    Level::Error,
    "lists no pose of this format: since 1.1 they end in `.bvh`",
)];
const RIGS: Case = &[
    (
        Makehuman2,
        Level::Warning,
        "ignores a rig of this format: rigs end in `.mhskel`",
    ),
    (
        Makehuman1,
        Level::Warning,
        "ignores a rig of this format: since 1.1 rigs end in `.mhskel`",
    ),
    (
        Mpfb,
        Level::Warning,
        "ignores a rig of this format: it has no `identifying_bones`",
    ),
];
const GROUPS: Case = &[
    (
        Makehuman2,
        Level::Info,
        "ignores weights of this format: they end in `.mhw`",
    ),
    (
        Makehuman1,
        Level::Info,
        "ignores weights of this format: since 1.1 they end in `.mhw`",
    ),
    (Mpfb, Level::Info, "ignores weights of this format"),
];
const MODELS: Case = &[
    (
        Makehuman2,
        Level::Warning,
        "passes over the lines that shape the figure, without a message",
    ),
    (
        Makehuman1,
        Level::Error,
        "fails with `AttributeError` at the version, and leaves the default human",
    ),
    (
        Mpfb,
        Level::Warning,
        "passes over the lines that shape the figure, without a message",
    ),
];
const TARGETS: Case = &[
    (
        Makehuman2,
        Level::Warning,
        "loads a target of it without a message, and moves the wrong vertices",
    ),
    (
        Makehuman1,
        Level::Warning,
        "loads a target of it without a message, and moves the wrong vertices",
    ),
    (
        Mpfb,
        Level::Warning,
        "loads a target of it without a message, and moves the wrong vertices",
    ),
];

pub(super) fn words(sort: Sort, files: &[(&FileFacts, Outdated)]) -> Words {
    let new = |noun, case, help| Words {
        noun,
        one: "has the format",
        several: "have the format",
        case,
        help,
    };
    match sort {
        Sort::Worn => new("asset", WORN, of_worn(files)),
        Sort::Unlisted => new("asset", UNLISTED, of_worn(files)),
        Sort::Costume => new(
            "costume",
            COSTUMES,
            "put the clothes on, and save a model (`.mhm`) in place of the costume",
        ),
        Sort::Expression => {
            let help = "make the expression again in the mixer of MakeHuman 1, which saves \
                `.mhpose`: another suffix or folder does not help";
            new("expression", EXPRESSIONS, help)
        }
        Sort::Pose => new(
            "pose",
            POSES,
            "make a BVH of the pose: another suffix does not help",
        ),
        Sort::Rig => {
            let help = "use a rig of today, such as `default.mhskel` in place of `basic.json` and \
                `cmu_mb.mhskel` in place of `game.json`: another suffix does not help";
            new("rig", RIGS, help)
        }
        Sort::VertexGroups => new(
            "list",
            GROUPS,
            "convert what is still needed to `.mhw`, and keep the rest outside of the data",
        ),
        Sort::Model => new(
            "model",
            MODELS,
            "build the character again: no program reads these lines",
        ),
        Sort::LaterModel => {
            let help = "write `version v1.0.0`, with which MakeHuman 1 reads a model as one of \
                1.0, and save it again there";
            new("model", MODELS, help)
        }
        Sort::Target => Words {
            one: "is for the base mesh",
            several: "are for the base mesh",
            ..new(
                "target",
                TARGETS,
                "make the shape again on `hm08`, or keep the file outside of the data",
            )
        },
    }
}

fn of_worn(files: &[(&FileFacts, Outdated)]) -> &'static str {
    let has = |alpha: Alpha| {
        files
            .iter()
            .any(|(_, found)| *found == Outdated::Worn(alpha))
    };
    match () {
        () if has(Alpha::Seven) || has(Alpha::Other) => {
            "export again for `hm08` from the meshes (MakeClothes, MPFB): the vertex numbers \
                belong to another base mesh"
        }
        () if has(Alpha::Six) => {
            "keep old files outside of the data, or make the asset again for `hm08` (MakeClothes, \
                MPFB)"
        }
        () => "export again for `hm08` from the meshes (MakeClothes, MPFB)",
    }
}
