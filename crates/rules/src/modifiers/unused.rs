//! Modifiers that nothing describes or sets.

use std::collections::BTreeSet;

use super::super::{Check, Rule, RuleCx, such};
use super::meant::{Meant, exchanged};
use super::{is_copy, moves_nothing};
use mhlint_diag::{Application::Makehuman1, Evidence, Finding, Level, Place, RuleInfo, grouped};
use mhlint_repo::makehuman1::{KnownModifier, View};

pub(crate) static UNDESCRIBED: Rule = Check::Makehuman1(undescribed).rule(RuleInfo {
    breaks: &[(Makehuman1, "logs a warning and shows no description")],
    docs: include_str!("modifiers-undescribed.md").trim_ascii_end(),
    ..RuleInfo::new(
        "modifiers-undescribed",
        Level::Info,
        "a modifier without a description",
    )
});

pub(crate) static WITHOUT_SLIDER: Rule = Check::Makehuman1(without_slider).rule(RuleInfo {
    breaks: &[(Makehuman1, "shows no slider for it: only models set it")],
    docs: include_str!("modifiers-without-slider.md").trim_ascii_end(),
    ..RuleInfo::new(
        "modifiers-without-slider",
        Level::Info,
        "a modifier that no slider sets",
    )
});

fn undescribed(view: &View<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let described = view.modifiers.sets.iter().map(|set| {
        let (_, texts) = set.texts?;
        Some(
            texts
                .described
                .iter()
                .map(|named| named.name.as_str())
                .collect::<BTreeSet<_>>(),
        )
    });
    let described: Vec<Option<BTreeSet<&str>>> = described.collect();
    // A modifier at fault that a description means by another name is told itself.
    let meant = Meant::of(view, cx);
    let unknown = described
        .iter()
        .flatten()
        .flatten()
        .filter(|name| view.modifiers.called(name).next().is_none());
    let told_there: BTreeSet<&str> = unknown
        .filter_map(|name| Some(meant.modifier(name, cx)?.name.as_str()))
        .collect();
    let is_bare = |one: &&KnownModifier<'_>| {
        !told_there.contains(one.name.as_str())
            && described
                .get(one.set)
                .and_then(Option::as_ref)
                .is_some_and(|names| !names.contains(one.name.as_str()))
    };
    told(
        &UNDESCRIBED,
        view,
        is_bare,
        "has no description",
        "add an entry for it, `\"\"` for no description",
        out,
    );
}

fn without_slider(view: &View<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    // A list of sliders that cannot be read may have any.
    if view
        .modifiers
        .sets
        .iter()
        .any(|set| set.file.is_some() && set.sliders.is_none())
    {
        return;
    }
    let (with_slider, meant) = (view.modifiers.with_slider(), Meant::of(view, cx));
    let names = view.modifiers.all.iter().map(|one| one.name.as_str());
    let bare: Vec<&str> = names.filter(|name| !with_slider.contains(name)).collect();
    let is_bare: BTreeSet<&str> = bare.iter().copied().collect();
    let unknown = with_slider
        .iter()
        .filter(|name| view.modifiers.called(name).next().is_none());
    let near = |name: &&str| {
        exchanged(name)
            .filter(|other| is_bare.contains(other.as_str()))
            .or_else(|| {
                let near = cx.suggestions.nearest(name, bare.iter().copied());
                near.map(str::to_owned)
            })
    };
    // What a slider means by a name with a slip in it is told there.
    let told_there: BTreeSet<String> = unknown.filter_map(near).collect();
    let is_bare = |one: &&KnownModifier<'_>| {
        !with_slider.contains(one.name.as_str())
            && meant.slider_for(one).is_none()
            && !told_there.contains(&one.name)
    };
    told(
        &WITHOUT_SLIDER,
        view,
        is_bare,
        "has no slider",
        "add a slider for it, or remove it",
        out,
    );
}

/// One finding a file.
fn told(
    rule: &Rule,
    view: &View<'_>,
    is_meant: impl Fn(&&KnownModifier<'_>) -> bool,
    what: &str,
    help: &str,
    out: &mut Vec<Finding>,
) {
    if !view.layers.checks_system() {
        return;
    }
    let found = view
        .modifiers
        .all
        .iter()
        .filter(is_meant)
        .filter(|one| !moves_nothing(view, one) && !is_copy(view, one))
        .map(|one| (one.set, one));
    for all in grouped(found).into_values() {
        let Some(first) = all.first() else { continue };
        let message = format!(
            "modifier `{}` {what}{}",
            first.name,
            such(all.len(), "modifiers")
        );
        let finding = rule
            .at(
                first.file,
                Place::Pointer(first.modifier.pointer.clone()),
                message,
            )
            .key("modifiers");
        let names = || all.iter().map(|one| one.name.as_str());
        out.push(
            finding
                .parts(names())
                .evidence(Evidence::of_cases(names()))
                .help(help),
        );
    }
}
