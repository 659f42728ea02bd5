//! The value of a reset is in the range of the slider.

use super::super::{Check, Rule, RuleCx};
use mhlint_diag::{Application::Makehuman1, Finding, Level, Place, RuleInfo};
use mhlint_repo::makehuman1::View;

pub(crate) static RULE: Rule = Check::Makehuman1(run).rule(RuleInfo {
    breaks: &[(Makehuman1, "resets the slider to the end of its range")],
    docs: include_str!("default_value.md").trim_ascii_end(),
    ..RuleInfo::new(
        "modifiers-default-value",
        Level::Warning,
        "a default outside the range of the slider",
    )
});

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    if !view.layers.checks_system() {
        return;
    }
    for one in &view.modifiers.all {
        let Some(value) = one.modifier.default else {
            continue;
        };
        let lowest = if one.modifier.variable.is_none() && one.modifier.tails.sides().is_some() {
            -1.0
        } else {
            0.0
        };
        if (lowest..=1.0).contains(&value) {
            continue;
        }
        let message = format!("`defaultValue` is {value}, outside {lowest} to 1");
        let place = Place::Pointer(format!("{}/defaultValue", one.modifier.pointer));
        out.push(
            RULE.at(one.file, place, message)
                .key(&one.name)
                .help(format!("write a number from {lowest} to 1")),
        );
    }
}
