//! Rigs of MPFB: `rig.*.json`, custom rigs and `.mpfbskel` (formats/mpfb.md §20, §21).
//!
//! The loader is strict on what a bone has and lenient on where it lies: what stops it, and what it takes otherwise than it
//! is written, is kept apart.

mod attribute;
mod bone;
mod constraint;
mod end;
mod layers;
mod reader;
mod rigify;

pub use attribute::BENDY;
pub use constraint::{Constraint, Target};
pub use end::{DefaultPosition, End, Strategy};
pub use layers::LayersFault;
pub use reader::read;

use super::unfit::Unfits;

/// The newest version of the format.
pub const NEWEST: f64 = 110.0;

/// A rig.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Rig {
    /// Whether the bones stand in `bones`; otherwise each key at the top is a bone.
    pub has_header: bool,
    /// Its version; that of a file without `bones` is 100.
    pub version: f64,
    /// The scale at which offsets were recorded; 0 where it is not said.
    pub scale_factor: f64,
    /// Whether it calls itself one that is added to another.
    pub is_subrig: bool,
    /// Bones in the order of the file.
    pub bones: Vec<RigBone>,
    /// Names of bone collections that it declares.
    pub collections: Vec<String>,
    /// Bones that Rigify makes later.
    pub extra_bones: Vec<String>,
    /// Whether there is anything for the panel of Rigify.
    pub has_rigify_ui: bool,
    /// By which bones it is recognised.
    pub identifying: Identifying,
    /// The first keys at the top of a file with a header and without `bones`.
    pub top_keys: Vec<String>,
    /// What is wrong with it.
    pub faults: RigFaults,
}

/// By which bones a custom rig is recognised.
#[derive(Debug, Clone, Default, PartialEq)]
pub enum Identifying {
    /// It does not say.
    #[default]
    Absent,
    /// Names of bones.
    Bones(Vec<String>),
    /// A value that is no list: its type.
    Other(&'static str),
}

/// A bone.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct RigBone {
    /// Its name.
    pub name: String,
    /// Where it begins.
    pub head: Option<End>,
    /// Where it ends.
    pub tail: Option<End>,
    /// Turn about itself, radians.
    pub roll: f64,
    /// How the turn is found instead.
    pub roll_strategy: Option<String>,
    /// Where its z axis is to point.
    pub roll_reference_z: Option<[f64; 3]>,
    /// Name of the bone that it hangs on; an empty one is none.
    pub parent: Option<String>,
    /// Whether its head is moved to the tail of its parent.
    pub use_connect: bool,
    /// What it takes of the scale of its parent.
    pub inherit_scale: String,
    /// Order of its angles, if that is said.
    pub rotation_mode: Option<String>,
    /// Names of the collections that it is put into.
    pub collections: Vec<String>,
    /// Names of collections in parameters of Rigify, each with its pointer.
    pub collection_references: Vec<(String, String)>,
    /// Bones that its handles are bound to, each with its key.
    pub handles: Vec<(&'static str, String)>,
    /// Segments that it is bent into, if that is said.
    pub segments: Option<f64>,
    /// What binds it to other bones.
    pub constraints: Vec<Constraint>,
}

/// What is wrong with a rig, apart from what the mesh says.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct RigFaults {
    /// Why no rig is made of the file as a whole.
    pub layout: Vec<LayoutFault>,
    /// Keys that are missing, or of another type.
    pub keys: Unfits,
    /// Words that are none of those which are known.
    pub words: Unfits,
    /// Words that are passed over.
    pub ignored_words: Unfits,
    /// Properties of constraints and of bending that do not exist.
    pub properties: Unfits,
    /// Ends of which nobody can tell where they are.
    pub ends: Unfits,
    /// What is wrong with layers.
    pub layers: Vec<LayersFault>,
    /// Types and parameters of Rigify that stop the loader.
    pub rigify: Unfits,
    /// Those that are passed over.
    pub ignored_rigify: Unfits,
    /// Collections in the panel of Rigify that are not declared: pointer and name.
    pub panel_collections: Vec<(String, String)>,
    /// Pointers to what cannot be made without Rigify.
    pub needs_rigify: Vec<String>,
}

/// Why no rig is made of a file.
#[derive(Debug, Clone, PartialEq)]
pub enum LayoutFault {
    /// It is no object: its type.
    NotObject(&'static str),
    /// It has a key of a header, and no `bones`: the key counts as a bone.
    HeaderWithoutBones(String),
    /// It has `bones`, and no `version`.
    WithoutVersion,
    /// `version` is no number: its type.
    VersionType(&'static str),
    /// `version` is newer than what is read.
    TooNew(f64),
    /// It has `joints`: it is a skeleton of MakeHuman.
    Skeleton,
}

impl Rig {
    /// The steps of a pointer to a bone.
    pub fn steps_to<'s>(&self, bone: &'s str) -> Vec<&'s str> {
        if self.has_header { vec!["bones", bone] } else { vec![bone] }
    }

    /// The steps of a pointer to a key of a bone.
    pub fn steps_below<'s>(&self, bone: &'s str, key: &'s str) -> Vec<&'s str> {
        let mut steps = self.steps_to(bone);
        steps.push(key);
        steps
    }

    /// Whether its layers count: since version 110 there are collections.
    pub fn has_layers(&self) -> bool {
        self.version < NEWEST
    }
}

#[cfg(test)]
mod tests;
