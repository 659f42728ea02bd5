//! An archive that cannot be loaded: of targets, of a base mesh or of an asset, or a zip of assets.

use super::super::{Check, Rule, RuleCx};
use super::Sort;
use super::pack;
use super::report::report;
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2, Mpfb},
    Finding, Level, RuleInfo,
};
use mhlint_repo::View;

pub(crate) static RULE: Rule = Check::Repository(run).rule(RuleInfo {
    breaks: &[
        (Makehuman2, "crashes at every start until the archive is deleted by hand"),
        (Makehuman1, "takes its targets from the texts; without these it finds none"),
        (Mpfb, "rejects the zip: nothing of it is imported"),
    ],
    docs: "`compressedtargets.npz` is the archive of all targets of a folder: a zip of arrays. If it exists, MakeHuman 2 loads \
        all of it at start.\n\n\
        MakeHuman 2 leaves an archive of 0 bytes if it could not parse a target while writing it. Fixing the target does \
        not help: the program crashes with `EOFError` at the empty archive. It also crashes if the file is not a zip, or an \
        array in it is damaged.\n\n\
        Delete the archive; MakeHuman 2 rebuilds it. It does not belong in version control.\n\n\
        `base.mhbin` is a base mesh packed by `compile_meshes.py`. If it exists, MakeHuman 2 loads it instead of `base.obj`. \
        A file that is not a zip crashes it with `ValueError`, one of 0 bytes with `EOFError` (`file-empty`), and members \
        that do not fit together with `IndexError`. At a position that is not a copy of any vertex the surface tears (a \
        warning). Delete the archive, or rebuild it.\n\n\
        `.mhbin` beside an asset is what MakeHuman 2 packs of its text and mesh. The library opens all of them at start: one \
        that is not a zip crashes it, and the next start comes up without any asset. Delete it if the text is beside \
        it.\n\n\
        `targets.npz` of MakeHuman 1 stands for all targets of its data, together with `images.list`. If one of the two \
        cannot be read, or a path in it has two values of a category, the program takes the texts; without texts it finds no \
        target, and fails at start. The same happens if the archive has other targets than its macros move. Members that \
        do not fit together stop each update of the figure.\n\nA zip of assets given as PATH is tried whole: one that is not a zip, is cut off, or has members that are damaged, encrypted or \
        packed in a rare way cannot be imported or unpacked. Pack it again.",
    counts: "members",
    ..RuleInfo::new("archive-malformed", Level::Error, "an archive of targets, of a base mesh or of an asset that cannot be loaded, or a zip of assets that cannot be unpacked")
});

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    // MPFB reads no archives.
    if !view.is_mpfb() {
        view.files().for_each(|file| report(&RULE, Sort::Malformed, view, file, out));
    }
    pack::report(&RULE, view.layers().checked, out);
}
