//! What evaluation measures on a scene, in plain data with names, which outlives the scene. Rules
//! judge it.

use std::collections::BTreeMap;

use super::rig_measure::{BoneMeasure, WeightMeasure};
use super::settings::SliderSetting;
use super::survey::Trouble;
use super::symmetry::MirrorDifference;
use super::target_measure::TargetMeasure;
use super::worn::WornMeasure;

/// Measures of one base mesh.
#[derive(Debug, Clone, Default)]
pub struct Measures {
    /// Whether some settings of the macros were left out: there are more than anybody waits for.
    pub lacks_settings: bool,
    /// What happens over the slider space; `None` if the default character cannot be made.
    pub space: Option<BTreeMap<Trouble, Seen>>,
    /// What the macros do over the range of their sliders.
    pub macros: MacroMeasure,
    /// Every target in use.
    pub targets: Vec<TargetMeasure>,
    /// Left targets compared with their right partners.
    pub pairs: Vec<PairMeasure>,
    /// Names of the joint cubes that torn cubes are counted by.
    pub cubes: Vec<String>,
    /// Skeletons of the base on the default character.
    pub skeletons: Vec<SkeletonMeasure>,
    /// Weights of the pose skeleton.
    pub weights: Option<WeightMeasure>,
    /// Names of the bones of the pose skeleton, as `weights` numbers them.
    pub bones: Vec<String>,
    /// What is worn, by printed path; only assets whose rows fit the mesh.
    pub worn: BTreeMap<String, WornMeasure>,
    /// Bones of the pose skeleton that have each other's weights on what is worn, by printed path
    /// of these weights.
    pub exchanged: BTreeMap<String, Vec<usize>>,
    /// Whether something was left out because it was too much work.
    pub is_cut: bool,
}

/// The worst that was seen of one thing.
#[derive(Debug, Clone, PartialEq)]
pub struct Seen {
    /// How bad; larger is worse.
    pub value: f64,
    /// Number of the vertex, face, joint or bone.
    pub element: usize,
    /// The value as a length in mesh units, where it is one in other units.
    pub length: Option<f64>,
    /// Its name: group of a face, joint, bone.
    pub name: String,
    /// How many elements are concerned at that setting.
    pub count: usize,
    /// All that are concerned at some setting, by number.
    pub elements: Vec<usize>,
    /// The same by name: faces with their group, groups, joints, bones. Vertices have none.
    pub all: Vec<String>,
    /// What differs from the defaults at that setting.
    pub setting: Vec<SliderSetting>,
    /// Printed path of the target that moves the element most at that setting.
    pub target: Option<String>,
}

/// What macros do over the range of their sliders.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct MacroMeasure {
    /// Stretches in which a macrodef applies nothing.
    pub dead: Vec<DeadRange>,
    /// Weights that do not sum to one.
    pub sums: Vec<SumOff>,
    /// Jumps between two sides of a step.
    pub jumps: Vec<Jump>,
    /// Whether it was more work than is done, and some of it was left out.
    pub is_cut: bool,
    /// Macrodef, weight lost to the cut-off at worst, and the setting.
    pub losses: Vec<(usize, f64, Vec<SliderSetting>)>,
}

/// A stretch of a slider in which a macrodef applies nothing, wherever its other sliders stand.
#[derive(Debug, Clone, PartialEq)]
pub struct DeadRange {
    /// Number of the macrodef.
    pub macrodef: usize,
    /// Position of the component in its `comp`.
    pub position: usize,
    /// Values that have no target in any combination; empty above the last step.
    pub values: Vec<usize>,
    /// Combinations with these values that are listed with null.
    pub null: usize,
    /// Combinations with these values that are not listed.
    pub missing: usize,
}

/// A sum of weights that is not one.
#[derive(Debug, Clone, PartialEq)]
pub struct SumOff {
    /// Number of the macrodef.
    pub macrodef: usize,
    /// Position of the component in its `comp`.
    pub position: usize,
    /// Slider position (of a barycentric set: none).
    pub at: Option<f64>,
    /// The sum.
    pub sum: f64,
}

/// A jump of the factor of a target between two sides of a step.
#[derive(Debug, Clone, PartialEq)]
pub struct Jump {
    /// Number of the macrodef whose component has the step.
    pub macrodef: usize,
    /// Position of the component in its `comp`.
    pub position: usize,
    /// The step.
    pub at: f64,
    /// How much the factor changes.
    pub by: f64,
}

/// A left target and its right partner.
#[derive(Debug, Clone, PartialEq)]
pub struct PairMeasure {
    /// Printed path of the left one.
    pub left: String,
    /// Printed path of the right one.
    pub right: String,
    /// How far the left one is from the mirror image of the right one.
    pub difference: MirrorDifference,
    /// The same for the visible body alone.
    pub body: MirrorDifference,
    /// Whether each of them moves the side that the other one is named after.
    pub is_exchanged: bool,
}

/// A skeleton on the default character.
#[derive(Debug, Clone, PartialEq)]
pub struct SkeletonMeasure {
    /// Printed path of its file.
    pub path: String,
    /// Its bones.
    pub bones: Vec<BoneMeasure>,
    /// Whether the mesh stands in the middle, so that left and right are told by the sign of x.
    pub is_centred: bool,
    /// What it gets of the weights of the pose skeleton.
    pub received: Received,
}

/// What a skeleton gets of the weights of the pose skeleton through the references of its bones;
/// nothing is known of the pose skeleton itself.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Received {
    /// Its bones that receive nothing.
    pub without_weights: Vec<String>,
    /// Bones of the pose skeleton whose weights nobody takes.
    pub lost_bones: Vec<String>,
    /// How many vertices there are whose weights are lost with them, all that they have.
    pub lost_vertices: usize,
}
