//! Skeletons with their weights, and what `base.json` names. All are looked for as a path below the
//! data root, user before system.

use crate::{FileFacts, Layer, Layers, Reference, ReferenceKind, Resolution, Rig};
use mhlint_diag::Place;
use mhlint_formats::base_json::BaseJson;
use mhlint_source::depth;

/// Weights of a skeleton that names none.
const DEFAULT_WEIGHTS: &str = "default_weights.mhw";
/// Parts of the path of a skeleton that the scan finds: one folder below `rigs/<base>/`.
const SCANNED_PARTS: usize = 4;

/// What `base.json` names: the skeleton for poses, and the start model.
pub(super) fn named_by_settings<'a>(
    base: &'a str,
    layers: Layers<'a>,
    (from, settings): (&'a FileFacts, &'a BaseJson),
) -> Vec<Reference<'a>> {
    let named = [
        (
            ReferenceKind::PoseSkeleton,
            "pose-skeleton",
            "rigs",
            settings.pose_skeleton.as_deref(),
        ),
        (ReferenceKind::Model, "mhm", "base", settings.mhm.as_deref()),
    ];
    let name = |(kind, member, folder, text): (_, &'static str, &str, Option<&'a str>)| {
        let (text, place) = (text?, Place::pointer([member]));
        Some(Reference {
            owner: member,
            ..reference(layers, kind, base, from, place, text, folder)
        })
    };
    named.into_iter().filter_map(name).collect()
}

/// The rigs of a base.
pub(super) fn rigs<'a>(
    base: &'a str,
    layers: Layers<'a>,
    named: &[Reference<'a>],
    skeletons: impl Iterator<Item = &'a FileFacts>,
) -> Vec<Rig<'a>> {
    let pose = named
        .iter()
        .find(|reference| reference.kind == ReferenceKind::PoseSkeleton);
    let pose = pose.and_then(Reference::found);
    let rig = |file: &'a FileFacts| {
        let is_default = pose.is_some_and(|pose| std::ptr::eq(pose, file));
        let is_found = is_default || depth(&file.rel) <= SCANNED_PARTS;
        Rig {
            file,
            weights: weights(base, layers, file),
            is_default,
            is_found,
        }
    };
    skeletons.map(rig).collect()
}

/// Weights are searched as `rigs/<base>/<weights_file>`, never beside the skeleton.
fn weights<'a>(base: &'a str, layers: Layers<'a>, from: &'a FileFacts) -> Option<Reference<'a>> {
    // Anything but a text is rejected by the schema; what it would lead to is not known.
    let skeleton = from
        .skeleton()
        .filter(|skeleton| !skeleton.weights_file_misshapen)?;
    let text = skeleton.weights_file.as_deref().unwrap_or(DEFAULT_WEIGHTS);
    let place = skeleton
        .weights_file
        .as_ref()
        .map_or(Place::File, |_| Place::pointer(["weights_file"]));
    Some(reference(
        layers,
        ReferenceKind::WeightsFile,
        base,
        from,
        place,
        text,
        "rigs",
    ))
}

/// What a skeleton of a base has to call weights.
pub(super) fn name_of<'f>(base: &str, file: &'f FileFacts) -> &'f str {
    let below = |rel: &'f str| {
        rel.strip_prefix("rigs/")?
            .strip_prefix(base)?
            .strip_prefix('/')
    };
    below(&file.rel).unwrap_or(&file.rel)
}

/// A name in a folder of the base, looked for in all layers.
fn reference<'a>(
    layers: Layers<'a>,
    kind: ReferenceKind,
    base: &'a str,
    from: &'a FileFacts,
    place: Place,
    text: &'a str,
    folder: &str,
) -> Reference<'a> {
    let all: Vec<&Layer> = layers.strongest_first().collect();
    let found = Reference::to(
        &all,
        kind,
        base,
        from,
        place,
        text,
        format!("{folder}/{base}/{text}"),
    );
    match found.resolution {
        Resolution::Missing if layers.system.is_none() => Reference {
            resolution: Resolution::NeedsSystem,
            ..found
        },
        _ => found,
    }
}
