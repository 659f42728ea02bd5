//! Files without which MakeHuman 1 does not work, or not as it should
//! (`docs/loaders/makehuman1/program.md#files-that-the-start-needs`).

use super::super::Rule;
use super::super::cause::consequence::STOPS_AT_START;
use super::super::cause::library::{FIRST_EYES, FIRST_SKIN};
use super::restoring::restoring;
use mhlint_diag::{Application::Makehuman1, Case, Finding, Level};
use mhlint_repo::makehuman1::has_most_of_program;
use mhlint_repo::{Layer, View};

/// What MakeHuman 1 opens by name, the folder whose other files show that it belongs there, and
/// what is lost with it.
const OF_MAKEHUMAN1: [(&str, &str, Case); 10] = [
    ("rigs/default.mhskel", MODIFIERS, STOPS),
    (BASE_MESH, MODIFIERS, STOPS),
    (FIRST_SKIN, "shaders", NO_SKIN),
    ("litspheres/skinmat_african.png", LITSPHERES, NO_BLEND),
    ("litspheres/skinmat_asian.png", LITSPHERES, NO_BLEND),
    ("litspheres/skinmat_caucasian.png", LITSPHERES, NO_BLEND),
    (FIRST_EYES, "eyes", NO_EYES),
    (FIRST_SCENE, "scenes", STOPS),
    ("textures/texture_notfound.png", "textures", NO_PLACEHOLDER),
    ("materials/xray.mhmat", "materials", NO_XRAY),
];
const FIRST_SCENE: &str = "scenes/default.mhscene";
/// Folders that every version has, in most of which the program opens something at start.
const ALWAYS_THERE: [&str; 4] = [MODIFIERS, "shaders", "eyes", "scenes"];
const MODIFIERS: &str = "modifiers";
const LITSPHERES: &str = "litspheres";
const BASE_MESH: &str = "3dobjs/base.obj";
const STOPS: Case = &[(Makehuman1, Level::Error, STOPS_AT_START)];
const NO_SKIN: Case = &[(
    Makehuman1,
    Level::Warning,
    "logs an error and shows the body without its skin",
)];
const NO_BLEND: Case = &[(
    Makehuman1,
    Level::Error,
    "ends each frame at the default skin, which blends this picture",
)];
const NO_EYES: Case = &[(
    Makehuman1,
    Level::Error,
    "fails with `AttributeError` at start and at each reset: it puts on these eyes",
)];
const NO_PLACEHOLDER: Case = &[(
    Makehuman1,
    Level::Warning,
    "logs an error for each picture that does not exist",
)];
const NO_XRAY: Case = &[(
    Makehuman1,
    Level::Warning,
    "logs an error and shows no bones through the skin",
)];
const NO_SHADERS: Case = &[(
    Makehuman1,
    Level::Warning,
    "logs errors and draws all surfaces without their shaders",
)];

const NO_UNITS: Case = &[(
    Makehuman1,
    Level::Error,
    "fails with an exception when the expressions are opened",
)];

/// What is read where a file is not there, as in a release.
fn packed(rel: &str) -> Option<String> {
    let (stem, extension) = rel.rsplit_once('.')?;
    let packed = match extension {
        "mhclo" => "mhpxy",
        "obj" => "npz",
        _ => return None,
    };
    Some(format!("{stem}.{packed}"))
}

/// Findings on what does not exist.
pub(super) fn missing(rule: &Rule, view: &View<'_>, system: &Layer, out: &mut Vec<Finding>) {
    let blends = view
        .surfaces()
        .iter()
        .any(|surface| surface.is_first && surface.is_true("autoBlendSkin"));
    let has_files = |folder: &str| {
        system
            .below(folder)
            .any(|file| !file.file_name().ends_with(".thumb"))
    };
    let is_most = has_most_of_program(system);
    let has = |folder: &str| {
        has_files(folder)
            || folder == LITSPHERES && blends
            || is_most && ALWAYS_THERE.contains(&folder)
    };
    // An asset with its extension in capitals has a finding of its own.
    let other = |rel: &str| {
        rel.strip_suffix(".mhclo")
            .map(|stem| format!("{stem}.MHCLO"))
    };
    // Without their texts the packed mesh and the packed eyes do.
    let is_packed = |rel: &str| packed(rel).is_some_and(|packed| system.file(&packed).is_some());
    let is_of_user =
        |rel: &str| rel == FIRST_SCENE && view.layers().user.is_some_and(|user| user.is_there(rel));
    let is_there = |rel: &str| {
        system.is_there(rel)
            || is_packed(rel)
            || is_of_user(rel)
            || other(rel).is_some_and(|other| system.file(&other).is_some())
    };
    let is_missing = |rel: &str, folder: &str| !is_there(rel) && has(folder);
    let blended = OF_MAKEHUMAN1
        .iter()
        .filter(|(_, folder, _)| *folder == LITSPHERES);
    let has_none = blended
        .clone()
        .all(|(rel, folder, _)| is_missing(rel, folder));
    if has_none {
        let message = "the pictures `skinmat_african.png`, `skinmat_asian.png` and \
            `skinmat_caucasian.png` do not exist";
        let finding = rule.in_layer(system, LITSPHERES, message).case(NO_BLEND);
        out.push(finding.help("restore the folder from the program"));
    }
    for (rel, _, case) in OF_MAKEHUMAN1
        .into_iter()
        .filter(|(rel, folder, _)| is_missing(rel, folder))
    {
        if has_none && rel.starts_with(LITSPHERES) {
            continue;
        }
        let finding = rule
            .in_layer(system, rel, format!("`{rel}` does not exist"))
            .case(case);
        out.push(finding.help(restoring(system, rel)));
    }
    // Without skins it is not the whole program.
    let shaders = "shaders/glsl";
    let gone = |folder: &str, case| {
        let finding = rule
            .in_layer(system, folder, format!("`{folder}` does not exist"))
            .case(case);
        finding.help("restore the folder from the program")
    };
    if !has_files(shaders) && (is_most || has_files("skins")) {
        out.push(gone(shaders, NO_SHADERS));
    }
    // With expressions `pose-missing-units` names it.
    if is_most
        && ["poseunits", "expressions"]
            .iter()
            .all(|folder| system.below(folder).next().is_none())
    {
        out.push(gone("poseunits", NO_UNITS));
    }
}
