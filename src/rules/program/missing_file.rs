//! The data folder of the program has the files without which it does not start.

use super::super::{Check, Rule, RuleCx};
use super::{makehuman1_files, mpfb_files};
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
        The rule asks for them only where the folder holds other parts of the program: shaders, or one of the two.\n\nOf the data of MakeHuman 1 the rule asks for the base mesh, the base skeleton, the default skin, its litspheres, the default eyes, the first scene and the shaders, each only where other files of its folder are there, or most of the rest of the program is.\n\n\
        MPFB opens files of its own data by their names: `target.json` and `macro.json`, `base.obj`, the files of \
        `mesh_metadata`, settings and node trees, and the folders `rigs/standard`, `targets/_images` and `textures`, with ten pictures of the skin. Without the catalogue, the \
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
        return makehuman1_files::missing(&RULE, view, system, out);
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
