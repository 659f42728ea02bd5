//! A target in a macro folder that nothing uses.

use super::super::{Check, Rule, RuleCx};
use super::fit::{fitting_names, listed_names, values_of};
use super::links::{is_in_folder, unreferenced};
use super::survey::survey;
use super::suspects::{by_file, is_crowd, suspects};
use mhlint_diag::{Application::Makehuman2, Evidence, Finding, Level, Place, RuleInfo};
use mhlint_formats::macro_json::Macrodef;
use mhlint_repo::FileFacts;
use mhlint_repo::makehuman2::{Base, View};
use std::collections::BTreeSet;

pub(crate) static RULE: Rule = Check::Makehuman2(run).rule(RuleInfo {
    breaks: &[(Makehuman2, "loads the file at start but never applies it")],
    docs: include_str!("unreferenced_target.md").trim_ascii_end(),
    counts: "combinations",
    ..RuleInfo::new(
        "macro-unreferenced-target",
        Level::Warning,
        "a target in a macro folder is unused",
    )
});

fn run(view: &View<'_>, base: &Base<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some((macro_file, macros)) = base.macro_file() else {
        return;
    };
    let free = unreferenced(view, base, &cx.suggestions);
    if free.is_empty() {
        return;
    }
    let suspects = suspects(view, base, &free);
    let crowds = by_file(&suspects)
        .into_values()
        .filter(|all| is_crowd(all))
        .flatten();
    let crowd: BTreeSet<&str> = crowds
        .map(|suspect| suspect.link.link.name.as_str())
        .collect();
    // `macro-alias-suspect` names the file that an entry should have.
    let better: BTreeSet<&str> = suspects
        .iter()
        .map(|suspect| suspect.better.rel.as_str())
        .collect();
    // `macro-missing-combination` names the files of its holes.
    let surveys = macros
        .macrodefs
        .iter()
        .filter_map(|macrodef| survey(base, macrodef, &free, &cx.suggestions));
    let awaited: BTreeSet<&str> = surveys
        .flat_map(|survey| survey.files)
        .map(|file| file.rel.as_str())
        .collect();
    let is_told = |file: &&&FileFacts| {
        awaited.contains(file.rel.as_str()) || better.contains(file.rel.as_str())
    };
    let listed = listed_names(&macros.macrodefs);
    for file in free.iter().filter(|file| !is_told(file)) {
        let holders: Vec<&Macrodef> = macros
            .macrodefs
            .iter()
            .filter(|macrodef| is_in_folder(base, macrodef, file))
            .collect();
        let fitting = fitting_names(&listed, &holders, &values_of(file.stem()));
        // Combinations that were all given one file are told as that, with the files that they
        // should name.
        if fitting.iter().any(|name| crowd.contains(*name)) {
            continue;
        }
        if is_for_faulty_entry(macro_file, &holders, !fitting.is_empty()) {
            continue;
        }
        let message = format!("no macrodef uses target `{}`", file.stem());
        let mut finding = RULE.at(file, Place::File, message).key(file.stem());
        finding = match fitting.as_slice() {
            [] => finding.help(
                "name it in `t` of its combination, or keep the file outside of \
                the data",
            ),
            [one] => finding.help(format!(
                "name it in `t` of `{one}`, which fits, or keep the \
                file outside of the data"
            )),
            [first, ..] => finding.help(format!(
                "name it in `t` of the {} combinations that fit, such as `{first}`, or keep the \
                    file outside of the data",
                fitting.len()
            )),
        };
        if !fitting.is_empty() {
            finding = finding.evidence(Evidence::of_cases(&fitting));
        }
        out.push(finding);
    }
}

/// Whether the schema rejects the entries of a definition whose folder holds the file, or one of
/// them while no listed name fits: that entry was probably the one for the file.
fn is_for_faulty_entry(file: &FileFacts, holders: &[&Macrodef], fits_listed: bool) -> bool {
    let own = |macrodef: &&Macrodef| format!("/macrodef/{}", macrodef.index);
    let is_faulty = |pointer: &str| file.schema.at(pointer).next().is_some();
    let all = |own: String| is_faulty(&own) || is_faulty(&format!("{own}/targets"));
    let single = |own: String| {
        file.schema
            .inside(&format!("{own}/targets"))
            .next()
            .is_some()
    };
    holders
        .iter()
        .any(|holder| holder.links.is_empty() && (all(own(holder)) || single(own(holder))))
        || !fits_listed && holders.iter().any(|holder| single(own(holder)))
}
