//! An archive that MakeHuman 2 cannot load: of targets, or of the base mesh.

use super::super::{Check, Rule, RuleCx};
use super::{words, worn};
use crate::diag::{Application::Makehuman2, Case, Evidence, Finding, Level, Place, RuleInfo};
use crate::formats::npz::{Archive, ArchiveFault, Member, NpyFault};
use crate::repo::{FileFacts, View};

pub(in crate::rules) static RULE: Rule = Check::File(run).rule(RuleInfo {
    breaks: &[(Makehuman2, "crashes at every start until the archive is deleted by hand")],
    docs: "`compressedtargets.npz` is the archive of all targets of a folder: a zip of arrays with the fields \
        `index` and `vector`. If it exists, MakeHuman 2 loads all of it at start.\n\nMakeHuman 2 leaves an \
        archive of 0 bytes if it could not parse a target while writing it. Fixing the target does not help: the \
        program crashes with `EOFError` at the empty archive. It also crashes if the file is not a zip, if an \
        array lacks the two fields, and if an array contains Python objects: those would have to be unpickled, \
        which can run any code. `mhlint` reads only the header of such an array.\n\nDelete the archive; \
        MakeHuman 2 rebuilds it. It does not belong in version control.\n\n`base.mhbin` is a base mesh packed by \
        `compile_meshes.py`: `header`, `grpNames`, `coord`, `uvs`, `overflow`, `groupinfo`, `vertsperface` and \
        `faceverts`. If it exists, MakeHuman 2 loads it instead of `base.obj`. A file that is not a zip crashes \
        it with `ValueError` (fops_binary.py:153), one of 0 bytes with `EOFError` (`file-empty`), and members \
        that do not fit together with `IndexError`. One that lacks a member is rejected. At a position that is \
        not a copy of any vertex the surface tears (a warning). All else is up to the rules for meshes. Delete \
        the archive, or rebuild it.\n\n`.mhbin` beside an asset is what MakeHuman 2 packs of its text and mesh. The \
        library opens all of them at start: one that is not a zip, or has no usable member `asset`, crashes it, and \
        the next start comes up without any asset. If another member is missing, the asset is refused with a message. \
        Delete it if the text is beside it.",
    counts: "members",
    ..RuleInfo::new(
        "archive-malformed",
        Level::Error,
        "an archive of targets, of a base mesh or of an asset that cannot be loaded",
    )
});

const EMPTY: Case =
    &[(Makehuman2, Level::Error, "crashes with `EOFError` at every start until the file is deleted by hand")];

fn run(view: &View<'_>, file: &FileFacts, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    if let Some((message, case)) = file.mesh_fault().and_then(words::of_mesh) {
        let help = words::help_with_mesh(view, file);
        out.push(RULE.at(file, Place::File, message).case(case).help(help));
    }
    if let Some((message, case)) = worn::fault(view, file) {
        out.push(RULE.at(file, Place::File, message).case(case).help(worn::help(view, file)));
    }
    let Some(archive) = file.archive() else { return };
    match &archive.fault {
        Some(ArchiveFault::Empty) => {
            out.push(at(file, "the archive is empty (0 bytes)".to_owned()).case(EMPTY));
        }
        Some(ArchiveFault::NotZip(reason)) => out.push(at(file, words::not_zip(reason))),
        None => out.extend(members(file, archive)),
    }
}

fn at(file: &FileFacts, message: String) -> Finding {
    RULE.at(file, Place::File, message).help(
        "delete the archive if the `.target` files are there: MakeHuman 2 rebuilds it from them at the next start",
    )
}

fn members(file: &FileFacts, archive: &Archive) -> Option<Finding> {
    let bad: Vec<(&Member, &NpyFault)> =
        archive.members.iter().filter_map(|member| Some((member, member.rows.as_ref().err()?))).collect();
    let (first, fault) = bad.first()?;
    let mut message = format!("member `{}` {}", first.name, words::of_member(fault));
    if bad.len() > 1 {
        message = format!("{message} ({} unusable members)", bad.len());
    }
    let evidence = Evidence::of_cases(bad.iter().map(|(member, _)| &member.name)).out_of(archive.members.len());
    Some(at(file, message).evidence(evidence))
}
