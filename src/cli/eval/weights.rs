//! `mhlint eval weights`.

use std::collections::BTreeSet;
use std::io::Write;

use serde_json::{Map, Value};

use super::args::{LoadedBy, WeightsArgs};
use super::{document, mpfb, write};
use crate::cli::exit::Failure;
use mhlint_evaluate::makehuman2::{
    read_skeleton, read_skeleton_with_joints, read_weights, to_mhw, transferred,
};
use mhlint_evaluate::{
    Error, NamedWeights, SkeletonFile, load_json, makehuman1, object, reduction_json, weights_json,
};

/// Root bone of weights without a skeleton, as the shipped skeletons call it.
const ROOT: &str = "root";

pub(super) fn run(args: &WeightsArgs, out: &mut dyn Write) -> Result<(), Failure> {
    if let Some(rig) = &args.rig {
        return mpfb::weights(&args.file, rig, args.vertices, out);
    }
    if args.app == LoadedBy::Makehuman1 {
        return of_makehuman1(args, out);
    }
    let lists = read_weights(&args.file)?;
    let skeleton = args
        .skeleton
        .as_deref()
        .map(read_skeleton_with_joints)
        .transpose()?;
    let root = skeleton
        .as_ref()
        .map_or(Ok(ROOT), |skeleton| skeleton.root())?;
    let count = args.vertices.unwrap_or_else(|| lists.vertices_named());
    let mut weights = lists.load(root, count)?;
    let mut more = load_json(&weights);
    if let Some(skeleton) = &skeleton {
        more.insert(
            "unknown_bones".to_owned(),
            unknown_bones(&weights, skeleton),
        );
        if let Some(other) = &args.remap_to {
            let lost;
            (weights, lost) = transferred(&weights, skeleton, &read_skeleton_with_joints(other)?)?;
            more.insert("lost_bones".to_owned(), Value::from(lost));
        }
    }
    if let Some(limit) = args.max_influences {
        let reduction = weights.reduce(usize::from(limit), count)?;
        more.insert(
            "reduction".to_owned(),
            reduction_json(&reduction, usize::from(limit)),
        );
    }
    show(args, &weights, more, root, count, out)
}

/// As MakeHuman 1 loads them.
fn of_makehuman1(args: &WeightsArgs, out: &mut dyn Write) -> Result<(), Failure> {
    let lists = read_weights(&args.file)?;
    let skeleton = args.skeleton.as_deref().map(read_skeleton).transpose()?;
    let mut bones: Option<Vec<String>> = skeleton
        .as_ref()
        .map(|skeleton| skeleton.model.names_in_order());
    let first = bones.as_ref().map(|bones| {
        bones
            .first()
            .ok_or_else(|| Error::Input(NO_ROOT.to_owned()))
    });
    let root = first.transpose()?.map_or(ROOT, String::as_str).to_owned();
    let count = args.vertices.unwrap_or_else(|| lists.vertices_named());
    let mut weights = makehuman1::loaded(&lists, &root, count)?;
    let mut more = load_json(&weights);
    if let Some(skeleton) = &skeleton {
        more.insert(
            "unknown_bones".to_owned(),
            unknown_bones(&weights, skeleton),
        );
        if let Some(other) = &args.remap_to {
            let other = read_skeleton(other)?;
            let taken = makehuman1::weight_references(&skeleton.model, &other.model);
            let taken = taken
                .into_iter()
                .map(|(bone, names)| (bone, Value::from(names)));
            more.insert(
                "weight_references".to_owned(),
                Value::Object(taken.collect()),
            );
            weights = makehuman1::remapped(&weights, &skeleton.model, &other.model, count)?;
            bones = Some(other.model.names_in_order());
        }
    }
    if let Some(limit) = args.max_influences {
        let order = bones.unwrap_or_else(|| weights.names.clone());
        let told;
        (weights, told) = makehuman1::reduced(&weights, order, usize::from(limit), count)?;
        more.insert("reduction".to_owned(), told);
    }
    show(args, &weights, more, &root, count, out)
}

const NO_ROOT: &str = "the skeleton has no bones";

/// Bones of weights that a skeleton does not have.
fn unknown_bones(weights: &NamedWeights, skeleton: &SkeletonFile) -> Value {
    let known: BTreeSet<&String> = skeleton.model.bones.iter().map(|bone| &bone.name).collect();
    weights
        .names
        .iter()
        .filter(|name| !known.contains(name))
        .cloned()
        .collect()
}

/// Prints weights, and writes them where a file is asked for.
fn show(
    args: &WeightsArgs,
    weights: &NamedWeights,
    more: Map<String, Value>,
    root: &str,
    count: usize,
    out: &mut dyn Write,
) -> Result<(), Failure> {
    let mut outputs = weights_json(weights, &weights.influences(count)?, &[]);
    outputs.remove("vertices");
    outputs.extend(more);
    if let Some(file) = &args.output {
        let name = args
            .file
            .file_stem()
            .map(|stem| stem.to_string_lossy().into_owned())
            .unwrap_or_default();
        write::write(to_mhw(weights, &name).as_bytes(), Some(file), out)?;
    }
    let inputs = object([
        ("file", Value::from(args.file.to_string_lossy())),
        ("root", Value::from(root)),
        ("vertex_count", Value::from(count)),
    ]);
    write::write(&document("weights", inputs, outputs), None, out)
}
