//! An asset pack must have its files where the importer takes them from.

use super::super::{Check, Rule, RuleCx};
use super::{Packed, lost, moved, named};
use crate::diag::{Application::Makehuman2, Finding, Level, RuleInfo};
use crate::repo::makehuman2::View;

pub(in crate::rules) static RULE: Rule = Check::Makehuman2Library(run).rule(RuleInfo {
    breaks: &[(Makehuman2, "ignores the files on import")],
    docs: "A zip given as PATH is checked as the folder that it becomes when MakeHuman 2 imports it as an asset pack. The \
        importer asks for the base mesh, or takes it from a name such as `newbase_imp.zip`, and looks at the folders at the \
        top of the zip:\n\n\
        - `clothes`, `hair`, `eyes`, `eyebrows`, `eyelashes`, `teeth`, `tongue`, `skins`, `rigs`, `poses` and `expressions` go \
        to the folder of that name for the base mesh, `proxymeshes` goes to `proxy`. In them an asset has one folder. A folder \
        in that folder becomes `materials`, whatever it is called: what names `textures/x.png` does not find the picture any \
        more.\n\
        - `contarget` keeps its folders. `base` and `models` lose theirs: of two files of one name one is left.\n\
        - `shader_litspheres`, `shader_skybox` and `shader_floor` go to folders in `shaders`.\n\
        - All else is ignored without a word: a folder around everything, `proxy`, `target`, `targets`, `materials`, files at \
        the top.\n\n\
        There is no folder for the base mesh in a pack: importing adds it.\n\n\
        Names in a zip use `/`, and letters outside of ASCII must be marked as UTF-8. Old Windows programs write `\\`, \
        which leaves files with long names at the top on Linux and macOS. Names that are not marked get other letters.\n\n\
        Change the folders, and pack them again.",
    ..RuleInfo::new("pack-layout", Level::Error, "an asset pack with files that importing loses, renames or overwrites")
});

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some(pack) = Packed::of(view.layers.checked) else { return };
    lost::report(&RULE, &pack, out);
    moved::report(&RULE, &pack, view, out);
    named::report(&RULE, &pack, out);
}
