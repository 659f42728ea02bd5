//! A base needs its `base.json`, its mesh, and what `base.json` names.

use super::super::{Check, Rule, RuleCx};
use super::absent_keys;
use crate::diag::{Application, Finding, Level, RuleInfo, Sight, nearest};
use crate::repo::{Base, FileFacts, Layer, Reference, ReferenceKind, Repository, Resolution};

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        sight: Some(Sight::Base),
        breaks: &[(Application::Makehuman2, "stops with a traceback when the base is loaded")],
        docs: "A base mesh consists of `base/<base>/base.json` and `base.obj` (or `base.mhbin`) beside it; `base.json` names a start model (`mhm`) in \
            the same folder and a skeleton (`pose-skeleton`) in `rigs/<base>/`.\n\nWithout `base.json`, without the mesh, or with a start model \
            that does not exist, loading the base ends in an exception. A skeleton that does not exist means no pose mode and no bone \
            weights for assets, without a message (a warning). Targets for a base that exists nowhere are never loaded (a warning). A base with targets and without modelling.json has no sliders, and macro sliders without macro.json move nothing (warnings). \
            Without the key `mhm` no target is applied to the base, and without `pose-skeleton` the skeletons in `rigs/<base>/` are not used for poses: both \
            load without a message (warnings).\n\n\
            Add the file, correct its name, or remove the key.",
        ..RuleInfo::new("base-missing-file", Level::Error, "a file that a base mesh needs does not exist")
    },
    check: Check::Base(run),
};

fn run(repository: &Repository<'_>, base: &Base<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for reference in repository.references_of(base) {
        if matches!(reference.resolution, Resolution::Missing) {
            out.extend(named(repository, base, reference));
        }
    }
    out.extend(absent_keys::findings(&RULE, repository, base));
    // Only system data can prove that a file exists nowhere.
    if repository.system.is_some() {
        out.extend(unnamed(repository, base));
        out.extend(of_sliders(repository, base));
    }
}

/// A file that `base.json` names.
fn named(repository: &Repository<'_>, base: &Base<'_>, reference: &Reference<'_>) -> Option<Finding> {
    let (what, folder) = match reference.kind {
        ReferenceKind::PoseSkeleton => ("skeleton", "rigs"),
        ReferenceKind::Model => ("start model", "base"),
        _ => return None,
    };
    let message = format!("the {what} `{}` does not exist", reference.rel);
    let finding = RULE.at(reference.from, reference.place.clone(), message).key(reference.owner);
    let extension = if what == "skeleton" { ".mhskel" } else { ".mhm" };
    let folder = format!("{folder}/{}", base.name);
    let layers: Vec<&Layer> = repository.strongest_first().collect();
    let files = layers.iter().flat_map(|layer| layer.below(&folder));
    let names: Vec<&str> = files.map(FileFacts::file_name).filter(|name| name.ends_with(extension)).collect();
    let help = match nearest(reference.text, names.iter().copied()).or_else(|| names.first().copied()) {
        Some(near) => format!("did you mean `{near}`?"),
        None => format!("add the file to `{folder}`, or remove the key"),
    };
    let finding = finding.help(help);
    Some(match reference.kind {
        ReferenceKind::PoseSkeleton => finding
            .level(Level::Warning)
            .breaks(Application::Makehuman2, "has no pose mode and no bone weights for assets, without a message"),
        _ => finding.breaks(Application::Makehuman2, "stops with a TypeError when the base is loaded"),
    })
}

/// `base.json` and the mesh, of a base that the judged layer holds a part of.
fn unnamed(repository: &Repository<'_>, base: &Base<'_>) -> Option<Finding> {
    let judged = repository.judged;
    let folder = format!("base/{}", base.name);
    // What is there but cannot be opened, or is written with other capitals, has a finding of its own.
    let exists = |file: &str| {
        let rel = format!("{folder}/{file}");
        let is_here = |layer: &Layer| layer.file_ignoring_case(&rel).is_some() || layer.has_unusable(&rel);
        repository.strongest_first().any(is_here)
    };
    let (settings, mesh) = (exists("base.json"), exists("base.obj") || exists("base.mhbin"));
    let has_base = judged.below(&folder).next().is_some();
    match (settings, mesh) {
        (true, false) if has_base => {
            let message = format!("the base `{}` has no mesh: neither base.obj nor base.mhbin", base.name);
            let finding = RULE.in_layer(judged, &format!("{folder}/base.json"), message).key("mesh");
            Some(finding.help(format!("add `{folder}/base.obj`")))
        }
        (false, true) if has_base => {
            let message = format!("the base `{}` has no base.json", base.name);
            let finding = RULE.in_layer(judged, &format!("{folder}/base.json"), message).key("base.json");
            Some(finding.help(format!("add `{folder}/base.json`")))
        }
        // One root with `contarget/` may be a user's folder whose system data was not given.
        (false, false) if !repository.is_one_root() => orphan(judged, base),
        _ => None,
    }
}

/// `modelling.json` or `macro.json` of a system's base, whose targets and sliders need it. Overrides have rules of
/// their own.
fn of_sliders(repository: &Repository<'_>, base: &Base<'_>) -> Option<Finding> {
    let judged = repository.judged;
    let is_system = repository.system.is_some_and(|system| std::ptr::eq(system, judged)) && base.has_system;
    let folder = format!("target/{}", base.name);
    if !is_system || base.base_json.is_none() || judged.below(&format!("contarget/{}", base.name)).next().is_some() {
        return None;
    }
    let missing = |name: &str| {
        let rel = format!("{folder}/{name}");
        judged.file_ignoring_case(&rel).is_none() && !judged.has_unusable(&rel)
    };
    let targets = || judged.below(&folder).filter(|file| file.target().is_some());
    let finding = |name: &str, message: String, effect: &'static str| {
        let finding = RULE.in_layer(judged, &format!("{folder}/{name}"), message).key(name).level(Level::Warning);
        finding.breaks(Application::Makehuman2, effect).help(format!("add `{folder}/{name}`"))
    };
    if missing("modelling.json") {
        let count = targets().count();
        let message = format!("the base `{}` has {count} targets and no modelling.json", base.name);
        return (count > 0).then(|| finding("modelling.json", message, "offers no sliders for the base"));
    }
    let sliders = base.sliders.iter().filter(|bound| bound.slider.is_macro()).count();
    let waiting = targets().any(|file| file.rel.starts_with(&format!("{folder}/macro")));
    let message = match sliders {
        0 => format!("the base `{}` has targets of macros and no macro.json", base.name),
        count => format!("the base `{}` has {count} macro sliders and no macro.json", base.name),
    };
    let effect = "has no macros for the base: their sliders move nothing, without a word";
    (missing("macro.json") && (sliders > 0 || waiting)).then(|| finding("macro.json", message, effect))
}

/// Targets of a base that no layer has.
fn orphan(judged: &Layer, base: &Base<'_>) -> Option<Finding> {
    let folders = ["contarget", "target"].map(|folder| format!("{folder}/{}", base.name));
    let folder = folders.iter().find(|folder| judged.below(folder).next().is_some())?;
    let message = format!("there is no base `{}`: neither base.json nor a mesh", base.name);
    Some(
        RULE.in_layer(judged, folder, message)
            .key("base")
            .level(Level::Warning)
            .breaks(Application::Makehuman2, "never loads these targets")
            .help("the folder must have the name of a base; give the system data with `--system` if the base is there"),
    )
}
