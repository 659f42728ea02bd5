//! What a rig says to Rigify (`docs/loaders/mpfb/rigs.md#keys-of-a-bone`).

use std::collections::BTreeSet;

use super::attribute::{Properties, Wants, check, wanted};
use super::bone::{Whole, names};
use super::layers::OF_RIGIFY;
use super::{RigBone, RigFaults, layers};
use crate::unfit::{Why, below};
use mhlint_json::Node;

/// The types of Rigify 0.6.10.
const TYPES: &[&str] = &[
    "basic.copy_chain",
    "basic.pivot",
    "basic.raw_copy",
    "basic.super_copy",
    "experimental.super_chain",
    "face.basic_tongue",
    "face.skin_eye",
    "face.skin_jaw",
    "faces.super_face",
    "limbs.arm",
    "limbs.front_paw",
    "limbs.leg",
    "limbs.paw",
    "limbs.rear_paw",
    "limbs.simple_tentacle",
    "limbs.spline_tentacle",
    "limbs.super_finger",
    "limbs.super_limb",
    "limbs.super_palm",
    "skin.anchor",
    "skin.basic_chain",
    "skin.glue",
    "skin.stretchy_chain",
    "skin.transform.basic",
    "spines.basic_spine",
    "spines.basic_tail",
    "spines.super_head",
    "spines.super_spine",
];

/// Parameters whose types are known. Others have one, too, and are not checked.
const PARAMETERS: Properties = &[
    ("limb_type", Wants::Word(&["arm", "leg", "paw"])),
    ("rotation_axis", Wants::Word(&["x", "z", "automatic"])),
    (
        "primary_rotation_axis",
        Wants::Word(&["automatic", "X", "Y", "Z", "-X", "-Y", "-Z"]),
    ),
    ("roll_alignment", Wants::Word(&["automatic", "manual"])),
    (
        "foot_pivot_type",
        Wants::Word(&["ANKLE", "TOE", "ANKLE_TOE"]),
    ),
    (
        "skin_glue_add_constraint",
        Wants::Word(&["NONE", "COPY_LOCATION", "COPY_LOCATION_OWNER"]),
    ),
    (
        "skin_chain_pivot_pos skin_chain_priority bbones segments pivot_pos neck_pos tail_pos",
        Wants::Whole,
    ),
    ("skin_chain_falloff", Wants::Numbers(3)),
    (
        "skin_chain_falloff_spherical copy_rotation_axes",
        Wants::Bools(3),
    ),
    ("skin_chain_connect_ends", Wants::Bools(2)),
    ("skin_chain_connect_sharp_angle", Wants::Numbers(2)),
    ("skin_chain_use_scale", Wants::Bools(4)),
    (
        "skin_glue_add_constraint_influence jaw_mouth_influence",
        Wants::Number,
    ),
    (
        "auto_align_extremity connect_chain extra_ik_toe extra_toe_roll ik_local_location \
         make_control make_deform make_widget make_custom_pivot make_ik_wrist_pivot \
         make_fk_controls make_extra_ik_control relink_constraints skin_chain_falloff_scale \
         skin_glue_tail_reparent skin_glue_use_tail skin_secondary_layers_extra",
        Wants::Bool,
    ),
    (
        "skin_control_orientation_bone super_copy_widget_type",
        Wants::Text,
    ),
];

/// What a bone says to Rigify.
pub(super) fn of_bone(
    pointer: &str,
    node: &Node,
    whole: &Whole,
    bone: &mut RigBone,
    faults: &mut RigFaults,
) {
    if !node.is_object() {
        return faults.keys.add_type(pointer, node, "an object");
    }
    if let Some(kind) = node.get("rigify_type") {
        let place = below(pointer, "rigify_type");
        match kind.as_str() {
            Some("") => {}
            Some(_) => {
                faults.ignored_rigify.check_word(&place, kind, TYPES);
                faults.needs_rigify.push(place);
            }
            None => faults.rigify.add_type(&place, kind, "a text"),
        }
    }
    let Some(parameters) = node.get("rigify_parameters") else {
        return;
    };
    let pointer = below(pointer, "rigify_parameters");
    if !parameters.is_object() {
        return faults.rigify.add_type(&pointer, parameters, "an object");
    }
    layers::check_rigify(&pointer, parameters, whole.has_layers, &mut faults.layers);
    for member in parameters.effective_members() {
        let place = below(&pointer, &member.key);
        if member.key.ends_with("_coll_refs") {
            faults.needs_rigify.push(place.clone());
            let names = names(&place, &member.node, faults);
            bone.collection_references
                .extend(names.into_iter().map(|name| (place.clone(), name)));
        } else if let Some(wants) = wanted(PARAMETERS, &member.key) {
            let mut words = std::mem::take(&mut faults.rigify);
            let mut types = crate::unfit::Unfits::default();
            check(&place, &member.node, wants, &mut types, &mut words);
            words.extend(types);
            faults.rigify = words;
        } else if !OF_RIGIFY.contains(&&*member.key) {
            let known = PARAMETERS.iter().map(|(names, _)| *names).collect();
            faults.ignored_rigify.add(&place, Why::Property(known));
        }
    }
}

/// Keys of `rigify_ui`, and those of each of its collections.
const OF_PANEL: [&str; 4] = [
    "rigify_colors_lock",
    "selection_colors",
    "colors",
    "collections",
];
const OF_COLLECTION: [&str; 5] = [
    "is_visible",
    "ui_row",
    "ui_title",
    "sel_set",
    "color_set_id",
];

/// The panel of Rigify. That of older versions has other keys.
pub(super) fn panel(node: &Node, collections: &[String], faults: &mut RigFaults) {
    const POINTER: &str = "/rigify_ui";
    if !node.is_object() {
        return faults.keys.add_type(POINTER, node, "an object");
    }
    let lack = |pointer: &str, node: &Node, keys: &[&'static str], faults: &mut RigFaults| {
        for key in keys.iter().filter(|key| node.get(key).is_none()) {
            faults.keys.add(pointer, Why::Lacks(key));
        }
    };
    lack(POINTER, node, &OF_PANEL, faults);
    if let Some(colors) = node.get("selection_colors") {
        lack(
            "/rigify_ui/selection_colors",
            colors,
            &["select", "active"],
            faults,
        );
    }
    for (at, color) in node
        .get("colors")
        .map(Node::elements)
        .unwrap_or_default()
        .iter()
        .enumerate()
    {
        lack(
            &format!("/rigify_ui/colors/{at}"),
            color,
            &["name", "normal"],
            faults,
        );
    }
    let collections: BTreeSet<&str> = collections.iter().map(String::as_str).collect();
    for member in node
        .get("collections")
        .map(Node::effective_members)
        .unwrap_or_default()
    {
        let pointer = below("/rigify_ui/collections", &member.key);
        lack(&pointer, &member.node, &OF_COLLECTION, faults);
        if !collections.contains(member.key.as_str()) {
            faults.panel_collections.push((pointer, member.key.clone()));
        }
    }
}
