//! Combinations of the cross product that a macro definition does not list.

use super::super::{Check, Rule, RuleCx};
use super::absence::Absence;
use super::absence_text::{Kind, message};
use super::links::unreferenced;
use super::survey::{Survey, survey};
use mhlint_diag::{Application::Makehuman2, EXAMPLES, Evidence, Finding, Level, Place, RuleInfo};
use mhlint_formats::macro_json::Macrodef;
use mhlint_repo::FileFacts;
use mhlint_repo::makehuman2::{Base, View};

pub(crate) static RULE: Rule = Check::Makehuman2(run).rule(RuleInfo {
    breaks: &[(
        Makehuman2,
        "applies nothing for a combination that is not listed: the shape snaps back at that \
            corner of the sliders",
    )],
    docs: include_str!("missing_combination.md").trim_ascii_end(),
    counts: "combinations",
    ..RuleInfo::new(
        "macro-missing-combination",
        Level::Warning,
        "a macrodef does not list all combinations of its components",
    )
});

fn run(view: &View<'_>, base: &Base<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some((file, macros)) = base.macro_file() else {
        return;
    };
    let free = unreferenced(view, base, &cx.suggestions);
    for macrodef in &macros.macrodefs {
        let Some(survey) = survey(base, macrodef, &free, &cx.suggestions) else {
            continue;
        };
        let Some([system, holes]) = &survey.absent else {
            out.extend(uncounted(file, macrodef, &survey));
            continue;
        };
        let is_hole = holes.count <= survey.listed || !survey.files.is_empty();
        let kind = if is_hole { Kind::Hole } else { Kind::Sparse };
        out.extend(finding(file, macrodef, &survey, holes, kind));
        // Where nothing is listed although files wait, the rest is no system of its own.
        if survey.listed > 0 || survey.files.is_empty() {
            out.extend(finding(file, macrodef, &survey, system, Kind::System));
        }
    }
}

/// A finding on absent combinations of one kind, if there are any.
fn finding(
    file: &FileFacts,
    macrodef: &Macrodef,
    survey: &Survey<'_>,
    absence: &Absence,
    kind: Kind,
) -> Option<Finding> {
    let total = survey.space.size()?;
    let count = absence.count;
    let message = message(absence, total, survey, kind)?;
    let evidence = Evidence::of_groups(absence.patterns.iter().map(|(text, _)| text), count as u64)
        .out_of(total);
    let word = match kind {
        Kind::Hole => "holes",
        Kind::Sparse => "sparse",
        Kind::System => "system",
    };
    let finding = RULE
        .at(file, place(macrodef), message)
        .key(format!("{}/{word}", macrodef.components.join("-")));
    let finding = finding.parts(&absence.names);
    let finding = if kind == Kind::Hole {
        with_files(finding, survey)
    } else {
        let effect = "applies nothing here, which is probably intended";
        let help = "leave it if no shape is meant here; otherwise add the entries";
        finding.level(Level::Info).effect(effect).help(help)
    };
    Some(finding.evidence(evidence))
}

/// The help for holes, and the files that wait for them.
fn with_files(mut finding: Finding, survey: &Survey<'_>) -> Finding {
    for file in survey.files.iter().take(EXAMPLES) {
        finding = finding.related(&file.path, Place::File, "unused file that fits");
    }
    finding.help(match survey.files.as_slice() {
        [] => "add what is missing, with `null` as `t` where nothing should change".to_owned(),
        [one] => format!("add an entry with the unused file `{}` as `t`", one.stem()),
        files => format!("add entries with the {} unused files as `t`", files.len()),
    })
}

/// What can be said of a product too large to be walked.
fn uncounted(file: &FileFacts, macrodef: &Macrodef, survey: &Survey<'_>) -> Option<Finding> {
    let listed = survey.listed;
    let absent = match survey.space.size() {
        Some(total) if total == listed => return None,
        Some(total) => format!("{} of {total} combinations are not listed", total - listed),
        None => format!("all combinations but {listed} are not listed"),
    };
    let message = format!("{absent}; there are too many to check");
    let finding = RULE
        .at(file, place(macrodef), message)
        .key(format!("{}/uncounted", macrodef.components.join("-")));
    Some(
        finding
            .level(Level::Info)
            .help("split the macrodef into several with fewer components each"),
    )
}

fn place(macrodef: &Macrodef) -> Place {
    let index = macrodef.index.to_string();
    if macrodef.links.is_empty() {
        Place::pointer(["macrodef", &index])
    } else {
        Place::pointer(["macrodef", &index, "targets"])
    }
}
