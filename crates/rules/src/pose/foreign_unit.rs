//! Units that are known elsewhere: those of the other folder, and old ones of the tongue.

use mhlint_repo::{Body, BodyPose};

/// Units of older versions that are lost, and what to write instead.
const LOST: [(&str, &str); 4] = [
    ("TongueUp", "TongueVertical"),
    ("TongueDown", "TongueVertical"),
    ("TonguePointUp", "TonguePointVertical"),
    ("TonguePointDown", "TonguePointVertical"),
];

/// What to do about a unit that is known elsewhere.
pub(super) fn help(body: &Body<'_>, pose: &BodyPose<'_>, unit: &str) -> Option<String> {
    let has = |new: &str| {
        body.unit_names(pose)
            .is_some_and(|(_, known)| known.contains(new))
    };
    let lost = LOST
        .iter()
        .find(|(old, new)| *old == unit && has(new))
        .filter(|_| pose.is_expression);
    if let Some((_, new)) = lost {
        return Some(format!(
            "write `{new}`, with a negative value for the other direction"
        ));
    }
    let own = if pose.is_expression {
        "expressions"
    } else {
        "poses"
    };
    let mut others = body.pose_units.iter().filter(|units| units.category != own);
    let other = others.find(|units| {
        units.units.is_some() && units.names().is_some_and(|(_, names)| names.contains(unit))
    })?;
    Some(format!(
        "move the file to `{}/{}`: the unit is one of {}",
        other.category, body.name, other.category
    ))
}
