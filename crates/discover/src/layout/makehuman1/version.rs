//! The version that data of MakeHuman 1 are of
//! (`docs/loaders/versions.md#versions-of-makehuman-1`).

use std::collections::BTreeSet;

use super::super::super::paths::Paths;

/// Told by what came with it, or else by the base mesh: what is missing says nothing of data for
/// another one.
pub(super) fn version(paths: &Paths<'_>) -> Option<&'static str> {
    if paths.has("targets/bodyshapes/") || paths.has("modifiers/bodyshapes_") {
        return Some("1.3");
    }
    let has_all = || ["targets/", "modifiers/"].iter().all(|rel| paths.has(rel));
    match paths.mesh {
        (15340, _) => Some("alpha 6"),
        (18528, _) => Some("alpha 7"),
        (19158, 21333) if paths.has("costumes/") || paths.has("mhx/") => Some("alpha 8"),
        (19158, 21333) => Some("1.0"),
        (19158, 21334) if paths.says("VERSION", "{") || is_of_2020(paths) => Some("1.2"),
        (19158, 21334) if is_older_build(paths) || has_all() && !paths.has("targets.npz") => {
            Some("1.1")
        }
        (19158, 21334) => None,
        // Of another mesh nobody knows.
        _ if !paths.has_kind("rigs/", ".mhskel")
            && let Some(old) = version_without_skeletons(paths) =>
        {
            Some(old)
        }
        _ if is_older_build(paths) => Some("1.1"),
        // One folder may be gone; all of what came with 1.3 is not. In an archive nobody looks for
        // names.
        _ if has_all() || paths.has("targets.npz") && paths.has("modifiers/") => Some("1.2"),
        _ => None,
    }
}

/// Told by the folders that went.
fn version_without_skeletons(paths: &Paths<'_>) -> Option<&'static str> {
    let has_any = |starts: &[&str]| starts.iter().any(|start| paths.has(start));
    match paths.has("modifiers/") {
        true => paths.has_kind("rigs/", ".json").then_some("1.0"),
        false if has_any(&["costumes/", "vertexgroups/"]) => Some("alpha 8"),
        false if has_any(&["cages/", "hairstyles/", "landmarks/"]) => Some("alpha 7"),
        false => has_any(&["templates/", "hairs/"]).then_some("alpha 6"),
    }
}

/// Whether a build wrote its version as a text, `number:hash`; from 1.2 on it is JSON.
fn is_older_build(paths: &Paths<'_>) -> bool {
    paths
        .first("VERSION")
        .is_some_and(|rel| rel == "VERSION" && paths.says(rel, ":") && !paths.says(rel, "{"))
}

/// Whether the headers of its targets are those of the autumn of 2020.
fn is_of_2020(paths: &Paths<'_>) -> bool {
    paths
        .first("targets/")
        .is_some_and(|rel| paths.says(rel, "september 2020"))
}

/// Whether most of what is worn, or all targets, come compiled
/// (`docs/loaders/versions.md#whose-data-a-folder-is`).
pub(super) fn is_release(paths: &Paths<'_>) -> bool {
    let stems = |suffix: &'static str| -> BTreeSet<&str> {
        paths
            .all()
            .filter_map(|path| path.strip_suffix(suffix))
            .collect()
    };
    let (texts, packed) = (stems(".mhclo"), stems(".mhpxy"));
    paths.has("targets.npz") && paths.has("images.list")
        || packed.difference(&texts).count() > texts.len()
}
