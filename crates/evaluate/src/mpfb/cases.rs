//! What each kind of case of MPFB computes.

use serde_json::{Map, Value};

use super::keys::Keys;
use super::macros::outputs;
use super::rig_cases;
use crate::cases::tolerance::{
    BONE_ENDS, FACTORS, FITTED_IN_BLENDER, GROUP_SUMS, MIXED, MIXED_SUMS, POSED_IN_BLENDER,
    REST_AXES, RIG_ENDS, TAKEN_SUMS, Tolerance, WEIGHTS,
};
use crate::cases::{Compute, Computer, Kind, inputs};
use crate::outputs::{mesh_json, rounded};
use crate::{Error, Evaluation, SliderSetting};
use mhlint_diag::Application;
use mhlint_eval::mpfb::loops::CUT_OFF;
use mhlint_eval::mpfb::mix::{feet_on_ground, lowest_point};
use mhlint_eval::scene::Setting;
use mhlint_eval::vector::round_to_f32;
use mhlint_json::{Node, Value as Json};

type Outputs = Map<String, Value>;

/// The kinds that the reference files of MPFB have.
pub(crate) static KINDS: [Kind; 7] = [
    Kind {
        tolerances: &[("sum", FACTORS)],
        ..kind("mpfb_macro", macros, FACTORS)
    },
    Kind {
        tolerances: &[
            ("shape_keys", FACTORS),
            ("sum", MIXED_SUMS),
            ("sum_xyz", MIXED_SUMS),
        ],
        ..kind("mpfb_morph", morph, MIXED)
    },
    kind("mpfb_rig", rig_cases::rig, RIG_ENDS),
    Kind {
        tolerances: &[
            ("matrix", REST_AXES),
            ("roll", REST_AXES),
            ("relative_scale", FACTORS),
        ],
        ..kind("mpfb_bones", rig_cases::bones, BONE_ENDS)
    },
    Kind {
        tolerances: &[("groups", GROUP_SUMS)],
        ..kind("mpfb_weights", rig_cases::weights, WEIGHTS)
    },
    Kind {
        tolerances: &[
            ("sum", MIXED_SUMS),
            ("sum_xyz", MIXED_SUMS),
            ("groups", TAKEN_SUMS),
        ],
        ..kind("mpfb_fit", rig_cases::fit, FITTED_IN_BLENDER)
    },
    Kind {
        tolerances: &[("sum", MIXED_SUMS), ("sum_xyz", MIXED_SUMS)],
        ..kind("mpfb_pose", rig_cases::pose, POSED_IN_BLENDER)
    },
];

const fn kind(name: &'static str, outputs: Compute, tolerance: Tolerance) -> Kind {
    Kind {
        name,
        application: Application::Mpfb,
        outputs,
        tolerance,
        tolerances: &[],
        by_bone: false,
    }
}

/// Here values are taken as they are: no property stores them.
fn macros(of: &mut Computer<'_>, case: &Node, _: &mut Vec<String>) -> Result<Outputs, Error> {
    let values = settings(inputs::wanted(case, "macro_info")?)?;
    let cut_off = inputs::field(case, "cutoff")
        .and_then(Node::as_f64)
        .unwrap_or(CUT_OFF);
    let base = of.base(case)?;
    let setting = base.setting(&values)?;
    outputs(base, &setting.macros, cut_off)
}

fn morph(of: &mut Computer<'_>, case: &Node, _: &mut Vec<String>) -> Result<Outputs, Error> {
    let file = of.file;
    let scale = inputs::field(case, "scale_factor")
        .and_then(Node::as_f64)
        .map_or(0.1, round_to_f32);
    let is_lifted = matches!(
        inputs::field(case, "feet_on_ground").map(|node| &node.value),
        Some(Json::Bool(true))
    );
    let details = details(case, "targets")?;
    let base = of.base(case)?;
    let mut keys = Keys::default();
    let setting = |base: &Evaluation, node: &Node| -> Result<Setting, Error> {
        base.setting(&settings(node)?)
    };
    if let Some(node) =
        inputs::field(case, "macro").filter(|node| !matches!(node.value, Json::Null))
    {
        let setting = setting(base, node)?;
        keys.set_macros(base, &setting)?;
    }
    let mut lift = 0.0;
    if is_lifted {
        let mut standing = keys.mixed(base, scale)?;
        let before = lowest_point(&standing).unwrap_or(0.0);
        feet_on_ground(&mut standing);
        lift = lowest_point(&standing).unwrap_or(0.0) - before;
    }
    for (target, value) in details {
        keys.add(base, &target, value);
    }
    if let Some(node) = inputs::field(case, "reapply") {
        let setting = setting(base, node)?;
        keys.set_macros(base, &setting)?;
    }
    let mut positions = keys.mixed(base, scale)?;
    positions.iter_mut().for_each(|point| point[2] += lift);
    let mut outputs = mesh_json(&positions, &inputs::vertex_ids(file, case, base.base())?)?;
    outputs.insert("shape_keys".to_owned(), keys.json());
    let lowest = lowest_point(&positions).map_or(Value::Null, |lowest| rounded(f64::from(lowest)));
    outputs.insert("lowest_point".to_owned(), lowest);
    Ok(outputs)
}

/// Values of settings; those of the races stand in an object of their own.
pub(super) fn settings(node: &Node) -> Result<Vec<SliderSetting>, Error> {
    let mut settings = Vec::new();
    for member in node.effective_members() {
        let races = member.node.effective_members();
        let one = [member];
        let values = if member.key == "race" {
            races.as_slice()
        } else {
            &one
        };
        for value in values {
            let number = value.node.as_f64();
            let number = number.ok_or_else(|| {
                Error::Input(format!("`{}` of the case is not a number", value.key))
            })?;
            settings.push((value.key.clone(), number));
        }
    }
    Ok(settings)
}

/// Target files with their values, out of a field of a case.
pub(super) fn details(case: &Node, key: &str) -> Result<Vec<SliderSetting>, Error> {
    let listed = inputs::field(case, key)
        .map(Node::elements)
        .unwrap_or_default();
    let pair = |node: &Node| match node.elements() {
        [file, value] => Some((file.as_str()?.to_owned(), value.as_f64()?)),
        _ => None,
    };
    let wrong = || {
        Error::Input(format!(
            "`{key}` of the case is not a list of [file, value]"
        ))
    };
    listed
        .iter()
        .map(|node| pair(node).ok_or_else(wrong))
        .collect()
}
