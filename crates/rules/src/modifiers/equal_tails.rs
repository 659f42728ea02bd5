//! The two sides of a modifier differ.

use super::super::{Check, Rule, RuleCx};
use mhlint_diag::{Application::Makehuman1, Finding, Level, Place, RuleInfo};
use mhlint_repo::makehuman1::View;

pub(crate) static RULE: Rule = Check::Makehuman1(run).rule(RuleInfo {
    breaks: &[(
        Makehuman1,
        "moves the same targets on both sides of the slider",
    )],
    docs: include_str!("equal_tails.md").trim_ascii_end(),
    ..RuleInfo::new(
        "modifiers-equal-tails",
        Level::Warning,
        "a modifier with the same targets on both sides",
    )
});

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    if !view.layers.checks_system() {
        return;
    }
    for one in view
        .modifiers
        .all
        .iter()
        .filter(|one| one.modifier.variable.is_none())
    {
        let Some((min, _)) = one.modifier.tails.sides().filter(|(min, max)| min == max) else {
            continue;
        };
        let message = format!("`min` and `max` are both `{min}`");
        let finding = RULE
            .at(
                one.file,
                Place::Pointer(one.modifier.pointer.clone()),
                message,
            )
            .key(&one.name);
        out.push(finding.help("correct one of them"));
    }
}
