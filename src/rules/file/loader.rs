//! Which files MakeHuman 2 opens, when, and what its user sees if that fails (formats/makehuman2.md §1, §2, §19).

use crate::diag::Level;
use crate::discover::{Kind, SCANNED};
use crate::repo::makehuman2::View;
use crate::repo::{FileFacts, Layer};

/// When a file is opened.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Moment {
    /// When the base mesh is loaded.
    Start,
    /// When the asset library is scanned, also at start: one bad file takes all assets along.
    Scan,
    /// When somebody uses the asset.
    Use,
    /// By no loader of the program, only by tools.
    Never,
}

/// When MakeHuman 2 opens a file of this name.
pub(super) fn moment(file: &FileFacts) -> Moment {
    match file.kind {
        Kind::Geometry => Moment::Never,
        _ if !opens(&file.rel) => Moment::Never,
        Kind::BaseJson
        | Kind::BaseMesh
        | Kind::MacroJson
        | Kind::ModellingJson
        | Kind::TargetCategories
        | Kind::Target
        | Kind::TargetArchive => Moment::Start,
        Kind::Json | Kind::Pose if file.rel.starts_with("base/") => Moment::Start,
        Kind::Json => Moment::Use,
        _ if is_scanned(&file.rel) => Moment::Scan,
        Kind::Weights => Moment::Start,
        _ => Moment::Use,
    }
}

/// Whether the asset scan opens a file of this name.
fn is_scanned(rel: &str) -> bool {
    let folder = rel.split('/').next().unwrap_or_default();
    let wanted = match extension(rel) {
        "mhskel" => folder == "rigs",
        "mhpose" => matches!(folder, "poses" | "expressions"),
        "meta" => folder == "poses",
        "mhm" => folder == "models",
        "proxy" => folder == "proxy",
        "mhclo" => folder != "proxy",
        "mhbin" => true,
        _ => false,
    };
    wanted && SCANNED.contains(&folder) && matches!(rel.split('/').count(), 3 | 4)
}

/// Whether any loader (or a tool of the program) opens a file of this name. Decided for the folders of base
/// meshes, targets and rigs; everything else counts as opened.
pub(super) fn opens(rel: &str) -> bool {
    let parts: Vec<&str> = rel.split('/').collect();
    match parts.as_slice() {
        ["target" | "contarget", _, "icons", .., icon] => extension(icon) == "png",
        ["target" | "contarget", _, "macro.json" | "modelling.json" | "target_cat.json" | "compressedtargets.npz"]
        | ["rigs", _, "icons", ..] => true,
        ["target" | "contarget", _, .., target] => extension(target) == "target",
        ["rigs", _, .., file] => {
            *file == "selection_filter.json" || matches!(extension(file), "mhskel" | "mhw" | "thumb")
        }
        ["base", _, file] => is_base_file(file),
        _ => true,
    }
}

/// The path under which MakeHuman 2 looks for a file of this name but for its capitals, where nothing has that path.
pub(super) fn misnamed(layer: &Layer, rel: &str) -> Option<String> {
    let (folder, name) = rel.rsplit_once('/')?;
    let lower = name.to_lowercase();
    let is_wanted = match folder.split('/').collect::<Vec<_>>().as_slice() {
        ["target" | "contarget", _] => matches!(&*lower, "macro.json" | "modelling.json" | "target_cat.json"),
        ["base", _] if lower == "base.obj" => layer.file(&format!("{folder}/base.mhbin")).is_none(),
        ["base", _] => lower == "base.json",
        _ => false,
    };
    let right = format!("{folder}/{lower}");
    (is_wanted && lower != name && layer.file(&right).is_none()).then_some(right)
}

/// Beside the files that the program opens by name, a base folder holds what its start model needs.
fn is_base_file(file: &str) -> bool {
    let named = ["base.json", "base.obj", "base.mhbin", "geometry.json", "face-poses.json", "body-poses.json"];
    named.contains(&file)
        || file.ends_with("_target.json")
        || matches!(extension(file), "mhm" | "mhmat" | "png" | "jpg" | "jpeg" | "thumb")
}

/// What is behind the last point of a name, as written.
pub(super) fn extension(rel: &str) -> &str {
    let name = rel.rsplit('/').next().unwrap_or(rel);
    name.rsplit_once('.').map_or("", |(_, extension)| extension)
}

/// Whether something else in the file speaks before its content does: it was not read, or is a stand-in.
fn is_unread(file: &FileFacts) -> bool {
    file.unreadable.is_some() || file.encoding.lfs_pointer || file.gzip_fault.is_some()
}

/// Whether the file is an override that counts as missing when it cannot be read: `overlay-broken-override`
/// names its fault, because the fallback is the worse news.
pub(super) fn is_override(file: &FileFacts) -> bool {
    file.rel.starts_with("contarget/")
        && matches!(file.kind, Kind::MacroJson | Kind::ModellingJson | Kind::TargetCategories)
}

/// Whether the text of the file is somebody's to read, and nothing else speaks before it: it was read, a loader
/// opens its name, and it is not the `macro.json` of a user's target folder (`overlay-shadowed` tells that it is
/// never read).
pub(super) fn is_met(view: &View<'_>, file: &FileFacts) -> bool {
    let ignored = file.kind == Kind::MacroJson && is_generated(view, file);
    opens(&file.rel) && !is_unread(file) && !ignored
}

/// Whether the file lies in the target folder of a user, whose JSON MakeHuman 2 writes itself.
pub(super) fn is_generated(view: &View<'_>, file: &FileFacts) -> bool {
    let user = view.layers.user.is_some_and(|user| std::ptr::eq(user, view.layers.checked));
    user && !view.layers.is_one_root() && file.rel.starts_with("target/")
}

/// What happens with a JSON that Python's reader refuses, and how bad that is (formats/makehuman2.md §1.2, §5.2,
/// §7, §9, §11, §12, §19, §20).
pub(super) fn refused_json(view: &View<'_>, file: &FileFacts) -> (Level, &'static str) {
    let name = file.file_name();
    match (moment(file), file.kind) {
        (Moment::Never, _) => (Level::Warning, "does not read it; tools that do stop"),
        (Moment::Scan, _) => (Level::Error, "stops at start while it scans the assets"),
        (_, Kind::BaseJson) => (Level::Error, "does not load the base mesh"),
        (_, Kind::MacroJson) => (Level::Error, "logs a line and takes it as missing: the base has no macros"),
        (_, Kind::ModellingJson) => (Level::Error, "logs a line and takes it as missing: its sliders are gone"),
        (_, Kind::TargetCategories) if is_generated(view, file) => (Level::Error, "stops at start with a TypeError"),
        (_, Kind::TargetCategories) => (Level::Error, "logs a line and takes it as missing: no slider can be reached"),
        (_, Kind::Weights | Kind::AssetWeights) => {
            (Level::Error, "has no weights: the mesh collapses as soon as it is posed")
        }
        _ if name == "face-poses.json" => (Level::Error, "offers no expressions for the base"),
        _ if name == "body-poses.json" => (Level::Error, "offers no pose editor for the base"),
        _ if matches!(file.rel.as_str(), "makehuman2_version.json" | "shaders/shader.json") => {
            (Level::Error, "does not start")
        }
        _ => (Level::Warning, "takes it as missing, if it reads it at all"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_folders_of_targets_hold_only_what_loaders_open() {
        for (rel, opened) in [
            ("target/b/a/deep/x.target", true),
            ("target/b/icons/x.png", true),
            ("target/b/x.png", false),
            ("target/b/a/x.target.gz", false),
            ("target/b/a/X.TARGET", false),
            ("contarget/b/macro.json", true),
            ("contarget/b/sub/macro.json", false),
            ("rigs/b/sub/x.mhskel", true),
            ("rigs/b/x.json", false),
            ("base/b/skin.png", true),
            ("base/b/base.obj.bak", false),
            ("clothes/b/x/anything", true),
        ] {
            assert_eq!(opens(rel), opened, "{rel}");
        }
    }

    #[test]
    fn the_scan_goes_one_folder_deep() {
        for (rel, scanned) in [
            ("clothes/b/x/x.mhclo", true),
            ("clothes/b/x/y/x.mhclo", false),
            ("clothes/b/x/x.mhmat", false),
            ("proxy/b/x.mhclo", false),
            ("base/b/base.mhm", false),
            ("models/b/x.mhm", true),
        ] {
            assert_eq!(is_scanned(rel), scanned, "{rel}");
        }
    }
}
