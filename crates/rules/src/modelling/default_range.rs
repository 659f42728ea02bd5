//! `default` must lie on the slider.

use super::super::{Check, Rule, RuleCx};
use super::groups;
use mhlint_diag::{Application::Makehuman2, Finding, Level, Place, RuleInfo};
use mhlint_repo::makehuman2::{Base, View};

pub(crate) static RULE: Rule = Check::Makehuman2(run).rule(RuleInfo {
    breaks: &[(
        Makehuman2,
        "sets the slider beyond its end at every reset: a macro disappears or is exaggerated",
    )],
    docs: include_str!("default_range.md").trim_ascii_end(),
    ..RuleInfo::new(
        "modelling-default-range",
        Level::Warning,
        "`default` is outside 0 to 1",
    )
});

fn run(_: &View<'_>, base: &Base<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for bound in groups::hand_made(base) {
        let slider = bound.slider;
        // `json-syntax` names what is no finite number.
        let Some(default) = slider.default.filter(|default| default.is_finite()) else {
            continue;
        };
        let lowest = if slider.decr.is_some() && !slider.is_macro() {
            -1.0
        } else {
            0.0
        };
        if (lowest..=1.0).contains(&default) {
            continue;
        }
        let message = format!(
            "`default` of `{}` is {default}, outside {lowest} to 1",
            slider.key
        );
        let help = if (2.0..=100.0).contains(&default) {
            format!(
                "did you mean `{}`? Values are not percentages",
                default / 100.0
            )
        } else {
            format!("write a number from {lowest} to 1")
        };
        let place = Place::pointer([&slider.key, "default"]);
        out.push(
            RULE.at(bound.file, place, message)
                .key(&slider.key)
                .help(help),
        );
    }
}
