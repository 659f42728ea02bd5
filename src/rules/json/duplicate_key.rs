//! A key once in an object.

use std::collections::BTreeMap;

use super::super::{Check, Rule, RuleCx};
use super::left_out;
use crate::diag::{Application, Finding, Level, Place, RuleInfo, steps, structural};
use crate::json::Duplicate;
use crate::repo::{FileFacts, View};

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        breaks: &[(Application::Makehuman2, "takes the last value and forgets the others without a word")],
        docs: "The same key twice in one object is allowed by the grammar of JSON, but only one value can be kept. Python \
            keeps the last, so what stands before it is lost: a slider, a bone, a macro component.\n\nMostly an entry was \
            copied and its key not changed. Give one of the two another key, or remove the one that is not meant. If both \
            values are the same nothing is lost, which makes it an info.",
        ..RuleInfo::new("json-duplicate-key", Level::Warning, "a key occurs twice in an object")
    },
    check: Check::File(run),
};

fn run(_: &View<'_>, file: &FileFacts, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let mut by_member: BTreeMap<&str, Vec<&Duplicate>> = BTreeMap::new();
    for duplicate in &file.json.duplicates {
        by_member.entry(&duplicate.pointer).or_default().push(duplicate);
    }
    out.extend(by_member.into_iter().filter_map(|(pointer, all)| finding(file, pointer, &all)));
    out.extend(left_out(&RULE, file, file.json.duplicates_left_out, "keys that occur twice"));
}

/// One finding for a key, however often it occurs: at the first one that is lost, with the one that wins.
fn finding(file: &FileFacts, pointer: &str, all: &[&Duplicate]) -> Option<Finding> {
    let (first, last) = (all.first()?, all.last()?);
    let key = steps(pointer).last().unwrap_or_default();
    let equal = all.iter().all(|duplicate| duplicate.equal);
    let times = if all.len() == 1 { "twice".to_owned() } else { format!("{} times", all.len() + 1) };
    let loss = if equal { "with the same value" } else { "only the last value counts" };
    let finding = RULE.at(file, Place::Span(first.lost.clone()), format!("key `{key}` occurs {times}; {loss}"));
    let related = Place::Span(last.kept.clone());
    let finding = if equal { finding.at_most(Level::Info) } else { finding };
    Some(
        finding
            .key(structural(pointer))
            .help(if equal { "remove one of them" } else { "give one of them another key, or remove it" })
            .related(file.path.clone(), related, format!("this `{key}` wins")),
    )
}
