//! What one side has, the other one has as well.

use std::collections::{BTreeMap, BTreeSet};

use super::super::{Check, Rule, RuleCx};
use mhlint_diag::{Application::Makehuman1, Finding, Level, Place, RuleInfo};
use mhlint_repo::FileFacts;
use mhlint_repo::makehuman1::{KnownModifier, View};

pub(crate) static RULE: Rule = Check::Makehuman1(run).rule(RuleInfo {
    breaks: &[(Makehuman1, "fails with `KeyError` when symmetry is used")],
    docs: include_str!("missing_symmetric.md").trim_ascii_end(),
    ..RuleInfo::new(
        "modifiers-missing-symmetric",
        Level::Error,
        "a modifier without its left or right counterpart",
    )
});

fn run(view: &View<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let told = |file: &FileFacts, place: Place, name: &str, other: &str, near: Option<&str>| {
        let finding = RULE
            .at(
                file,
                place,
                format!("`{name}` has no counterpart: `{other}` does not exist"),
            )
            .key(name);
        let renamed = |near| {
            format!("if `{near}` is meant, rename it, with its targets, slider and description")
        };
        finding.help(near.map_or_else(|| "add the counterpart".to_owned(), renamed))
    };
    if view.layers.checks_system() {
        // What a file that cannot be read holds, nobody knows.
        if !view.modifiers.is_whole() {
            return;
        }
        let lonely = view.modifiers.all.iter().filter_map(|one| {
            let other = opposite(&one.name)
                .filter(|other| view.modifiers.called(other).next().is_none())?;
            Some((one, other))
        });
        // Two that differ in their ends alone miss one another.
        let mut pairs: BTreeMap<[String; 2], Vec<(&KnownModifier<'_>, String)>> = BTreeMap::new();
        for (one, other) in lonely {
            let mut key = [stem(&one.name).to_owned(), stem(&other).to_owned()];
            key.sort_unstable();
            pairs.entry(key).or_default().push((one, other));
        }
        for pair in pairs.into_values() {
            let Some((one, other)) = pair.first() else {
                continue;
            };
            let near = pair
                .iter()
                .map(|(near, _)| near)
                .find(|near| stem(&near.name) == stem(other));
            let place = Place::Pointer(one.modifier.pointer.clone());
            let near = near
                .map(|near| near.name.as_str())
                .or_else(|| cx.suggestions.nearest(other, view.modifiers.names()));
            let near = near.filter(|near| *near != one.name);
            out.push(told(one.file, place, &one.name, other, near));
        }
        return;
    }
    let known: BTreeSet<&str> = view
        .targets
        .custom
        .iter()
        .map(|one| one.name.as_str())
        .collect();
    for one in view
        .targets
        .custom
        .iter()
        .filter(|one| view.layers.is_checked(one.file))
    {
        let other = opposite(&one.name).filter(|other| !known.contains(other.as_str()));
        out.extend(other.map(|other| told(one.file, Place::File, &one.name, &other, None)));
    }
}

/// The name without what follows on both sides.
fn stem(name: &str) -> &str {
    name.rsplit_once('-')
        .filter(|(_, tails)| tails.contains('|'))
        .map_or(name, |(stem, _)| stem)
}

/// The name of the other side. With both words `l` counts.
fn opposite(full: &str) -> Option<String> {
    let (group, name) = full.split_once('/')?;
    let words: Vec<&str> = name.split('-').collect();
    if !words.iter().any(|word| matches!(*word, "l" | "r")) {
        return None;
    }
    let exchanged = words.into_iter().map(|word| match word {
        "l" => "r",
        "r" => "l",
        other => other,
    });
    Some(format!(
        "{group}/{}",
        exchanged.collect::<Vec<_>>().join("-")
    ))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_are_exchanged() {
        assert_eq!(
            opposite("arms/l-hand-in|out").as_deref(),
            Some("arms/r-hand-in|out")
        );
        assert_eq!(opposite("l/hand"), None);
        assert_eq!(opposite("a/hand-r").as_deref(), Some("a/hand-l"));
        assert_eq!(opposite("a/left-hand"), None);
    }
}
