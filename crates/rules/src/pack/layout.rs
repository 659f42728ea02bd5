//! An asset pack must have its files where the importer takes them from.

use super::super::{Check, Rule, RuleCx};
use super::{Packed, lost, moved, named, unpacked};
use mhlint_diag::{
    Application::{Makehuman2, Mpfb},
    Finding, Level, RuleInfo,
};
use mhlint_repo::makehuman2::View;

// A zip for MakeHuman 1 is unpacked by people, who have their own ways.
pub(crate) static RULE: Rule = Check::LibrariesOfAll(run, |_, _, _| {}, |view, _, out| unpacked::report(&RULE, view, out)).rule(RuleInfo {
    breaks: &[(Makehuman2, "ignores the files on import"), (Mpfb, "rejects the zip")],
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
        MPFB unpacks a zip as it is over the data of the user, and overwrites files of the same path (a warning where that \
        folder is given, too). Before, it checks that a name in the zip begins with `packs/`, in small letters and with \
        `/`, and rejects any other zip. It has three modes for that check:\n\n\
        - BLOCK, the default, rejects the zip: nothing of it is imported.\n\
        - FIX leaves out a folder that is around everything, and `__MACOSX` beside it. It cannot repair two folders around \
        the pack, `Packs` in capitals, `\\`, or a zip without `packs`.\n\
        - INSTALL checks nothing and unpacks all: what is in a folder around the pack is not listed.\n\n\
        Loose files and `__MACOSX` beside `packs` do no harm. `..` and `/` at the beginning of a name are left out.\n\n\
        A zip is one of MPFB where that is asked for, by `--app mpfb` or by its data with `--system`, and where `packs/` is at \
        its top beside assets.\n\n\
        Change the folders, and pack them again.",
    ..RuleInfo::new("pack-layout", Level::Error, "an asset pack that importing rejects, or with files that it loses, renames or overwrites")
});

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some(pack) = Packed::of(view.layers.checked) else { return };
    lost::report(&RULE, &pack, out);
    moved::report(&RULE, &pack, view, out);
    named::report(&RULE, pack.layer, pack.pack, out);
}
