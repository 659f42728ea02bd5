//! A component may occur in `comp` only once.

use super::super::{Check, Rule, RuleCx};
use mhlint_diag::{Application::Makehuman2, Finding, Level, Place, RuleInfo};
use mhlint_repo::makehuman2::{Base, View};
use std::collections::BTreeSet;

pub(crate) static RULE: Rule = Check::Makehuman2(run).rule(RuleInfo {
    breaks: &[(
        Makehuman2,
        "generates names such as `female-female`, which no entry has, and applies none of its \
            targets",
    )],
    docs: include_str!("repeated_component.md").trim_ascii_end(),
    ..RuleInfo::new(
        "macro-repeated-component",
        Level::Error,
        "a component occurs more than once \
        in `comp`",
    )
});

fn run(_: &View<'_>, base: &Base<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some((file, macros)) = base.macro_file() else {
        return;
    };
    for macrodef in &macros.macrodefs {
        let mut seen = BTreeSet::new();
        let repeated = macrodef
            .components
            .iter()
            .enumerate()
            .find(|(_, name)| !seen.insert(*name));
        let Some((at, name)) = repeated else { continue };
        let place = Place::pointer([
            "macrodef",
            &macrodef.index.to_string(),
            "comp",
            &at.to_string(),
        ]);
        let finding = RULE.at(
            file,
            place,
            format!("component `{name}` occurs more than once in `comp`"),
        );
        out.push(
            finding
                .key(macrodef.components.join("-"))
                .help("remove the repetition, or name the intended component"),
        );
    }
}
