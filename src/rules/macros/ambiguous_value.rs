//! Names of values must not make names of combinations ambiguous.

use super::super::{Check, Rule, RuleCx};
use super::component::sound_components;
use super::space::Space;
use crate::diag::{Application, Evidence, Finding, Level, Place, RuleInfo};
use crate::repo::makehuman2::{Base, View};
use std::collections::BTreeSet;

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        breaks: &[(
            Application::Makehuman2,
            "applies the target of an ambiguous name for every combination that spells it",
        )],
        docs: "The name of a combination is its values joined by `-`. A value that holds a dash itself makes such a \
            name hard to read, and possibly the name of two combinations: `a` + `b-c` and `a-b` + \
            `c`.\n\nMakeHuman 2 compares whole names only. As long as every name has one meaning nothing happens \
            (info); a name with two meanings is applied for both (warning).\n\nUse another character inside the \
            names of values.",
        ..RuleInfo::new(
            "macro-ambiguous-value",
            Level::Warning,
            "a value holds a dash, or two combinations spell the same name",
        )
    },
    check: Check::Makehuman2(run),
};

fn run(_: &View<'_>, base: &Base<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some((file, macros)) = base.macro_file() else { return };
    let mut explained: BTreeSet<&str> = BTreeSet::new();
    for macrodef in &macros.macrodefs {
        let Some(space) = Space::of(macros, macrodef) else { continue };
        let ambiguous: Vec<_> = macrodef.links.iter().filter(|link| space.spellings(&link.name) > 1).collect();
        let Some(first) = ambiguous.first() else { continue };
        explained.extend(space.axes.iter().map(|axis| axis.name.as_str()));
        let message = match ambiguous.len() {
            1 => format!("`{}` is the name of several combinations", first.name),
            count => format!("{count} names stand for several combinations each, `{}` for one", first.name),
        };
        let finding = RULE.at(file, Place::Pointer(macrodef.link_pointer(first, "name")), message);
        let evidence = Evidence::of_cases(ambiguous.iter().map(|link| &link.name)).out_of(macrodef.links.len());
        out.push(finding.key(macrodef.components.join("-")).help("name the values without `-`").evidence(evidence));
    }
    for component in sound_components(file, macros).filter(|component| !explained.contains(component.name.as_str())) {
        let Some((at, value)) = component.values.iter().enumerate().find(|(_, value)| value.contains('-')) else {
            continue;
        };
        let message = format!("value `{value}` of `{}` holds a dash, which separates values in names", component.name);
        let place = Place::pointer(["components", &component.name, "values", &at.to_string()]);
        let finding = RULE.at(file, place, message).key(&component.name).level(Level::Info);
        out.push(finding.effect("nothing yet: every listed name has one meaning").help("name the value without `-`"));
    }
}
