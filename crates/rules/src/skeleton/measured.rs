//! Skeletons as evaluation measured them on the default character: what the numeric rules of this
//! family share.

use std::collections::BTreeMap;

use mhlint_eval::measures::{Measures, SkeletonMeasure};
use mhlint_eval::rig_measure::BoneMeasure;
use mhlint_formats::mhskel::{Bone, RotationPlane, Skeleton};
use mhlint_repo::{Body, FileFacts};

/// Head and tail closer than this are one point, mesh units: a rounding step of 32 bit floats at
/// the size of a body.
pub(super) const NO_LENGTH: f64 = 1e-6;

/// A skeleton with its measures.
pub(super) struct Measured<'a> {
    pub(super) file: &'a FileFacts,
    pub(super) skeleton: &'a Skeleton,
    pub(super) measure: &'a SkeletonMeasure,
}

/// Skeletons of the base that could be measured. Those on a mesh that is NaN or infinite are left
/// out: mesh and targets are at fault there.
pub(super) fn measured<'a>(body: &'a Body<'_>, measures: &'a Measures) -> Vec<Measured<'a>> {
    let files: BTreeMap<&str, &'a FileFacts> = body
        .rigs
        .iter()
        .map(|rig| (rig.file.path.as_str(), rig.file))
        .collect();
    let with_file = |measure: &'a SkeletonMeasure| {
        let file = *files.get(measure.path.as_str())?;
        let is_finite = measure.bones.iter().all(|bone| bone.length.is_finite());
        Some(Measured {
            file,
            skeleton: file.skeleton()?,
            measure,
        })
        .filter(|_| is_finite)
    };
    measures.skeletons.iter().filter_map(with_file).collect()
}

impl<'a> Measured<'a> {
    /// Bones with their measures, in the order of the file.
    pub(super) fn bones(&self) -> impl Iterator<Item = (&'a Bone, &'a BoneMeasure)> {
        let measures = self.measure.bones.iter().rev();
        // Of equal names the first.
        let measures: BTreeMap<&str, &BoneMeasure> =
            measures.map(|bone| (bone.name.as_str(), bone)).collect();
        self.skeleton
            .bones
            .iter()
            .filter_map(move |bone| Some((bone, *measures.get(bone.name.as_str())?)))
    }

    /// Head and tail of the bones without length.
    pub(super) fn collapsed(&self) -> Vec<(&'a str, &'a str)> {
        let short = self
            .bones()
            .filter(|(_, measure)| measure.length < NO_LENGTH);
        short
            .filter_map(|(bone, _)| Some((bone.head.as_deref()?, bone.tail.as_deref()?)))
            .collect()
    }
}

/// The plane that a bone names.
pub(super) fn plane_of(bone: &Bone) -> Option<&str> {
    if let RotationPlane::Named(plane) = &bone.rotation_plane {
        Some(plane)
    } else {
        None
    }
}
