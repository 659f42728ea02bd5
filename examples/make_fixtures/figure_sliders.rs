//! `modelling.json` and `target_cat.json` of `figure`, with the detail targets and all icons.

use serde_json::{Map, Value, json};

use crate::fields;
use crate::figure::Body;
use crate::json_text;
use crate::slider::{Detail, Place, add_details, add_icon};
use crate::tree::Tree;

const PLACE: Place = Place {
    base: "figure",
    folder: "data/target/figure",
};

const SIZE: Option<(&str, &str)> = Some(("decr", "incr"));
const DEPTH: Option<(&str, &str)> = Some(("in", "out"));
const HEIGHT: Option<(&str, &str)> = Some(("down", "up"));
const LENGTH: Option<(&str, &str)> = Some(("backward", "forward"));

pub(crate) const DETAILS: [Detail; 13] = [
    detail(
        "Head Size",
        "face|head size",
        "head/head-size",
        SIZE,
        0.1,
        fields::head_size,
    ),
    detail(
        "Head Sides",
        "face|head size",
        "head/head-side",
        DEPTH,
        0.1,
        fields::head_side,
    ),
    detail(
        "Head Oval",
        "face|head shape",
        "head/head-oval",
        None,
        0.06,
        fields::head_oval,
    ),
    detail(
        "Torso Height",
        "torso|torso",
        "torso/torso-trans",
        HEIGHT,
        0.25,
        fields::torso_height,
    ),
    detail(
        "Chest Depth",
        "torso|torso",
        "torso/chest-depth",
        SIZE,
        0.12,
        fields::chest_depth,
    ),
    detail(
        "Belly",
        "torso|belly",
        "torso/belly-trans",
        DEPTH,
        0.1,
        fields::belly,
    ),
    sided(
        "Upper Arm Thickness",
        "arms|{side} arm",
        "arms/{side}-upperarm-thick",
        SIZE,
        0.15,
        fields::upper_arm,
    ),
    sided(
        "Lower Arm Thickness",
        "arms|{side} arm",
        "arms/{side}-lowerarm-thick",
        SIZE,
        0.15,
        fields::lower_arm,
    ),
    sided(
        "Upper Leg Thickness",
        "legs|{side} leg",
        "legs/{side}-upperleg-thick",
        SIZE,
        0.15,
        fields::upper_leg,
    ),
    sided(
        "Lower Leg Thickness",
        "legs|{side} leg",
        "legs/{side}-lowerleg-thick",
        SIZE,
        0.15,
        fields::lower_leg,
    ),
    sided(
        "Foot Length",
        "legs|{side} leg",
        "legs/{side}-foot-trans",
        LENGTH,
        0.12,
        fields::foot,
    ),
    detail(
        "ME-Waist Circ",
        "measure|girth",
        "measure/measure-waist-circ",
        SIZE,
        0.1,
        fields::waist_girth,
    ),
    detail(
        "ME-Hips Circ",
        "measure|girth",
        "measure/measure-hips-circ",
        SIZE,
        0.1,
        fields::hips_girth,
    ),
];

type Move = fn([f64; 3], f64) -> [f64; 3];
type Ends = Option<(&'static str, &'static str)>;

const fn detail(
    label: &'static str,
    group: &'static str,
    stem: &'static str,
    ends: Ends,
    amount: f64,
    field: Move,
) -> Detail {
    Detail {
        label,
        group,
        stem,
        ends,
        sided: false,
        amount,
        field,
    }
}

const fn sided(
    label: &'static str,
    group: &'static str,
    stem: &'static str,
    ends: Ends,
    amount: f64,
    field: Move,
) -> Detail {
    Detail {
        sided: true,
        ..detail(label, group, stem, ends, amount, field)
    }
}

pub(crate) fn add(tree: &mut Tree, body: &Body) {
    let mut entries = macro_entries();
    for icon in ["phenotype.png", "gender.png", "age.png", "muscle.png"] {
        add_icon(tree, &PLACE, icon);
    }
    entries.extend(add_details(tree, &body.mesh, &PLACE, &DETAILS));
    // Grid heights of waist and hips, see the table of the torso in `figure`.
    for (key, height) in [("ME-Waist Circ", 9), ("ME-Hips Circ", 8)] {
        entries[key]["measure"] = json!(body.girth(height));
    }
    tree.add(
        "data/target/figure/modelling.json",
        json_text::by_hand(&Value::Object(entries)),
    );
    tree.add(
        "data/target/figure/target_cat.json",
        json_text::by_hand(&categories()),
    );
}

fn macro_entries() -> Map<String, Value> {
    let entries = json!({
        "Phenotype": {
            "group": "main|macro",
            "icon": "phenotype.png",
            "barycentric": ["macrodetails/Coastal", "macrodetails/Highland", "macrodetails/Woodland"],
            "barycentric_diffuse": [[0.45, 0.3, 0.2], [0.8, 0.6, 0.5], [0.65, 0.45, 0.35]],
            "macro_influence": [0],
        },
        "Gender": {
            "group": "main|macro",
            "icon": "gender.png",
            "tip": "Minimum is female, maximum is male.",
            "macro": "macrodetails/Gender",
            "macro_influence": [0, 1],
            "default": 0.5,
            "display": {
                "slot": 1,
                "text": "{}",
                "formula": "'neutral' if 0.49 < val < 0.51 else str(round(val * 100)) + '% male'",
            },
        },
        "Age": {
            "group": "main|macro",
            "icon": "age.png",
            "tip": "Child, teen, adult (centre position) and old.",
            "macro": "macrodetails/Age",
            "macro_influence": [1],
            "default": 0.5,
            "display": {
                "slot": 2,
                "text": "Age: {}",
                "formula": "round(6 + val * 38) if val < 0.5 else round(25 + (val - 0.5) * 120)",
            },
        },
        "Muscle": {
            "group": "main|macro",
            "icon": "muscle.png",
            "macro": "macrodetails-universal/Muscle",
            "macro_influence": [1],
            "default": 0.5,
            "display": { "slot": 3, "text": "Muscle: {}%", "formula": "round(val * 100, 2)" },
        },
    });
    entries
        .as_object()
        .cloned()
        .expect("invariant: written as an object")
}

fn categories() -> Value {
    json!({
        "Main": { "group": "main", "items": [
            { "title": "Macro", "cat": "macro" },
        ] },
        "Face": { "group": "face", "items": [
            { "title": "Head size", "cat": "head size" },
            { "title": "Head shape", "cat": "head shape" },
        ] },
        "Torso": { "group": "torso", "items": [
            { "title": "Torso", "cat": "torso" },
            { "title": "Belly", "cat": "belly" },
        ] },
        "Arms": { "group": "arms", "items": [
            { "title": "Right arm", "cat": "right arm" },
            { "title": "Left arm", "cat": "left arm" },
        ] },
        "Legs": { "group": "legs", "items": [
            { "title": "Right leg", "cat": "right leg" },
            { "title": "Left leg", "cat": "left leg" },
        ] },
        "Measure": { "group": "measure", "items": [
            { "title": "Girth", "cat": "girth" },
        ] },
    })
}
