//! A slider names its targets in the slots of the sides that it has.

use super::super::{Check, Rule, RuleCx};
use super::{checked, key, place, sliders};
use mhlint_diag::{Application::Mpfb, Finding, Level, RuleInfo};
use mhlint_repo::mpfb::View;

pub(crate) static RULE: Rule = Check::Mpfb(run).rule(RuleInfo {
    breaks: &[(
        Mpfb,
        "asks for a target without a name and fails whenever the slider moves",
    )],
    docs: include_str!("opposites_sides.md").trim_ascii_end(),
    ..RuleInfo::new(
        "catalog-opposites-sides",
        Level::Error,
        "`has_left_and_right` does not fit the slots that name targets",
    )
});

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some(catalog) = checked(view) else { return };
    for (section, category) in
        sliders(&catalog).filter(|(_, category)| category.has_slots_of_other_kind())
    {
        let (value, slots) = if category.is_sided {
            ("true", "unsided")
        } else {
            ("false", "left and right")
        };
        let message = format!(
            "`has_left_and_right` of `{}` is {value}, but only {slots} slots are used",
            category.name
        );
        let finding = RULE.at(
            catalog.file,
            place(section, Some(category), &["has_left_and_right"]),
            message,
        );
        let other = if category.is_sided { "false" } else { "true" };
        out.push(finding.key(key(section, category)).help(format!(
            "write {other}, or move the names to the other slots"
        )));
    }
}
