//! A modifier has two sides or none.

use super::super::{Check, Rule, RuleCx};
use super::LOST_TABS;
use super::meant::Meant;
use mhlint_diag::{Application::Makehuman1, Finding, Level, Place, RuleInfo};
use mhlint_repo::makehuman1::View;

pub(crate) static RULE: Rule = Check::Makehuman1(run).rule(RuleInfo {
    breaks: &[(Makehuman1, LOST_TABS)],
    docs: include_str!("unpaired_tails.md").trim_ascii_end(),
    ..RuleInfo::new(
        "modifiers-unpaired-tails",
        Level::Error,
        "a modifier with one side of two",
    )
});

fn run(view: &View<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    if !view.layers.checks_system() {
        return;
    }
    let meant = Meant::of(view, cx);
    for one in view
        .modifiers
        .all
        .iter()
        .filter(|one| one.modifier.variable.is_none())
    {
        let Some(key) = one.modifier.tails.unpaired() else {
            continue;
        };
        let other = match key {
            "min" => "`max`",
            "max" => "`min`",
            _ => "`min` and `max`",
        };
        let has_target = one.parts.iter().all(|part| !part.targets.is_empty());
        let message = format!(
            "`{key}` without {other}: neither is read, and the modifier is `{}`",
            one.name
        );
        let finding = RULE
            .at(
                one.file,
                Place::Pointer(one.modifier.pointer.clone()),
                message,
            )
            .key(&one.name);
        let finding = finding.help(format!("add {other}, or remove `{key}`"));
        out.push(match (meant.slider_for(one), has_target) {
            (Some(_), _) => finding,
            (None, true) => finding
                .level(Level::Warning)
                .effect("moves the target of the name without a side"),
            (None, false) => finding
                .level(Level::Warning)
                .effect("shows a slider that moves nothing"),
        });
    }
}
