//! `t` that spells another value than its name, beside a file that fits better.

use super::super::{Check, Rule, RuleCx};
use super::links::unreferenced;
use super::suspects::{Suspect, by_file, is_crowd, suspects};
use mhlint_diag::{Application::Makehuman2, Confidence, Evidence, Finding, Level, Place, RuleInfo};
use mhlint_repo::FileFacts;
use mhlint_repo::makehuman2::{Base, View};

pub(crate) static RULE: Rule = Check::Makehuman2(run).rule(RuleInfo {
    breaks: &[(
        Makehuman2,
        "applies the target of a different value to this combination",
    )],
    docs: include_str!("alias_suspect.md").trim_ascii_end(),
    counts: "combinations",
    ..RuleInfo::new(
        "macro-alias-suspect",
        Level::Warning,
        "`t` spells a different value than `name`, and a file that fits better is unused",
    )
});

fn run(view: &View<'_>, base: &Base<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some((file, _)) = base.macro_file() else {
        return;
    };
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
    let names =
        || std::iter::once(name).chain(others.iter().map(|suspect| &suspect.link.link.name));
    let count = names().count();
    let more = others.len();
    let message = format!(
        "{count} combinations use `{text}`, which is named after other values: `{name}` and \
            {more} more"
    );
    RULE.at(file, first.link.place(), message)
        .key(format!("all {text}"))
        .confidence(Confidence::Medium)
        .help(
            "name the file of each combination in `t`; the `t` of one entry was probably copied \
            to the others",
        )
        .related(
            &first.better.path,
            Place::File,
            "unused file that fits better",
        )
        .evidence(Evidence::of_cases(names()))
}

fn single(file: &FileFacts, suspect: &Suspect<'_>) -> Finding {
    let (spelt, meant) = suspect.values;
    let name = &suspect.link.link.name;
    let message = format!(
        "`{name}` uses `{}`: `{spelt}` instead of `{meant}`",
        suspect.link.reference.text
    );
    let finding = RULE
        .at(file, suspect.link.place(), message)
        .key(name)
        .confidence(Confidence::Medium);
    finding
        .help(format!("did you mean `{}`?", suspect.better.stem()))
        .related(
            &suspect.better.path,
            Place::File,
            "unused file that fits better",
        )
}
