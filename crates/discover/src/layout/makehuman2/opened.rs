//! Which names the loaders of MakeHuman 2 look for
//! (`docs/loaders/makehuman2/folders.md#lookup-order`,
//! `docs/loaders/makehuman2/text-and-json.md#json`, `docs/loaders/makehuman2/libraries.md#scan`).

use super::super::{Single, WORN};
use super::{is_filtered, is_scanned_folder};
use mhlint_source::{depth, extension, first_name};

/// Decided for the folders of base meshes, targets and rigs; everything else counts as opened.
/// Tools of the program count as loaders.
pub(super) fn opens(rel: &str) -> bool {
    let parts: Vec<&str> = rel.split('/').collect();
    match parts.as_slice() {
        // All targets below are packed, those among the icons as well.
        ["target" | "contarget", _, "icons", .., icon] => {
            matches!(extension(icon), "png" | "target")
        }
        [
            "target" | "contarget",
            _,
            "macro.json" | "modelling.json" | "target_cat.json" | "compressedtargets.npz",
        ]
        | ["rigs", _, "icons", ..] => true,
        ["target" | "contarget", _, .., target] => extension(target) == "target",
        ["rigs", _, .., file] => {
            *file == "selection_filter.json"
                || matches!(extension(file), "mhskel" | "mhw" | "thumb")
        }
        ["base", _, file] => is_base_file(file),
        _ => true,
    }
}

/// Beside the files that the program opens by name, a base folder holds what its start model needs.
fn is_base_file(file: &str) -> bool {
    let named = [
        "base.json",
        "base.obj",
        "base.mhbin",
        "geometry.json",
        "face-poses.json",
        "body-poses.json",
    ];
    named.contains(&file)
        || file.ends_with("_target.json")
        || matches!(
            extension(file),
            "mhm" | "mhmat" | "png" | "jpg" | "jpeg" | "thumb"
        )
}

pub(super) fn is_scanned(rel: &str) -> bool {
    let folder = first_name(rel);
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
    wanted && is_scanned_folder(folder) && matches!(depth(rel), 3 | 4)
}

/// Which folder's list shows a file, if any: the scan goes one folder below that of the base mesh,
/// and takes suffixes as they are written.
pub fn listed_in(rel: &str) -> Option<&str> {
    let folder = first_name(rel);
    let is_listed = match extension(rel) {
        "bvh" => folder == "poses",
        "mhmat" => folder == "skins",
        "meta" => false,
        _ => return is_scanned(rel).then_some(folder),
    };
    (is_listed && matches!(depth(rel), 3 | 4)).then_some(folder)
}

/// The folders whose lists show files with a suffix.
pub fn in_place_of(suffix: &str) -> &'static [&'static str] {
    match suffix {
        "mhskel" => &["rigs"],
        "mhpose" => &["poses", "expressions"],
        "bvh" => &["poses"],
        "mhm" => &["models"],
        "proxy" => &["proxy"],
        "mhclo" => &WORN,
        _ => &[],
    }
}

/// Whether a file of a skybox has the name of one of its sides.
fn is_side(file: &str) -> bool {
    file.rsplit_once('.')
        .is_some_and(|(side, suffix)| SKY_SIDES.contains(&side) && matches!(suffix, "png" | "jpg"))
}

/// The sides of a skybox, by their names.
pub const SKY_SIDES: [&str; 6] = ["posx", "negx", "posy", "negy", "posz", "negz"];

pub(super) fn single(rel: &str) -> Option<Single> {
    match rel.split('/').collect::<Vec<_>>().as_slice() {
        ["base", "hm08", "geometry.json"] => Some(Single::ScriptedRanges),
        ["base", _, "face-poses.json"] => Some(Single::Expressions),
        ["base", _, "body-poses.json"] => Some(Single::Poses),
        ["base", ..] => Some(Single::BesideBase),
        ["shaders", "meshes", "lampsymbol.obj"] => Some(Single::LampSymbol),
        ["shaders", "skybox", _, file] if is_side(file) => Some(Single::SkySide),
        _ if extension(rel) == "thumb" => Some(Single::Thumbnail),
        _ => None,
    }
}

/// Whether a path lies in the folder whose files take the place of the system's.
pub fn is_in_override_folder(rel: &str) -> bool {
    rel.starts_with("contarget/")
}

/// Whose surface a material is for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct MaterialUse<'p> {
    /// The folder at the top in which its textures are looked for, besides those around it.
    pub folder: &'p str,
    /// Whether it is offered only for an asset whose folder it lies in, or below.
    pub is_worn: bool,
}

/// What the application has a material of this path for: skins, one folder deep, the base mesh, and
/// what is worn (`docs/loaders/makehuman2/materials.md#alternative-materials`); a topology wears
/// the skin.
pub fn material_of(rel: &str) -> Option<MaterialUse<'_>> {
    match rel.split('/').collect::<Vec<_>>().as_slice() {
        ["skins" | "base", _, _] | ["skins", _, _, _] => Some(MaterialUse {
            folder: "skins",
            is_worn: false,
        }),
        [folder, _, "materials", _, ..] if WORN.contains(folder) => Some(MaterialUse {
            folder,
            is_worn: false,
        }),
        [folder, _, _, ..] if WORN.contains(folder) => Some(MaterialUse {
            folder,
            is_worn: true,
        }),
        _ => None,
    }
}

pub(super) fn misnamed(rel: &str, exists: &dyn Fn(&str) -> bool) -> Option<String> {
    let (folder, name) = rel.rsplit_once('/')?;
    let lower = name.to_lowercase();
    let is_wanted = match folder.split('/').collect::<Vec<_>>().as_slice() {
        ["target" | "contarget", _] => {
            matches!(&*lower, "macro.json" | "modelling.json" | "target_cat.json")
        }
        // With one of both the other is not missed.
        ["base", _] if lower == "base.obj" => !exists(&format!("{folder}/base.mhbin")),
        ["base", _] if lower == "base.mhbin" => !exists(&format!("{folder}/base.obj")),
        ["base", _] => matches!(&*lower, "base.json" | "body-poses.json" | "face-poses.json"),
        [category, _] if is_filtered(category) => lower == "selection_filter.json",
        _ => false,
    };
    let right = format!("{folder}/{lower}");
    (is_wanted && lower != name && !exists(&right)).then_some(right)
}

/// Folders below the data root that are sorted by base mesh.
const BY_BASE: [&str; 5] = ["base", "target", "contarget", "rigs", "models"];

pub(super) fn is_folder(rel: &str, is_base: &dyn Fn(&str) -> bool) -> bool {
    match rel.split('/').collect::<Vec<_>>().as_slice() {
        [folder] => BY_BASE.contains(folder),
        [folder, base] => BY_BASE.contains(folder) && is_base(base),
        ["target" | "contarget", _, "icons"] => true,
        _ => false,
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
    fn materials_are_those_of_skins_bases_and_what_is_worn() {
        for (rel, found) in [
            ("skins/b/x.mhmat", Some(("skins", false))),
            ("skins/b/x/x.mhmat", Some(("skins", false))),
            ("skins/b/x/y/x.mhmat", None),
            ("base/b/x.mhmat", Some(("skins", false))),
            ("eyes/b/materials/x.mhmat", Some(("eyes", false))),
            ("clothes/b/a/materials/x.mhmat", Some(("clothes", true))),
            ("clothes/b/materials", Some(("clothes", true))),
            ("poses/b/x.mhmat", None),
            ("clothes/x.mhmat", None),
            ("proxy/b/a/x.mhmat", None),
        ] {
            assert_eq!(
                material_of(rel).map(|use_of| (use_of.folder, use_of.is_worn)),
                found,
                "{rel}"
            );
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
