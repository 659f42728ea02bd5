//! Targets without any override that would make an application look at them.

use super::super::{are, counted};
use super::SystemFolder;
use mhlint_diag::Level;
use mhlint_repo::FileFacts;
use mhlint_repo::makehuman2::Base;

/// A gap: how bad, what is wrong, what MakeHuman 2 does, what to do.
pub(super) type Gap = (Level, String, &'static str, &'static str);

/// What a missing folder of targets in the system data leads to.
pub(super) const NO_FOLDER: &str =
    "crashes with `FileNotFoundError` at start: it tries to write an archive into that folder";

/// The file at which the gap stands, with the gap.
pub(super) fn gap<'a>(base: &Base<'a>, system: SystemFolder) -> Option<(&'a FileFacts, Gap)> {
    of_user(base, system).or_else(|| in_contarget(base))
}

/// No override at all, but user targets for a base of user space: they lead to the same folder.
fn of_user<'a>(base: &Base<'a>, system: SystemFolder) -> Option<(&'a FileFacts, Gap)> {
    let file = base.user_modelling.file()?;
    let has_sliders = base
        .user_modelling
        .accepted()
        .is_some_and(|(_, model)| !model.sliders.is_empty());
    let dead = system == SystemFolder::Absent && has_sliders && base.own_json.is_some();
    let message = format!(
        "user targets exist, but neither `contarget/{0}/macro.json` nor `target/{0}` in the \
            system data",
        base.name
    );
    let own = base
        .user_targets
        .and_then(|folder| folder.layer.file(&format!("{}/macro.json", folder.rel())));
    let help = if own.is_some() {
        "move the folder to `contarget/`: the user's `target/` is only for additions to a base of \
            the system data"
    } else {
        "add a macro.json to contarget; without macros, write `{\"components\": {}, \"macrodef\": \
            []}`"
    };
    dead.then_some((file, (Level::Error, message, NO_FOLDER, help)))
}

/// Targets in contarget and none of the files that would make anybody look at them.
fn in_contarget<'a>(base: &Base<'a>) -> Option<(&'a FileFacts, Gap)> {
    let folder = base
        .other_targets
        .filter(|folder| !base.macros.is_overridden() && folder.folder == "contarget")?;
    let file = folder.targets().next()?;
    let count = folder.targets().count();
    let (own, be) = (counted(count, "target file"), are(count));
    let message = format!(
        "macro.json is missing in `{}`: its {own} {be} never read",
        folder.rel()
    );
    let help = "add their macro.json and modelling.json, or move additions to the targets of the \
        system data to `target/<base>/<group>/`";
    Some((
        file,
        (
            Level::Warning,
            message,
            "loads all targets of the base from the system data",
            help,
        ),
    ))
}
