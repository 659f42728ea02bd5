//! `macro_influence` must hold indices of macro definitions.

use super::super::{Check, Rule, RuleCx};
use mhlint_diag::{
    Application::Makehuman2, EXAMPLES, Evidence, Finding, Level, Place, RuleInfo, grouped,
};
use mhlint_repo::makehuman2::{Base, BoundSlider, View};

pub(crate) static RULE: Rule = Check::Makehuman2(run).rule(RuleInfo {
    breaks: &[(
        Makehuman2,
        "ignores the index; with no valid index left, opening the slider hides all macro shapes \
         until another macro slider moves",
    )],
    docs: include_str!("influence_range.md").trim_ascii_end(),
    ..RuleInfo::new(
        "macro-influence-range",
        Level::Warning,
        "`macro_influence` lists an index \
        without a macrodef",
    )
});

fn run(_: &View<'_>, base: &Base<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some((_, macros)) = base.macro_file() else {
        return;
    };
    if macros.macrodefs.is_empty() {
        return; // `macro-unused-component`, or the schema: no index could be right.
    }
    let count = i64::try_from(macros.macrodefs.len()).unwrap_or(i64::MAX);
    // A macro definition that was removed leaves the same index in many sliders: one cause.
    let groups = grouped(base.sliders.iter().filter_map(|bound| {
        let influence = bound.slider.macro_influence.iter().flatten().copied();
        let wrong: Vec<i64> = influence
            .filter(|index| !(0..count).contains(index))
            .collect();
        (!wrong.is_empty()).then_some((wrong, bound))
    }));
    for (wrong, sliders) in groups {
        out.extend(finding(&wrong, &sliders, count));
    }
}

/// One finding on all sliders that list the same wrong indices.
fn finding(wrong: &[i64], sliders: &[&BoundSlider<'_>], count: i64) -> Option<Finding> {
    let (first, others) = sliders.split_first()?;
    let place =
        |bound: &BoundSlider<'_>| Place::pointer([bound.slider.key.as_str(), "macro_influence"]);
    let key = &first.slider.key;
    let shown = wrong
        .iter()
        .map(ToString::to_string)
        .collect::<Vec<_>>()
        .join(", ");
    let range = if count == 1 {
        "the only macrodef is number 0".to_owned()
    } else {
        format!("the macrodefs are numbered 0 to {}", count - 1)
    };
    let more = if others.is_empty() {
        String::new()
    } else {
        format!(" (in {} sliders)", sliders.len())
    };
    let message = format!("`macro_influence` of `{key}` lists {shown}, but {range}{more}");
    let mut finding = RULE.at(first.file, place(first), message);
    finding = finding.help(if others.is_empty() {
        "correct the index, or remove it if the list has others"
    } else {
        "correct the index; if a macrodef was removed, restore it, or also remove its components \
            and folder"
    });
    finding = if others.is_empty() {
        let listed = first.slider.macro_influence.as_ref().map_or(0, Vec::len);
        finding
            .key(key)
            .evidence(Evidence::of_cases(wrong).out_of(listed))
    } else {
        finding.key(shown).evidence(Evidence::of_cases(
            sliders.iter().map(|bound| &bound.slider.key),
        ))
    };
    for other in others.iter().take(EXAMPLES - 1) {
        finding = finding.related(&other.file.path, place(other), "also lists it");
    }
    // Negative indices pass the loader's test, which looks at the upper end only.
    let has_other = |bound: &&BoundSlider<'_>| {
        bound
            .slider
            .macro_influence
            .iter()
            .flatten()
            .any(|index| *index < count)
    };
    if sliders.iter().all(has_other) {
        let in_range = |bound: &&BoundSlider<'_>| {
            bound
                .slider
                .macro_influence
                .iter()
                .flatten()
                .any(|at| (0..count).contains(at))
        };
        let effect = if sliders.iter().all(in_range) {
            "ignores the index; the slider works, because another index is left"
        } else {
            "keeps the negative index; the slider works, because MakeHuman 2 only checks whether \
                any index is left"
        };
        finding = finding.level(Level::Info).effect(effect);
    }
    Some(finding)
}
