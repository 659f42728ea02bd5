//! MPFB: one base mesh, packed targets, sliders in a catalogue
//! (`docs/loaders/mpfb/folders.md#roots`).

pub(crate) mod importer;
mod version;

use super::super::listing::{Listing, at};
use super::super::{Candidate, Kind};
use super::{
    CLOTHES, HM08, HiddenPath, LIBRARIES, Layout, Role, Sign, Single, WORN, near, worn_shelf,
};
use mhlint_diag::Application;
use mhlint_source::{extension, first_name, folder_and_name};

pub(super) static LAYOUT: Layout = Layout {
    application: Application::Mpfb,
    shape: "targets/target.json",
    depth: 3,
    folders: &[
        &[
            "targets",
            "3dobjs",
            "mesh_metadata",
            "ink_layers",
            "uv_layers",
            "packs",
            "custom",
            "node_trees",
            "settings",
        ],
        &LIBRARIES,
        &WORN,
    ],
    sign,
    weigh,
    version: version::version,
    is_of_user: |parts| matches!(parts, ["rigs", _]),
    // What it shares with others is for these where nobody asks.
    is_of_others: |extension, _| !matches!(extension, "json" | "gz"),
    list_by_content: |extension, says| {
        (extension == "json" && STORED_POSE.iter().any(|word| says(word))).then_some("poses")
    },
    place,
    loose_place,
    shelf,
    refuses: Some(importer::refusal),
    beside: &["config", "models"],
    is_telling: |kind| {
        use Kind::{EyeSettings, HumanPreset, ImporterPreset, MakeupPreset, SkinSettings};
        matches!(
            kind,
            HumanPreset | ImporterPreset | MakeupPreset | EyeSettings | SkinSettings
        )
    },
    above_data: |parts| match parts {
        [.., "config", name] if of_config(name) == Some(Kind::HumanPreset) => Some(2),
        _ => None,
    },
    tells_without_data: |listing, file| {
        SAVED_CHARACTER
            .iter()
            .all(|words| listing.says(file, words))
    },
    shares_roots_of: Some(Application::Makehuman1),
    has_second_user: true,
    role,
    reads_hidden,
    is_folder: |rel, _| FOLDERS.contains(&rel) || WORN.contains(&rel),
    single: |rel| is_skin_picture(rel).then_some(Single::SkinPicture),
    ..Layout::PLAIN
};

fn is_skin_picture(rel: &str) -> bool {
    let map = |name: &str| {
        name.strip_prefix("mpfb_")?
            .strip_suffix(".jpg")
            .map(|name| SKIN_MAPS.contains(&name))
    };
    let name = rel.strip_prefix("textures/").unwrap_or_default();
    name == "sss.png" || map(name) == Some(true)
}

/// What a saved character says: of each row one word. Genes of other programs have a phenotype,
/// too.
pub const SAVED_CHARACTER: [&[&str]; 2] = [
    &["\"phenotype\""],
    &[
        "\"rig\"",
        "\"skin_mhmat\"",
        "\"skin_material_type\"",
        "\"targets\"",
        "\"race\"",
    ],
];

/// What a pose of MPFB says; recordings of other programs have some of it.
pub const STORED_POSE: [&str; 3] = [
    "\"skeleton_type\"",
    "\"bone_rotations\"",
    "\"bone_translations\"",
];

/// A node asks for each of these by its name (`docs/loaders/mpfb/materials.md#value-maps`).
pub const SKIN_MAPS: [&str; 10] = [
    "aureolae",
    "crotch",
    "ears",
    "eyelids",
    "face",
    "fingernails",
    "genitals",
    "inside-mouth",
    "lips",
    "toenails",
];

/// Folders that are listed.
const FOLDERS: [&str; 9] = [
    "targets",
    "targets/custom",
    "custom",
    "expressions",
    "skins",
    "proxymeshes",
    "poses",
    "packs",
    "ink_layers",
];

fn sign(parts: &[&str]) -> Option<(Sign, usize)> {
    match parts {
        [.., "targets", "target.json"] | [.., "mesh_metadata", _] => Some((Sign::Strong, 2)),
        [.., "targets", "macrodetails", "macro.json"] => Some((Sign::Strong, 3)),
        [.., "rigs", "standard" | "rigify", name] if name.starts_with("rig.") => {
            Some((Sign::Strong, 3))
        }
        [.., "packs", name] if extension(name) == "json" => Some((Sign::Weak, 2)),
        [.., "ink_layers", name] if extension(name) == "json" => Some((Sign::Weak, 2)),
        [.., "uv_layers", name] if name.ends_with(".json.gz") => Some((Sign::Weak, 2)),
        // A user's folder: nobody else reads packed targets, or has expressions in JSON.
        [.., "targets", _, name] if name.ends_with(".target.gz") => Some((Sign::OfUser, 3)),
        [.., "targets", "custom", name] if Kind::of_target(name).is_some() => {
            Some((Sign::OfUser, 3))
        }
        [.., "targets", _, name] if Kind::of_target(name).is_some() => Some((Sign::Weak, 3)),
        [.., "targets" | "custom", name] if Kind::of_target(name).is_some() => {
            Some((Sign::Faint, 2))
        }
        [.., "expressions", name] if extension(name) == "json" => Some((Sign::Faint, 2)),
        [.., "rigs", name] if extension(name) == "json" => Some((Sign::OfUser, 2)),
        [.., "poses", _, name] if extension(name) == "json" => Some((Sign::OfUser, 3)),
        _ => None,
    }
}

/// A rig of a user says by which bones it is known
/// (`docs/loaders/mpfb/custom-rigs.md#listing-custom-rigs`), and a pack whose assets those in it
/// are (`docs/loaders/mpfb/libraries.md#the-list-of-a-pack`): with that no other application is
/// meant.
fn weigh(listing: &Listing<'_>, root: &str, file: &str, sign: Sign) -> Option<Sign> {
    let rel = file
        .get(root.len()..)
        .unwrap_or_default()
        .trim_start_matches('/');
    let has = |folder: &str| listing.below(&at(root, folder)).next().is_some();
    match rel.split_once('/')? {
        // Other programs have lists of this name.
        ("targets", "target.json") => {
            let is_own = || {
                ["mesh_metadata", "rigs", "targets/macrodetails", "3dobjs"]
                    .into_iter()
                    .any(has)
            };
            (listing.says(file, &["\"categories\""])
                || !listing.says(file, &["{", "["])
                || is_own())
            .then_some(sign)
        }
        ("rigs", name) if !name.contains('/') => listing
            .says(file, &["\"identifying_bones\""])
            .then_some(sign),
        ("poses", _) => listing.says(file, &STORED_POSE).then_some(sign),
        ("packs", _) if listing.says(file, &["\"author\"", "\"license\"", "\"category\""]) => {
            Some(Sign::OfUser)
        }
        _ => Some(sign),
    }
}

/// Every target of a user is listed, whatever it and the folders above it are called: one below
/// `.git` stops the add-on (`docs/loaders/mpfb/sliders.md#names-of-user-targets`).
fn reads_hidden(path: &HiddenPath<'_>) -> bool {
    let is_target = path.is_folder || Kind::of_target(path.name).is_some();
    path.visible
        .iter()
        .any(|part| matches!(*part, "targets" | "custom"))
        && is_target
}

/// Parts of the add-on that no user has together.
const MUCH: usize = 3;

/// What the add-on has for itself: it looks for it nowhere else. A single copy of that among the
/// assets of a user makes no data of the add-on.
fn role(below: &[Candidate<'_>]) -> Role {
    const OWN: [Kind; 3] = [Kind::TargetCatalog, Kind::MacroParts, Kind::BaseMesh];
    const FOLDERS: [&str; 4] = [
        "mesh_metadata/",
        "rigs/standard/",
        "node_trees/",
        "settings/",
    ];
    let has = |kind: &&Kind| {
        below
            .iter()
            .any(|one| one.kind_in(Application::Mpfb) == **kind)
    };
    let has_folder = |folder: &&&str| {
        below
            .iter()
            .any(|one| !one.is_loose && one.rel.starts_with(**folder))
    };
    let is_of_user = |one: &Candidate<'_>| {
        let top = first_name(&one.rel);
        WORN.contains(&top) || matches!(top, "custom" | "skins" | "proxymeshes" | "packs")
    };
    let (files, folders) = (
        OWN.iter().filter(has).count(),
        FOLDERS.iter().filter(has_folder).count(),
    );
    let is_of_addon = match (files, files + folders) {
        (_, MUCH..) | (2.., _) => true,
        (1, _) => !below.iter().any(is_of_user),
        _ => false,
    };
    // What is copied over the data of a user is both.
    match (is_of_addon, below.iter().any(|one| one.is_loose)) {
        (true, false) => Role::System,
        (true, true) => Role::Both,
        (false, _) => Role::User,
    }
}

/// `macro.json` shares nothing but its name with that of MakeHuman 2.
fn place<'p>(parts: &[&'p str]) -> (Kind, Option<&'p str>) {
    let kind = match parts {
        ["3dobjs", "base.obj"] => Kind::BaseMesh,
        ["targets", "target.json"] => Kind::TargetCatalog,
        ["targets", "macrodetails", "macro.json"] => Kind::MacroParts,
        ["expressions", .., file] if extension(file) == "json" => Kind::FaceExpression,
        ["mesh_metadata", "basemesh_vertex_groups.json"] => Kind::VertexGroups,
        ["mesh_metadata", "hm08_config.json"] => Kind::BodyDimensions,
        ["mesh_metadata", "proxy_corrective.json"] => Kind::ProxyCorrections,
        ["mesh_metadata", "hm08.mirror"] => Kind::MirrorTable,
        ["rigs", folders @ .., file] if extension(file) == "json" => of_rigs(folders, file),
        [.., file] if extension(file) == "mpfbskel" => Kind::SubRig,
        ["mesh_metadata", "basemesh_face_to_vertex_table.json.gz"] => Kind::FaceTable,
        ["mesh_metadata", "basemesh_vertex_to_face_table.json.gz"] => Kind::VertexTable,
        ["poses", .., file] if extension(file) == "json" => Kind::StoredPose,
        ["uv_layers", file] if file.ends_with(".json.gz") => Kind::UvLayer,
        ["ink_layers", .., file] if extension(file) == "json" => Kind::InkLayer,
        // Every name with the suffix in it counts, and folders in it are not looked into
        // (`docs/loaders/mpfb/libraries.md#the-list-of-a-pack`).
        ["packs", file] if file.contains(".json") => Kind::PackMetadata,
        ["node_trees", file] if extension(file) == "json" => Kind::NodeTree,
        ["config", file] if extension(file).eq_ignore_ascii_case("json") => {
            of_config(file).unwrap_or(Kind::ConfigJson)
        }
        ["config", .., file] if extension(file).eq_ignore_ascii_case("json") => Kind::ConfigJson,
        // A saved character where nobody looks for it.
        [file] if file.starts_with("human.") && extension(file) == "json" => Kind::ConfigJson,
        ["config" | "settings", file] => of_config(file).unwrap_or(Kind::by_extension(file)),
        ["targets", "_images", file] if extension(file) == "png" => Kind::TargetIcon,
        [.., file] if file.ends_with(".ptarget") => Kind::PartTarget,
        [.., file] if file.ends_with(".ptarget.gz") => Kind::PackedPartTarget,
        ["targets" | "custom", .., file] => {
            Kind::of_target(file).unwrap_or(Kind::by_extension(file))
        }
        [.., file] => Kind::by_extension(file),
        [] => Kind::Other,
    };
    (kind, (parts.len() > 1).then_some(HM08))
}

/// What a JSON is in folders below `rigs/`: MPFB has its own in `standard/` and `rigify/`, users
/// theirs at the top (`docs/loaders/mpfb/rigs.md#where-rigs-lie`,
/// `docs/loaders/mpfb/custom-rigs.md#listing-custom-rigs`). In any other folder it is one of a user
/// where nobody looks.
fn of_rigs(folders: &[&str], file: &str) -> Kind {
    match folders {
        [] | [_] if file.starts_with("weights.") => Kind::Weights,
        ["standard" | "rigify"] if file.starts_with("rig.") => Kind::Rig,
        ["standard" | "rigify", ..] => Kind::Json,
        _ => Kind::CustomRig,
    }
}

/// What the beginning of the name of a file in `config/` or `settings/` makes of it.
fn of_config(file: &str) -> Option<Kind> {
    const KINDS: [(&str, Kind); 6] = [
        ("human.", Kind::HumanPreset),
        ("importer_presets.", Kind::ImporterPreset),
        ("makeup.", Kind::MakeupPreset),
        ("randomization.", Kind::RandomizationPreset),
        ("eye_settings.", Kind::EyeSettings),
        ("enhanced_settings.", Kind::SkinSettings),
    ];
    let row = KINDS.iter().find(|(prefix, _)| file.starts_with(prefix));
    // Between the two points there is a name.
    row.filter(|(prefix, _)| file.len() > prefix.len() + ".json".len() && extension(file) == "json")
        .map(|(_, kind)| *kind)
}

/// The library of a loose file.
fn shelf(extension: &str, above: &[&str]) -> Option<&'static str> {
    match extension {
        "mhclo" => Some(worn_shelf(above)),
        "proxy" => Some("proxymeshes"),
        "bvh" => Some("poses"),
        "mhmat" => Some("skins"),
        "json" if above.contains(&"poses") => Some("poses"),
        _ => None,
    }
}

/// What has no library: targets and rigs as their author would put them, and a model, which is
/// imported from wherever it is.
fn loose_place(path: &str, _: Option<&str>) -> Option<String> {
    let (folder, name) = folder_and_name(path);
    let near = near(folder);
    match extension(name) {
        "json" if of_config(name) == Some(Kind::HumanPreset) => Some(format!("config/{name}")),
        _ if Kind::of_target(name).is_some() => Some(format!("custom/{near}/{name}")),
        "json" => Some(format!("rigs/{name}")),
        "mhw" => Some(format!("{CLOTHES}/{near}/{name}")),
        "mhm" => Some(format!("models/{near}/{name}")),
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
            ("targets/target.json", Kind::TargetCatalog),
            ("targets/macrodetails/macro.json", Kind::MacroParts),
            ("targets/nose/nose-up.target.gz", Kind::PackedTarget),
            ("targets/custom/a.target", Kind::Target),
            ("custom/a/b.target.gz", Kind::PackedTarget),
            ("custom/hat.ptarget", Kind::PartTarget),
            ("clothes/hat/hat.ptarget.gz", Kind::PackedPartTarget),
            ("targets/_images/l-ear-up.png", Kind::TargetIcon),
            ("targets/nose/a.TARGET", Kind::Other),
            ("rigs/standard/rig.default.json", Kind::Rig),
            ("rigs/standard/weights.default.json", Kind::Weights),
            ("rigs/stick.json", Kind::CustomRig),
            ("rigs/weights.stick.json", Kind::Weights),
            ("rigs/mine/stick.json", Kind::CustomRig),
            ("hair/tail/tail.mpfbskel", Kind::SubRig),
            (
                "mesh_metadata/basemesh_vertex_groups.json",
                Kind::VertexGroups,
            ),
            (
                "mesh_metadata/proxy_corrective.json",
                Kind::ProxyCorrections,
            ),
            ("mesh_metadata/hm08.mirror", Kind::MirrorTable),
            ("clothes/a/a.mhclo", Kind::Clothes),
            ("clothes/a/a.mhw", Kind::AssetWeights),
            ("skins/a/a.mhmat", Kind::Material),
            ("uv_layers/a.json.gz", Kind::UvLayer),
            ("uv_layers/a/b.json.gz", Kind::Other),
            ("poses/default_fk/t-pose.json", Kind::StoredPose),
            (
                "mesh_metadata/basemesh_vertex_to_face_table.json.gz",
                Kind::VertexTable,
            ),
            ("expressions/a/b.json", Kind::FaceExpression),
            ("config/human.joe.json", Kind::HumanPreset),
            ("config/human..json", Kind::ConfigJson),
            ("config/x.json", Kind::ConfigJson),
            ("settings/eye_settings.default.json", Kind::EyeSettings),
            ("node_trees/makeskin.json", Kind::NodeTree),
            ("ink_layers/a/b.json", Kind::InkLayer),
            ("packs/a.json.bak", Kind::PackMetadata),
            ("packs/a/b.json", Kind::Json),
        ] {
            let found = LAYOUT.use_of(path);
            assert_eq!(
                (found.kind, found.owner.as_deref()),
                (kind, Some(HM08)),
                "{path}"
            );
        }
    }
}
