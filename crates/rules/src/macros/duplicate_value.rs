//! A value may occur in a component only once.

use super::super::{Check, Rule, RuleCx};
use super::component::{sound_components, weigh};
use mhlint_diag::{Application::Makehuman2, Finding, Level, Place, RuleInfo};
use mhlint_repo::makehuman2::{Base, View};
use std::collections::BTreeSet;

pub(crate) static RULE: Rule = Check::Makehuman2(run).rule(RuleInfo {
    breaks: &[(
        Makehuman2,
        "uses the same combinations at both slider positions, so that one of the two shapes can \
            never be reached",
    )],
    docs: include_str!("duplicate_value.md").trim_ascii_end(),
    ..RuleInfo::new(
        "macro-duplicate-value",
        Level::Warning,
        "a component has a value twice",
    )
});

fn run(_: &View<'_>, base: &Base<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some((file, macros)) = base.macro_file() else {
        return;
    };
    for component in sound_components(file, macros) {
        let mut seen = BTreeSet::new();
        let repeated = component
            .values
            .iter()
            .enumerate()
            .find(|(_, value)| !seen.insert(*value));
        let Some((at, value)) = repeated else {
            continue;
        };
        let name = &component.name;
        let message = format!("component `{name}` has the value `{value}` twice");
        let place = Place::pointer(["components", name, "values", &at.to_string()]);
        let finding = RULE
            .at(file, place, message)
            .key(name)
            .help("give each value its own name");
        out.push(weigh(finding, macros, component));
    }
}
