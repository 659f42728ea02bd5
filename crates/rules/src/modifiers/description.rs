//! A description is a text, for a modifier that exists.

use super::super::{Check, Rule, RuleCx, did_you_mean, such};
use super::LOST_TABS;
use super::meant::Meant;
use mhlint_diag::{Application::Makehuman1, Evidence, Finding, Level, Place, RuleInfo};
use mhlint_repo::makehuman1::View;

pub(crate) static RULE: Rule = Check::Makehuman1(run).rule(RuleInfo {
    breaks: &[(Makehuman1, "logs a warning: the description is never shown")],
    docs: include_str!("modifiers-unknown-in-description.md").trim_ascii_end(),
    ..RuleInfo::new(
        "modifiers-unknown-in-description",
        Level::Info,
        "a description for a modifier that does not exist",
    )
});

pub(crate) static OF_TYPE: Rule = Check::Makehuman1(of_type).rule(RuleInfo {
    breaks: &[(Makehuman1, LOST_TABS)],
    docs: include_str!("modifiers-description-type.md").trim_ascii_end(),
    ..RuleInfo::new(
        "modifiers-description-type",
        Level::Error,
        "a description that is not a text",
    )
});

fn run(view: &View<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    if !view.layers.checks_system() || !view.modifiers.is_whole() {
        return;
    }
    let meant = Meant::of(view, cx);
    for (file, texts) in view.modifiers.sets.iter().filter_map(|set| set.texts) {
        let is_unknown = |name: &str| {
            view.modifiers.called(name).next().is_none() && meant.modifier(name, cx).is_none()
        };
        let unknown: Vec<_> = texts
            .described
            .iter()
            .filter(|named| is_unknown(&named.name))
            .collect();
        let Some(first) = unknown.first() else {
            continue;
        };
        let message = format!(
            "modifier `{}` does not exist{}",
            first.name,
            such(unknown.len(), "entries")
        );
        let near = cx.suggestions.nearest(&first.name, view.modifiers.names());
        let finding = RULE
            .at(file, Place::Key(first.pointer.clone()), message)
            .key("entries");
        let finding = finding.parts(unknown.iter().map(|named| named.name.as_str()));
        let finding = finding.evidence(Evidence::of_cases(
            unknown.iter().map(|named| named.name.as_str()),
        ));
        out.push(finding.help(did_you_mean(near, "correct the name, or remove the entry")));
    }
}

fn of_type(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    if !view.layers.checks_system() {
        return;
    }
    let with_slider = view.modifiers.with_slider();
    for (file, texts) in view.modifiers.sets.iter().filter_map(|set| set.texts) {
        for (named, found) in &texts.no_texts {
            let has_slider = with_slider.contains(named.name.as_str());
            let message = format!(
                "the description of `{}` is {found}, expected a text",
                named.name
            );
            let finding = OF_TYPE
                .at(file, Place::Pointer(named.pointer.clone()), message)
                .key(&named.name);
            let finding = finding.help("write a text, `\"\"` for none");
            let harmless = "shows nothing of it: no slider has this modifier";
            out.push(if has_slider {
                finding
            } else {
                finding.level(Level::Info).effect(harmless)
            });
        }
    }
}
