//! Keys that `base.json` needs for what the base mesh has.

use super::super::Rule;
use super::super::cause::consequence::NO_POSE_SKELETON;
use super::super::cause::schema::is_faulty;
use mhlint_diag::{Finding, Level, Place};
use mhlint_repo::makehuman2::{Base, View};

/// Keys of `base.json` without which a part of the base is silently not used. A base without
/// sliders needs no start model, and one without skeletons no skeleton.
pub(super) fn findings(rule: &Rule, view: &View<'_>, base: &Base<'_>) -> Vec<Finding> {
    let Some((file, settings)) = base
        .settings()
        .filter(|(file, _)| view.layers.is_checked(file))
    else {
        return Vec::new();
    };
    let finding = |key: &str, message: String, effect: &'static str, near: &str| {
        let finding = rule
            .at(file, Place::File, message)
            .key(format!("no {key}"))
            .level(Level::Warning);
        finding
            .effect(effect)
            .help(format!("add `\"{key}\": \"{near}\"`"))
    };
    let mut found = Vec::new();
    if settings.mhm.is_none() && !base.sliders.is_empty() && !is_faulty(file, "mhm") {
        let message = format!("`mhm` is missing: base `{}` has no start model", base.name);
        let effect = "loads the base with the default material and silently applies no targets";
        found.push(finding("mhm", message, effect, "base.mhm"));
    }
    if let (None, [rig, ..], false) = (
        &settings.pose_skeleton,
        &*base.rigs,
        is_faulty(file, "pose-skeleton"),
    ) {
        let message = format!(
            "`pose-skeleton` is missing, but base `{}` has skeletons",
            base.name
        );
        let own = base
            .rigs
            .iter()
            .find(|rig| rig.file.stem() == "default")
            .unwrap_or(rig);
        found.push(
            finding(
                "pose-skeleton",
                message,
                NO_POSE_SKELETON,
                own.file.file_name(),
            )
            .level(Level::Error),
        );
    }
    found
}
