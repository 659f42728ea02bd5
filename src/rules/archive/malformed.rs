//! An archive that MakeHuman 2 cannot load: of targets, or of the base mesh.

use super::super::{Check, Rule, RuleCx};
use super::words;
use crate::diag::{Application, Case, Evidence, Finding, Level, Place, RuleInfo};
use crate::formats::npz::{Archive, ArchiveFault, Member, NpyFault};
use crate::repo::{FileFacts, View};

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        breaks: &[(Application::Makehuman2, "stops at every start until the archive is deleted by hand")],
        docs: "`compressedtargets.npz` is the archive of all targets of a folder: a zip of arrays with the fields `index` and \
            `vector`. If it is there, MakeHuman 2 loads all of it at start.\n\nAn archive of 0 bytes is what the program leaves \
            behind when a target could not be parsed while it was made; mending the target does not help, the program stops \
            at the empty archive (EOFError). It stops as well at a file that is no zip, at arrays without the two fields, \
            and at arrays of Python objects: those would have to be unpickled, which can run foreign code. `mhlint` reads \
            the header of such an array and nothing else.\n\nDelete the archive; the program makes it anew. It does not \
            belong into version control.\n\n`base.mhbin` is a base mesh that `compile_meshes.py` packed: `header`, `grpNames`, \
            `coord`, `uvs`, `overflow`, `groupinfo`, `vertsperface` and `faceverts`. While it is there MakeHuman 2 loads it in place \
            of `base.obj`. A file that is no zip ends in a \
            ValueError (fops_binary.py:153), one of 0 bytes in an EOFError (`file-empty`), one that lacks a member is refused, and members \
            that do not fit together end in an IndexError. Behind a position that is a copy of no vertex the surface tears (a \
            warning). What else is wrong with a mesh is for the rules on meshes. Delete the archive, or pack the mesh anew.",
        ..RuleInfo::new(
            "archive-malformed",
            Level::Error,
            "an archive of targets or of the base mesh that cannot be loaded",
        )
    },
    check: Check::File(run),
};

const EMPTY: Case = &[(
    Application::Makehuman2,
    Level::Error,
    "stops at every start with an EOFError until the file is deleted by hand",
)];

fn run(view: &View<'_>, file: &FileFacts, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    if let Some((message, case)) = file.mesh_fault().and_then(words::of_mesh) {
        let help = words::help_with_mesh(view, file);
        out.push(RULE.at(file, Place::File, message).case(case).help(help));
    }
    let Some(archive) = file.archive() else { return };
    match &archive.fault {
        Some(ArchiveFault::Empty) => {
            out.push(at(file, "the archive is empty (0 bytes)".to_owned()).case(EMPTY));
        }
        Some(ArchiveFault::NotZip(reason)) => out.push(at(file, format!("no zip archive: {reason}"))),
        None => out.extend(members(file, archive)),
    }
}

fn at(file: &FileFacts, message: String) -> Finding {
    RULE.at(file, Place::File, message).help("delete the archive; MakeHuman 2 makes it anew at the next start")
}

fn members(file: &FileFacts, archive: &Archive) -> Option<Finding> {
    let bad: Vec<(&Member, &NpyFault)> =
        archive.members.iter().filter_map(|member| Some((member, member.rows.as_ref().err()?))).collect();
    let (first, fault) = bad.first()?;
    let mut message = format!("member `{}` {}", first.name, words::of_member(fault));
    if bad.len() > 1 {
        message = format!("{message}; {} members cannot be used", bad.len());
    }
    let evidence = Evidence::of_cases(bad.iter().map(|(member, _)| &member.name)).out_of(archive.members.len());
    Some(at(file, message).evidence(evidence))
}
