//! Combinations of the cross product that a macro definition does not list.

use super::super::{Check, Rule, RuleCx};
use super::absence::Absence;
use super::absence_text::{Kind, message};
use super::links::unreferenced;
use super::survey::{Survey, survey};
use crate::diag::{Application, EXAMPLES, Evidence, Finding, Level, Place, RuleInfo};
use crate::formats::macro_json::Macrodef;
use crate::repo::FileFacts;
use crate::repo::makehuman2::{Base, View};

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        breaks: &[(
            Application::Makehuman2,
            "applies nothing for a combination that is not listed: at that corner of the sliders the shape snaps back",
        )],
        docs: "A macrodef stands for every combination of the values of its components. A combination that is not \
            listed changes nothing, exactly as `null` does, and MakeHuman 2 says nothing about it.\n\nThat is \
            fine where it is a system: a value that has no entry at all (`male` in a macro for breasts, `none` \
            in a macro for height), a neutral state (the values at the default position of their sliders), or a \
            combination all of whose siblings are `null`. Such absences are listed as an info, so that they can \
            be compared with what was meant. It is not fine where a single corner is missing in a block that is \
            listed otherwise: there the shape snaps back when the sliders come near (warning). Where fewer than \
            half of a block is listed, a table is taken for sparse on purpose (info). A combination for which an unused \
            file lies in the folder is never taken for meant: the finding names the file.\n\nIn the patterns `*` \
            stands for every value; the number behind a pattern is how many combinations it covers, and patterns \
            may overlap. Products of more than about a million combinations are counted, not listed.\n\nAdd the \
            entries; write `null` for a combination that should change nothing.",
        ..RuleInfo::new(
            "macro-missing-combination",
            Level::Warning,
            "a macrodef leaves combinations of its components unlisted",
        )
    },
    check: Check::Makehuman2(run),
};

fn run(view: &View<'_>, base: &Base<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some((file, macros)) = base.macro_file() else { return };
    let free = unreferenced(view, base, &cx.suggestions);
    for macrodef in &macros.macrodefs {
        let Some(survey) = survey(base, macrodef, &free, &cx.suggestions) else { continue };
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
    let evidence = Evidence::of_groups(absence.patterns.iter().map(|(text, _)| text), count as u64).out_of(total);
    let word = match kind {
        Kind::Hole => "holes",
        Kind::Sparse => "sparse",
        Kind::System => "system",
    };
    let finding = RULE.at(file, place(macrodef), message).key(format!("{}/{word}", macrodef.components.join("-")));
    let finding = finding.parts(&absence.names);
    let finding = if kind == Kind::Hole {
        with_files(finding, survey)
    } else {
        let effect = "nothing: these combinations are meant to have no shape of their own";
        let help = "nothing needs to be done if no shape is meant here";
        finding.level(Level::Info).effect(effect).help(help)
    };
    Some(finding.evidence(evidence))
}

/// The help for holes, and the files that wait for them.
fn with_files(mut finding: Finding, survey: &Survey<'_>) -> Finding {
    for file in survey.files.iter().take(EXAMPLES) {
        finding = finding.related(&file.path, Place::File, "fits, and is used by nothing");
    }
    finding.help(match survey.files.as_slice() {
        [] => "add the entries; write `null` for a combination that should change nothing".to_owned(),
        [one] => format!("its file `{}` is there: add the entry that names it in `t`", one.stem()),
        files => format!("{} files for them are there: add the entries that name them in `t`", files.len()),
    })
}

/// What can be said of a product too large to be walked.
fn uncounted(file: &FileFacts, macrodef: &Macrodef, survey: &Survey<'_>) -> Option<Finding> {
    let listed = survey.listed;
    let absent = match survey.space.size() {
        Some(total) if total == listed => return None,
        Some(total) => format!("{} of {total}", total - listed),
        None => format!("all but {listed}"),
    };
    let message = format!("{absent} combinations are not listed; they are too many to tell holes from systems");
    let finding = RULE.at(file, place(macrodef), message).key(format!("{}/uncounted", macrodef.components.join("-")));
    Some(finding.level(Level::Info).help("split the macrodef into several with fewer components"))
}

fn place(macrodef: &Macrodef) -> Place {
    let index = macrodef.index.to_string();
    if macrodef.links.is_empty() {
        Place::pointer(["macrodef", &index])
    } else {
        Place::pointer(["macrodef", &index, "targets"])
    }
}
