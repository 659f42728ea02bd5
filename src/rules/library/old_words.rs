//! What is said of each sort of old files: what programs of today make of them, and what an author can do
//! (formats/versions.md §4).

use crate::diag::{
    Application::{Makehuman1, Makehuman2, Mpfb},
    Case, Level,
};
use crate::discover::Kind;
use crate::formats::outdated::{Alpha, Outdated};
use crate::repo::FileFacts;

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
    (Makehuman2, Level::Error, "lists them without a name, and crashes with `AttributeError` when one is put on"),
    (Makehuman1, Level::Error, "puts none of them on: keywords behind `#` are comments, so there is no mesh"),
    (Mpfb, Level::Error, "lists them, and fails when one is loaded: keywords behind `#` are comments"),
];
const UNLISTED: Case = &[
    (Makehuman2, Level::Error, "does not list them, and could not put them on"),
    (Makehuman1, Level::Error, "does not look into this folder, and could not put them on"),
    (Mpfb, Level::Error, "does not list them, and could not load them"),
];
const COSTUMES: Case = &[
    (Makehuman2, Level::Error, "has no costumes: without a mesh they cannot be put on"),
    (Makehuman1, Level::Error, "has no costumes: without a mesh they cannot be put on"),
    (Mpfb, Level::Error, "has no costumes: without a mesh they cannot be loaded"),
];
const EXPRESSIONS: Case = &[
    (Makehuman2, Level::Error, "does not list them: its expressions end in `.mhpose`"),
    (Makehuman1, Level::Error, "does not list them: since 1.1 expressions end in `.mhpose`"),
    (Mpfb, Level::Error, "does not list them: its expressions end in `.json`"),
];
const POSES: Case = &[(Makehuman1, Level::Error, "does not list them: since 1.1 poses end in `.bvh`")];
const RIGS: Case = &[
    (Makehuman2, Level::Warning, "ignores them: its rigs end in `.mhskel`"),
    (Makehuman1, Level::Warning, "ignores them: since 1.1 rigs end in `.mhskel`"),
    (Mpfb, Level::Warning, "ignores them: they have no `identifying_bones`"),
];
const GROUPS: Case = &[
    (Makehuman2, Level::Info, "ignores them: weights end in `.mhw`"),
    (Makehuman1, Level::Info, "ignores them: since 1.1 weights end in `.mhw`"),
    (Mpfb, Level::Info, "ignores them"),
];
const MODELS: Case = &[
    (Makehuman2, Level::Warning, "passes over the lines that shape the figure, without a message"),
    (Makehuman1, Level::Error, "fails with `AttributeError` at the version, and leaves the default human"),
    (Mpfb, Level::Warning, "passes over the lines that shape the figure, without a message"),
];
const TARGETS: Case = &[
    (Makehuman2, Level::Warning, "loads them without a message, and moves the wrong vertices"),
    (Makehuman1, Level::Warning, "loads them without a message, and moves the wrong vertices"),
    (Mpfb, Level::Warning, "loads them without a message, and moves the wrong vertices"),
];

pub(super) fn words(sort: Sort, files: &[(&FileFacts, Outdated)]) -> Words {
    let new = |noun, case, help| Words { noun, one: "has the format", several: "have the format", case, help };
    match sort {
        Sort::Worn => new("asset", WORN, of_worn(files)),
        Sort::Unlisted => new("asset", UNLISTED, of_worn(files)),
        Sort::Costume => {
            new("costume", COSTUMES, "put the clothes on, and save a model (`.mhm`) in place of the costume")
        }
        Sort::Expression => {
            let help = "make them again in the expression mixer of MakeHuman 1, which saves `.mhpose`: another suffix or \
                folder does not help";
            new("expression", EXPRESSIONS, help)
        }
        Sort::Pose => new("pose", POSES, "make a BVH of each pose: another suffix does not help"),
        Sort::Rig => {
            let help = "use a rig of today, such as `default.mhskel` in place of `basic.json` and `cmu_mb.mhskel` in place of \
                `game.json`: another suffix does not help";
            new("rig", RIGS, help)
        }
        Sort::VertexGroups => {
            new("list", GROUPS, "convert what is still needed to `.mhw`, and keep the rest outside of the data")
        }
        Sort::Model => new("model", MODELS, "build the characters again: no program reads their lines"),
        Sort::LaterModel => {
            let help =
                "write `version v1.0.0`, with which MakeHuman 1 reads a model as one of 1.0, and save it again there";
            new("model", MODELS, help)
        }
        Sort::Target => Words {
            one: "is for the base mesh",
            several: "are for the base mesh",
            ..new("target", TARGETS, "model them again on `hm08`, or keep them outside of the data")
        },
    }
}

fn of_worn(files: &[(&FileFacts, Outdated)]) -> &'static str {
    let has = |alpha: Alpha| files.iter().any(|(_, found)| *found == Outdated::Worn(alpha));
    match () {
        () if has(Alpha::Seven) || has(Alpha::Other) => {
            "export again for `hm08` from the meshes (MakeClothes, MPFB): the vertex numbers belong to another base mesh"
        }
        () if has(Alpha::Six) => "keep them outside of the data, or make them again for `hm08` (MakeClothes, MPFB)",
        () => "export again for `hm08` from the meshes (MakeClothes, MPFB)",
    }
}
