//! Expressions with the frames that they are made of
//! (`docs/loaders/makehuman1/expressions.md#units`).

use std::sync::OnceLock;

use super::view::OWN;
use crate::{BodyPose, FileFacts, Layers, PoseUnitsFile};
use mhlint_discover::{Kind, library_of};
use mhlint_formats::bvh::Motion;

/// The names of the frames, which only the system has, and the motion that has the frames.
const NAMES: &str = "poseunits/face-poseunits.json";
const MOTION: &str = "poseunits/face-poseunits.bvh";
/// The library of what is made of them.
const LIBRARY: &str = "expressions";

/// A motion with a name for each frame.
#[derive(Debug, Default)]
pub struct FaceFrames<'a> {
    /// The names, if they could be read.
    pub names: Option<(&'a FileFacts, &'a [String])>,
    /// The motion, if it could be read.
    pub motion: Option<(&'a FileFacts, &'a Motion)>,
}

impl<'a> FaceFrames<'a> {
    pub(super) fn of(layers: Layers<'a>) -> Self {
        let Some(system) = layers.system else {
            return Self::default();
        };
        let names = |file: &'a FileFacts| Some((file, file.face_units()?.names.as_deref()?));
        Self {
            names: system.file(NAMES).and_then(names),
            motion: system
                .file(MOTION)
                .and_then(|file| Some((file, file.motion()?))),
        }
    }

    /// How many frames the motion has, if it can be read to its end.
    pub fn frames(&self) -> Option<usize> {
        let (_, motion) = self.motion.filter(|(_, motion)| motion.fault.is_none())?;
        Some(motion.frames_there.saturating_sub(motion.surplus_frames))
    }

    /// The names, if they are as many as the frames: otherwise there are no units at all.
    fn units(&self) -> Option<(&'a FileFacts, &'a [String])> {
        self.names
            .filter(|(_, names)| self.frames() == Some(names.len()))
    }

    /// The files that make units, and the units. Whether they are there matters to the system that
    /// needs them.
    pub(super) fn files(&self, layers: Layers<'a>) -> Vec<PoseUnitsFile<'a>> {
        let is_there = |rel: &str| {
            let system = layers.system.filter(|_| layers.checks_system());
            system.is_none_or(|system| system.is_there(rel))
        };
        let file = |rel: &str, frames| PoseUnitsFile {
            category: LIBRARY,
            rel: rel.to_owned(),
            is_there: is_there(rel),
            units: None,
            frames,
            names: OnceLock::new(),
        };
        vec![file(NAMES, self.units()), file(MOTION, None)]
    }
}

/// The expressions of the checked layer that are listed.
pub(super) fn expressions(layers: Layers<'_>) -> Vec<BodyPose<'_>> {
    let own = layers
        .checked
        .below(LIBRARY)
        .filter(|file| file.kind_in(OWN) == Kind::Pose);
    let listed = own.filter(|file| library_of(&file.rel).is_some());
    let expression = |file| {
        Some(BodyPose {
            file,
            pose: FileFacts::pose(file)?,
            is_expression: true,
            renewed: |_| None,
        })
    };
    listed.filter_map(expression).collect()
}
