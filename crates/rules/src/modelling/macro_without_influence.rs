//! A macro slider must name a macro definition that it influences.

use std::collections::{BTreeMap, BTreeSet};

use super::super::cause::component::{Readers, named_patterns};
use super::super::{Check, Rule, RuleCx};
use mhlint_diag::{Application::Makehuman2, Confidence, Finding, Level, Place, RuleInfo, pointer};
use mhlint_formats::macro_json::MacroFile;
use mhlint_repo::makehuman2::{Base, Pattern, View};

pub(crate) static RULE: Rule = Check::Makehuman2(run).rule(RuleInfo {
    breaks: &[(
        Makehuman2,
        "hides all macro shapes when the slider is opened, until another macro slider moves",
    )],
    docs: include_str!("macro_without_influence.md").trim_ascii_end(),
    ..RuleInfo::new(
        "modelling-macro-without-influence",
        Level::Warning,
        "a macro slider has no `macro_influence`",
    )
});

fn run(_: &View<'_>, base: &Base<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let is_judged = |macros: &MacroFile| !macros.macrodefs.is_empty() && !macros.is_too_large;
    let Some((_, macros)) = base.macro_file().filter(|(_, macros)| is_judged(macros)) else {
        return;
    };
    let readers = Readers::of(macros, named_patterns);
    let mut faulty: BTreeMap<&str, BTreeSet<&str>> = BTreeMap::new();
    for (file, _) in base
        .modelling
        .winner()
        .into_iter()
        .chain(base.user_modelling.accepted())
    {
        faulty.insert(
            &file.path,
            file.schema
                .faults
                .iter()
                .map(|fault| fault.pointer.as_str())
                .collect(),
        );
    }
    for bound in &base.sliders {
        let slider = bound.slider;
        // A list of wrong positions or of a wrong type is a finding of its own.
        let pointer = pointer(&[&slider.key, "macro_influence"]);
        let is_misshapen = || {
            let below = faulty
                .get(bound.file.path.as_str())
                .and_then(|faults| faults.range(pointer.as_str()..).next());
            below.is_some_and(|fault| fault.starts_with(&pointer))
        };
        let is_empty =
            slider.macro_influence.as_ref().is_some_and(Vec::is_empty) && !is_misshapen();
        if bound.as_meant().has("macro_influence") && !is_empty {
            continue;
        }
        let users = || -> Vec<usize> {
            let users = readers.of_any(bound.pattern.names()).into_iter();
            users.map(|macrodef| macrodef.index).collect()
        };
        let confidence = match &bound.pattern {
            Pattern::Macro(_) => Confidence::High,
            Pattern::Barycentric(_) if !users().is_empty() => Confidence::Medium,
            _ => continue,
        };
        let (what, member) = if is_empty {
            ("an empty", "macro_influence")
        } else {
            ("no", "macro")
        };
        let place = match &bound.pattern {
            Pattern::Barycentric(_) if !is_empty => Place::key([&slider.key]),
            _ => Place::pointer([&slider.key, member]),
        };
        let message = format!("macro slider `{}` has {what} `macro_influence`", slider.key);
        let finding = RULE
            .at(bound.file, place, message)
            .key(&slider.key)
            .help(help(&users()));
        out.push(finding.confidence(confidence));
    }
}

fn help(users: &[usize]) -> String {
    if users.is_empty() {
        return "list its macrodefs, or remove `macro`; no component of macro.json reads the slider"
            .to_owned();
    }
    let list: Vec<String> = users.iter().map(usize::to_string).collect();
    format!("add `\"macro_influence\": [{}]`", list.join(", "))
}
