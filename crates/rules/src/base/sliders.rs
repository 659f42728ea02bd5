//! What a system's base lacks so that its targets are of no use: `modelling.json`, `macro.json`, or
//! all of its target folder (`docs/loaders/makehuman2/folders.md#overlays`). Overrides have rules
//! of their own.

use std::collections::BTreeSet;

use super::super::cause::unfiled::TARGETS_OF_OTHERS;
use super::super::counted;
use super::NO_MEASURE;
use mhlint_diag::Level;
use mhlint_discover::Kind;
use mhlint_formats::base_json::BaseJson;
use mhlint_repo::makehuman2::{Base, View};
use mhlint_repo::{FileFacts, Layer};

/// A file that is not there and what comes of it.
pub(super) struct Gap {
    /// Its name in `target/<base>/`.
    pub(super) name: &'static str,
    pub(super) level: Level,
    pub(super) message: String,
    pub(super) effect: &'static str,
    pub(super) help: String,
}

/// Stands in the program's own data and nowhere else
/// (`docs/loaders/makehuman2/program.md#version-and-settings`).
const VERSION_FILE: &str = "makehuman2_version.json";

/// What is missing of the sliders of a base, if its data are the system's and nothing overrides
/// them.
pub(super) fn gap(view: &View<'_>, base: &Base<'_>) -> Option<Gap> {
    let checked = view.layers.checked;
    let is_system = view.layers.checks_system() && base.has_system;
    if !is_system
        || base.own_json.is_none()
        || checked
            .below(&format!("contarget/{}", base.name))
            .next()
            .is_some()
    {
        return None;
    }
    let folder = format!("target/{}", base.name);
    let is_missing = |name: &str| {
        let rel = format!("{folder}/{name}");
        checked.file_ignoring_case(&rel).is_none() && !checked.has_unusable(&rel)
    };
    // The folder of all targets has the name that other programs have for it
    // (`library-wrong-folder`).
    if !checked.has_folder("target")
        && checked
            .file(&format!("{TARGETS_OF_OTHERS}/{}/modelling.json", base.name))
            .is_some()
    {
        return None;
    }
    if is_missing("modelling.json") {
        without_sliders(checked, base, &folder)
    } else if is_missing("macro.json") {
        without_macros(checked, base, &folder)
    } else {
        None
    }
}

fn without_sliders(checked: &Layer, base: &Base<'_>, folder: &str) -> Option<Gap> {
    let count = targets(checked, folder).count();
    let named = base
        .settings()
        .map_or(0, |(_, settings)| named_sliders(settings).len());
    let pairs = base
        .settings()
        .map_or(0, |(_, settings)| settings.opposites.len());
    let sure = is_surely_system(checked, folder);
    let lost = if sure { Level::Error } else { Level::Warning };
    let (level, message) = match (count, named, pairs) {
        (0, 0, 0) => return None,
        (0, 0, _) => {
            let message = format!("base `{}` has `target-opposites` but no targets", base.name);
            (Level::Info, message)
        }
        (0, ..) => {
            let named = counted(named, "slider");
            let message = format!(
                "base.json of `{}` names {named}, but modelling.json is missing",
                base.name
            );
            (lost, message)
        }
        _ => (
            lost,
            format!(
                "base `{}` has {} but no modelling.json",
                base.name,
                counted(count, "target")
            ),
        ),
    };
    let file = format!("{folder}/modelling.json");
    let help = if sure {
        format!("add `{file}`")
    } else {
        format!(
            "add `{file}` with its macro.json and target_cat.json; if the system data has them, \
                pass that with `--system`"
        )
    };
    let effect =
        "shows no sliders for the base and applies none of its targets; only a log line says so";
    Some(Gap {
        name: "modelling.json",
        level,
        message,
        effect,
        help,
    })
}

fn without_macros(checked: &Layer, base: &Base<'_>, folder: &str) -> Option<Gap> {
    let sliders = base
        .sliders
        .iter()
        .filter(|bound| bound.slider.is_macro())
        .count();
    let waiting = targets(checked, folder)
        .filter(|file| file.rel.starts_with(&format!("{folder}/macro")))
        .count();
    let name = base.name;
    let (level, message) = match (sliders, waiting) {
        (0, 0) => return None,
        // Only the name of their folder says so.
        (0, _) => (
            Level::Warning,
            format!("base `{name}` has macro targets but no macro.json"),
        ),
        (count, _) => (
            Level::Error,
            format!(
                "base `{name}` has {} but no macro.json",
                counted(count, "macro slider")
            ),
        ),
    };
    let effect =
        "loads no macros: the macro sliders move nothing, and their targets are never loaded";
    Some(Gap {
        name: "macro.json",
        level,
        message,
        effect,
        help: format!("add `{folder}/macro.json`"),
    })
}

fn targets<'a>(checked: &'a Layer, folder: &str) -> impl Iterator<Item = &'a FileFacts> + use<'a> {
    checked
        .below(folder)
        .filter(|file| file.kind == Kind::Target)
}

/// Patterns and keys of sliders that the settings of a base name.
fn named_sliders(settings: &BaseJson) -> BTreeSet<&str> {
    let presets = settings.presets.iter().map(|(pattern, _)| pattern.as_str());
    let measures = settings
        .measure
        .iter()
        .map(|(_, pattern)| pattern.as_str())
        .filter(|name| *name != NO_MEASURE);
    let random = settings.random.iter();
    let keys = random.flat_map(|random| {
        let rules = random.rules.iter().map(|(key, _)| key);
        random
            .gender
            .iter()
            .chain(&random.ideal)
            .chain(rules)
            .map(String::as_str)
    });
    presets.chain(measures).chain(keys).collect()
}

/// A user's folder may hold another `base.json` for a base whose sliders the system has. It has
/// neither the file that only the program's own data have, nor what else belongs to hand-made
/// sliders.
fn is_surely_system(checked: &Layer, folder: &str) -> bool {
    let beside = ["macro.json", "target_cat.json"].map(|name| format!("{folder}/{name}"));
    checked.file(VERSION_FILE).is_some() || beside.iter().any(|rel| checked.file(rel).is_some())
}
