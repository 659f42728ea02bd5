//! An entry must do something.

use std::collections::BTreeMap;

use super::super::cause::component::{Readers, patterns};
use super::super::{Check, Rule, RuleCx};
use super::groups;
use mhlint_diag::{Application::Makehuman2, EXAMPLES, Finding, Level, Place, RuleInfo};
use mhlint_formats::macro_json::Macrodef;
use mhlint_formats::modelling::EFFECTS;
use mhlint_repo::makehuman2::{Base, BoundSlider, Pattern, View};
use mhlint_repo::{Reference, ReferenceKind};

pub(crate) static RULE: Rule = Check::Makehuman2(run).rule(RuleInfo {
    breaks: &[(
        Makehuman2,
        "shows a slider that does nothing and is never saved",
    )],
    docs: include_str!("no_effect.md").trim_ascii_end(),
    ..RuleInfo::new(
        "modelling-no-effect",
        Level::Warning,
        "an entry has none of `incr`, `decr`, `macro` and `barycentric`",
    )
});

fn run(view: &View<'_>, base: &Base<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let loaded = loaded(view, base);
    let macros = base.macro_file().map(|(_, macros)| macros);
    let readers = macros
        .filter(|macros| !macros.is_too_large)
        .map(|macros| Readers::of(macros, patterns));
    for bound in groups::hand_made(base) {
        let slider = bound.slider;
        if EFFECTS.iter().any(|key| slider.has(key)) {
            out.extend(beside_macro(bound, &loaded));
            continue;
        }
        let help = match slider.misspelt_effect() {
            Some((key, near)) => format!("did you mean `{near}` instead of `{key}`?"),
            None => "add `incr`, `macro` or `barycentric`, or remove the entry".to_owned(),
        };
        let message = format!(
            "`{}` has none of `incr`, `decr`, `macro` and `barycentric`",
            slider.key
        );
        let finding = RULE
            .at(bound.file, Place::key([&slider.key]), message)
            .key(&slider.key)
            .help(help);
        let lost = readers
            .iter()
            .flat_map(|all| all.of_any(bound.meant.names()));
        let lost: Vec<&Macrodef> = lost.collect();
        out.push(if lost.is_empty() {
            finding
        } else {
            finding.level(Level::Error).effect(never_applied(&lost))
        });
    }
}

/// What becomes of the macro definitions that get no value without the slider.
fn never_applied(lost: &[&Macrodef]) -> String {
    let name = |macrodef: &&Macrodef| {
        macrodef.name.as_deref().map_or_else(
            || format!("number {}", macrodef.index),
            |name| format!("`{name}`"),
        )
    };
    let names: Vec<String> = lost.iter().take(EXAMPLES).map(name).collect();
    let more = if lost.len() > EXAMPLES {
        " and others"
    } else {
        ""
    };
    let macrodefs = if lost.len() == 1 {
        "macrodef"
    } else {
        "macrodefs"
    };
    format!(
        "finds no slider with this pattern and never applies the {macrodefs} {}{more}",
        names.join(", ")
    )
}

/// The first target that is there of each entry, by key.
fn loaded<'r>(view: &'r View<'_>, base: &'r Base<'_>) -> BTreeMap<&'r str, &'r Reference<'r>> {
    let is_loaded = |reference: &&Reference<'_>| {
        matches!(reference.kind, ReferenceKind::Incr | ReferenceKind::Decr)
            && reference.found().is_some()
    };
    let mut loaded = BTreeMap::new();
    for reference in view.references_of(base).filter(is_loaded) {
        loaded.entry(reference.owner).or_insert(reference);
    }
    loaded
}

/// `incr` or `decr` of an entry that `macro` or `barycentric` takes all effect from; a target that
/// does not exist has a finding of its own.
fn beside_macro(
    bound: &BoundSlider<'_>,
    loaded: &BTreeMap<&str, &Reference<'_>>,
) -> Option<Finding> {
    let slider = bound.slider;
    let winner = match bound.pattern {
        Pattern::Macro(_) => "macro",
        Pattern::Barycentric(_) => "barycentric",
        _ => return None,
    };
    let loaded = loaded.get(slider.key.as_str())?;
    let member = if loaded.kind == ReferenceKind::Incr {
        "incr"
    } else {
        "decr"
    };
    let message = format!(
        "`{member}` of `{}` has no effect beside `{winner}`: `{}` is never applied",
        slider.key, loaded.text
    );
    let finding = RULE
        .at(bound.file, loaded.place.clone(), message)
        .key(&slider.key);
    Some(
        finding
            .effect(format!(
                "silently ignores `{member}`, although it loads the target"
            ))
            .help(format!("move `{member}` to its own entry, or remove it")),
    )
}
