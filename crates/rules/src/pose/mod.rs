//! Poses, expressions and motions.

pub(crate) mod folder;
mod foreign_unit;
pub(crate) mod framemapping;
pub(crate) mod imported_joint;
mod licence_spelling;
pub(crate) mod matrix;
pub(crate) mod meta;
pub(crate) mod missing_units;
pub(crate) mod mpfb;
mod mpfb_rigs;
pub(crate) mod no_units;
pub(crate) mod non_finite;
mod units_bone;
pub(crate) mod unknown_bone;
pub(crate) mod unknown_unit;
pub(crate) mod value_range;

use super::Rule;
use std::collections::BTreeSet;

/// The rules of the family.
pub(super) static RULES: &[&Rule] = &[
    &licence_spelling::RULE,
    &matrix::RULE,
    &meta::RULE,
    &missing_units::RULE,
    &no_units::RULE,
    &non_finite::RULE,
    &unknown_bone::RULE,
    &unknown_unit::RULE,
    &value_range::RULE,
    &folder::RULE,
    &framemapping::RULE,
    &mpfb::RULE,
];

use mhlint_diag::pointer;
use mhlint_formats::pose_units::{PoseUnits, Turn, Unit};

/// The key of `unit_poses` in a pose.
const UNITS: &str = "unit_poses";

/// The names of units.
fn names(units: &PoseUnits) -> BTreeSet<&str> {
    units.units.iter().map(|unit| unit.name.as_str()).collect()
}

/// Everything that the units turn, with the pointer to its matrix.
fn turns(units: &PoseUnits) -> impl Iterator<Item = (&Unit, &'static str, &Turn)> {
    units.units.iter().flat_map(|unit| {
        let halves = [("bones", &unit.bones), ("reverse", &unit.reverse)];
        halves.into_iter().flat_map(move |(half, turns)| {
            turns.iter().flatten().map(move |turn| (unit, half, turn))
        })
    })
}

/// Where a matrix stands.
fn at(unit: &Unit, half: &str, turn: &Turn) -> String {
    pointer(&[&unit.name, half, &turn.bone])
}
