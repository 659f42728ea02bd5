//! A target in a macro folder that nothing uses.

use super::super::{Check, Rule, RuleCx};
use super::alias_suspect::suspects;
use super::fit::{fitting_names, values_of};
use super::links::unreferenced;
use crate::diag::{Application, Evidence, Finding, Level, Place, RuleInfo};
use crate::formats::macro_json::MacroFile;
use crate::repo::{Base, FileFacts, Repository};

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        breaks: &[(Application::Makehuman2, "reads the file at start and never applies it")],
        docs: "A target in the folder of a macrodef has an effect only if an entry names it in `t`, or a slider \
            uses it.\n\nSuch a file is often the one that a nearby combination should name: an entry was copied \
            and `t` not changed, or forgotten. MakeHuman 2 reads it and never applies it.\n\nLet the combination \
            that it is for name it, or remove it.",
        ..RuleInfo::new(
            "macro-unreferenced-target",
            Level::Warning,
            "a target in a macro folder is used by no macrodef",
        )
    },
    check: Check::Base(run),
};

fn run(repository: &Repository<'_>, base: &Base<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some((macro_file, macros)) = base.macro_file() else { return };
    let free = unreferenced(repository, base);
    let suspects = if free.is_empty() { Vec::new() } else { suspects(repository, base, &free) };
    for file in free.iter().filter(|file| !is_for_faulty_entry(base, (macro_file, macros), file)) {
        let message = format!("no macrodef uses `{}`", file.stem());
        let mut finding = RULE.at(file, Place::File, message).key(file.stem());
        let fitting = fitting_names(macros, &values_of(file.stem()));
        finding = match fitting.as_slice() {
            [] => finding.help("let the combination it is for name it in `t`, or remove it"),
            [one] => finding.help(format!("the combination `{one}` fits; let it name the file, or remove the file")),
            [first, ..] => finding.help(format!(
                "{} combinations fit, `{first}` among them; let them name the file, or remove the file",
                fitting.len()
            )),
        };
        if !fitting.is_empty() {
            finding = finding.evidence(Evidence::of_cases(&fitting));
        }
        for suspect in suspects.iter().filter(|suspect| suspect.better.rel == file.rel) {
            let text = format!("`{}` names `{}` instead", suspect.link.link.name, suspect.link.reference.text);
            finding = finding.related(&macro_file.path, suspect.link.place(), text);
        }
        out.push(finding);
    }
}

/// Whether the schema refuses an entry, or all entries, of a definition whose folder holds the file: the entry was
/// probably the one that names it.
fn is_for_faulty_entry(base: &Base<'_>, (file, macros): (&FileFacts, &MacroFile), target: &FileFacts) -> bool {
    let name = base.targets.and_then(|folder| folder.name_of(target)).unwrap_or_default();
    let is_inside = |folder: &str| name.strip_prefix(folder.trim_matches('/')).is_some_and(|rest| rest.starts_with('/'));
    let holders = macros.macrodefs.iter().filter(|macrodef| macrodef.effective_folder.as_deref().is_some_and(is_inside));
    let mut below = holders.map(|macrodef| format!("/macrodef/{}/targets", macrodef.index));
    let fits_listed = || !fitting_names(macros, &values_of(target.stem())).is_empty();
    below.any(|below| file.schema.faults.iter().any(|fault| fault.pointer.starts_with(&below))) && !fits_listed()
}
