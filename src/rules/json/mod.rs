//! Rules on the text and the shape of any JSON.

pub(super) mod duplicate_key;
pub(super) mod schema;
mod schema_effects;
mod schema_words;
pub(super) mod syntax;
pub(super) mod too_deep;
pub(super) mod unknown_key;

use crate::diag::Level;
use crate::discover::Kind;
use crate::repo::FileFacts;
use crate::repo::makehuman2::View;

/// What becomes of MakeHuman 2 and its user when it cannot read a JSON at all: it depends on what the
/// file is for (formats/makehuman2.md §1.2, §5.2, §7, §9, §10, §11, §12, §19, §20, §21).
fn loss(view: &View<'_>, file: &FileFacts) -> (Level, &'static str) {
    let generated = file.rel.starts_with("target/") && is_user_root(view);
    match file.kind {
        Kind::MacroJson if generated => (Level::Info, "never reads this file"),
        Kind::MacroJson => (Level::Error, "logs a line and treats the file as absent: the base has no macros"),
        Kind::ModellingJson if generated => {
            (Level::Error, "logs a line and treats the file as absent: the sliders of the user's targets are gone")
        }
        Kind::ModellingJson => (Level::Error, "logs a line and treats the file as absent: the base has no sliders"),
        Kind::TargetCategories if generated => (Level::Error, "stops at start (TypeError)"),
        Kind::TargetCategories => {
            (Level::Error, "logs a line and treats the file as absent: no slider can be reached in the window")
        }
        Kind::BaseJson => (Level::Error, "does not load the base mesh; the window opens without one"),
        Kind::Geometry => (Level::Warning, "never reads this file; the scripts that align joint cubes stop"),
        Kind::Skeleton => (Level::Error, "stops at start, while it scans the assets (AttributeError)"),
        Kind::Weights | Kind::AssetWeights => {
            (Level::Error, "loads no weights at all: in pose mode the mesh collapses to the origin")
        }
        _ => loss_of_other(&file.rel),
    }
}

fn loss_of_other(rel: &str) -> (Level, &'static str) {
    let parts: Vec<&str> = rel.split('/').collect();
    match parts.as_slice() {
        ["expressions" | "poses", .., name] if name.ends_with(".mhpose") => {
            (Level::Error, "stops at start, while it scans the assets (AttributeError)")
        }
        ["base", _, "face-poses.json"] => (Level::Error, "offers no expressions for the base"),
        ["base", _, "body-poses.json"] => (Level::Error, "offers no pose editor for the base"),
        ["makehuman2_version.json"] => (Level::Error, "does not start (exit code 20)"),
        ["shaders", "shader.json"] => (Level::Error, "does not start (exit code 21)"),
        [.., "selection_filter.json"] => (Level::Warning, "goes on with an empty filter"),
        _ => (Level::Warning, "treats the file as absent, if it reads it at all"),
    }
}

fn is_user_root(view: &View<'_>) -> bool {
    let judged_is_user = view.layers.user.is_some_and(|user| std::ptr::eq(user, view.layers.checked));
    judged_is_user && !view.layers.is_one_root()
}
