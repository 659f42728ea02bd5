//! The data folder of the program has the files without which it does not start.

use super::super::{Check, Rule, RuleCx};
use super::{makehuman1_files, makehuman2_files, mpfb_files};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2, Mpfb},
    Finding, Level, RuleInfo,
};
use mhlint_repo::View;

pub(crate) static RULE: Rule = Check::Repository(run).rule(RuleInfo {
    breaks: &[
        (Makehuman2, "exits at start"),
        (Makehuman1, "misses the file at start"),
        (Mpfb, "fails where it needs the file"),
    ],
    docs: "The data folder of MakeHuman 2 itself needs `makehuman2_version.json` and `shaders/shader.json`. Without the first \
        the program exits at start with code 20, without the second with code 21. Where there are shaders, \
        `shaders/meshes/lampsymbol.obj` belongs to them (a warning).\n\n\
        The rule asks for them only where the folder holds other parts of the program: shaders, or one of the two. Where there \
        are these, or macros in `target/`, and no `base/`, all base meshes are gone.\n\nOf the data of MakeHuman 1 the rule asks for the base mesh, the base skeleton, the default skin, its litspheres, the default eyes, the first scene and the shaders, each only where other files of its folder are there, or most of the rest of the program is.\n\n\
        MPFB opens files of its own data by their names: `target.json` and `macro.json`, `base.obj`, the files of \
        `mesh_metadata`, settings and node trees, and the folders `rigs/standard`, `rigs/rigify`, `targets/_images` and `textures`, with ten pictures of the skin. Without the catalogue, the \
        macros, the vertex groups or the icons the add-on cannot be enabled; without the others it fails where it needs them. \
        Capitals count.\n\n\
        Restore the file from the program.",
    of_library: true,
    ..RuleInfo::new("program-missing-file", Level::Error, "a file of the program does not exist")
});

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let layers = view.layers();
    let Some(system) = layers.system.filter(|system| std::ptr::eq(*system, layers.checked)) else { return };
    if view.is_makehuman1() {
        makehuman1_files::missing(&RULE, view, system, out);
    } else if view.is_mpfb() {
        mpfb_files::missing(&RULE, view, system, out);
    } else {
        makehuman2_files::missing(&RULE, view, system, out);
    }
}
