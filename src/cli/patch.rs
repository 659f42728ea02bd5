//! Names in a patch: it is applied in one folder, so all of them begin there and none leads out of
//! it.

use std::path::{Component, Path, PathBuf};

use mhlint_source::{canonical, own_place, slashed};

/// Names of the files of a patch.
pub(super) struct Names {
    /// One for each path.
    pub(super) names: Vec<String>,
    /// The folder above the one where mhlint runs that they are seen from.
    pub(super) above: Option<String>,
}

/// The names of files by their paths as reports print them.
pub(super) fn names(paths: &[&str]) -> Names {
    let is_inside = |path: &&str| {
        Path::new(path)
            .components()
            .all(|part| matches!(part, Component::Normal(_)))
    };
    let as_they_are = || Names {
        names: paths.iter().map(|path| (*path).to_owned()).collect(),
        above: None,
    };
    if paths.iter().all(is_inside) {
        return as_they_are();
    }
    let Some(here) = canonical(Path::new(".")) else {
        return as_they_are();
    };
    let places: Vec<PathBuf> = paths
        .iter()
        .map(|path| own_place(Path::new(path)))
        .collect();
    let common = |folder: &&Path| places.iter().all(|place| place.starts_with(folder));
    let Some((ups, folder)) = here
        .ancestors()
        .enumerate()
        .find(|(_, folder)| common(folder))
    else {
        return as_they_are();
    };
    let name = |place: &PathBuf| slashed(place.strip_prefix(folder).unwrap_or(place));
    let is_top = folder.parent().is_none();
    let above = if is_top {
        slashed(folder)
    } else {
        vec![".."; ups].join("/")
    };
    Names {
        names: places.iter().map(name).collect(),
        above: (ups > 0).then_some(above),
    }
}
