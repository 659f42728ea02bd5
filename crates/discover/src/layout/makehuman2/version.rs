//! The version that data of MakeHuman 2 are of
//! (`docs/loaders/versions.md#versions-of-makehuman-2`).

use super::super::super::paths::Paths;

/// Each change to what it loads left a sign.
pub(super) fn version(paths: &Paths<'_>) -> Option<&'static str> {
    if paths.has("props/") || paths.has("base/fantasy/") {
        return Some("2026-08-20");
    }
    let settings = || {
        paths
            .all()
            .filter(|rel| rel.starts_with("base/") && rel.ends_with("/base.json"))
    };
    let any = |word: &str| settings().any(|rel| paths.says(rel, word));
    let is_old = ["\"standardnumverts\"", "MakeHuman Community"]
        .iter()
        .any(|word| paths.says("makehuman2_version.json", word))
        || paths.has("base/cube/")
        || paths.has("base/spider/");
    match is_old {
        _ if settings().next().is_none() || any("\"numverts\"") => None,
        true if any("\"equipment\"") => Some("2025"),
        true => Some("2024"),
        false => None,
    }
}
