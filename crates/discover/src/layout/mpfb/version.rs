//! The version that data of MPFB are of (`docs/loaders/versions.md#versions-of-mpfb`).

use super::super::super::paths::Paths;

/// The walk cycles went with the newest version; what came before that dates the others.
pub(super) fn version(paths: &Paths<'_>) -> Option<&'static str> {
    let rig = |name: &str| paths.has(&format!("rigs/standard/rig.{name}.json"));
    match paths.has("walkcycles/") {
        false => None,
        true if paths.has("expressions/") => Some("2.0.16"),
        true if rig("mixamo_unity") || rig("openpose") => Some("2.0.14"),
        true if paths.has("uv_layers/") => Some("2.0.10"),
        true => Some("2.0.5"),
    }
}
