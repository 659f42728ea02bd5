//! `t` that spells another value than its name, beside a file that fits better.

use super::super::{Check, Rule, RuleCx};
use super::links::unreferenced;
use super::suspects::{Suspect, by_file, is_crowd, suspects};
use crate::diag::{Application, Confidence, Evidence, Finding, Level, Place, RuleInfo};
use crate::repo::FileFacts;
use crate::repo::makehuman2::{Base, View};

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        breaks: &[(Application::Makehuman2, "applies the target of another value for this combination")],
        docs: "Several combinations may share a target, and then `t` does not spell all of their values. But when \
            `t` spells *another* value of a component than the name does, and a file that spells the right one \
            lies in the same folder and is used by nobody, the entry was probably copied and not \
            finished.\n\nMakeHuman 2 applies what `t` says; the shape of this combination is that of \
            another.\n\nLet `t` name the file that fits.",
        ..RuleInfo::new(
            "macro-alias-suspect",
            Level::Warning,
            "`t` spells another value than `name` while a better fitting file lies unused beside it",
        )
    },
    check: Check::Makehuman2(run),
};

fn run(view: &View<'_>, base: &Base<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some((file, _)) = base.macro_file() else { return };
    let free = unreferenced(view, base, &cx.suggestions);
    if free.is_empty() {
        return;
    }
    let suspects = suspects(view, base, &free);
    for all in by_file(&suspects).into_values() {
        match all.as_slice() {
            [first, others @ ..] if is_crowd(&all) => out.push(crowd(file, first, others)),
            few => out.extend(few.iter().map(|suspect| single(file, suspect))),
        }
    }
}

/// One file written to many entries.
fn crowd(file: &FileFacts, first: &Suspect<'_>, others: &[&Suspect<'_>]) -> Finding {
    let (text, name) = (first.link.reference.text, &first.link.link.name);
    let names = || std::iter::once(name).chain(others.iter().map(|suspect| &suspect.link.link.name));
    let count = names().count();
    let message = format!("{count} combinations name `{text}`, which spells other values than theirs, `{name}` first");
    RULE.at(file, first.link.place(), message)
        .key(format!("all {text}"))
        .confidence(Confidence::Medium)
        .help("was `t` of one entry copied to the others? Name the file of each combination")
        .related(&first.better.path, Place::File, "fits better and is used by nothing")
        .evidence(Evidence::of_cases(names()))
}

fn single(file: &FileFacts, suspect: &Suspect<'_>) -> Finding {
    let (spelt, meant) = suspect.values;
    let name = &suspect.link.link.name;
    let message = format!("`{name}` names `{}`: `{spelt}` where it means `{meant}`", suspect.link.reference.text);
    let finding = RULE.at(file, suspect.link.place(), message).key(name).confidence(Confidence::Medium);
    finding.help(format!("did you mean `{}`?", suspect.better.stem())).related(
        &suspect.better.path,
        Place::File,
        "fits better and is used by nothing",
    )
}
