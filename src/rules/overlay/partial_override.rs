//! An override that lacks the files it needs beside it.

use super::super::{Check, Rule, RuleCx, counted};
use super::{
    SystemFolder, has_broken_override, has_misnamed_override, in_other_layer, lacks_folder, overrides, system_folder,
    user_sliders,
};
use crate::diag::{Application, Finding, Level, Place, RuleInfo};
use crate::repo::FileFacts;
use crate::repo::makehuman2::{Base, View};

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        breaks: &[(Application::Makehuman2, "mixes the override with files of the system that were not made for it")],
        docs: "The files of a base in `contarget/<base>/` belong together, but MakeHuman 2 chooses each JSON for itself and \
            takes the target files and icons from the folder whose macro.json won.\n\nWithout macro.json the override's \
            sliders load the system's targets, and targets beside them are never read; if the system has no such base, \
            the program stops at start, because it wants to write an archive into a folder that is not there. Such a base \
            needs a macro.json even without macros: `{\"components\": {}, \"macrodef\": []}`. Without modelling.json the \
            system's sliders look for their targets in contarget.\n\nAdd the missing files. Targets in contarget \
            without any of the three files are never read. Where all names resolve in spite of the gap nothing is wrong \
            today, so that is an info.",
        ..RuleInfo::new("overlay-partial-override", Level::Warning, "an override without the files it needs beside it")
    },
    check: Check::Makehuman2(run),
};

/// A gap: how bad, what is wrong, what MakeHuman 2 does, what to do.
type Gap = (Level, String, &'static str, &'static str);

fn run(view: &View<'_>, base: &Base<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    // What follows from a broken file, or shows as targets in the wrong layer, is said by those rules.
    let system = system_folder(view, base);
    let [macros, sliders, categories] = overrides(base);
    let is_elsewhere = || !lacks_folder(view, base) && in_other_layer(view, base).next().is_some();
    if has_broken_override(base) || has_misnamed_override(view, base) || is_elsewhere() {
        return;
    }
    let found = match (macros.active, sliders.active, categories.active) {
        (true, false, _) => macros.file.zip(without_sliders(base, system)),
        (false, true, _) => sliders.file.zip(without_macros(base, system)),
        (false, false, true) => categories.file.map(|file| (file, categories_alone(base, system))),
        (false, false, false) => user_targets_alone(base, system).or_else(|| targets_alone(base)),
        (true, true, _) => None,
    };
    if let Some((file, (level, message, effect, help))) = found {
        let finding = RULE.at(file, Place::File, message).key(base.name).level(level);
        out.push(finding.effect(effect).help(help));
    }
}

fn without_sliders(base: &Base<'_>, system: SystemFolder) -> Option<Gap> {
    let folder = format!("contarget/{}", base.name);
    let help = "add a modelling.json whose sliders fit the targets in contarget";
    if base.modelling.winner().is_some() {
        let message = format!("no modelling.json beside it: the system's sliders take their targets from `{folder}`");
        return Some((Level::Info, message, "uses the system's sliders with the targets in contarget", help));
    }
    if system == SystemFolder::Unknown {
        let message = format!("no modelling.json beside it: all targets of the system's sliders must be in `{folder}`");
        let effect =
            "searches all targets of the system's sliders in contarget and cannot load those that are not there";
        return Some((Level::Warning, message, effect, help));
    }
    let has_macros = base.macro_file().is_some_and(|(_, file)| !file.macrodefs.is_empty());
    let message = "no modelling.json beside it nor in the system data: nothing moves these macros".to_owned();
    let (level, effect) = without_any(base);
    has_macros.then_some((level, message, effect, help))
}

fn without_macros(base: &Base<'_>, system: SystemFolder) -> Option<Gap> {
    let folder = format!("target/{}", base.name);
    let help = "add a macro.json to contarget; without macros write `{\"components\": {}, \"macrodef\": []}`";
    let own = base.other_targets.map_or(0, |contarget| contarget.targets().count());
    match system {
        SystemFolder::Absent => {
            let message = format!("no macro.json beside it, and the system has no folder `{folder}`");
            let effect = "stops at start (FileNotFoundError): it wants to write an archive into the system's folder";
            Some((Level::Error, message, effect, help))
        }
        SystemFolder::Exists if own > 0 => {
            let own = counted(own, "target file");
            let message =
                format!("no macro.json beside it: targets come from `{folder}`, and {own} in contarget never");
            Some((Level::Warning, message, "loads the system's targets of the same names", help))
        }
        SystemFolder::Exists => {
            let message = format!("no macro.json beside it: targets and icons come from `{folder}` of the system");
            Some((Level::Info, message, "uses these sliders with the system's targets", help))
        }
        // Its references are among what was not checked.
        SystemFolder::Unknown => None,
    }
}

fn categories_alone(base: &Base<'_>, system: SystemFolder) -> Gap {
    let help = "add the modelling.json that these categories are for";
    let shown = "shows the system's sliders under these categories";
    if base.modelling.winner().is_some() {
        let message = "only the categories are overridden; sliders and targets are the system's".to_owned();
        (Level::Info, message, shown, help)
    } else if system == SystemFolder::Unknown {
        let message = "only the categories are overridden; they must fit the system's sliders (`--system`)".to_owned();
        (Level::Info, message, shown, help)
    } else {
        let message = "no modelling.json beside it nor in the system data: nothing to categorise".to_owned();
        let (level, effect) = without_any(base);
        (level, message, effect, help)
    }
}

/// What a base without any modelling.json comes to.
fn without_any(base: &Base<'_>) -> (Level, &'static str) {
    if base.user_modelling.accepted().is_some() {
        (Level::Warning, "offers the sliders of the user's targets only")
    } else {
        (Level::Error, "offers no sliders for the base, and no macro does anything")
    }
}

/// No override at all, but user targets for a base of user space: they lead to the same folder.
fn user_targets_alone<'a>(base: &Base<'a>, system: SystemFolder) -> Option<(&'a FileFacts, Gap)> {
    let file = base.user_modelling.file()?;
    let dead = system == SystemFolder::Absent && user_sliders(base) > 0 && base.own_json.is_some();
    let message =
        format!("user targets, but neither `contarget/{0}/macro.json` nor `target/{0}` in the system data", base.name);
    let effect = "stops at start (FileNotFoundError): it wants to write an archive into the system's folder";
    let own = base.user_targets.and_then(|folder| folder.layer.file(&format!("{}/macro.json", folder.rel())));
    let help = if own.is_some() {
        "move the folder to `contarget/`: in `target/` of the user MakeHuman 2 looks for additions to a base of the system"
    } else {
        "add a macro.json to contarget; without macros write `{\"components\": {}, \"macrodef\": []}`"
    };
    dead.then_some((file, (Level::Error, message, effect, help)))
}

/// Targets in contarget and none of the files that would make anybody look at them.
fn targets_alone<'a>(base: &Base<'a>) -> Option<(&'a FileFacts, Gap)> {
    let folder = base.other_targets.filter(|folder| !base.macros.is_overridden() && folder.folder == "contarget")?;
    let file = folder.targets().next()?;
    let own = counted(folder.targets().count(), "target file");
    let message = format!("no macro.json in `{}`: its {own} are never read", folder.rel())
        .replace("1 target file are", "1 target file is");
    let help = "add the macro.json and modelling.json that they are for; targets beside those of the system belong in \
        `target/<base>/<group>/`";
    Some((file, (Level::Warning, message, "takes all targets of the base from the system's folder", help)))
}
