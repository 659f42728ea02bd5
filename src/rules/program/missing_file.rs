//! The data folder of the program has the files without which it does not start.

use super::super::cause::consequence::STOPS_AT_START;
use super::super::cause::library::{FIRST_EYES, FIRST_SKIN};
use super::super::{Check, Rule, RuleCx};
use super::{mpfb_files, restoring::restoring};
use crate::diag::{
    Application::{Makehuman1, Makehuman2, Mpfb},
    Case, Finding, Level, RuleInfo,
};
use crate::repo::{Layer, View};

pub(in crate::rules) static RULE: Rule = Check::Repository(run).rule(RuleInfo {
    breaks: &[
        (Makehuman2, "exits at start"),
        (Makehuman1, "misses the file at start"),
        (Mpfb, "fails where it needs the file"),
    ],
    docs: "The data folder of MakeHuman 2 itself needs `makehuman2_version.json` and `shaders/shader.json`. Without the first \
        the program exits at start with code 20, without the second with code 21. Where there are shaders, \
        `shaders/meshes/lampsymbol.obj` belongs to them (a warning).\n\n\
        The rule asks for them only where the folder holds other parts of the program: shaders, or one of the two.\n\nOf the data of MakeHuman 1 the rule asks for the base mesh, the base skeleton, the default skin, its litspheres, the default eyes, the first scene and the shaders, each only where other files of its folder are there.\n\n\
        MPFB opens files of its own data by their names: `target.json` and `macro.json`, `base.obj`, the files of \
        `mesh_metadata`, settings and node trees, and the folders `targets/_images` and `textures`, with ten pictures of the skin. Without the catalogue, the \
        macros, the vertex groups or the icons the add-on cannot be enabled; without the others it fails where it needs them. \
        Capitals count.\n\n\
        Restore the file from the program.",
    of_library: true,
    ..RuleInfo::new("program-missing-file", Level::Error, "a file of the program does not exist")
});

const NEEDED: [(&str, u8); 2] = [("makehuman2_version.json", 20), ("shaders/shader.json", 21)];

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let layers = view.layers();
    let Some(system) = layers.system.filter(|system| std::ptr::eq(*system, layers.checked)) else { return };
    if view.is_makehuman1() {
        return of_makehuman1(view, system, out);
    }
    if mpfb_files::missing(&RULE, view, system, out) || !holds_program(system) {
        return;
    }
    // It came at the end of 2024.
    let is_later = |rel: &str| rel == NEEDED[1].0 && view.is_before("2025");
    for (rel, code) in NEEDED.into_iter().filter(|(rel, _)| !exists(system, rel) && !is_later(rel)) {
        let message = format!("`{rel}` does not exist");
        let finding = RULE
            .in_layer(system, rel, message)
            .effect_in(view.application(), format!("exits at start with code {code}"));
        out.push(finding.help("restore the file from the download of the program"));
    }
    if has_shaders(system) && !exists(system, LAMP) {
        let finding = RULE.in_layer(system, LAMP, format!("`{LAMP}` does not exist")).case(NO_LAMP);
        out.push(finding.help("restore the file from the download of the program"));
    }
}

/// The mesh that is shown for a lamp (formats/additions.md 1.3).
const LAMP: &str = "shaders/meshes/lampsymbol.obj";
const NO_LAMP: Case = &[(Makehuman2, Level::Warning, "logs a line at start and shows no symbol for lamps")];

/// What is there and cannot be read has a finding of its own; one with other capitals is as good as none on Linux.
fn exists(layer: &Layer, rel: &str) -> bool {
    layer.file(rel).is_some() || layer.has_unusable(rel)
}

fn holds_program(layer: &Layer) -> bool {
    NEEDED.iter().any(|(rel, _)| exists(layer, rel)) || has_shaders(layer)
}

fn has_shaders(layer: &Layer) -> bool {
    let is_shader = |rel: &str| matches!(rel.rsplit('.').next(), Some("vert" | "frag"));
    layer.below("shaders").any(|file| is_shader(&file.rel))
}

/// What MakeHuman 1 opens by name, the folder whose other files show that it belongs there, and what is lost with it
/// (formats/makehuman1-observed.md 4).
const OF_MAKEHUMAN1: [(&str, &str, Case); 10] = [
    ("rigs/default.mhskel", "modifiers", STOPS),
    (BASE_MESH, "modifiers", STOPS),
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
const LITSPHERES: &str = "litspheres";
const BASE_MESH: &str = "3dobjs/base.obj";
const STOPS: Case = &[(Makehuman1, Level::Error, STOPS_AT_START)];
const NO_SKIN: Case = &[(Makehuman1, Level::Warning, "logs an error and shows the body without its skin")];
const NO_BLEND: Case = &[(Makehuman1, Level::Error, "ends each frame at the default skin, which blends this picture")];
const NO_EYES: Case =
    &[(Makehuman1, Level::Error, "fails with `AttributeError` at start and at each reset: it puts on these eyes")];
const NO_PLACEHOLDER: Case = &[(Makehuman1, Level::Warning, "logs an error for each picture that does not exist")];
const NO_XRAY: Case = &[(Makehuman1, Level::Warning, "logs an error and shows no bones through the skin")];
const NO_SHADERS: Case = &[(Makehuman1, Level::Warning, "logs errors and draws all surfaces without their shaders")];

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

fn of_makehuman1(view: &View<'_>, system: &Layer, out: &mut Vec<Finding>) {
    let blends = view.surfaces().iter().any(|surface| surface.is_first && surface.is_true("autoBlendSkin"));
    let has_files = |folder: &str| system.below(folder).any(|file| !file.file_name().ends_with(".thumb"));
    let has = |folder: &str| has_files(folder) || folder == LITSPHERES && blends;
    // An asset with its extension in capitals has a finding of its own.
    let other = |rel: &str| rel.strip_suffix(".mhclo").map(|stem| format!("{stem}.MHCLO"));
    // Without their texts the packed mesh and the packed eyes do.
    let is_packed = |rel: &str| packed(rel).is_some_and(|packed| system.file(&packed).is_some());
    let is_of_user = |rel: &str| rel == FIRST_SCENE && view.layers().user.is_some_and(|user| exists(user, rel));
    let is_there = |rel: &str| {
        exists(system, rel)
            || is_packed(rel)
            || is_of_user(rel)
            || other(rel).is_some_and(|other| system.file(&other).is_some())
    };
    let is_missing = |rel: &str, folder: &str| !is_there(rel) && has(folder);
    let blended = OF_MAKEHUMAN1.iter().filter(|(_, folder, _)| *folder == LITSPHERES);
    let has_none = blended.clone().all(|(rel, folder, _)| is_missing(rel, folder));
    if has_none {
        let message =
            "the pictures `skinmat_african.png`, `skinmat_asian.png` and `skinmat_caucasian.png` do not exist";
        let finding = RULE.in_layer(system, LITSPHERES, message).case(NO_BLEND);
        out.push(finding.help("restore the folder from the program"));
    }
    for (rel, _, case) in OF_MAKEHUMAN1.into_iter().filter(|(rel, folder, _)| is_missing(rel, folder)) {
        if has_none && rel.starts_with(LITSPHERES) {
            continue;
        }
        let finding = RULE.in_layer(system, rel, format!("`{rel}` does not exist")).case(case);
        out.push(finding.help(restoring(system, rel)));
    }
    // Without skins it is not the whole program.
    let shaders = "shaders/glsl";
    if !has(shaders) && has("skins") {
        let finding = RULE.in_layer(system, shaders, format!("`{shaders}` does not exist")).case(NO_SHADERS);
        out.push(finding.help("restore the folder from the program"));
    }
}
