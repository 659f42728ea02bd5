//! An override that lacks the files it needs beside it.

use super::super::{Check, Rule, RuleCx, are, counted};
use super::targets_alone::{self, Gap, NO_FOLDER};
use super::{
    SystemFolder, has_broken_override, has_misnamed_override, in_other_layer, lacks_folder,
    overrides, system_folder,
};
use mhlint_diag::{Application::Makehuman2, Finding, Level, Place, RuleInfo};
use mhlint_repo::makehuman2::{Base, View};

pub(crate) static RULE: Rule = Check::Makehuman2(run).rule(RuleInfo {
    breaks: &[(
        Makehuman2,
        "combines the override with system files that were not made for it",
    )],
    docs: include_str!("partial_override.md").trim_ascii_end(),
    ..RuleInfo::new(
        "overlay-partial-override",
        Level::Warning,
        "an override without the other files it needs",
    )
});

fn run(view: &View<'_>, base: &Base<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    // What follows from a broken file, or shows as targets in the wrong layer, is said by those
    // rules.
    let system = system_folder(view, base);
    let [macros, sliders, categories] = overrides(base);
    let is_elsewhere = || !lacks_folder(view, base) && in_other_layer(view, base).next().is_some();
    if has_broken_override(base) || has_misnamed_override(view, base) || is_elsewhere() {
        return;
    }
    let found = match (macros.active, sliders.active, categories.active) {
        (true, false, _) => macros.file.zip(without_sliders(base, system)),
        (false, true, _) => sliders.file.zip(without_macros(base, system)),
        (false, false, true) => categories
            .file
            .map(|file| (file, categories_alone(base, system))),
        (false, false, false) => targets_alone::gap(base, system),
        (true, true, _) => None,
    };
    if let Some((file, (level, message, effect, help))) = found {
        let finding = RULE
            .at(file, Place::File, message)
            .key(base.name)
            .level(level);
        out.push(finding.effect(effect).help(help));
    }
}

fn without_sliders(base: &Base<'_>, system: SystemFolder) -> Option<Gap> {
    let folder = format!("contarget/{}", base.name);
    let help = "add a modelling.json whose sliders fit the targets in contarget";
    if base.modelling.winner().is_some() {
        let message = format!(
            "modelling.json is missing: the sliders of the system data use the targets in \
                `{folder}`"
        );
        return Some((
            Level::Info,
            message,
            "uses the sliders of the system data with the targets in contarget",
            help,
        ));
    }
    if system == SystemFolder::Unknown {
        let message = format!(
            "modelling.json is missing: all targets of the sliders in the system data must be in \
                `{folder}`"
        );
        let effect =
            "looks for all targets of these sliders in contarget, and cannot load the missing ones";
        return Some((Level::Warning, message, effect, help));
    }
    let has_macros = base
        .macro_file()
        .is_some_and(|(_, file)| !file.macrodefs.is_empty());
    let message =
        "modelling.json is missing here and in the system data: no slider moves these macros"
            .to_owned();
    let (level, effect) = without_any(base);
    has_macros.then_some((level, message, effect, help))
}

fn without_macros(base: &Base<'_>, system: SystemFolder) -> Option<Gap> {
    let folder = format!("target/{}", base.name);
    let help = "add a macro.json to contarget; without macros, write `{\"components\": {}, \
        \"macrodef\": []}`";
    // With a macro.json nothing is read from the folder of the system data any more.
    let whole = "remove it, or add a macro.json with all targets and icons: none are read from \
        `target/` then";
    let own = base
        .other_targets
        .map_or(0, |contarget| contarget.targets().count());
    match system {
        SystemFolder::Absent => {
            let message =
                format!("macro.json is missing, and the system data has no folder `{folder}`");
            Some((Level::Error, message, NO_FOLDER, help))
        }
        SystemFolder::Exists if own > 0 => {
            let (own, be) = (counted(own, "target file"), are(own));
            let message = format!(
                "macro.json is missing: targets come from `{folder}`, and {own} in contarget {be} \
                    never read"
            );
            Some((
                Level::Warning,
                message,
                "loads the targets of the system data with the same names",
                whole,
            ))
        }
        SystemFolder::Exists => {
            let message = format!(
                "macro.json is missing: targets and icons come from `{folder}` of the system data"
            );
            Some((
                Level::Info,
                message,
                "uses these sliders with the targets of the system data",
                whole,
            ))
        }
        // Its references are among what was not checked.
        SystemFolder::Unknown => None,
    }
}

fn categories_alone(base: &Base<'_>, system: SystemFolder) -> Gap {
    let help = "remove it, or add all that belongs to these categories: modelling.json, \
        macro.json, targets and icons";
    let shown = "shows the sliders of the system data under these categories";
    if base.modelling.winner().is_some() {
        let message =
            "only target_cat.json is overridden: sliders and targets come from the system data"
                .to_owned();
        (Level::Info, message, shown, help)
    } else if system == SystemFolder::Unknown {
        let message =
            "only target_cat.json is overridden: it must match the sliders of the system data \
                (`--system`)"
                .to_owned();
        (Level::Info, message, shown, help)
    } else {
        let message =
            "modelling.json is missing here and in the system data: categories have no sliders"
                .to_owned();
        let (level, effect) = without_any(base);
        (level, message, effect, help)
    }
}

/// What a base without any modelling.json comes to.
fn without_any(base: &Base<'_>) -> (Level, &'static str) {
    if base.user_modelling.accepted().is_some() {
        (
            Level::Warning,
            "shows only the sliders of the user's targets",
        )
    } else {
        (
            Level::Error,
            "shows no sliders for the base, and macros have no effect",
        )
    }
}
