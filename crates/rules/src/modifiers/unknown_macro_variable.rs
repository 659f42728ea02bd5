//! A macro variable exists.

use super::super::{Check, Rule, RuleCx, did_you_mean};
use mhlint_diag::{Application::Makehuman1, Finding, Level, Place, RuleInfo};
use mhlint_repo::makehuman1::{VARIABLES, View};

pub(crate) static RULE: Rule = Check::Makehuman1(run).rule(RuleInfo {
    breaks: &[(
        Makehuman1,
        "shows none of the tabs behind its slider, and fails each time the modifier is used",
    )],
    docs: include_str!("unknown_macro_variable.md").trim_ascii_end(),
    ..RuleInfo::new(
        "modifiers-unknown-macro-variable",
        Level::Error,
        "a macro variable that does not exist",
    )
});

fn run(view: &View<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    if !view.layers.checks_system() {
        return;
    }
    for one in &view.modifiers.all {
        let Some(variable) = &one.modifier.variable else {
            continue;
        };
        let name = variable.name.as_str();
        if VARIABLES.contains(&name) {
            continue;
        }
        let in_capitals = VARIABLES
            .into_iter()
            .find(|own| own.eq_ignore_ascii_case(name));
        let near = in_capitals.or_else(|| cx.suggestions.nearest(name, VARIABLES));
        let message = format!("macro variable `{name}` does not exist");
        let finding = RULE
            .at(one.file, Place::Pointer(variable.pointer.clone()), message)
            .key(&one.name);
        let finding = finding.help(did_you_mean(near, "name a variable that exists"));
        out.push(if in_capitals.is_some() {
            finding.effect(super::super::cause::consequence::STOPS_AT_START)
        } else {
            finding
        });
    }
}
