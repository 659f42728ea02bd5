//! A slider sets a modifier that is loaded.

use super::super::{Check, Rule, RuleCx, did_you_mean};
use super::LOST_TABS;
use super::meant::{KnownGroups, Meant, exchanged, group_of};
use mhlint_diag::{Application::Makehuman1, Evidence, Finding, Level, Place, RuleInfo, grouped};
use mhlint_formats::unfit::NamedAt;
use mhlint_repo::FileFacts;
use mhlint_repo::makehuman1::View;

pub(crate) static RULE: Rule = Check::Makehuman1(run).rule(RuleInfo {
    breaks: &[(Makehuman1, LOST_TABS)],
    docs: include_str!("unknown_in_slider.md").trim_ascii_end(),
    ..RuleInfo::new(
        "modifiers-unknown-in-slider",
        Level::Error,
        "a slider for a modifier that does not exist",
    )
});

fn run(view: &View<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    // What a file that cannot be read holds, nobody knows.
    if !view.layers.checks_system() || !view.modifiers.is_whole() {
        return;
    }
    let meant = Meant::of(view, cx);
    let known = KnownGroups::of(view);
    for (place, set) in view.modifiers.sets.iter().enumerate() {
        let Some((file, sliders)) = set.sliders else {
            continue;
        };
        let (lost, others): (Vec<_>, Vec<_>) = sliders
            .modifiers()
            .partition(|named| !known.all.contains(group_of(&named.name)));
        for (group, sliders) in
            grouped(lost.into_iter().map(|named| (group_of(&named.name), named)))
        {
            match sliders.as_slice() {
                [only] => out.extend(finding(view, place, file, only, &meant, cx)),
                all => out.extend(of_group(view, file, group, all, &known, cx)),
            }
        }
        out.extend(
            others
                .into_iter()
                .filter_map(|named| finding(view, place, file, named, &meant, cx)),
        );
    }
}

/// Several sliders for a group that does not exist: it has another name.
fn of_group(
    view: &View<'_>,
    file: &FileFacts,
    group: &str,
    sliders: &[&NamedAt],
    known: &KnownGroups<'_>,
    cx: &RuleCx<'_>,
) -> Option<Finding> {
    let first = sliders.first()?;
    let message = format!(
        "no modifier is in group `{group}`, which {} sliders name",
        sliders.len()
    );
    let finding = RULE
        .at(file, Place::Pointer(first.pointer.clone()), message)
        .key(format!("group {group}"));
    let evidence = Evidence::of_cases(sliders.iter().map(|named| named.name.as_str()));
    // The targets say which of the two names is right.
    let help = match known.near(group, cx) {
        Some(near) if view.targets.has_group_from(group) => {
            format!("write `{group}` in place of `{near}` in the list of modifiers")
        }
        Some(near) => {
            format!(
                "write `{group}` in place of `{near}` in the list of modifiers, or the other way \
                    around here"
            )
        }
        None => "correct the group of these modifiers, or remove the sliders".to_owned(),
    };
    Some(finding.evidence(evidence).help(help))
}

fn finding(
    view: &View<'_>,
    place: usize,
    file: &FileFacts,
    named: &NamedAt,
    meant: &Meant<'_>,
    cx: &RuleCx<'_>,
) -> Option<Finding> {
    let name = named.name.as_str();
    let mut sets = view.modifiers.called(name).map(|one| one.set);
    let told = |message: String| {
        RULE.at(file, Place::Pointer(named.pointer.clone()), message)
            .key(name)
    };
    if let Some(first) = sets.next() {
        let later = view.modifiers.sets.get(first).filter(|_| first > place)?;
        let message = format!(
            "modifier `{name}` is loaded later, with `{}_modifiers.json`",
            later.stem
        );
        return Some(
            told(message).help(format!("move the slider to `{}_sliders.json`", later.stem)),
        );
    }
    // The modifier itself is what is wrong, and told.
    if meant.modifier(name, cx).is_some() {
        return None;
    }
    let other = exchanged(name);
    let other = other
        .as_deref()
        .and_then(|other| view.modifiers.called(other).next())
        .map(|one| one.name.as_str());
    let near = other.or_else(|| cx.suggestions.nearest(name, view.modifiers.names()));
    let finding = told(format!("modifier `{name}` does not exist"));
    Some(finding.help(did_you_mean(near, "correct the name, or remove the slider")))
}
