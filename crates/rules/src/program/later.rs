//! What the programs have that came after a version.

use mhlint_diag::{
    Application::{Makehuman1, Makehuman2, Mpfb},
    Version,
};

/// What newer programs have besides (`docs/loaders/versions.md#versions-of-makehuman-1` and behind
/// it).
pub(super) fn later(version: Version) -> Option<&'static str> {
    let before = |name: &str| version.is_before(name);
    match version.application() {
        Makehuman1 if before("1.0") => {
            Some("the base mesh of 1.0, and modifiers and skeletons of 1.1,")
        }
        Makehuman1 if before("1.1") => Some("skeletons, poses and expressions of 1.1"),
        Makehuman1 if before("1.3") => Some("the body shapes"),
        Makehuman2 if before("2025") => Some("`equipment`, `measure`, `random` and `numverts`"),
        Makehuman2 if before("2026-08-05") => Some("`numverts` and `geometry.json`"),
        Mpfb if before("2.0.16") => Some("expressions"),
        _ => None,
    }
}
