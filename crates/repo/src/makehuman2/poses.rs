//! Poses and expressions with the units that they are made of
//! (`docs/loaders/makehuman2/poses.md#pose-units`, `docs/loaders/makehuman2/poses.md#mhpose`).

use std::sync::OnceLock;

use super::OWN;
use crate::{BodyPose, FileFacts, Layers, PoseUnitsFile};
use mhlint_discover::{Kind, listed_in};

/// Names of units in expressions of older versions, and the unit that takes their place. Four of
/// the tongue's have none.
const OLD: [(&str, &str); 26] = [
    ("ChinLeft", "ChinRotate"),
    ("ChinRight", "ChinRotate"),
    ("LeftEyeUp", "LeftEyeVertical"),
    ("LeftEyeDown", "LeftEyeVertical"),
    ("RightEyeUp", "RightEyeVertical"),
    ("RightEyeDown", "RightEyeVertical"),
    ("LeftEyeturnLeft", "LeftEyeturn"),
    ("LeftEyeturnRight", "LeftEyeturn"),
    ("RightEyeturnLeft", "RightEyeturn"),
    ("RightEyeturnRight", "RightEyeturn"),
    ("LeftUpperLidOpen", "LeftUpperLidClosed"),
    ("RightUpperLidOpen", "RightUpperLidClosed"),
    ("MouthMoveLeft", "MouthMove"),
    ("MouthMoveRight", "MouthMove"),
    ("MouthLeftPullUp", "MouthLeftPullVertical"),
    ("MouthLeftPullDown", "MouthLeftPullVertical"),
    ("MouthRightPullUp", "MouthRightPullVertical"),
    ("MouthRightPullDown", "MouthRightPullVertical"),
    ("TongueLeft", "TongueHorizontal"),
    ("TongueRight", "TongueHorizontal"),
    ("UpperLipForward", "UpperLipDepth"),
    ("UpperLipBackward", "UpperLipDepth"),
    ("lowerLipUp", "lowerLipVertical"),
    ("lowerLipDown", "lowerLipVertical"),
    ("lowerLipForward", "lowerLipDepth"),
    ("lowerLipBackward", "lowerLipDepth"),
];

/// Where the units of a folder of poses are.
fn units_name(category: &str) -> &'static str {
    if category == "expressions" {
        "face-poses.json"
    } else {
        "body-poses.json"
    }
}

/// The unit of today that an expression's unit of an older version becomes.
fn renewed(unit: &str) -> Option<&'static str> {
    OLD.iter()
        .find(|(old, _)| *old == unit)
        .map(|(_, new)| *new)
}

/// The units of a base, first those of poses.
pub(super) fn units<'a>(layers: Layers<'a>, base: &str) -> [PoseUnitsFile<'a>; 2] {
    ["poses", "expressions"].map(|category| {
        let rel = format!("base/{base}/{}", units_name(category));
        let file = layers.first_existing(&rel);
        let is_there = |rel: &str| {
            let mut layers = layers.strongest_first();
            layers.any(|layer| layer.file_ignoring_case(rel).is_some() || layer.has_unusable(rel))
        };
        let units = file
            .filter(|file| !file.json.falsy && !file.is_misshapen())
            .and_then(|file| Some((file, file.pose_units()?)));
        PoseUnitsFile {
            category,
            is_there: is_there(&rel),
            rel,
            units,
            frames: None,
            names: OnceLock::new(),
        }
    })
}

/// The poses of these files that are listed.
pub(super) fn poses<'a>(files: impl Iterator<Item = &'a FileFacts>) -> Vec<BodyPose<'a>> {
    let listed = files.filter(|file| file.kind_in(OWN) == Kind::Pose);
    let pose = |file: &'a FileFacts| {
        let category = listed_in(&file.rel)?;
        let is_expression = category == "expressions";
        // Poses are younger than the new names.
        let renewed = if is_expression {
            renewed
        } else {
            |_: &str| None
        };
        Some(BodyPose {
            file,
            pose: file.pose()?,
            is_expression,
            renewed,
        })
    };
    listed.filter_map(pose).collect()
}
