//! Words for what a loader cannot take of a JSON: one finding for each cause.

use super::rule::{Rule, RuleCx, did_you_mean, either, such};
use mhlint_diag::{EXAMPLES, Evidence, Finding, Place, grouped, steps};
use mhlint_formats::unfit::{Unfit, Unfits, Why};
use mhlint_repo::FileFacts;

/// How faults of a format are told.
#[derive(Clone, Copy)]
pub(super) struct Wording {
    /// What is the same in faults that one slip makes. Baselines hold it.
    pub cause: fn(&Unfit) -> String,
    /// What a pointer leads to, in words.
    pub subject: fn(&str) -> String,
}

/// As most formats have it: below one key at the top there is one thing.
const USUAL: Wording = Wording { cause, subject };

/// Longest text that is quoted, in characters.
const QUOTED: usize = 60;

/// Findings on faults: one for those of one sort below one key of the file. With each goes its
/// first fault.
pub(super) fn findings<'f>(
    rule: &'f Rule,
    file: &'f FileFacts,
    faults: &'f Unfits,
    cx: &'f RuleCx<'_>,
) -> impl Iterator<Item = (&'f Unfit, Finding)> + use<'f> {
    findings_in(USUAL, rule, file, faults, cx)
}

/// The same in other words.
pub(super) fn findings_in<'f>(
    wording: Wording,
    rule: &'f Rule,
    file: &'f FileFacts,
    faults: &'f Unfits,
    cx: &'f RuleCx<'_>,
) -> impl Iterator<Item = (&'f Unfit, Finding)> + use<'f> {
    let by_cause = grouped(faults.all().iter().map(|one| ((wording.cause)(one), one)));
    by_cause.into_iter().filter_map(move |(cause, all)| {
        let first = *all.first()?;
        let message = format!(
            "{}{}",
            sentence(first, wording),
            such(all.len(), things(first))
        );
        let mut finding = rule
            .at(file, place(first), message)
            .key(cause)
            .help(help(first, cx));
        for other in all.iter().skip(1).take(EXAMPLES - 1) {
            finding = finding.related(file.path.clone(), place(other), sentence(other, wording));
        }
        Some((
            first,
            finding.evidence(Evidence::of_cases(
                all.iter().map(|one| one.pointer.as_str()),
            )),
        ))
    })
}

/// The key at the top of the file that a fault is below; empty for one of the whole.
pub(super) fn top(one: &Unfit) -> String {
    steps(&one.pointer).next().unwrap_or_default()
}

/// What is the same in faults that one slip makes: the key at the top and the sort. Baselines hold
/// it.
fn cause(one: &Unfit) -> String {
    format!("{} {}", top(one), sort(one))
}

/// The sort of a fault.
pub(super) fn sort(one: &Unfit) -> String {
    match &one.why {
        Why::Lacks(key) => format!("lacks {key}"),
        Why::Key(_) | Why::Property(_) => "key".to_owned(),
        Why::Type { .. } | Why::Text(_) => "type".to_owned(),
        Why::Word(..) => "word".to_owned(),
        Why::Length(..) => "length".to_owned(),
        Why::Range(_) => "range".to_owned(),
        Why::Twice(_) => "twice".to_owned(),
        Why::SecondLink(_) => "link".to_owned(),
        Why::Unknown(_) => "unknown".to_owned(),
    }
}

fn place(one: &Unfit) -> Place {
    match one.why {
        Why::Key(_) | Why::Property(_) => Place::Key(one.pointer.clone()),
        _ => Place::Pointer(one.pointer.clone()),
    }
}

const fn things(one: &Unfit) -> &'static str {
    match one.why {
        Why::Lacks(_) => "places",
        Why::Key(_) | Why::Property(_) => "keys",
        Why::Type { .. } | Why::Text(_) | Why::Word(..) | Why::Length(..) | Why::Range(_) => {
            "values"
        }
        Why::SecondLink(_) => "links",
        Why::Twice(_) | Why::Unknown(_) => "entries",
    }
}

fn sentence(one: &Unfit, wording: Wording) -> String {
    let subject = (wording.subject)(&one.pointer);
    match &one.why {
        Why::Lacks(key) => format!("{subject} has no `{key}`"),
        Why::Key(_) | Why::Property(_) => format!("{subject} is not a known key"),
        Why::Type { found, wanted } => format!("{subject} is {found}, expected {wanted}"),
        Why::Text(text) => format!("{subject} is `{}`, which is not a number", quoted(text)),
        Why::Word(text, known) => {
            let expected = if known.len() > MANY {
                String::new()
            } else {
                format!(", expected {}", either(&few(known)))
            };
            let unknown = if expected.is_empty() {
                ", which does not exist"
            } else {
                ""
            };
            format!("{subject} is `{}`{unknown}{expected}", quoted(text))
        }
        Why::Length(found, wanted) => format!("{subject} has {found} numbers, expected {wanted}"),
        Why::Range(value) if value.is_finite() => format!("{subject} is {value}, outside 0 to 1"),
        Why::Range(_) => format!("{subject} is NaN or infinite, expected a number from 0 to 1"),
        Why::Twice(name) => format!("`{}` occurs more than once", quoted(name)),
        Why::SecondLink(input) => format!("{subject} is a second link to {input}, expected one"),
        Why::Unknown(name) => format!("{subject} names `{}`, which does not exist", quoted(name)),
    }
}

fn help(one: &Unfit, cx: &RuleCx<'_>) -> String {
    match &one.why {
        Why::Lacks(key) => format!("add `{key}`"),
        Why::Key(known) => {
            let key = steps(&one.pointer).last().unwrap_or_default();
            did_you_mean(
                nearest(&key, known, cx),
                format!("write {}, or remove the key", either(&few(known))),
            )
        }
        Why::Property(known) => {
            let key = steps(&one.pointer).last().unwrap_or_default();
            did_you_mean(nearest_property(&key, known, cx), "remove the key")
        }
        Why::Type { wanted, .. } => format!("write {wanted}"),
        Why::Word(text, known) => did_you_mean(nearest(text, known, cx), write_one(known)),
        Why::Text(_) => "write a number from 0 to 1".to_owned(),
        Why::Length(_, wanted) => format!("write {wanted} numbers"),
        Why::Range(_) => "write a number from 0 to 1".to_owned(),
        Why::Twice(_) | Why::SecondLink(_) => "keep one of them".to_owned(),
        Why::Unknown(_) => "correct the name, or add what it names".to_owned(),
    }
}

/// The known word that one in other capitals, or with a slip in it, is meant to be.
fn nearest(text: &str, known: &'static [&'static str], cx: &RuleCx<'_>) -> Option<&'static str> {
    let in_other_case = known
        .iter()
        .find(|word| word.eq_ignore_ascii_case(text))
        .copied();
    in_other_case.or_else(|| cx.suggestions.nearest(text, known.iter().copied()))
}

/// Whether a key or a property that is not known is like one that is; any other is somebody's own.
/// Other faults are what they are.
pub(super) fn is_misspelt(one: &Unfit, cx: &RuleCx<'_>) -> bool {
    let key = steps(&one.pointer).last().unwrap_or_default();
    match &one.why {
        Why::Key(known) => nearest(&key, known, cx).is_some(),
        Why::Property(known) => nearest_property(&key, known, cx).is_some(),
        _ => true,
    }
}

fn nearest_property<'k>(key: &str, known: &'k [&'static str], cx: &RuleCx<'_>) -> Option<&'k str> {
    let known = known
        .iter()
        .flat_map(|names| names.split(' '))
        .filter(|name| !name.is_empty());
    cx.suggestions.nearest(key, known)
}

/// So many words are named one by one.
const MANY: usize = 10;

fn write_one(known: &[&str]) -> String {
    if known.len() > MANY {
        "write one that exists".to_owned()
    } else {
        format!("write {}", either(&few(known)))
    }
}

fn few(known: &[&str]) -> Vec<String> {
    known.iter().map(|word| format!("`{word}`")).collect()
}

fn quoted(text: &str) -> String {
    let mut short: String = text.chars().take(QUOTED).collect();
    if short.len() < text.len() {
        short.push('…');
    }
    short
}

/// The names that a pointer leads through; numbers of elements belong to the name before.
pub(super) fn names(pointer: &str) -> Vec<String> {
    let mut names: Vec<String> = Vec::new();
    for step in steps(pointer) {
        match names.last_mut() {
            Some(name) if step.bytes().all(|byte| byte.is_ascii_digit()) => {
                *name = format!("{name}[{step}]");
            }
            _ => names.push(quoted(&step)),
        }
    }
    names
}

/// `b[1]` of `a` for `/a/b/1`: the value and what it belongs to.
pub(super) fn subject(pointer: &str) -> String {
    let names = names(pointer);
    match names.as_slice() {
        [] => "the file".to_owned(),
        [name] => format!("`{name}`"),
        [.., owner, name] => format!("`{name}` of `{owner}`"),
    }
}
