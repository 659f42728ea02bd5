//! A base needs its `base.json`, its mesh, and what `base.json` names.

use super::super::cause::consequence::NO_POSE_SKELETON;
use super::super::{Check, Rule, RuleCx, did_you_mean};
use super::absent_keys;
use super::sliders::{self, Gap};
use crate::diag::{Application, Finding, Level, RuleInfo, nearest};
use crate::repo::makehuman2::{Base, View};
use crate::repo::{FileFacts, Layer, Reference, ReferenceKind, Resolution};

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        breaks: &[(Application::Makehuman2, "stops with a traceback when the base is loaded")],
        docs: "A base mesh consists of `base/<base>/base.json` and `base.obj` (or `base.mhbin`) beside it; `base.json` names a start model (`mhm`) in \
            the same folder and a skeleton (`pose-skeleton`) in `rigs/<base>/`.\n\nWithout `base.json`, without the mesh, or with a start model \
            that does not exist, loading the base ends in an exception. A skeleton that does not exist means a message at every visit to \
            poses and rigs, no bone weights for assets, and an AttributeError in the editors and the glTF export. Targets for a base that exists nowhere are never loaded (a warning).\n\n\
            The sliders of a base come from `modelling.json` in `target/<base>/`, their macros from `macro.json` beside it. Without the first \
            all targets are lost, without the second those of the macros: errors, as when the file cannot be read, since MakeHuman 2 does \
            the same in both cases and says nothing but a line in its log. A base whose macros no slider needs may do without macro.json. It is a \
            warning where the folder could be a user's, whose system has the file, and an info where `base.json` pairs targets that there are none of.\n\n\
            Without the key `mhm` no target is applied to the base, which loads without a message (a warning). Without `pose-skeleton` the \
            skeletons in `rigs/<base>/` are not used for poses, as if the one it names did not exist (an error).\n\n\
            Add the file, correct its name, or remove the key.",
        ..RuleInfo::new("base-missing-file", Level::Error, "a file that a base mesh needs does not exist")
    },
    check: Check::Makehuman2(run),
};

fn run(view: &View<'_>, base: &Base<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for reference in view.references_of(base) {
        if matches!(reference.resolution, Resolution::Missing) {
            out.extend(named(view, base, reference));
        }
    }
    out.extend(absent_keys::findings(&RULE, view, base));
    // Only system data can prove that a file exists nowhere.
    if view.layers.system.is_some() {
        out.extend(unnamed(view, base));
        out.extend(of_sliders(view, base));
    }
}

/// A file that `base.json` names.
fn named(view: &View<'_>, base: &Base<'_>, reference: &Reference<'_>) -> Option<Finding> {
    let (what, folder) = match reference.kind {
        ReferenceKind::PoseSkeleton => ("skeleton", "rigs"),
        ReferenceKind::Model => ("start model", "base"),
        _ => return None,
    };
    let message = format!("the {what} `{}` does not exist", reference.rel);
    let finding = RULE.at(reference.from, reference.place.clone(), message).key(reference.owner);
    let extension = if what == "skeleton" { ".mhskel" } else { ".mhm" };
    let folder = format!("{folder}/{}", base.name);
    let layers: Vec<&Layer> = view.layers.strongest_first().collect();
    let files = layers.iter().flat_map(|layer| layer.below(&folder));
    let names: Vec<&str> = files.map(FileFacts::file_name).filter(|name| name.ends_with(extension)).collect();
    let help = did_you_mean(
        nearest(reference.text, names.iter().copied()).or_else(|| names.first().copied()),
        // Without the key there are no poses either.
        match reference.kind {
            ReferenceKind::PoseSkeleton => format!("add the file to `{folder}`, or name one that is there"),
            _ => format!("add the file to `{folder}`, or remove the key"),
        },
    );
    let finding = finding.help(help);
    Some(match reference.kind {
        ReferenceKind::PoseSkeleton => finding.effect(NO_POSE_SKELETON),
        _ => finding.effect("stops with a TypeError when the base is loaded"),
    })
}

/// `base.json` and the mesh, of a base that the checked layer holds a part of.
fn unnamed(view: &View<'_>, base: &Base<'_>) -> Option<Finding> {
    let checked = view.layers.checked;
    let folder = format!("base/{}", base.name);
    // What is there but cannot be opened, or is written with other capitals, has a finding of its own.
    let exists = |file: &str| {
        let rel = format!("{folder}/{file}");
        let is_here = |layer: &Layer| layer.file_ignoring_case(&rel).is_some() || layer.has_unusable(&rel);
        view.layers.strongest_first().any(is_here)
    };
    let (settings, mesh) = (exists("base.json"), exists("base.obj") || exists("base.mhbin"));
    let has_base = checked.below(&folder).next().is_some();
    match (settings, mesh) {
        (true, false) if has_base => {
            let message = format!("the base `{}` has no mesh: neither base.obj nor base.mhbin", base.name);
            let finding = RULE.in_layer(checked, &format!("{folder}/base.json"), message).key("mesh");
            let effect = "stops with an AttributeError when the base is loaded";
            Some(finding.effect(effect).help(format!("add `{folder}/base.obj`")))
        }
        (false, true) if has_base && base.has_system => {
            let message = format!("the base `{}` has no base.json", base.name);
            let finding = RULE.in_layer(checked, &format!("{folder}/base.json"), message).key("base.json");
            let effect = "stops with a TypeError when the base is loaded";
            Some(finding.effect(effect).help(format!("add `{folder}/base.json`")))
        }
        // One root with `contarget/` may be a user's folder whose system data was not given.
        (false, false) if !view.layers.is_one_root() => orphan(checked, base),
        _ => None,
    }
}

/// What the sliders of a system's base need.
fn of_sliders(view: &View<'_>, base: &Base<'_>) -> Option<Finding> {
    let Gap { name, level, message, effect, help } = sliders::gap(view, base)?;
    let rel = format!("target/{}/{name}", base.name);
    let finding = RULE.in_layer(view.layers.checked, &rel, message).key(name).level(level);
    Some(finding.effect(effect).help(help))
}

/// Targets of a base that no layer has.
fn orphan(checked: &Layer, base: &Base<'_>) -> Option<Finding> {
    let folders = ["contarget", "target"].map(|folder| format!("{folder}/{}", base.name));
    // A loose file lies in no folder of a base: that its base is not known is among what was not checked.
    let is_in = |folder: &&String| checked.below(folder).any(|file| !file.is_loose());
    let folder = folders.iter().find(is_in)?;
    let message = format!("there is no base `{}`: neither base.json nor a mesh", base.name);
    Some(
        RULE.in_layer(checked, folder, message)
            .key("base")
            .level(Level::Warning)
            .effect("never loads these targets")
            .help("the folder must have the name of a base; give the system data with `--system` if the base is there"),
    )
}
