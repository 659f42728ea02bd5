//! What the program has and its users have not.

use crate::Layer;

/// Folders and files of the program that no user has together.
const OF_PROGRAM: [&str; 6] = [
    "3dobjs/base.obj",
    "modifiers",
    "targets/macrodetails",
    "rigs/default.mhskel",
    "poseunits",
    "shaders/glsl",
];
/// A folder that lacks more of them is a part of the program.
const MOST: usize = 4;

/// Whether a layer has most of the program, so that what is not there of the rest was lost.
pub fn has_most_of_program(layer: &Layer) -> bool {
    let is_there = |rel: &&&str| layer.file(rel).is_some() || layer.below(rel).next().is_some();
    OF_PROGRAM.iter().filter(is_there).count() >= MOST
}
