//! Files without which MPFB does not work, or not as it should
//! (`docs/loaders/mpfb/folders.md#shipped-data`, `docs/loaders/mpfb/base-mesh.md#the-mesh`,
//! `docs/loaders/mpfb/base-mesh.md#vertex-groups`, `docs/loaders/mpfb/base-mesh.md#dimensions`,
//! `docs/loaders/mpfb/materials.md#settings-of-skins`,
//! `docs/loaders/mpfb/materials.md#value-maps`).

use std::collections::BTreeSet;

use super::super::Rule;
use super::super::cause::differing;
use mhlint_diag::{Application::Mpfb, Case, Evidence, Finding, Level};
use mhlint_discover::SKIN_MAPS;
use mhlint_repo::mpfb::lost_rigs;
use mhlint_repo::{Layer, View};
use mhlint_source::file_name;

/// What MPFB opens by name in its own data.
const NEEDED: [(&str, Case); 13] = [
    ("targets/target.json", NO_START),
    ("targets/macrodetails/macro.json", NO_START),
    ("mesh_metadata/basemesh_vertex_groups.json", NO_START),
    ("mesh_metadata/hm08_config.json", NO_DIMENSIONS),
    ("mesh_metadata/hm08.mirror", NO_MIRROR),
    (
        "mesh_metadata/basemesh_face_to_vertex_table.json.gz",
        NO_FACES,
    ),
    (
        "mesh_metadata/basemesh_vertex_to_face_table.json.gz",
        NO_FACES,
    ),
    ("3dobjs/base.obj", NO_BODY),
    (SKIN_SETTINGS, NO_SKIN),
    ("settings/eye_settings.default.json", NO_EYES),
    ("node_trees/makeskin.json", NO_MATERIAL),
    ("node_trees/enhanced_skin.json", NO_MATERIAL),
    ("node_trees/procedural_eyes.json", NO_MATERIAL),
];
pub(super) const SKIN_SETTINGS: &str = "settings/enhanced_settings.default.json";
/// Where the user has a copy of these.
pub(super) const OWN_SKIN_SETTINGS: &str = "config/enhanced_settings.default.json";

const NO_START: Case = &[(
    Mpfb,
    Level::Error,
    "fails while the add-on is imported: MPFB cannot be enabled",
)];
const NO_DIMENSIONS: Case = &[(
    Mpfb,
    Level::Error,
    "fails with an exception after it fits an asset that has a scale: this one is left half-made",
)];
const NO_MIRROR: Case = &[(
    Mpfb,
    Level::Error,
    "fails with an exception when a target is made symmetric",
)];
const NO_FACES: Case = &[(
    Mpfb,
    Level::Error,
    "fails with `FileNotFoundError` when an asset that hides vertices of the body is put on",
)];
const NO_BODY: Case = &[(
    Mpfb,
    Level::Error,
    "starts, and fails with `OSError` at the first character",
)];
const NO_SKIN: Case = &[(
    Mpfb,
    Level::Error,
    "fails with `FileNotFoundError` at the first enhanced skin, after its material was made",
)];
const NO_EYES: Case = &[(
    Mpfb,
    Level::Info,
    "silently makes eyes with the defaults of the shader",
)];
const NO_SKIN_MAP: Case = &[(
    Mpfb,
    Level::Error,
    "fails with `RuntimeError` at each layered skin, which is left half-made: ink layers fail \
        after it",
)];
const NO_SCATTERING: Case = &[(
    Mpfb,
    Level::Warning,
    "makes skins without the map of scattering light, with a message in the log",
)];
const NO_MATERIAL: Case = &[(
    Mpfb,
    Level::Error,
    "fails when it makes a material of this kind",
)];

const NO_RIG: Case = &[(
    Mpfb,
    Level::Error,
    "offers the rig, and fails with `OSError` when it is chosen",
)];

/// Folders that must exist: of the icons of sliders any may be missing.
const FOLDERS: [(&str, Case); 4] = [
    ("targets/_images", NO_START),
    ("textures", NO_SKIN_MAP),
    ("rigs/standard", NO_RIG),
    ("rigs/rigify", NO_RIG),
];

/// Whether the user has a copy of the settings of skins, which is read in place of the shipped one.
pub(super) fn has_own_skin_settings(view: &View<'_>) -> bool {
    let layers = view.layers();
    let user = layers.user.into_iter().chain(layers.beside);
    user.chain([layers.checked])
        .any(|layer| layer.is_there(OWN_SKIN_SETTINGS))
}

/// Findings on what does not exist.
pub(super) fn missing(rule: &Rule, view: &View<'_>, system: &Layer, out: &mut Vec<Finding>) {
    let mut renamed = BTreeSet::new();
    let has_own = has_own_skin_settings(view);
    let is_missing = |rel: &str| !(system.is_there(rel) || rel == SKIN_SETTINGS && has_own);
    let needed = NEEDED.into_iter().filter(|(rel, _)| is_missing(rel));
    let offered = lost_rigs(system).map(|rel| (rel, NO_RIG));
    let files = needed.chain(offered).map(|(rel, case)| {
        let other = system.file_ignoring_case(rel).map(|file| file.rel.as_str());
        (rel, case, "file", other)
    });
    let folders = FOLDERS
        .into_iter()
        .filter(|(folder, _)| !system.has_folder(folder) && !system.has_fault(folder));
    let folders = folders
        .map(|(folder, case)| (folder, case, "folder", folder_in_other_case(system, folder)));
    for (rel, case, what, other) in files.chain(folders) {
        let finding = if let Some(other) = other {
            let (is, right) = differing(other, rel);
            // A folder is told once for all that lies in it.
            if !renamed.insert(is.clone()) {
                continue;
            }
            let finding = rule
                .in_layer(system, &is, format!("`{is}` must be named `{right}`"))
                .key("capitals");
            finding.help(format!("rename it to `{}`", file_name(&right)))
        } else {
            let name = if what == "file" {
                format!("`{rel}`")
            } else {
                format!("folder `{rel}`")
            };
            let finding = rule.in_layer(system, rel, format!("{name} does not exist"));
            finding.help(format!(
                "restore the {what} from the download of the add-on"
            ))
        };
        out.push(finding.case(case));
    }
    out.extend(missing_maps(rule, system));
}

/// Pictures of the skin that are missing one by one; of the whole folder there is a finding above.
fn missing_maps(rule: &Rule, system: &Layer) -> Vec<Finding> {
    if !system.has_folder("textures") || system.has_fault("textures") {
        return Vec::new();
    }
    let is_missing = |rel: &String| !system.is_there(rel);
    let maps: Vec<String> = SKIN_MAPS
        .iter()
        .map(|name| format!("textures/mpfb_{name}.jpg"))
        .filter(is_missing)
        .collect();
    let scattering = Some("textures/sss.png".to_owned()).filter(is_missing);
    let of_maps = maps.first().map(|first| {
        let message = match maps.len() {
            1 => format!("`{first}` does not exist"),
            count => format!("{count} pictures of the skin do not exist, first `{first}`"),
        };
        let finding = rule
            .in_layer(system, first, message)
            .key("maps")
            .case(NO_SKIN_MAP)
            .parts(&maps);
        finding.evidence(Evidence::of_cases(&maps).out_of(SKIN_MAPS.len()))
    });
    let of_scattering =
        scattering.map(|rel| rule.in_layer(system, &rel, format!("`{rel}` does not exist")));
    let all = of_maps
        .into_iter()
        .chain(of_scattering.map(|finding| finding.case(NO_SCATTERING)));
    all.map(|finding| finding.help("restore the pictures from the download of the add-on"))
        .collect()
}

/// The folder that something lies in and that differs from the name in its capitals alone.
fn folder_in_other_case<'l>(layer: &'l Layer, folder: &str) -> Option<&'l str> {
    layer.files.keys().find_map(|rel| {
        let is = rel
            .get(..folder.len())
            .filter(|is| is.eq_ignore_ascii_case(folder))?;
        rel.get(folder.len()..)
            .filter(|rest| rest.starts_with('/'))
            .map(|_| is)
    })
}
