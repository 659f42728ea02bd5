//! A value may occur in a component only once.

use super::super::{Check, Rule, RuleCx};
use super::component::{sound_components, weigh};
use crate::diag::{Application, Finding, Level, Place, RuleInfo};
use crate::repo::makehuman2::{Base, View};
use std::collections::BTreeSet;

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        breaks: &[(
            Application::Makehuman2,
            "takes both positions of the slider for the same combinations, so that one of the two shapes can never be had",
        )],
        docs: "The name of a value is the only thing that tells the combinations of one slider position from those \
            of another.\n\nMakeHuman 2 does not check it. Two positions with one name lead to the same targets; \
            the shape that was meant for one of them cannot be reached. Nothing stops, so this is a \
            warning.\n\nGive every value a name of its own; the same file can still be used for several names.",
        ..RuleInfo::new("macro-duplicate-value", Level::Warning, "a component names a value twice")
    },
    check: Check::Makehuman2(run),
};

fn run(_: &View<'_>, base: &Base<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some((file, macros)) = base.macro_file() else { return };
    for component in sound_components(file, macros) {
        let mut seen = BTreeSet::new();
        let repeated = component.values.iter().enumerate().find(|(_, value)| !seen.insert(*value));
        let Some((at, value)) = repeated else { continue };
        let name = &component.name;
        let message = format!("component `{name}` names the value `{value}` twice");
        let place = Place::pointer(["components", name, "values", &at.to_string()]);
        let finding = RULE.at(file, place, message).key(name).help("give every value a name of its own");
        out.push(weigh(finding, macros, component));
    }
}
