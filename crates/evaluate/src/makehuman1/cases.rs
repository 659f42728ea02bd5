//! What each kind of case of MakeHuman 1 computes.

use serde_json::{Map, Value, json};

use super::OWN;
use super::macros::variables_json;
use super::modifiers::{Moved, moved};
use super::weights::{compiled, loaded, remapped, weight_references};
use crate::cases::tolerance::{FACTORS, MORPHED, Tolerance, WEIGHTS};
use crate::cases::{Compute, Computer, Kind, inputs, setting};
use crate::data::NamedWeights;
use crate::makehuman2::{WeightLists, inline_weights, read_skeleton, read_weights};
use crate::outputs::{mesh_json, rounded, weight_lists_json, weights_json};
use crate::{Error, SliderSetting, object};
use mhlint_eval::influences::Influences;
use mhlint_eval::makehuman1::variables::{Human, SLIDERS};
use mhlint_formats::mhskel::Skeleton;
use mhlint_formats::target::name::TargetName;
use mhlint_json::Node;

type Outputs = Map<String, Value>;

/// The kinds that the reference files of MakeHuman 1 have.
pub(crate) static KINDS: [Kind; 5] = [
    kind("mh1_macro_vars", variables, FACTORS),
    kind("mh1_modifier_targets", modifier, FACTORS),
    kind("mh1_target_groups", group, FACTORS),
    Kind {
        tolerances: &[("stack", FACTORS)],
        ..kind("mh1_morph", morph, MORPHED)
    },
    Kind {
        by_bone: true,
        ..kind("mh1_weights_remap", remap, WEIGHTS)
    },
];

const fn kind(name: &'static str, outputs: Compute, tolerance: Tolerance) -> Kind {
    Kind {
        name,
        application: OWN,
        outputs,
        tolerance,
        tolerances: &[],
        by_bone: false,
    }
}

/// Macro sliders that are set one after the other, and as a file sets them.
fn variables(_: &mut Computer<'_>, case: &Node, _: &mut Vec<String>) -> Result<Outputs, Error> {
    let settings = macro_settings(case)?;
    let mut as_file: Vec<f64> = (0..SLIDERS.len())
        .map(|slider| Human::default().value(slider))
        .collect();
    for (slider, value) in &settings {
        if let Some(slot) = as_file.get_mut(*slider) {
            *slot = *value;
        }
    }
    Ok(object([
        (
            "one_by_one",
            Value::Object(variables_json(&one_by_one(&settings))),
        ),
        (
            "as_file",
            Value::Object(variables_json(&Human::of_file(&as_file))),
        ),
    ]))
}

fn one_by_one(settings: &[(usize, f64)]) -> Human {
    let mut human = Human::default();
    settings
        .iter()
        .for_each(|(slider, value)| human.set(*slider, *value));
    human
}

/// Numbers of macro sliders with values.
fn macro_settings(case: &Node) -> Result<Vec<(usize, f64)>, Error> {
    let settings = crate::settings::modifiers(inputs::wanted(case, "settings")?);
    let settings =
        settings.map_err(|reason| Error::Input(format!("`settings` of the case: {reason}")))?;
    let number = |(name, value): SliderSetting| {
        let slider = SLIDERS.iter().position(|own| *own == name);
        let unknown = || {
            Error::Input(format!(
                "`{name}` of the case is no macro slider ({})",
                SLIDERS.join(", ")
            ))
        };
        Ok((slider.ok_or_else(unknown)?, value))
    };
    settings.into_iter().map(number).collect()
}

/// The weights that a modifier gives its targets, on a human with some macro settings.
fn modifier(of: &mut Computer<'_>, case: &Node, _: &mut Vec<String>) -> Result<Outputs, Error> {
    let human = one_by_one(&macro_settings(case)?);
    let name = inputs::text(case, "modifier")?;
    let wrong = || Error::Input("`value` of the case is not a number".to_owned());
    let value = inputs::wanted(case, "value")?.as_f64().ok_or_else(wrong)?;
    let base = of.base(case)?;
    let moved = inputs::field(case, "definition").map_or_else(
        || moved(base, name),
        |definition| {
            let text = |key: &str| definition.get(key).and_then(Node::as_str);
            let group = inputs::text(definition, "group")?;
            Ok(Moved::of_groups(
                base,
                group,
                text("left"),
                text("center"),
                text("right"),
            ))
        },
    )?;
    Ok(moved.at(value, human))
}

/// The group of a target and the values in its name. Such a case is a list `[PATH, KEY, VALUES]`.
fn group(_: &mut Computer<'_>, case: &Node, _: &mut Vec<String>) -> Result<Outputs, Error> {
    let path = case.elements().first().and_then(Node::as_str);
    let path = path.map_or_else(|| inputs::text(case, "path"), Ok)?;
    let name = TargetName::of(path).map_err(|clash| {
        super::stops(
            "RuntimeError",
            format!(
                "`{path}` has two values of {}: {}, {}",
                clash.category, clash.first, clash.second
            ),
        )
    })?;
    let values = name
        .categories()
        .map(|(category, value)| (category.to_owned(), Value::from(value)));
    let values = Value::Object(values.collect());
    Ok(object([("key", Value::from(name.key)), ("values", values)]))
}

/// A model on the body.
fn morph(of: &mut Computer<'_>, case: &Node, notes: &mut Vec<String>) -> Result<Outputs, Error> {
    let (file, modifiers) = (of.file, inputs::modifiers(case)?.unwrap_or_default());
    let base = of.base(case)?;
    let setting = setting(base, &modifiers, notes);
    let stack = base.factors(&setting)?;
    let name = |place: usize| {
        base.scene
            .targets
            .get(place)
            .map(|target| target.name.clone())
    };
    let stack = stack
        .iter()
        .filter_map(|(place, weight)| Some((name(*place)?, rounded(*weight))))
        .collect();
    let positions = base.morphed(&setting)?;
    let mut outputs = mesh_json(&positions, &inputs::vertex_ids(file, case, base.base())?)?;
    outputs.insert("stack".to_owned(), Value::Object(stack));
    Ok(outputs)
}

/// Influences of a vertex that a case without a number of its own keeps.
const USUAL: usize = 4;

/// Weights of the base skeleton on a rig, or those of the case itself.
fn remap(of: &mut Computer<'_>, case: &Node, _: &mut Vec<String>) -> Result<Outputs, Error> {
    let count = inputs::count(case, "vertex_count")?;
    of.work += count;
    let limit = if inputs::field(case, "influences").is_some() {
        inputs::count(case, "influences")?
    } else {
        USUAL
    };
    if let Some(lists) = inputs::field(case, "weights").filter(|lists| lists.as_str().is_none()) {
        let order = inputs::wanted(case, "bone_order")?
            .elements()
            .iter()
            .filter_map(Node::as_str);
        let order: Vec<String> = order.map(str::to_owned).collect();
        let weights = loaded(&inline_weights(lists)?, inputs::text(case, "root")?, count)?;
        let mut outputs = weight_lists_json(&weights);
        outputs.extend(reduced(&weights, &order, limit, count, case)?);
        return Ok(outputs);
    }
    let skeleton = |of: &Computer<'_>, key: &str| {
        read_skeleton(&of.roots.file_of(inputs::text(case, key)?, OWN)?)
    };
    let rig = skeleton(of, "rig")?.model;
    let lists: WeightLists = read_weights(&of.roots.file_of(inputs::text(case, "weights")?, OWN)?)?;
    let mut outputs = Outputs::new();
    let weights = if inputs::field(case, "reference rig").is_some() {
        let base = skeleton(of, "reference rig")?.model;
        let own = loaded(&lists, root(&base)?, count)?;
        outputs.insert(
            "weight_references".to_owned(),
            listed(&weight_references(&base, &rig)),
        );
        remapped(&own, &base, &rig, count)?
    } else {
        loaded(&lists, root(&rig)?, count)?
    };
    let influences = Influences::new(&weights.loaded.bones, count).map_err(super::stopped)?;
    let mut own = weights_json(&weights, &influences, &inputs::weighted_vertices(case));
    own.remove("vertex_sum_range");
    outputs.extend(own);
    outputs.extend(reduced(
        &weights,
        &rig.names_in_order(),
        limit,
        count,
        case,
    )?);
    Ok(outputs)
}

fn root(skeleton: &Skeleton) -> Result<&str, Error> {
    let order = skeleton.breadth_first();
    let bone = order
        .first()
        .and_then(|(place, _)| skeleton.bones.get(*place));
    bone.map(|bone| bone.name.as_str())
        .ok_or_else(|| Error::Input("the skeleton of the case has no root".to_owned()))
}

/// What bones take, by name; a bone that takes nothing or its namesake is left out.
fn listed(references: &[(String, Vec<String>)]) -> Value {
    let is_own = |bone: &String, taken: &[String]| matches!(taken, [only] if only == bone);
    let named = references
        .iter()
        .filter(|(bone, taken)| !taken.is_empty() && !is_own(bone, taken));
    let sorted = named.map(|(bone, taken)| {
        let mut taken = taken.clone();
        taken.sort_unstable();
        (bone.clone(), Value::from(taken))
    });
    Value::Object(sorted.collect())
}

/// The strongest bones of the vertices that the case names.
fn reduced(
    weights: &NamedWeights,
    order: &[String],
    limit: usize,
    count: usize,
    case: &Node,
) -> Result<Outputs, Error> {
    let influences = Influences::new(&weights.loaded.bones, count).map_err(super::stopped)?;
    let most = influences.iter().map(<[_]>::len).max().unwrap_or(0);
    let all = compiled(weights, order, limit, count)?;
    let asked = case
        .get("outputs")
        .and_then(|outputs| outputs.get("compiled"))
        .map(Node::elements)
        .unwrap_or_default();
    let vertices = asked
        .iter()
        .filter_map(|pair| pair.elements().first()?.as_i64());
    let listed = vertices.map(|vertex| {
        let of = usize::try_from(vertex)
            .ok()
            .and_then(|vertex| all.get(vertex))
            .map(Vec::as_slice)
            .unwrap_or_default();
        let pairs = of
            .iter()
            .map(|(bone, weight)| json!([order.get(*bone), rounded(f64::from(*weight))]));
        json!([vertex, pairs.collect::<Value>()])
    });
    Ok(object([
        ("max_influences", Value::from(most)),
        (
            "compiled_influences",
            Value::from(all.first().map_or(0, Vec::len)),
        ),
        ("compiled", listed.collect()),
    ]))
}
