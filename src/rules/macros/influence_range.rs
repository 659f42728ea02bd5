//! `macro_influence` must hold indices of macro definitions.

use super::super::{Check, Rule, RuleCx};
use crate::diag::{Application, Evidence, Finding, Level, Place, RuleInfo};
use crate::repo::{Base, Repository};

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        breaks: &[(
            Application::Makehuman2,
            "drops the index; with no valid index left, opening the slider removes all macro shape from view",
        )],
        docs: "`macro_influence` of a macro slider lists the macrodefs it takes part in, counted from \
            0.\n\nMakeHuman 2 drops indices for which there is no macrodef. It does not use the others to select \
            anything either: only whether any is left matters. So a single wrong index changes nothing (info), \
            but when none is left, the macro shape disappears while the slider is open (warning). A negative \
            index is kept and means nothing.\n\nCorrect the index.",
        ..RuleInfo::new("macro-influence-range", Level::Warning, "`macro_influence` holds an index without a macrodef")
    },
    check: Check::Base(run),
};

fn run(_: &Repository<'_>, base: &Base<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some((_, macros)) = base.macro_file() else { return };
    if macros.macrodefs.is_empty() {
        return; // `macro-unused-component`, or the schema: no index could be right.
    }
    let count = i64::try_from(macros.macrodefs.len()).unwrap_or(i64::MAX);
    for bound in &base.sliders {
        let Some(influence) = &bound.slider.macro_influence else { continue };
        let wrong: Vec<i64> = influence.iter().copied().filter(|index| !(0..count).contains(index)).collect();
        if wrong.is_empty() {
            continue;
        }
        let key = &bound.slider.key;
        let shown = wrong.iter().map(ToString::to_string).collect::<Vec<_>>().join(", ");
        let range = if count == 1 { "the only one is 0".to_owned() } else { format!("they are 0 to {}", count - 1) };
        let message = format!("`macro_influence` of `{key}` lists {shown}, which is no macrodef: {range}");
        let place = Place::pointer([key, "macro_influence"]);
        let evidence = Evidence::of_cases(&wrong).out_of(influence.len());
        let mut finding =
            RULE.at(bound.file, place, message).key(key).help("correct or remove the index").evidence(evidence);
        // Negative indices pass the loader's test, which looks at the upper end only.
        if influence.iter().any(|index| *index < count) {
            finding = finding.level(Level::Info).breaks(Application::Makehuman2, "nothing: another index is left");
        }
        out.push(finding);
    }
}
