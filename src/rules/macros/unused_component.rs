//! A component that no macro definition uses.

use super::super::{Check, Rule, RuleCx};
use crate::diag::{Application, Finding, Level, Place, RuleInfo, nearest};
use crate::repo::{Base, Repository};

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        breaks: &[(Application::Makehuman2, "nothing: the component is never evaluated")],
        docs: "A component has an effect only through the macrodefs that list it in `comp`.\n\nMakeHuman 2 does not \
            look at other components. Perhaps a macrodef was removed and its component forgotten, or the \
            component is missing from a `comp`.\n\nRemove it, or add it where it was meant.",
        ..RuleInfo::new("macro-unused-component", Level::Info, "a component is used by no macrodef")
    },
    check: Check::Base(run),
};

fn run(_: &Repository<'_>, base: &Base<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some((file, macros)) = base.macro_file() else { return };
    let used = || macros.macrodefs.iter().flat_map(|macrodef| &macrodef.components).map(String::as_str);
    let known = || macros.components.iter().map(|component| component.name.as_str());
    // An unknown component that is a slip of the pen for this one is the cause, and `macro-unknown-component` names it.
    let misspelt =
        |name: &str| used().any(|other| !known().any(|k| k == other) && nearest(other, known()) == Some(name));
    if macros.macrodefs.iter().any(|macrodef| macrodef.components.is_empty()) {
        return; // `macro-unexpected-combination`: what belongs into the empty `comp` is open.
    }
    for component in &macros.components {
        let name = component.name.as_str();
        if !used().any(|other| other == name) && !misspelt(name) {
            let place = Place::key(["components", name]);
            let finding = RULE.at(file, place, format!("component `{name}` is used by no macrodef"));
            out.push(finding.key(name).help("remove it, or add it to the `comp` of a macrodef"));
        }
    }
}
