//! A slider sets a modifier that is loaded.

use super::super::{Check, Rule, RuleCx, did_you_mean};
use super::LOST_TABS;
use super::meant::{Meant, exchanged};
use crate::diag::{Application::Makehuman1, Finding, Level, Place, RuleInfo};
use crate::formats::unfit::NamedAt;
use crate::repo::FileFacts;
use crate::repo::makehuman1::View;

pub(in crate::rules) static RULE: Rule = Check::Makehuman1(run).rule(RuleInfo {
    breaks: &[(Makehuman1, LOST_TABS)],
    docs: "`mod` of a slider is the full name of a modifier, `group/target-min|max`, of its own file or one that is loaded \
        before: MakeHuman 1 loads `modeling`, then `bodyshapes`, then `measurement`.\n\n\
        One unknown name costs the rest of its tab and all tabs behind it in the file. The modifiers themselves exist, and \
        models set them.\n\nCorrect the name.",
    ..RuleInfo::new("modifiers-unknown-in-slider", Level::Error, "a slider for a modifier that does not exist")
});

fn run(view: &View<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    // What a file that cannot be read holds, nobody knows.
    if !view.layers.checks_system() || !view.modifiers.is_whole() {
        return;
    }
    let meant = Meant::of(view, cx);
    for (place, set) in view.modifiers.sets.iter().enumerate() {
        let Some((file, sliders)) = set.sliders else { continue };
        for named in sliders.modifiers() {
            out.extend(finding(view, place, file, named, &meant, cx));
        }
    }
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
    let told = |message: String| RULE.at(file, Place::Pointer(named.pointer.clone()), message).key(name);
    if let Some(first) = sets.next() {
        let later = view.modifiers.sets.get(first).filter(|_| first > place)?;
        let message = format!("modifier `{name}` is loaded later, with `{}_modifiers.json`", later.stem);
        return Some(told(message).help(format!("move the slider to `{}_sliders.json`", later.stem)));
    }
    // The modifier itself is what is wrong, and told.
    if meant.modifier(name, cx).is_some() {
        return None;
    }
    let other = exchanged(name);
    let other = other.as_deref().and_then(|other| view.modifiers.called(other).next()).map(|one| one.name.as_str());
    let near = other.or_else(|| cx.suggestions.nearest(name, view.modifiers.names()));
    let finding = told(format!("modifier `{name}` does not exist"));
    Some(finding.help(did_you_mean(near, "correct the name, or remove the slider")))
}
