//! Rules on rigs of MPFB. The rules share words for bones, and the places of bones on the base
//! mesh.

mod asymmetric;
mod bendy_bone;
mod bone_name;
mod custom_scan;
mod cycle;
mod default_position_drift;
mod disconnected;
mod empty_joint_group;
mod ends;
mod enums;
mod identifying_bones;
mod ignored_rotation_mode;
mod influence;
mod layers;
mod located;
mod missing_key;
mod missing_weights;
mod name_asymmetry;
mod needs_rigify;
mod no_bones;
mod pairs;
mod parent_span;
mod renumbered;
mod rigify_type;
mod roll;
mod strategy;
mod subrig_unweighted;
mod swapped_ends;
mod unknown_collection;
mod unknown_cube;
mod unknown_parent;
mod unknown_property;
mod unknown_subtarget;
mod version;
mod vertex_out_of_range;
mod wrong_side;
mod zero_length_bone;

use super::Rule;
use super::unfit::{Wording, names, sort};
use mhlint_diag::{Application::Mpfb, Case, Evidence, Finding, Level, Place, pointer, steps};
use mhlint_formats::rig::Rig;
use mhlint_formats::unfit::Unfit;
use mhlint_repo::mpfb::{RigFile, RigPart};
use mhlint_source::parent;

/// The rules of the family.
pub(super) static RULES: &[&Rule] = &[
    &asymmetric::RULE,
    &bendy_bone::RULE,
    &bone_name::RULE,
    &custom_scan::RULE,
    &cycle::RULE,
    &default_position_drift::RULE,
    &disconnected::RULE,
    &empty_joint_group::RULE,
    &enums::RULE,
    &identifying_bones::RULE,
    &ignored_rotation_mode::RULE,
    &influence::RULE,
    &layers::RULE,
    &missing_key::RULE,
    &missing_weights::RULE,
    &name_asymmetry::RULE,
    &needs_rigify::RULE,
    &no_bones::RULE,
    &parent_span::RULE,
    &renumbered::RULE,
    &rigify_type::RULE,
    &roll::RULE,
    &strategy::RULE,
    &subrig_unweighted::RULE,
    &swapped_ends::RULE,
    &unknown_collection::RULE,
    &unknown_cube::RULE,
    &unknown_parent::RULE,
    &unknown_property::RULE,
    &unknown_subtarget::RULE,
    &version::RULE,
    &vertex_out_of_range::RULE,
    &wrong_side::RULE,
    &zero_length_bone::RULE,
];

/// What happens when a rig has a fault at which the loader stops.
pub(super) const STOPS: &str =
    "fails with an exception when the rig is added: half-made objects stay in the scene";
const OF_ASSET: Case = &[(
    Mpfb,
    Level::Error,
    "fails with an exception when the asset is added: it stays without its own rig",
)];

/// A finding on a fault that stops the loader, with the words for a rig of an asset if the rig is
/// one.
fn stops(rig: &RigFile<'_>, finding: Finding) -> Finding {
    if rig.part == RigPart::Asset {
        finding.case(OF_ASSET)
    } else {
        finding
    }
}

/// Whether there is an asset that a sub-rig belongs to: a file beside it with the same name. MPFB
/// reads no other sub-rigs.
fn has_asset(rig: &RigFile<'_>) -> bool {
    let prefix = format!("{}/{}.", parent(&rig.file.rel), rig.file.stem());
    ["mhclo", "proxy"]
        .iter()
        .any(|ending| rig.layer.file(&format!("{prefix}{ending}")).is_some())
}

/// A finding on some bones of a rig, placed at `key` of the first bone, or at that bone if `key` is
/// empty.
fn at_bones(
    rule: &Rule,
    file: &RigFile<'_>,
    rig: &Rig,
    bones: &[&str],
    key: &str,
    message: String,
) -> Option<Finding> {
    let first = bones.first()?;
    let steps = if key.is_empty() {
        rig.steps_to(first)
    } else {
        rig.steps_below(first, key)
    };
    let place = if key.is_empty() {
        Place::Key(pointer(&steps))
    } else {
        Place::Pointer(pointer(&steps))
    };
    let evidence = Evidence::of_cases(bones).out_of(rig.bones.len());
    Some(rule.at(file.file, place, message).evidence(evidence))
}

/// Findings on values in bones: faults of one sort at the same key become one finding, in however
/// many bones they are.
const IN_BONES: Wording = Wording { cause, subject };

fn cause(one: &Unfit) -> String {
    let is_name = |step: &String| !step.bytes().all(|byte| byte.is_ascii_digit());
    let key = steps(&one.pointer)
        .filter(is_name)
        .last()
        .unwrap_or_default();
    // A missing key is reported at the bone. The last step is then the name of the bone, which must
    // not divide the findings.
    let key = if is_of_bone(&one.pointer) {
        String::new()
    } else {
        key
    };
    format!("{key} {}", sort(one))
}

/// Keys at the top of a rig that are not names of bones.
const HEADER: [&str; 6] = [
    "version",
    "scale_factor",
    "collections",
    "extra_bones",
    "rigify_ui",
    "identifying_bones",
];

/// Whether a pointer leads to a bone as a whole.
fn is_of_bone(pointer: &str) -> bool {
    match steps(pointer).collect::<Vec<_>>().as_slice() {
        [bones, _] => bones == "bones",
        [bone] => bone != "bones" && !HEADER.contains(&bone.as_str()),
        _ => false,
    }
}

/// The name of the bone that a JSON pointer leads into, and the rest of the pointer.
fn split(pointer: &str) -> (Option<String>, &str) {
    let below = pointer
        .strip_prefix("/bones")
        .filter(|rest| rest.starts_with('/'));
    let first = steps(pointer).next().unwrap_or_default();
    if below.is_none() && (HEADER.contains(&first.as_str()) || pointer == "/bones") {
        return (None, pointer);
    }
    let rest = below.unwrap_or(pointer);
    let Some(rest) = rest.strip_prefix('/') else {
        return (None, pointer);
    };
    let end = rest.find('/').unwrap_or(rest.len());
    (
        steps(&format!("/{}", rest.get(..end).unwrap_or_default())).next(),
        rest.get(end..).unwrap_or_default(),
    )
}

/// The value at a JSON pointer in words, such as "`roll` of bone `hand_l`" or "`strategy` of `head`
/// of bone `hand_l`".
fn subject(pointer: &str) -> String {
    let (bone, rest) = split(pointer);
    let mut words: Vec<String> = names(rest)
        .iter()
        .rev()
        .take(2)
        .map(|name| format!("`{name}`"))
        .collect();
    words.extend(bone.map(|bone| format!("bone `{bone}`")));
    if words.is_empty() {
        "the file".to_owned()
    } else {
        words.join(" of ")
    }
}
