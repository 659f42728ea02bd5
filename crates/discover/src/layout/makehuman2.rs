//! MakeHuman 2: folders of assets with a folder for each base mesh in them
//! (`docs/loaders/makehuman2/folders.md#lookup-order`).

pub(crate) mod importer;
pub(crate) mod opened;
mod version;

use std::collections::BTreeSet;

use super::super::listing::{Listing, at};
use super::super::{Candidate, Kind};
use super::{HiddenPath, Holds, Layout, Role, Says, Sign, WORN, first_of, near, worn_shelf};
use mhlint_diag::Application;
use mhlint_source::{extension, first_name, folder_and_name};

pub(super) static LAYOUT: Layout = Layout {
    application: Application::Makehuman2,
    shape: "base/<name>/base.json",
    depth: 5,
    folders: &[&WORN, &SCANNED, &NOT_SCANNED],
    sign,
    weigh,
    version: version::version,
    is_release: |_| false,
    is_of_user: |_| false,
    is_of_others,
    list_by_content: |_, _| None,
    place,
    reads_hidden,
    loose_place,
    import: Some(importer::import),
    unpacks_singly: false,
    refuses: None,
    is_dangerous: |_| false,
    shelf,
    beside: &[],
    is_telling: |_| false,
    above_data: |_| None,
    tells_without_data: |_, _| false,
    everywhere: None,
    shares_roots_of: None,
    has_second_user: false,
    has_bases: true,
    only_base: None,
    joint: None,
    // Weights are looked for there and nowhere below
    // (`docs/loaders/makehuman2/skeletons.md#keys-of-a-skeleton`).
    flat: "rigs",
    role,
    is_system_of_two,
    stands_alone,
    opens: opened::opens,
    scans: opened::is_scanned,
    single: opened::single,
    is_folder: opened::is_folder,
    misnamed: opened::misnamed,
};

/// Folders that the asset scan visits besides those of what is worn, with one level of folders
/// below the base mesh.
const SCANNED: [&str; 5] = ["proxy", "rigs", "poses", "expressions", "models"];

fn is_scanned_folder(folder: &str) -> bool {
    WORN.contains(&folder) || SCANNED.contains(&folder)
}

/// Whether the assets of a folder are chosen by labels.
fn is_filtered(folder: &str) -> bool {
    is_scanned_folder(folder) || folder == "skins"
}

/// Folders with a folder for each base mesh that the scan leaves out.
const NOT_SCANNED: [&str; 4] = ["target", "contarget", "base", "skins"];

/// Folder of loose files for no known base mesh, which are checked alone; no application has one of
/// this name.
const ALONE: &str = "(loose)";

fn sign(parts: &[&str]) -> Option<(Sign, usize)> {
    match parts {
        [.., "base", _, "base.json" | "base.obj" | "base.mhbin"] => Some((Sign::Strong, 3)),
        [
            ..,
            "target" | "contarget",
            base,
            "macro.json" | "modelling.json" | "target_cat.json" | "compressedtargets.npz",
            // The folder of macro targets that MPFB has, below a misspelt `targets`.
        ] if *base != "macrodetails" => Some((Sign::Strong, 3)),
        [.., "rigs", _, name] if extension(name) == "mhskel" => Some((Sign::Weak, 3)),
        [.., "dbcache", _, "repository.db"] => Some((Sign::Weak, 3)),
        // Below one of its own base meshes: in a pack or of a user there may be nothing else.
        [.., category, base, _, _, _] | [.., category, base, _, _] | [.., category, base, _]
            if is_filtered(category) && *base != MATERIALS =>
        {
            let levels = parts
                .iter()
                .rposition(|part| part == category)
                .map_or(0, |at| parts.len() - at);
            (Kind::by_extension(parts.last().copied().unwrap_or_default()) != Kind::Other)
                .then_some((Sign::Faint, levels))
        }
        [.., name] if extension(name) == "target" => target_below(parts),
        _ => None,
    }
}

/// A folder is that of a base mesh if the run knows one of its name, or something else for it lies
/// in its place (`docs/loaders/makehuman2/folders.md#target-folders`): other programs have folders
/// called `base` and `rigs`, too.
fn weigh(listing: &Listing<'_>, root: &str, file: &str, sign: Sign) -> Option<Sign> {
    let rel = file
        .get(root.len()..)
        .unwrap_or_default()
        .trim_start_matches('/');
    let (folder, rest) = rel.split_once('/')?;
    let name = first_name(rest);
    let has = |folder: &str| {
        listing
            .below(&at(root, &format!("{folder}/{name}")))
            .next()
            .is_some()
    };
    let is_base = match folder {
        "base" => {
            ["target", "contarget", "rigs"].into_iter().any(has) || has_settings(listing, file)
        }
        "rigs" => has("base") || is_in_many(listing, root, name),
        _ if is_filtered(folder) => is_in_many(listing, root, name),
        _ => true,
    };
    (is_base || listing.knows_base(name)).then_some(sign)
}

/// Whether three of the libraries have a folder of this name: it is that of a base mesh.
fn is_in_many(listing: &Listing<'_>, root: &str, name: &str) -> bool {
    let has = |folder: &&&str| {
        listing
            .below(&at(root, &format!("{folder}/{name}")))
            .next()
            .is_some()
    };
    name != MATERIALS
        && WORN
            .iter()
            .chain(&SCANNED)
            .chain(&["skins", "target"])
            .filter(has)
            .count()
            >= 3
}

/// Materials that several assets share lie in folders of this name.
const MATERIALS: &str = "materials";

/// Whether the folder with this file has a `base.json` that can be that of a base mesh.
fn has_settings(listing: &Listing<'_>, file: &str) -> bool {
    const KEYS: [&str; 5] = [
        "\"visible groups\"",
        "\"target-opposites\"",
        "\"pose-skeleton\"",
        "\"modifier-presets\"",
        "\"equipment\"",
    ];
    let (folder, _) = folder_and_name(file);
    let settings = at(folder, "base.json");
    let has_mesh = || {
        ["base.obj", "base.mhbin"]
            .iter()
            .any(|name| listing.has(&at(folder, name)))
    };
    // Damaged ones may hold anything but the sound settings of another program.
    listing.has(&settings)
        && (has_mesh() || !listing.says(&settings, &["{"]) || listing.says(&settings, &KEYS))
}

/// A target somewhere below `target/<base>/` or `contarget/<base>/`.
fn target_below(parts: &[&str]) -> Option<(Sign, usize)> {
    let at = parts.iter().rposition(|part| is_target_folder(part))?;
    let levels = parts.len() - at;
    (levels >= 3).then_some((Sign::Weak, levels))
}

fn place<'p>(parts: &[&'p str]) -> (Kind, Option<&'p str>) {
    let kind = match parts {
        ["base", _, "base.json"] => Kind::BaseJson,
        ["base", _, "base.obj"] => Kind::BaseMesh,
        ["base", _, "base.mhbin"] => Kind::MeshArchive,
        ["base", _, "geometry.json"] => Kind::Geometry,
        ["base", _, "body-poses.json" | "face-poses.json"] => Kind::PoseUnits,
        ["makehuman2_version.json"] => Kind::Version,
        ["shaders", "shader.json"] => Kind::Shaders,
        [category, _, "selection_filter.json"] if is_filtered(category) => Kind::SelectionFilter,
        ["rigs", .., file] if extension(file) == "mhw" => Kind::Weights,
        ["target" | "contarget", _, rest @ ..] if !rest.is_empty() => in_target_folder(rest),
        [ALONE, .., file] if extension(file) == "target" => Kind::Target,
        [.., file] => Kind::by_extension(file),
        [] => Kind::Other,
    };
    let owner = match parts {
        [folder, base, _, ..] if *folder != ALONE => Some(*base),
        _ => None,
    };
    (kind, owner)
}

fn in_target_folder(rest: &[&str]) -> Kind {
    match rest {
        ["macro.json"] => Kind::MacroJson,
        ["modelling.json"] => Kind::ModellingJson,
        ["target_cat.json"] => Kind::TargetCategories,
        ["compressedtargets.npz"] => Kind::TargetArchive,
        ["icons", .., file] if extension(file) == "png" => Kind::TargetIcon,
        [.., file] => Kind::of_target(file).unwrap_or(Kind::by_extension(file)),
        [] => Kind::Other,
    }
}

fn is_target_folder(folder: &str) -> bool {
    matches!(folder, "target" | "contarget")
}

/// Every `*.target` below a target folder is opened, whatever it and the folders above it are
/// called, `.git` as well (`docs/loaders/makehuman2/targets.md#the-archive-at-the-start`).
fn reads_hidden(path: &HiddenPath<'_>) -> bool {
    // A name for the base mesh stands between.
    let above = path
        .visible
        .split_last()
        .map_or(path.visible, |(_, above)| above);
    let is_target = path.is_folder || extension(path.name) == "target";
    above.iter().any(|part| is_target_folder(part)) && is_target || is_scanned_though_hidden(path)
}

/// The asset scan takes files by their suffix, hidden or not; macOS leaves such beside each of its
/// own (`docs/loaders/makehuman2/libraries.md#scan`).
fn is_scanned_though_hidden(path: &HiddenPath<'_>) -> bool {
    let Some(at) = path
        .visible
        .iter()
        .rposition(|part| is_scanned_folder(part))
    else {
        return false;
    };
    let below = path.visible.get(at..).unwrap_or_default().join("/");
    !path.is_folder
        && path.name.starts_with('.')
        && opened::is_scanned(&format!("{below}/{}", path.name))
}

/// The list that shows a loose file. Poses of the face are by far the most of what is in `.mhpose`.
fn shelf(extension: &str, above: &[&str]) -> Option<&'static str> {
    match extension {
        "mhclo" => Some(worn_shelf(above)),
        "proxy" => Some("proxy"),
        "mhskel" => Some("rigs"),
        "mhpose" => first_of(&["poses", "expressions"], above).or(Some("expressions")),
        "bvh" => Some("poses"),
        "mhm" => Some("models"),
        "mhmat" => Some("skins"),
        _ => None,
    }
}

/// A loose target, skeleton or weights file is checked as if its owner had already copied it into a
/// user folder; without a base mesh to copy it to, it is checked alone.
fn loose_place(path: &str, base: Option<&str>) -> Option<String> {
    let (folder, file) = folder_and_name(path);
    let (_, extension) = file.rsplit_once('.')?;
    // Targets and skeletons are looked for one folder below the base; deeper ones would be out of
    // sight.
    let near = near(folder);
    let place = match (extension, base) {
        ("target", Some(base)) => format!("target/{base}/{near}/{file}"),
        ("mhskel" | "mhw", Some(base)) if folder.is_empty() => format!("rigs/{base}/{file}"),
        ("mhskel" | "mhw", Some(base)) => format!("rigs/{base}/{near}/{file}"),
        ("target" | "mhskel" | "mhw", None) => format!("{ALONE}/{path}"),
        _ => return None,
    };
    Some(place)
}

/// Models say which program wrote them.
fn is_of_others(extension: &str, says: Says<'_>) -> bool {
    extension == "mhm" && (says("version v1.") || says("Written by MakeHuman 1"))
}

/// What the program opens at start nobody else has.
fn is_programs(one: &Candidate<'_>) -> bool {
    matches!(
        one.kind_in(LAYOUT.application),
        Kind::Version | Kind::Shaders
    )
}

/// Users have base meshes, too, and macros by mistake: two of what the program has are its data.
fn stands_alone(below: &[Candidate<'_>], is_base: Holds<'_>) -> bool {
    let of_kind = |wanted: fn(Kind) -> bool| {
        below
            .iter()
            .filter(move |one| wanted(one.kind_in(LAYOUT.application)))
    };
    let mut bases = of_kind(Kind::is_base_mesh)
        .filter_map(Candidate::owner)
        .peekable();
    let has_bases = bases.peek().is_some() && bases.all(is_base);
    let has_macros =
        of_kind(|kind| kind == Kind::MacroJson).any(|one| one.rel.starts_with("target/"));
    let has_shaders = below.iter().any(|one| one.rel.starts_with("shaders/"));
    below.iter().any(is_programs)
        || usize::from(has_bases) + usize::from(has_macros) + usize::from(has_shaders) >= 2
}

/// Base meshes make a root the system, or both with `contarget/`, which is read in the user's
/// folder only (`docs/loaders/makehuman2/folders.md#target-folders`). Capitals make no difference:
/// which part is meant is clear.
fn role(below: &[Candidate<'_>]) -> Role {
    let is_override = |one: &Candidate<'_>| match one.rel.split('/').collect::<Vec<_>>().as_slice()
    {
        [folder, _, _, ..] => folder.eq_ignore_ascii_case("contarget"),
        _ => false,
    };
    let has_base = below.iter().any(is_base)
        || has_packed_base(below)
        || below.iter().any(is_programs)
        || has_indexes(below);
    match (has_base, below.iter().any(is_override)) {
        (true, false) => Role::System,
        (true, true) => Role::Both,
        (false, _) => Role::User,
    }
}

fn is_base(one: &Candidate<'_>) -> bool {
    matches!(
        one.kind_in(LAYOUT.application),
        Kind::BaseJson | Kind::BaseMesh
    ) || matches!(
        one.rel.split('/').collect::<Vec<_>>().as_slice(),
        [folder, _, "base.json" | "base.obj"] if folder.eq_ignore_ascii_case("base")
    )
}

/// A packed mesh alone may be a user's, over the system's base. With macros in `target/`, where no
/// user has any, it is the system's.
fn has_packed_base(below: &[Candidate<'_>]) -> bool {
    let of_kind = |kind| {
        below
            .iter()
            .filter(move |one| one.kind_in(LAYOUT.application) == kind)
    };
    let macros = of_kind(Kind::MacroJson).filter(|one| one.rel.starts_with("target/"));
    let with_macros: BTreeSet<Option<&str>> = macros.map(Candidate::owner).collect();
    of_kind(Kind::MeshArchive).any(|one| with_macros.contains(&one.owner()))
}

/// Whether a base mesh has macros and sliders in `target/`, and a skeleton or shaders: all of a
/// program's but the mesh.
fn has_indexes(below: &[Candidate<'_>]) -> bool {
    let has = |start: &str, end: &str| {
        below
            .iter()
            .any(|one| one.rel.starts_with(start) && one.rel.ends_with(end))
    };
    let is_more = || has("rigs/", "/default.mhskel") || has("shaders/", "");
    has("target/", "/macro.json") && has("target/", "/modelling.json") && is_more()
}

/// Beside another root, the one whose bases have sliders or macros in `target/` is the system, and
/// its `contarget/` counts for nothing.
fn is_system_of_two(below: &[Candidate<'_>]) -> bool {
    let bases: BTreeSet<Option<&str>> = below
        .iter()
        .filter(|one| is_base(one))
        .map(|one| one.owner())
        .collect();
    let has_sliders = |one: &&Candidate<'_>| {
        matches!(
            one.kind_in(LAYOUT.application),
            Kind::MacroJson | Kind::ModellingJson
        ) && one.rel.starts_with("target/")
    };
    below
        .iter()
        .filter(has_sliders)
        .any(|one| bases.contains(&one.owner()))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn kind_and_base(path: &str) -> (Kind, Option<String>) {
        let found = LAYOUT.use_of(path);
        (found.kind, found.owner)
    }

    #[test]
    fn place_decides_the_kind() {
        for (path, kind, base) in [
            ("base/hm08/base.json", Kind::BaseJson, Some("hm08")),
            ("base/hm08/base.obj", Kind::BaseMesh, Some("hm08")),
            ("base/hm08/base.mhbin", Kind::MeshArchive, Some("hm08")),
            ("base/hm08/helper.mhbin", Kind::Packed, Some("hm08")),
            ("base/hm08/helper.obj", Kind::AssetMesh, Some("hm08")),
            ("target/hm08/macro.json", Kind::MacroJson, Some("hm08")),
            ("contarget/x/a/b/c.target", Kind::Target, Some("x")),
            (
                "target/hm08/a/c.target.gz",
                Kind::PackedTarget,
                Some("hm08"),
            ),
            ("target/hm08/icons/a.png", Kind::TargetIcon, Some("hm08")),
            ("target/hm08/a/X.TARGET", Kind::Other, Some("hm08")),
            ("rigs/hm08/sub/a.mhskel", Kind::Skeleton, Some("hm08")),
            ("rigs/hm08/a.mhw", Kind::Weights, Some("hm08")),
            ("clothes/hm08/x/x.mhw", Kind::AssetWeights, Some("hm08")),
            ("clothes/hm08/x/macro.json", Kind::Json, Some("hm08")),
            ("clothes/hm08/x/x.target", Kind::Other, Some("hm08")),
            ("clothes/hm08/x/x.mhbin", Kind::Packed, Some("hm08")),
            ("target/hm08", Kind::Other, None),
            ("makehuman2_version.json", Kind::Version, None),
            ("shaders/shader.json", Kind::Shaders, None),
            ("shaders/hm08/shader.json", Kind::Json, Some("hm08")),
            ("base/hm08/face-poses.json", Kind::PoseUnits, Some("hm08")),
            (
                "skins/hm08/selection_filter.json",
                Kind::SelectionFilter,
                Some("hm08"),
            ),
            (
                "skins/hm08/a/selection_filter.json",
                Kind::Json,
                Some("hm08"),
            ),
        ] {
            assert_eq!(
                kind_and_base(path),
                (kind, base.map(str::to_owned)),
                "{path}"
            );
        }
    }

    #[test]
    fn of_what_is_hidden_targets_and_files_of_the_scan_are_read() {
        for (path, is_folder, read) in [
            ("target/b/._a.target", false, true),
            ("data/contarget/b/a/.hidden/c.target", false, true),
            ("data/target/b/.hidden", true, true),
            ("target/b/.DS_Store", false, false),
            ("target/b/.git", true, true),
            ("target/b/.git/a.target", false, true),
            (".git/target/b/a.target", false, false),
            ("target/.cache", true, false),
            (".venv", true, false),
            (".venv/target/b/a.target", false, false),
            ("rigs/b/._a.mhskel", false, true),
            ("data/rigs/b/sub/._a.mhskel", false, true),
            ("data/rigs/b/sub/deep/._a.mhskel", false, false),
            ("rigs/._a.mhskel", false, false),
            ("rigs/b/.hidden", true, false),
            ("rigs/b/.hidden/a.mhskel", false, false),
            ("rigs/b/._a.mhw", false, false),
            ("clothes/b/x/._x.mhclo", false, true),
        ] {
            assert_eq!(LAYOUT.takes(path, 0, is_folder), read, "{path}");
        }
    }

    #[test]
    fn loose_files_are_of_the_kind_their_place_says() {
        for (path, base, kind) in [
            ("a/b/c.target", Some("figure"), Kind::Target),
            ("c.target", None, Kind::Target),
            ("a.mhskel", Some("figure"), Kind::Skeleton),
            ("a/a.mhw", Some("figure"), Kind::Weights),
            ("a/a.mhw", None, Kind::AssetWeights),
        ] {
            let place = (LAYOUT.loose_place)(path, base).unwrap_or_default();
            assert_eq!(
                kind_and_base(&place),
                (kind, base.map(str::to_owned)),
                "{place}"
            );
        }
        assert_eq!((LAYOUT.loose_place)("package.json", None), None);
        assert_eq!(
            (LAYOUT.loose_place)("a/b/c.target", Some("figure")).as_deref(),
            Some("target/figure/a_b/c.target")
        );
    }

    #[test]
    fn a_path_inside_knows_where_its_root_would_be() {
        assert_eq!(LAYOUT.roots_above("data/target/hm08").next(), Some("data"));
        assert_eq!(LAYOUT.roots_above("target").next(), Some(""));
        assert_eq!(LAYOUT.roots_above("src/formats").next(), None);
    }
}
