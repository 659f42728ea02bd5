//! A base needs its `base.json`, its mesh, and what `base.json` names.

use super::super::cause::consequence::NO_POSE_SKELETON;
use super::super::cause::unfiled::renamed_rigs;
use super::super::{Check, Rule, RuleCx, did_you_mean};
use super::sliders::{self, Gap};
use super::{absent_keys, orphan};
use mhlint_diag::{Application::Makehuman2, Finding, Level, RuleInfo, nearest};
use mhlint_repo::makehuman2::{Base, View};
use mhlint_repo::{FileFacts, Layer, Reference, ReferenceKind, Resolution};

pub(crate) static RULE: Rule = Check::Makehuman2(run).rule(RuleInfo {
    breaks: &[(Makehuman2, "crashes when it loads the base")],
    docs: include_str!("missing_file.md").trim_ascii_end(),
    ..RuleInfo::new(
        "base-missing-file",
        Level::Error,
        "a file that a base mesh needs does not exist",
    )
});

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
    let message = format!("{what} `{}` does not exist", reference.rel);
    let finding = RULE
        .at(reference.from, reference.place.clone(), message)
        .key(reference.owner);
    let extension = if what == "skeleton" {
        ".mhskel"
    } else {
        ".mhm"
    };
    let folder = format!("{folder}/{}", base.name);
    let layers: Vec<&Layer> = view.layers.strongest_first().collect();
    let files = layers.iter().flat_map(|layer| layer.below(&folder));
    let names: Vec<&str> = files
        .map(FileFacts::file_name)
        .filter(|name| name.ends_with(extension))
        .collect();
    let renamed = layers
        .iter()
        .find_map(|layer| renamed_rigs(layer, reference));
    let help = renamed.map(|folder| format!("rename the folder `{folder}` to `rigs`"));
    let near = did_you_mean(
        nearest(reference.text, names.iter().copied()).or_else(|| names.first().copied()),
        // Without the key there are no poses either.
        match reference.kind {
            ReferenceKind::PoseSkeleton => {
                format!("add the file to `{folder}`, or name a skeleton that exists")
            }
            _ => format!("add the file to `{folder}`, or name a start model that exists"),
        },
    );
    let finding = finding.help(help.unwrap_or(near));
    Some(match reference.kind {
        ReferenceKind::PoseSkeleton => finding.effect(NO_POSE_SKELETON),
        _ => finding.effect("crashes with `TypeError` when it loads the base"),
    })
}

/// `base.json` and the mesh, of a base that the checked layer holds a part of.
fn unnamed(view: &View<'_>, base: &Base<'_>) -> Option<Finding> {
    let checked = view.layers.checked;
    let folder = format!("base/{}", base.name);
    let exists = |file: &str| view.has_base_file(base.name, file);
    let (settings, mesh) = (
        exists("base.json"),
        exists("base.obj") || exists("base.mhbin"),
    );
    let has_base = checked.below(&folder).next().is_some();
    match (settings, mesh) {
        (true, false) if has_base => {
            let message = format!("base `{}` has neither base.obj nor base.mhbin", base.name);
            let finding = RULE
                .in_layer(checked, &format!("{folder}/base.json"), message)
                .key("mesh");
            let effect = "crashes with `AttributeError` when it loads the base";
            Some(
                finding
                    .effect(effect)
                    .help(format!("add `{folder}/base.obj`")),
            )
        }
        (false, true) if has_base && base.has_system => {
            let message = format!("base `{}` has no base.json", base.name);
            let finding = RULE
                .in_layer(checked, &format!("{folder}/base.json"), message)
                .key("base.json");
            let effect = "crashes with `TypeError` when it loads the base";
            Some(
                finding
                    .effect(effect)
                    .help(format!("add `{folder}/base.json`")),
            )
        }
        (false, false) if view.is_nowhere(base.name) => orphan::finding(&RULE, view, base),
        _ => None,
    }
}

/// What the sliders of a system's base need.
fn of_sliders(view: &View<'_>, base: &Base<'_>) -> Option<Finding> {
    let Gap {
        name,
        level,
        message,
        effect,
        help,
    } = sliders::gap(view, base)?;
    let rel = format!("target/{}/{name}", base.name);
    let finding = RULE
        .in_layer(view.layers.checked, &rel, message)
        .key(name)
        .level(level);
    Some(finding.effect(effect).help(help))
}
