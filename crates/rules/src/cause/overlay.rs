//! Overrides that are not in use, and what is in use instead of what was meant.

use super::schema::is_of_wrong_type;
use mhlint_repo::Layer;
use mhlint_repo::makehuman2::{Base, Overlaid, View};

/// Whether one of the files is rejected. What is then in use is not what the author meant, and
/// everything that follows from it follows from the damage.
pub(crate) fn is_damaged<T>(overlaid: &Overlaid<'_, T>) -> bool {
    overlaid.contarget.is_refused() || overlaid.is_broken()
}

/// Whether the sliders in use are those that were meant; without them no name can be judged.
pub(crate) fn has_sliders(base: &Base<'_>) -> bool {
    !is_damaged(&base.modelling) && base.modelling.winner().is_some()
}

/// Whether an override is there and in use. One that is no object is taken, too, but stops the
/// application; nothing can be said about what it would do.
pub(crate) fn is_active<T>(overlaid: &Overlaid<'_, T>) -> bool {
    overlaid
        .contarget
        .accepted()
        .is_some_and(|(file, _)| !is_of_wrong_type(file))
}

/// Whether an override is there and not in use: what follows from that is no finding of its own.
pub(crate) fn has_broken_override(base: &Base<'_>) -> bool {
    fn is_broken<T>(overlaid: &Overlaid<'_, T>) -> bool {
        overlaid.contarget.file().is_some() && !is_active(overlaid)
    }
    is_broken(&base.macros) || is_broken(&base.modelling) || is_broken(&base.categories)
}

/// Whether an override is there under a name with other capitals: `file-case-mismatch` says that
/// nobody finds it.
pub(crate) fn has_misnamed_override(view: &View<'_>, base: &Base<'_>) -> bool {
    let layers = [Some(view.layers.checked), view.layers.user]
        .into_iter()
        .flatten();
    let folder = format!("contarget/{}", base.name);
    let names =
        ["macro.json", "modelling.json", "target_cat.json"].map(|name| format!("{folder}/{name}"));
    let is_misnamed = |layer: &Layer, rel: &String| {
        layer.file(rel).is_none() && layer.file_ignoring_case(rel).is_some()
    };
    layers
        .into_iter()
        .any(|layer| names.iter().any(|rel| is_misnamed(layer, rel)))
}

/// What is known of the system's target folder of a base.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum SystemFolder {
    /// It is there.
    Exists,
    /// The base lives in user space alone.
    Absent,
    /// No system data was given.
    Unknown,
}

/// Whether the program looks for targets in a folder of the system that is not there; it stops
/// before it asks for one.
pub(crate) fn lacks_folder(view: &View<'_>, base: &Base<'_>) -> bool {
    !base.macros.is_overridden() && system_folder(view, base) == SystemFolder::Absent
}

pub(crate) fn system_folder(view: &View<'_>, base: &Base<'_>) -> SystemFolder {
    let rel = format!("target/{}", base.name);
    let Some(system) = view.layers.system.filter(|_| base.has_system) else {
        return SystemFolder::Unknown;
    };
    // One with other capitals has a finding of its own.
    let exists = system.below(&rel).next().is_some() || system.has_folder_ignoring_case(&rel);
    if exists {
        SystemFolder::Exists
    } else {
        SystemFolder::Absent
    }
}
