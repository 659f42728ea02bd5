//! The findings on an archive that cannot be loaded, of one sort each.

use super::super::Rule;
use super::{Sort, compiled, packed_targets, words, worn};
use mhlint_diag::{Application::Makehuman2, Case, Evidence, Finding, Level, Place};
use mhlint_formats::npz::{Archive, ArchiveFault, Member, NpyFault};
use mhlint_repo::{FileFacts, View};

const EMPTY: Case = &[(
    Makehuman2,
    Level::Error,
    "crashes with `EOFError` at every start until the file is deleted by hand",
)];

/// What is wrong of this sort.
pub(super) fn report(
    rule: &Rule,
    sort: Sort,
    view: &View<'_>,
    file: &FileFacts,
    out: &mut Vec<Finding>,
) {
    if let Some(own) = view.as_makehuman1() {
        packed_targets::report(rule, sort, own, file, out);
        return compiled::report(rule, sort, own, file, out);
    }
    let is_own = |(own, ..): &(Sort, String, Case)| *own == sort;
    if let Some((_, message, case)) = file.mesh_fault().and_then(words::of_mesh).filter(is_own) {
        let help = words::help_with_mesh(view, file);
        out.push(rule.at(file, Place::File, message).case(case).help(help));
    }
    if let Some((_, message, case)) = worn::fault(view, file).filter(is_own) {
        out.push(
            rule.at(file, Place::File, message)
                .case(case)
                .help(worn::help(view, file)),
        );
    }
    let Some(archive) = file.archive() else {
        return;
    };
    match &archive.fault {
        None => out.extend(members(rule, sort, file, archive)),
        Some(_) if sort != Sort::Malformed => {}
        Some(ArchiveFault::Empty) => {
            out.push(at(rule, file, "the archive is empty (0 bytes)".to_owned()).case(EMPTY));
        }
        Some(ArchiveFault::NotZip(reason)) => out.push(at(rule, file, words::not_zip(reason))),
    }
}

fn at(rule: &Rule, file: &FileFacts, message: String) -> Finding {
    rule.at(file, Place::File, message).help(
        "delete the archive if the `.target` files are there: MakeHuman 2 rebuilds it from them \
            at the next start",
    )
}

fn members(rule: &Rule, sort: Sort, file: &FileFacts, archive: &Archive) -> Option<Finding> {
    let all = archive
        .members
        .iter()
        .filter_map(|member| Some((member, member.rows.as_ref().err()?)));
    let bad: Vec<(&Member, &NpyFault)> = all.filter(|(_, fault)| Sort::of(fault) == sort).collect();
    let (first, fault) = bad.first()?;
    let mut message = format!("member `{}` {}", first.name, words::of_member(fault));
    if bad.len() > 1 {
        message = format!("{message} ({} unusable members)", bad.len());
    }
    let evidence = Evidence::of_cases(bad.iter().map(|(member, _)| &member.name))
        .out_of(archive.members.len());
    Some(at(rule, file, message).evidence(evidence))
}
