//! The class of a modifier can make it.

use super::super::{Check, Rule, RuleCx, did_you_mean};
use super::LOST_FILE;
use mhlint_diag::{Application::Makehuman1, Finding, Level, Place, RuleInfo};
use mhlint_repo::makehuman1::View;

pub(crate) static RULE: Rule = Check::Makehuman1(run).rule(RuleInfo {
    breaks: &[(Makehuman1, LOST_FILE)],
    docs: include_str!("unknown_type.md").trim_ascii_end(),
    ..RuleInfo::new(
        "modifiers-unknown-type",
        Level::Error,
        "a class that cannot make the modifier",
    )
});

const OF_MACROS: [&str; 2] = ["MacroModifier", "EthnicModifier"];
const OF_TARGETS: [&str; 1] = ["UniversalModifier"];

fn run(view: &View<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    if !view.layers.checks_system() {
        return;
    }
    for one in &view.modifiers.all {
        let Some(class) = &one.modifier.class else {
            continue;
        };
        let fitting: &[&str] = if one.modifier.variable.is_some() {
            &OF_MACROS
        } else {
            &OF_TARGETS
        };
        let name = class.name.as_str();
        if fitting.contains(&name) {
            continue;
        }
        let is_other = OF_MACROS.contains(&name) || OF_TARGETS.contains(&name);
        let why = if is_other {
            "is for the other kind of modifier"
        } else {
            "cannot make a modifier"
        };
        let near = cx
            .suggestions
            .nearest(name, fitting.iter().copied())
            .filter(|_| !is_other);
        let finding = RULE
            .at(
                one.file,
                Place::Pointer(class.pointer.clone()),
                format!("`{name}` {why}"),
            )
            .key(&one.name);
        out.push(finding.help(did_you_mean(
            near,
            "remove `modifierType`: the program finds the right one",
        )));
    }
}
