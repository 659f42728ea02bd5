//! A component may occur in `comp` only once.

use super::super::{Check, Rule, RuleCx};
use crate::diag::{Application, Finding, Level, Place, RuleInfo};
use crate::repo::makehuman2::{Base, View};
use std::collections::BTreeSet;

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        breaks: &[(
            Application::Makehuman2,
            "generates names such as `female-female` that no target has: nothing of the macrodef applies",
        )],
        docs: "The names of a macrodef have one value for each entry of `comp`.\n\nWith a component twice, \
            MakeHuman 2 generates names that hold its value twice. None of the listed names is among them, so \
            the macrodef has no effect.\n\nRemove the repetition, or put the component there that was meant.",
        ..RuleInfo::new("macro-repeated-component", Level::Error, "a component occurs twice in one `comp`")
    },
    check: Check::Makehuman2(run),
};

fn run(_: &View<'_>, base: &Base<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some((file, macros)) = base.macro_file() else { return };
    for macrodef in &macros.macrodefs {
        let mut seen = BTreeSet::new();
        let repeated = macrodef.components.iter().enumerate().find(|(_, name)| !seen.insert(*name));
        let Some((at, name)) = repeated else { continue };
        let place = Place::pointer(["macrodef", &macrodef.index.to_string(), "comp", &at.to_string()]);
        let finding = RULE.at(file, place, format!("component `{name}` occurs twice in `comp`"));
        out.push(
            finding
                .key(macrodef.components.join("-"))
                .help("remove the repetition, or name the component that was meant"),
        );
    }
}
