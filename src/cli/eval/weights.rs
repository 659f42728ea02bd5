//! `mhlint eval weights`.

use std::collections::BTreeSet;
use std::io::Write;

use serde_json::Value;

use super::args::WeightsArgs;
use super::{document, mpfb, write};
use crate::cli::exit::Failure;
use crate::evaluate::makehuman2::{read_skeleton, read_weights, to_mhw, transferred};
use crate::evaluate::{load_json, object, reduction_json, weights_json};

/// Root bone of weights without a skeleton, as the shipped skeletons call it.
const ROOT: &str = "root";

pub(super) fn run(args: &WeightsArgs, out: &mut dyn Write) -> Result<(), Failure> {
    if let Some(rig) = &args.rig {
        return mpfb::weights(&args.file, rig, args.vertices, out);
    }
    let lists = read_weights(&args.file)?;
    let skeleton = args.skeleton.as_deref().map(read_skeleton).transpose()?;
    let root = skeleton.as_ref().map_or(Ok(ROOT), |skeleton| skeleton.root())?;
    let count = args.vertices.unwrap_or_else(|| lists.vertices_named());
    let mut weights = lists.load(root, count)?;
    let mut more = load_json(&weights);
    if let Some(skeleton) = &skeleton {
        let known: BTreeSet<&String> = skeleton.model.bones.iter().map(|bone| &bone.name).collect();
        let unknown = weights.names.iter().filter(|name| !known.contains(name));
        more.insert("unknown_bones".to_owned(), unknown.cloned().collect());
        if let Some(other) = &args.remap_to {
            let lost;
            (weights, lost) = transferred(&weights, skeleton, &read_skeleton(other)?)?;
            more.insert("lost_bones".to_owned(), Value::from(lost));
        }
    }
    if let Some(limit) = args.max_influences {
        let reduction = weights.reduce(usize::from(limit), count)?;
        more.insert("reduction".to_owned(), reduction_json(&reduction, usize::from(limit)));
    }
    let mut outputs = weights_json(&weights, &weights.influences(count)?, &[]);
    outputs.remove("vertices");
    outputs.extend(more);
    if let Some(file) = &args.output {
        let name = args.file.file_stem().map(|stem| stem.to_string_lossy().into_owned()).unwrap_or_default();
        write::write(to_mhw(&weights, &name).as_bytes(), Some(file), out)?;
    }
    let inputs = object([
        ("file", Value::from(args.file.to_string_lossy())),
        ("root", Value::from(root)),
        ("vertex_count", Value::from(count)),
    ]);
    write::write(&document("weights", inputs, outputs), None, out)
}
