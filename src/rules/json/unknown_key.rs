//! Keys that no application reads.

use std::collections::{BTreeMap, BTreeSet};

use super::super::cause::consequence::of_misspelt;
use super::super::cause::is_ignored_override;
use super::super::cause::schema::stands_for;
use super::super::{Check, Rule, RuleCx, did_you_mean};
use super::left_out;
use crate::diag::{Application, Case, EXAMPLES, Evidence, Finding, Level, Place, RuleInfo, pointer};
use crate::discover::Kind;
use crate::formats::Content;
use crate::formats::macro_json::Component;
use crate::formats::mhskel::{Bone, RotationPlane, Section};
use crate::json::UnknownKey;
use crate::repo::{FileFacts, View};

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        breaks: &[(Application::Makehuman2, "ignores the key without a word")],
        docs: "Every loader takes the keys it knows and leaves the others, so a misspelt key is as good as none: the slider \
            has no partner, the bone no parent. In the files of the sliders and of the base a key that is nearly a known one \
            is a warning, and so is a misspelt `rotation_plane` of a bone, which then rolls otherwise. Where the known key is one that must be there, the finding on the missing key names the misspelt \
            one, and nothing is said here.\n\nThe usual trap is `sym`: sliders have `rsym` on the left side (it names \
            the right partner) and `lsym` on the right side.\n\nCorrect the key, or remove it. Notes are welcome under \
            `comment` or `description`.",
        ..RuleInfo::new("json-unknown-key", Level::Info, "a key that no application reads")
    },
    check: Check::File(run),
};

/// Something slipped inside another thing of its kind.
const NESTED: Case = &[(Application::Makehuman2, Level::Warning, "ignores all that is in it, without a word")];

/// Whoever has no plane takes the vertical, which changes the rest pose (formats/makehuman2.md §10.1).
const NO_PLANE: Case = &[(
    Application::Makehuman2,
    Level::Warning,
    "ignores the key: the bones have no plane and roll as if the vertical were its normal",
)];

fn run(view: &View<'_>, file: &FileFacts, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    if file.schema.unknown.is_empty() || is_ignored_override(file) {
        return;
    }
    let mut by_key: BTreeMap<(&str, Option<&str>), Vec<&UnknownKey>> = BTreeMap::new();
    let sliders = told_sliders(view, file);
    let lacking = lacking(file);
    let are_bones = has_bones_at_top(file);
    let kindless = kindless(file);
    let lost = lost_components(file);
    let is_lost = |unknown: &UnknownKey| lost.contains(unknown.key.as_str()) && nested(file, unknown).is_some();
    let told = |unknown: &&UnknownKey| {
        are_bones || is_lost(unknown) || lacks(&lacking, unknown) || is_told(file, &sliders, &kindless, unknown)
    };
    for unknown in file.schema.unknown.iter().filter(|unknown| !told(unknown)) {
        by_key.entry((&unknown.key, unknown.object.as_deref())).or_default().push(unknown);
    }
    out.extend(by_key.into_values().filter_map(|all| finding(view, file, &all)));
    out.extend(left_out(&RULE, file, file.schema.unknown_left_out, "keys that no application reads"));
}

/// Pointers of entries, and the keys of theirs that another rule names.
type Told<'f> = BTreeSet<(String, &'f str)>;

/// The misspelt keys for which entries of `modelling.json` are said to have no effect.
fn told_sliders<'f>(view: &View<'_>, file: &'f FileFacts) -> Told<'f> {
    // Generated entries are not checked for their effect.
    match &*file.content {
        Content::Modelling(model) if !view.is_generated(&file.rel) => {
            let sliders = model.sliders.iter();
            sliders.filter_map(|slider| Some((pointer(&[&slider.key]), slider.misspelt_effect()?.0))).collect()
        }
        _ => BTreeSet::new(),
    }
}

/// Pointers of the components with neither `steps` nor `sum`.
fn kindless(file: &FileFacts) -> BTreeSet<String> {
    let Content::Macro(macros) = &*file.content else { return BTreeSet::new() };
    let kindless = |component: &&Component| component.steps.is_none() && component.sum.is_none();
    macros.components.iter().filter(kindless).map(|component| pointer(&["components", &component.name])).collect()
}

/// Whether the bones of a weights file stand where `weights` is missing, which is said.
fn has_bones_at_top(file: &FileFacts) -> bool {
    file.weights().is_some_and(|weights| !weights.has_weights)
        && file.schema.faults.iter().any(|f| f.lacks("", "weights"))
}

/// Pointers of objects and the keys that the schema wants in them.
fn lacking(file: &FileFacts) -> BTreeSet<(&str, &str)> {
    file.schema.faults.iter().filter_map(|fault| Some((fault.pointer.as_str(), fault.missing()?))).collect()
}

/// What an object with an unknown key for a name is, where it may have slipped inside its neighbour.
fn nested(file: &FileFacts, unknown: &UnknownKey) -> Option<&'static str> {
    match (file.kind, unknown.object.as_deref()) {
        _ if unknown.nearest.is_some() || !unknown.is_object => None,
        (Kind::ModellingJson, Some("Slider")) => Some("slider"),
        (Kind::MacroJson, Some("Component")) => Some("component"),
        _ => None,
    }
}

/// Whether the finding on the key that the schema misses names this one.
fn lacks(lacking: &BTreeSet<(&str, &str)>, unknown: &UnknownKey) -> bool {
    let owner = unknown.pointer.rsplit_once('/').map_or("", |(owner, _)| owner);
    lacking.range((owner, "")..).take_while(|(other, _)| *other == owner).any(|(_, key)| stands_for(unknown, key))
}

/// Whether the finding of another rule on the key that is missing instead names this one.
fn is_told(file: &FileFacts, sliders: &Told<'_>, kindless: &BTreeSet<String>, unknown: &UnknownKey) -> bool {
    let Some(nearest) = unknown.nearest.as_deref() else { return false };
    let (owner, _) = unknown.pointer.rsplit_once('/').unwrap_or_default();
    match &*file.content {
        Content::Skeleton(skeleton) if owner.is_empty() => match nearest {
            "bones" => skeleton.bones_section == Section::Absent,
            "joints" => skeleton.joints_section == Section::Absent,
            "planes" => {
                let names_one = |bone: &Bone| matches!(bone.rotation_plane, RotationPlane::Named(_));
                skeleton.planes.is_empty() && skeleton.bones.iter().any(names_one)
            }
            _ => false,
        },
        Content::BaseJson(settings) if owner.is_empty() => nearest == "visible groups" && !settings.has_visible_groups,
        Content::Macro(_) if matches!(nearest, "steps" | "sum") => kindless.contains(owner),
        Content::Modelling(_) => sliders.contains(&(owner.to_owned(), &unknown.key)),
        _ => false,
    }
}

/// Components that some `comp` names and that are not defined where they should be: `macro-unknown-component` says where
/// one of them lies inside another one.
fn lost_components(file: &FileFacts) -> BTreeSet<&str> {
    let Content::Macro(macros) = &*file.content else { return BTreeSet::new() };
    let defined: BTreeSet<&str> = macros.components.iter().map(|component| component.name.as_str()).collect();
    let named = macros.macrodefs.iter().flat_map(|macrodef| &macrodef.components).map(String::as_str);
    named.filter(|name| !defined.contains(name)).collect()
}

/// One finding for a key, however many objects have it.
fn finding(view: &View<'_>, file: &FileFacts, all: &[&UnknownKey]) -> Option<Finding> {
    let first = all.first()?;
    let owner = first.object.as_deref().map(|object| format!(" of a {}", object.to_lowercase())).unwrap_or_default();
    let times = if all.len() == 1 { String::new() } else { format!(" ({} times)", all.len()) };
    let message = format!("no application reads the key `{}`{owner}{times}", first.key);
    let mut finding = RULE
        .at(file, Place::Key(first.pointer.clone()), message)
        .key(format!("{}{owner}", first.key))
        .help(did_you_mean(first.nearest.as_deref(), "remove it, or keep notes under `comment`"))
        .parts(all.iter().map(|unknown| &unknown.name))
        .evidence(Evidence::of_cases(all.iter().map(|unknown| &unknown.pointer)));
    if file.kind == Kind::Skeleton && first.nearest.as_deref() == Some("rotation_plane") {
        finding = finding.case(NO_PLANE);
    } else if let Some(loss) = of_misspelt(view, file, first) {
        finding = loss.of(view, finding);
    } else if let Some(noun) = nested(file, first) {
        finding = finding.case(NESTED).help(format!("a {noun} inside another one? Move it one level up"));
    }
    for other in all.iter().skip(1).take(EXAMPLES - 1) {
        finding = finding.related(file.path.clone(), Place::Key(other.pointer.clone()), "here, too");
    }
    Some(finding)
}
