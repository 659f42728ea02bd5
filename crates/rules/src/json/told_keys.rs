//! Unknown keys that another finding names already.

use std::collections::BTreeSet;

use super::super::cause::schema::stands_for;
use mhlint_diag::pointer;
use mhlint_discover::Kind;
use mhlint_formats::Content;
use mhlint_formats::macro_json::Component;
use mhlint_formats::mhskel::{Bone, RotationPlane, Section};
use mhlint_json::UnknownKey;
use mhlint_repo::{FileFacts, View};
use mhlint_source::parent;

/// What other findings of a file name.
pub(super) struct Told<'f> {
    file: &'f FileFacts,
    /// Pointers of entries of `modelling.json`, and the keys of theirs.
    sliders: BTreeSet<(String, &'f str)>,
    lacking: BTreeSet<(&'f str, &'f str)>,
    are_bones: bool,
    kindless: BTreeSet<String>,
    lost: BTreeSet<&'f str>,
}

impl<'f> Told<'f> {
    pub(super) fn of(view: &View<'_>, file: &'f FileFacts) -> Self {
        let (sliders, lacking, kindless) =
            (told_sliders(view, file), lacking(file), kindless(file));
        Self {
            file,
            sliders,
            lacking,
            are_bones: has_bones_at_top(file),
            kindless,
            lost: lost_components(file),
        }
    }

    /// Whether one of them names this key.
    pub(super) fn has(&self, unknown: &UnknownKey) -> bool {
        let is_lost =
            self.lost.contains(unknown.key.as_str()) && nested(self.file, unknown).is_some();
        self.are_bones || is_lost || lacks(&self.lacking, unknown) || is_told(self, unknown)
    }
}

/// The misspelt keys for which entries of `modelling.json` are said to have no effect.
fn told_sliders<'f>(view: &View<'_>, file: &'f FileFacts) -> BTreeSet<(String, &'f str)> {
    // Generated entries are not checked for their effect.
    match &*file.content {
        Content::Modelling(model) if !view.is_generated(&file.rel) => {
            let sliders = model.sliders.iter();
            sliders
                .filter_map(|slider| Some((pointer(&[&slider.key]), slider.misspelt_effect()?.0)))
                .collect()
        }
        _ => BTreeSet::new(),
    }
}

/// Pointers of the components with neither `steps` nor `sum`.
fn kindless(file: &FileFacts) -> BTreeSet<String> {
    let Content::Macro(macros) = &*file.content else {
        return BTreeSet::new();
    };
    let kindless = |component: &&Component| component.steps.is_none() && component.sum.is_none();
    macros
        .components
        .iter()
        .filter(kindless)
        .map(|component| pointer(&["components", &component.name]))
        .collect()
}

/// Whether the bones of a weights file stand where `weights` is missing, which is said.
fn has_bones_at_top(file: &FileFacts) -> bool {
    file.weights().is_some_and(|weights| !weights.has_weights)
        && file.schema.faults.iter().any(|f| f.lacks("", "weights"))
}

/// Pointers of objects and the keys that the schema wants in them.
fn lacking(file: &FileFacts) -> BTreeSet<(&str, &str)> {
    file.schema
        .faults
        .iter()
        .filter_map(|fault| Some((fault.pointer.as_str(), fault.missing()?)))
        .collect()
}

/// Whether the finding on the key that the schema misses names this one.
fn lacks(lacking: &BTreeSet<(&str, &str)>, unknown: &UnknownKey) -> bool {
    let owner = parent(&unknown.pointer);
    lacking
        .range((owner, "")..)
        .take_while(|(other, _)| *other == owner)
        .any(|(_, key)| stands_for(unknown, key))
}

/// Whether the finding of another rule on the key that is missing instead names this one.
fn is_told(
    Told {
        file,
        sliders,
        kindless,
        ..
    }: &Told<'_>,
    unknown: &UnknownKey,
) -> bool {
    let Some(nearest) = unknown.nearest.as_deref() else {
        return false;
    };
    let (owner, _) = unknown.pointer.rsplit_once('/').unwrap_or_default();
    match &*file.content {
        Content::Skeleton(skeleton) if owner.is_empty() => match nearest {
            "bones" => skeleton.bones_section == Section::Absent,
            "joints" => skeleton.joints_section == Section::Absent,
            "planes" => {
                let names_one =
                    |bone: &Bone| matches!(bone.rotation_plane, RotationPlane::Named(_));
                skeleton.planes.is_empty() && skeleton.bones.iter().any(names_one)
            }
            _ => false,
        },
        Content::BaseJson(settings) if owner.is_empty() => {
            nearest == "visible groups" && !settings.has_visible_groups
        }
        Content::Pose(pose) if owner.is_empty() => nearest == "unit_poses" && !pose.has_units,
        Content::Macro(_) if matches!(nearest, "steps" | "sum") => kindless.contains(owner),
        Content::Modelling(_) => sliders.contains(&(owner.to_owned(), &unknown.key)),
        _ => false,
    }
}

/// Components that some `comp` names and that are not defined where they should be:
/// `macro-unknown-component` says where one of them lies inside another one.
fn lost_components(file: &FileFacts) -> BTreeSet<&str> {
    let Content::Macro(macros) = &*file.content else {
        return BTreeSet::new();
    };
    let defined: BTreeSet<&str> = macros
        .components
        .iter()
        .map(|component| component.name.as_str())
        .collect();
    let named = macros
        .macrodefs
        .iter()
        .flat_map(|macrodef| &macrodef.components)
        .map(String::as_str);
    named.filter(|name| !defined.contains(name)).collect()
}

/// What an object with an unknown key for a name is, where it may have slipped inside its
/// neighbour.
pub(super) fn nested(file: &FileFacts, unknown: &UnknownKey) -> Option<&'static str> {
    match (file.kind, unknown.object.as_deref()) {
        _ if unknown.nearest.is_some() || !unknown.is_object => None,
        (Kind::ModellingJson, Some("Slider")) => Some("slider"),
        (Kind::MacroJson, Some("Component")) => Some("component"),
        _ => None,
    }
}
