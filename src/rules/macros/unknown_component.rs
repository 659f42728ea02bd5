//! `comp` must name components that are defined.

use super::super::{Check, Rule, RuleCx};
use crate::diag::{Application, Finding, Level, Place, RuleInfo, nearest};
use crate::repo::{Base, Repository};

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        breaks: &[(
            Application::Makehuman2,
            "skips the component; the names of the macrodef become too short, and none of its targets is ever applied",
        )],
        docs: "`comp` lists the components whose values make the names of a macrodef, by their keys in \
            `components`.\n\nMakeHuman 2 skips a name it does not know, without a message. Every generated name \
            then lacks that part: usually nothing matches, sometimes the wrong target does.\n\nCorrect the name, \
            or define the component.",
        ..RuleInfo::new("macro-unknown-component", Level::Error, "`comp` names a component that is not defined")
    },
    check: Check::Base(run),
};

fn run(_: &Repository<'_>, base: &Base<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some((file, macros)) = base.macro_file() else { return };
    // Without any component `components` is no object, or missing, and the schema says so.
    if macros.components.is_empty() && !file.schema.faults.is_empty() {
        return;
    }
    let known = || macros.components.iter().map(|component| component.name.as_str());
    for macrodef in &macros.macrodefs {
        for (at, name) in macrodef.components.iter().enumerate() {
            if known().any(|other| other == name) {
                continue;
            }
            let help = match nearest(name, known().filter(|other| !macrodef.components.iter().any(|own| own == other)))
            {
                Some(near) => format!("did you mean `{near}`?"),
                None => "define the component, or remove it from `comp` and from the names".to_owned(),
            };
            let place = Place::pointer(["macrodef", &macrodef.index.to_string(), "comp", &at.to_string()]);
            let finding = RULE.at(file, place, format!("component `{name}` is not defined"));
            out.push(finding.key(format!("{}/{name}", macrodef.components.join("-"))).help(help));
        }
    }
}
