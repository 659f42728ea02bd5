//! Bones that the application never reaches: circles of parents beside a root, with what hangs
//! below them. A circle is one fault and told once, by the rule on circles or by that on the bones
//! below.

use super::super::Rule;
use super::hierarchy::{Ring, hierarchy};
use super::rigs;
use mhlint_diag::{
    Application::{self, Makehuman1, Makehuman2},
    Case, Evidence, Finding, Level, Place,
};
use mhlint_repo::Body;

/// What becomes of bones that are never reached, where the weights mention one.
pub(super) const LOST_AND_WEIGHTED: &[(Application, &str)] = &[
    (
        Makehuman2,
        "silently drops these bones; entering pose mode then crashes with `KeyError`, because the \
            weights use them",
    ),
    (
        Makehuman1,
        "fails with `KeyError` at start: the base skeleton lacks these bones",
    ),
];

const REFUSED: Case = &[
    (
        Makehuman2,
        Level::Error,
        "rejects the skeleton: none of its bones is a root",
    ),
    (
        Makehuman1,
        Level::Error,
        "fails with `IndexError` when the skeleton is chosen: none of its bones is a root",
    ),
];
const LOST: Case = &[
    (Makehuman2, Level::Warning, "silently drops these bones"),
    (
        Makehuman1,
        Level::Warning,
        "drops these bones with a line in the log; other bones get their weights",
    ),
];

/// One finding of `rule` for every circle that it is for.
pub(super) fn lost_bones(
    rule: &Rule,
    body: &Body<'_>,
    is_for: impl Fn(&Ring<'_>) -> bool,
) -> Vec<Finding> {
    let mut found = Vec::new();
    for rig in rigs(body) {
        let hierarchy = hierarchy(rig.skeleton);
        if hierarchy.lacks_root() {
            continue;
        }
        let weighted = rig.weighted_bones();
        for ring in hierarchy.rings.iter().filter(|ring| is_for(ring)) {
            let (Some(first), Some(key)) = (ring.bones.first(), ring.bones.iter().min()) else {
                continue;
            };
            let lost: Vec<&str> = ring.bones.iter().chain(&ring.below).copied().collect();
            // The message names the circle and counts what hangs below it.
            let told = if ring.below.is_empty() {
                &ring.bones
            } else {
                &ring.below
            };
            let finding = rule
                .at(
                    rig.file,
                    Place::pointer(["bones", first, "parent"]),
                    message(first, ring),
                )
                .key(*key)
                .help("give one bone of the cycle a parent outside it")
                .evidence(Evidence::of_cases(told).out_of(rig.skeleton.bones.len()));
            found.push(if hierarchy.roots.is_empty() {
                finding
                    .case(REFUSED)
                    .help("set `parent` of one bone of the cycle to null, to make it the root")
            } else if lost.iter().any(|bone| weighted.contains(bone)) {
                finding
            } else {
                finding.case(LOST)
            });
        }
    }
    found
}

fn message(first: &str, ring: &Ring<'_>) -> String {
    let circle = match ring.bones.as_slice() {
        [only] => format!("bone `{only}` is its own parent"),
        bones => format!(
            "the parents of `{first}` form a cycle of {} bones",
            bones.len()
        ),
    };
    match ring.below.as_slice() {
        [] => circle,
        [only] => format!("bone `{only}` cannot be reached from the root: {circle}"),
        below => format!(
            "{} bones cannot be reached from the root: {circle}",
            below.len()
        ),
    }
}
