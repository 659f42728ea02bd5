//! An archive of targets that MakeHuman 2 cannot load.

use super::super::{Check, Rule, RuleCx};
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
            belong into version control.",
        ..RuleInfo::new("archive-malformed", Level::Error, "an archive of targets that cannot be loaded")
    },
    check: Check::File(run),
};

const EMPTY: Case = &[(
    Application::Makehuman2,
    Level::Error,
    "stops at every start with an EOFError until the file is deleted by hand",
)];

fn run(_: &View<'_>, file: &FileFacts, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
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
    let mut message = format!("member `{}` {}", first.name, words(fault));
    if bad.len() > 1 {
        message = format!("{message}; {} members cannot be used", bad.len());
    }
    let evidence = Evidence::of_cases(bad.iter().map(|(member, _)| &member.name)).out_of(archive.members.len());
    Some(at(file, message).evidence(evidence))
}

fn words(fault: &NpyFault) -> String {
    match fault {
        NpyFault::NotNpy => "is no NumPy array".to_owned(),
        NpyFault::Header => "has a header that NumPy refuses".to_owned(),
        NpyFault::Object => "holds Python objects, which are never unpickled".to_owned(),
        NpyFault::MissingField(name) => format!("has no field `{name}`"),
        NpyFault::WrongType(name, kind) => format!("has a field `{name}` of type `{kind}` that does not fit a target"),
        NpyFault::Shape => "is no plain list of rows".to_owned(),
        NpyFault::Truncated => "ends before its last row".to_owned(),
        NpyFault::Damaged(reason) => format!("cannot be unpacked: {reason}"),
    }
}
