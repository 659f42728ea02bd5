//! Names of values must not make names of combinations ambiguous.

use super::super::{Check, Rule, RuleCx};
use super::component::sound_components;
use super::space::Space;
use mhlint_diag::{Application::Makehuman2, Evidence, Finding, Level, Place, RuleInfo};
use mhlint_repo::makehuman2::{Base, View};
use std::collections::BTreeSet;

pub(crate) static RULE: Rule = Check::Makehuman2(run).rule(RuleInfo {
    breaks: &[(
        Makehuman2,
        "applies the target of an ambiguous name to every combination with that name",
    )],
    docs: include_str!("ambiguous_value.md").trim_ascii_end(),
    counts: "names",
    ..RuleInfo::new(
        "macro-ambiguous-value",
        Level::Warning,
        "a value contains a dash, or two combinations have the same name",
    )
});

const HELP: &str =
    "remove every `-` from the value, in the component and in the names that contain it";

fn run(_: &View<'_>, base: &Base<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some((file, macros)) = base.macro_file() else {
        return;
    };
    let mut explained: BTreeSet<&str> = BTreeSet::new();
    for macrodef in &macros.macrodefs {
        let Some(space) = Space::of(macros, macrodef) else {
            continue;
        };
        let ambiguous: Vec<_> = macrodef
            .links
            .iter()
            .filter(|link| space.spellings(&link.name) > 1)
            .collect();
        let Some(first) = ambiguous.first() else {
            continue;
        };
        explained.extend(space.axes.iter().map(|axis| axis.name.as_str()));
        let message = match ambiguous.len() {
            1 => format!("`{}` is the name of more than one combination", first.name),
            count => format!(
                "{count} names stand for more than one combination each, such as `{}`",
                first.name
            ),
        };
        let finding = RULE.at(
            file,
            Place::Pointer(macrodef.link_pointer(first, "name")),
            message,
        );
        let evidence = Evidence::of_cases(ambiguous.iter().map(|link| &link.name))
            .out_of(macrodef.links.len());
        out.push(
            finding
                .key(macrodef.components.join("-"))
                .help(HELP)
                .evidence(evidence),
        );
    }
    for component in sound_components(file, macros)
        .filter(|component| !explained.contains(component.name.as_str()))
    {
        let Some((at, value)) = component
            .values
            .iter()
            .enumerate()
            .find(|(_, value)| value.contains('-'))
        else {
            continue;
        };
        let message = format!(
            "value `{value}` of `{}` contains a dash, which separates values in names",
            component.name
        );
        let place = Place::pointer(["components", &component.name, "values", &at.to_string()]);
        let finding = RULE
            .at(file, place, message)
            .key(&component.name)
            .level(Level::Info);
        out.push(
            finding
                .effect("reads each listed name as meant, because each still has one meaning")
                .help(HELP),
        );
    }
}
