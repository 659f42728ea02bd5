//! MakeHuman 1: one base mesh, libraries without a folder for it
//! (`docs/loaders/makehuman1/folders.md#libraries-and-their-places`).

mod version;

use super::super::kind::SHADER_FILES;
use super::super::listing::{Listing, at};
use super::super::{Candidate, Kind};
use super::{
    HM08, HiddenPath, LIBRARIES, Layout, MAKEHUMAN2_BASES, Role, Says, Sign, Single, WORN, near,
    worn_shelf,
};
use mhlint_diag::Application;
use mhlint_source::{extension, folder_and_name};

pub(super) static LAYOUT: Layout = Layout {
    application: Application::Makehuman1,
    shape: "modifiers/*_modifiers.json",
    depth: 3,
    folders: &[
        &["targets", "modifiers", "3dobjs", "custom"],
        &LIBRARIES,
        &WORN,
    ],
    sign,
    weigh,
    version: version::version,
    is_release: version::is_release,
    is_of_others,
    place,
    role,
    shelf,
    loose_place,
    unpacks_singly: true,
    is_dangerous,
    // In a folder `custom` there nobody looks, but it is a usual mistake.
    beside: &["models", "custom", CACHE, SETTINGS],
    above_data,
    tells_without_data: |_, _| false,
    is_folder: |rel, _| is_beside(rel, CACHE),
    // What is called a target is one
    // (`docs/loaders/makehuman1/targets.md#where-targets-are-found`).
    everywhere: Some(Kind::Target),
    only_base: Some(HM08),
    joint: Some("upperleg02.L"),
    scans: |rel| library_of(rel).is_some(),
    reads_hidden,
    single,
    ..Layout::PLAIN
};

fn sign(parts: &[&str]) -> Option<(Sign, usize)> {
    match parts {
        [.., "modifiers", name] if name.ends_with("_modifiers.json") => Some((Sign::Strong, 2)),
        [.., "3dobjs", "base.obj"] => Some((Sign::Weak, 2)),
        // Everything that a build has of its targets; worth something beside the list of its
        // pictures.
        [.., TARGETS_NPZ] => Some((Sign::Strong, 1)),
        [.., "rigs", name] if extension(name) == "mhskel" => Some((Sign::Weak, 2)),
        // Rigs are listed at any depth.
        [.., "rigs", _, name] if extension(name) == "mhskel" => Some((Sign::Faint, 3)),
        // What is packed stands for its text
        // (`docs/loaders/makehuman1/compiled-clothes.md#when-it-is-read`).
        [.., "proxymeshes", _, name] if extension(name) == "mhpxy" => Some((Sign::Faint, 3)),
        [.., library, _, name] if WORN.contains(library) && extension(name) == "mhpxy" => {
            Some((Sign::Faint, 3))
        }
        // MPFB has them, too.
        [.., "proxymeshes", _, name] if extension(name) == "proxy" => Some((Sign::Faint, 3)),
        // Packs of nothing but skins, or of poses, each with what else belongs to one.
        [.., "skins", name] if extension(name) == "mhmat" => Some((Sign::Faint, 2)),
        [.., "skins", base, name]
            if extension(name) == "mhmat" && !MAKEHUMAN2_BASES.contains(base) =>
        {
            Some((Sign::Faint, 3))
        }
        [.., "poses", name] if matches!(extension(name), "meta" | "thumb") => {
            Some((Sign::Faint, 2))
        }
        [.., library, name]
            if WORN.contains(library) && extension(name).eq_ignore_ascii_case("mhclo") =>
        {
            Some((Sign::Faint, 2))
        }
        // Nothing but targets of a user; in this place they are those of one of MPFB.
        [.., "targets", "custom", _] => None,
        [.., "custom", name] if extension(name) == "target" => Some((Sign::Faint, 2)),
        // An asset in its own folder: in a pack or of a user there may be nothing else.
        [.., library, asset, name]
            if WORN.contains(library)
                && extension(name).eq_ignore_ascii_case("mhclo")
                && !MAKEHUMAN2_BASES.contains(asset) =>
        {
            Some((Sign::Faint, 3))
        }
        _ => None,
    }
}

/// An archive of targets lies beside a list of pictures, and a folder of rigs that is called like a
/// base mesh of another application is none of ours.
fn weigh(listing: &Listing<'_>, root: &str, file: &str, sign: Sign) -> Option<Sign> {
    let rel = file
        .get(root.len()..)
        .unwrap_or_default()
        .trim_start_matches('/');
    let is_own = match rel.split('/').collect::<Vec<_>>().as_slice() {
        [TARGETS_NPZ] => listing.has(&at(root, "images.list")),
        ["rigs", folder, _] => {
            !listing.knows_base(folder) && !listing.has_folder(&at(root, &format!("base/{folder}")))
        }
        _ => true,
    };
    is_own.then_some(sign)
}

/// Models and the lists of libraries lie beside the data of a user, which may be an empty folder
/// (`docs/loaders/versions.md#whose-data-a-folder-is`).
fn above_data(parts: &[&str]) -> Option<usize> {
    match parts {
        [.., CACHE, name] if name.ends_with("_filecache.mhc") => Some(2),
        [.., "models", name] if extension(name).eq_ignore_ascii_case("mhm") => Some(2),
        [.., "models", _, name] if extension(name).eq_ignore_ascii_case("mhm") => Some(3),
        _ => None,
    }
}

/// Models say which program wrote them; poses of the body and of the face are most often of
/// another.
fn is_of_others(extension: &str, says: Says<'_>) -> bool {
    extension == "mhpose"
        || extension == "mhm" && (says("MakeHuman2 Model File") || says("version v2."))
}

/// Only the program has such files: it opens them by their names. Its first rig users copy, too.
fn role(below: &[Candidate<'_>]) -> Role {
    let own = || below.iter().filter(|one| !one.is_loose);
    let has = |start: &str| own().any(|one| one.rel.starts_with(start));
    let has_mesh = below
        .iter()
        .any(|one| one.kind_in(Application::Makehuman1).is_base_mesh());
    let is_build = has("images.list") && has(TARGETS_NPZ);
    // Users keep a copy of the mesh for their 3D program, of the sliders or of the targets, too;
    // all of it is a program.
    let is_of_user = has("custom/") || below.iter().any(|one| one.is_loose);
    let is_copy = is_of_user && !is_build && !(has("targets/") && has("modifiers/"));
    let is_own = has("modifiers/modeling_modifiers.json") || has_mesh || has("rigs/default.mhskel");
    // A program that was copied over the data of its user.
    let is_home = below
        .iter()
        .any(|one| one.is_loose && !one.rel.starts_with("custom/"));
    match (is_build || is_own && !is_copy, is_home) {
        (true, false) => Role::System,
        (true, true) => Role::Both,
        (false, _) => Role::User,
    }
}

fn place<'p>(parts: &[&'p str]) -> (Kind, Option<&'p str>) {
    let kind = match parts {
        ["3dobjs", "base.obj"] => Kind::BaseMesh,
        ["3dobjs", "base.npz"] => Kind::PackedBaseMesh,
        // Users have some in `custom` alone, where capitals count; the program has them anywhere in
        // its data.
        ["custom", .., file] if extension(file) == "target" => Kind::Target,
        [folder, .., file]
            if *folder != "custom" && extension(file).eq_ignore_ascii_case("target") =>
        {
            Kind::Target
        }
        // Nobody looks for it there.
        [file] if extension(file) == "target" => Kind::Target,
        ["modifiers", file] if file.ends_with("_modifiers.json") => Kind::ModifierFile,
        ["modifiers", file] if file.ends_with("_modifiers_desc.json") => Kind::ModifierTexts,
        ["modifiers", file] if file.ends_with("_sliders.json") => Kind::ModifierSliders,
        ["modifiers", MAPPING] => Kind::ModifierMapping,
        [TARGETS_NPZ] => Kind::TargetsNpz,
        ["images.list"] => Kind::PictureList,
        ["..", CACHE] => Kind::LibraryCache,
        ["..", SETTINGS] => Kind::ProgramSettings,
        ["poseunits", "face-poseunits.json"] => Kind::FaceUnits,
        ["poseunits", FACE_MOTION] => Kind::Motion,
        ["languages", file] if extension(file) == "json" => Kind::Language,
        ["rigs", .., file] if extension(file) == "mhw" => Kind::Weights,
        // Whatever its list shows is loaded under the name that it has.
        ["models", .., file] if extension(file).eq_ignore_ascii_case("mhm") => Kind::Model,
        [_, .., file] if SHADER_FILES.iter().any(|ending| file.ends_with(ending)) => {
            Kind::ShaderSource
        }
        ["poses", .., file] if extension(file) == "mhp" => Kind::Unlisted,
        ["poses", .., file] if extension(file).eq_ignore_ascii_case("bvh") => Kind::Motion,
        [folder, .., file] => match Kind::by_extension(file) {
            // In folders such as `costumes` older versions had some.
            Kind::Clothes if !holds_worn(folder) && !OWN_FOLDERS.contains(folder) => Kind::Unlisted,
            // Elsewhere the program has such files for itself, and opens them by name or never.
            Kind::Clothes | Kind::AssetMesh | Kind::AssetWeights if !holds_worn(folder) => {
                Kind::Other
            }
            Kind::Motion | Kind::MotionMeta if *folder != "poses" => Kind::Other,
            // What MakeHuman 2 packs is nothing to it, nor is any other archive.
            Kind::Packed if !matches!(extension(file), "mhpxy" | "npz") => Kind::Other,
            kind => kind,
        },
        // What lists show for assets without a picture.
        [file] if extension(file) == "thumb" => Kind::Image,
        [file] if is_dangerous(file) => Kind::by_extension(file),
        _ => Kind::Other,
    };
    (
        kind,
        (parts.len() > 1 || kind == Kind::Target).then_some(HM08),
    )
}

/// Libraries list files by their extension, hidden or not; macOS and editors leave such beside each
/// of their own (`docs/loaders/makehuman1/folders.md#links`). The names of all folders of the data
/// count for its targets (`docs/loaders/makehuman1/targets.md#faults-of-names`).
fn reads_hidden(path: &HiddenPath<'_>) -> bool {
    let is_in_data = path.in_root
        || path
            .visible
            .iter()
            .any(|part| matches!(*part, "data" | "targets"));
    if is_in_data && (path.is_folder || extension(path.name).eq_ignore_ascii_case("target")) {
        return true;
    }
    let Some(at) = path
        .visible
        .iter()
        .rposition(|part| library_extension(part).is_some())
    else {
        return false;
    };
    let below = path.visible.get(at..).unwrap_or_default().join("/");
    // The list of materials of an asset as well.
    let is_listed = || {
        library_of(&format!("{below}/{}", path.name)).is_some() || extension(path.name) == "mhmat"
    };
    !path.is_folder && path.name.starts_with('.') && is_listed()
}

/// The library of a loose file, of those that are checked.
fn shelf(extension: &str, above: &[&str]) -> Option<&'static str> {
    match extension {
        "mhclo" => Some(worn_shelf(above)),
        "proxy" => Some(TOPOLOGIES),
        // Beside a text it is no asset of its own.
        "mhpxy" => Some(packed_shelf(above)),
        "bvh" => Some("poses"),
        "mhmat" => Some("skins"),
        "mhskel" => Some("rigs"),
        "mhpose" => Some("expressions"),
        "mhm" => Some("models"),
        // What is in one may run code, wherever it lies.
        _ if extension.eq_ignore_ascii_case("mhscene") => Some("scenes"),
        _ => None,
    }
}

/// The library of a loose archive, which does not say whether it stands for the body.
fn packed_shelf(above: &[&str]) -> &'static str {
    if above.contains(&TOPOLOGIES) {
        TOPOLOGIES
    } else {
        worn_shelf(above)
    }
}

/// Scenes and lists of libraries are pickles, which can call anything.
fn is_dangerous(path: &str) -> bool {
    ["mhscene", "mhc"]
        .iter()
        .any(|known| extension(path).eq_ignore_ascii_case(known))
}

/// A list of a library, which may run code as well as a scene, and an archive of something worn,
/// wherever they lie; a target and weights as their author would put them. What is wrong with the
/// archive of all targets shows only beside these.
fn loose_place(path: &str, _: Option<&str>) -> Option<String> {
    let (folder, name) = folder_and_name(path);
    let above: Vec<&str> = folder.rsplit('/').collect();
    let near = near(folder);
    match extension(name).to_ascii_lowercase().as_str() {
        "target" => Some(format!("{CUSTOM}/{near}/{name}")),
        "mhw" => Some(format!("rigs/{near}/{name}")),
        "mhc" => Some(format!("{CACHE}/{}", name.to_ascii_lowercase())),
        "mhpxy" => Some(format!("{}/{near}/{name}", packed_shelf(&above))),
        _ => None,
    }
}

/// Folders in which the program, or a user, has other things.
const OWN_FOLDERS: [&str; 3] = ["3dobjs", "models", "custom"];

fn holds_worn(folder: &str) -> bool {
    WORN.contains(&folder) || folder == TOPOLOGIES
}

fn single(rel: &str) -> Option<Single> {
    let name = rel
        .strip_prefix("litspheres/skinmat_")
        .and_then(|name| name.strip_suffix(".png"));
    match name {
        Some("african" | "asian" | "caucasian") => Some(Single::SkinPicture),
        _ if rel == "skins/default.mhmat" => Some(Single::FirstSkin),
        _ if matches!(rel, "rigs/default.mhskel" | "rigs/default_weights.mhw") => {
            Some(Single::FirstRig)
        }
        _ if is_beside(rel, CACHE) => Some(Single::CacheFolder),
        _ if rel == "scenes/default.mhscene" => Some(Single::FirstScene),
        _ if extension(rel) == "thumb" => Some(Single::Thumbnail),
        _ if rel.starts_with("custom/") && extension(rel) == "target" => Some(Single::OwnTarget),
        _ => None,
    }
}

/// What is beside the data of a user: the lists of libraries, and the settings of the program.
const CACHE: &str = "cache";
const SETTINGS: &str = "settings.ini";

fn is_beside(rel: &str, name: &str) -> bool {
    rel.strip_prefix("../") == Some(name)
}

/// Where users have targets of their own.
const CUSTOM: &str = "custom";

/// What stands for all targets.
pub const TARGETS_NPZ: &str = "targets.npz";

/// The names of modifiers in older models.
const MAPPING: &str = "mh_1-0_modifier_mapping.csv";

/// The motion whose frames are the units of expressions.
const FACE_MOTION: &str = "face-poseunits.bvh";

/// The folder of what stands for the body.
const TOPOLOGIES: &str = "proxymeshes";

/// The library that a file is listed in: at any depth, in whatever capitals its extension is
/// (`docs/loaders/makehuman1/folders.md#extensions`).
pub fn library_of(rel: &str) -> Option<&str> {
    // Those of a user's models lie beside the data.
    let rel = rel.strip_prefix("../").unwrap_or(rel);
    let (library, _) = rel.split_once('/')?;
    let extension = extension(rel);
    let is_listed =
        library_extension(library).is_some_and(|own| own.eq_ignore_ascii_case(extension));
    is_listed.then_some(library)
}

/// The library that lists an archive of something worn (`.mhpxy`). Elsewhere, such as in `3dobjs`,
/// nothing puts it on.
pub fn archive_library_of(rel: &str) -> Option<&str> {
    let (library, _) = rel.split_once('/')?;
    (holds_worn(library) && extension(rel) == "mhpxy").then_some(library)
}

/// The folders of libraries.
pub fn libraries() -> impl Iterator<Item = &'static str> {
    WORN.into_iter().chain([
        TOPOLOGIES,
        "skins",
        "poses",
        "rigs",
        "expressions",
        "models",
    ])
}

/// What the files of a library end in.
pub fn library_extension(library: &str) -> Option<&'static str> {
    match library {
        TOPOLOGIES => Some("proxy"),
        "skins" => Some("mhmat"),
        "poses" => Some("bvh"),
        "rigs" => Some("mhskel"),
        "expressions" => Some("mhpose"),
        "models" => Some("mhm"),
        _ if WORN.contains(&library) => Some("mhclo"),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn place_decides_the_kind() {
        for (path, kind) in [
            ("3dobjs/base.obj", Kind::BaseMesh),
            ("3dobjs/base.mhclo", Kind::Other),
            ("poseunits/face.bvh", Kind::Other),
            ("poseunits/face-poseunits.bvh", Kind::Motion),
            ("proxymeshes/a/a.obj", Kind::AssetMesh),
            ("litspheres/a.obj", Kind::Other),
            ("costumes/a/a.mhclo", Kind::Unlisted),
            ("poses/a.mhp", Kind::Unlisted),
            ("targets/macrodetails/a.target", Kind::Target),
            ("custom/mine/a.target", Kind::Target),
            ("custom/a.TARGET", Kind::Other),
            ("targets/a.target.gz", Kind::Other),
            ("clothes/a/a.target", Kind::Target),
            ("targets/a.TARGET", Kind::Target),
            ("modifiers/modeling_modifiers.json", Kind::ModifierFile),
            (
                "modifiers/modeling_modifiers_desc.json",
                Kind::ModifierTexts,
            ),
            ("modifiers/modeling_sliders.json", Kind::ModifierSliders),
            (
                "modifiers/mh_1-0_modifier_mapping.csv",
                Kind::ModifierMapping,
            ),
            ("modifiers/old/modeling_modifiers.json", Kind::Json),
            ("poseunits/face-poseunits.json", Kind::FaceUnits),
            ("languages/german.json", Kind::Language),
            ("rigs/default.mhskel", Kind::Skeleton),
            ("rigs/default_weights.mhw", Kind::Weights),
            ("hair/a/a.mhw", Kind::AssetWeights),
            ("expressions/a.mhpose", Kind::Pose),
            ("poses/a.bvh", Kind::Motion),
            ("clothes/a/a.mhpxy", Kind::Packed),
            ("skins/a.mhmat", Kind::Material),
            ("skins/a.thumb", Kind::Image),
            ("uvs/a.mhuv", Kind::UvMap),
            ("shaders/glsl/a_vertex_shader.txt", Kind::ShaderSource),
            ("clothes/a/a_fragment_shader.txt", Kind::ShaderSource),
            ("clothes/a/a_shader.txt", Kind::Other),
        ] {
            let found = LAYOUT.use_of(path);
            assert_eq!(
                (found.kind, found.owner.as_deref()),
                (kind, Some(HM08)),
                "{path}"
            );
        }
        assert_eq!(LAYOUT.use_of("targets.npz").owner, None);
    }

    #[test]
    fn a_path_in_a_library_knows_where_its_root_would_be() {
        assert_eq!(
            LAYOUT
                .roots_above("v1py3/data/hair/bob01/bob01.mhclo")
                .next(),
            Some("v1py3/data")
        );
        assert_eq!(
            LAYOUT.roots_above("v1py3/data/proxymeshes/a").next(),
            Some("v1py3/data")
        );
        assert_eq!(LAYOUT.roots_above("v1py3/data/proxy/a").next(), None);
        assert_eq!(
            LAYOUT.roots_above("u/targets/custom").collect::<Vec<_>>(),
            ["u/targets", "u"]
        );
    }

    #[test]
    fn assets_in_a_library_are_a_sign_and_those_below_a_base_mesh_are_none() {
        for (path, root) in [
            ("pack/clothes/hat/hat.mhclo", Some("pack")),
            ("hair/bob/bob.mhclo", Some("")),
            ("clothes/hm08/hat/hat.mhclo", None),
            ("clothes/hm08/hat.mhclo", None),
            ("clothes/hat.mhclo", Some("")),
            ("clothes/sets/hat/hat.mhclo", None),
            ("shop/hat/hat.mhclo", None),
            ("pack/skins/tan.mhmat", Some("pack")),
            ("pack/skins/tan/tan.mhmat", Some("pack")),
            ("pack/skins/hm08/tan.mhmat", None),
            ("pack/poses/walk.bvh", None),
            ("pack/poses/walk.meta", Some("pack")),
        ] {
            assert_eq!(
                LAYOUT
                    .sign(path, &Listing::of([path], []))
                    .map(|(root, _)| root),
                root,
                "{path}"
            );
        }
    }

    #[test]
    fn libraries_list_what_is_hidden() {
        for (path, is_read) in [
            ("v1py3/data/skins/._copper.mhmat", true),
            ("clothes/a/.#a.mhclo", true),
            ("clothes/a/._a.obj", false),
            ("clothes/.git/a.mhclo", false),
            ("materials/._a.mhmat", false),
        ] {
            assert_eq!(
                super::super::is_read_though_hidden("assets", path, false),
                is_read,
                "{path}"
            );
        }
    }

    #[test]
    fn archives_are_listed_where_something_is_worn() {
        for (rel, library) in [
            ("clothes/a/b/x.mhpxy", Some("clothes")),
            ("proxymeshes/a/a.mhpxy", Some("proxymeshes")),
            ("3dobjs/a7_converter.mhpxy", None),
            ("skins/a.mhpxy", None),
            ("hair/a/a.npz", None),
            ("x.mhpxy", None),
        ] {
            assert_eq!(archive_library_of(rel), library, "{rel}");
        }
    }

    #[test]
    fn libraries_list_at_any_depth() {
        for (rel, library) in [
            ("clothes/a/b/c/x.mhclo", Some("clothes")),
            ("clothes/x.MHCLO", Some("clothes")),
            ("proxymeshes/a/a.mhclo", None),
            ("skins/a.mhmat", Some("skins")),
            ("clothes/a/a.mhmat", None),
            ("poses/a.bvh", Some("poses")),
            ("poses/a.meta", None),
            ("x.mhclo", None),
        ] {
            assert_eq!(library_of(rel), library, "{rel}");
        }
    }
}
