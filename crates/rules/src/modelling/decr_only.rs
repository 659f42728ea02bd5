//! `decr` needs `incr` beside it.

use super::super::{Check, Rule, RuleCx};
use super::groups;
use mhlint_diag::{Application::Makehuman2, Finding, Level, Place, RuleInfo};
use mhlint_repo::makehuman2::{Base, View};

pub(crate) static RULE: Rule = Check::Makehuman2(run).rule(RuleInfo {
    breaks: &[(
        Makehuman2,
        "crashes with `AttributeError` when the slider moves in the increasing direction",
    )],
    docs: include_str!("decr_only.md").trim_ascii_end(),
    ..RuleInfo::new(
        "modelling-decr-only",
        Level::Error,
        "a slider has `decr` but no `incr`",
    )
});

fn run(_: &View<'_>, base: &Base<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for bound in groups::hand_made(base) {
        let slider = bound.slider;
        if slider.decr.is_none() || !slider.lacks_incr() {
            continue;
        }
        let help = match slider.misspelt_effect() {
            Some((key, meant)) => format!("did you mean `{meant}` instead of `{key}`?"),
            None => {
                "add `incr`, or rename `decr` to `incr` for a slider with one direction".to_owned()
            }
        };
        out.push(
            RULE.at(
                bound.file,
                Place::pointer([&slider.key, "decr"]),
                format!("`{}` has `decr` but no `incr`", slider.key),
            )
            .key(&slider.key)
            .help(help),
        );
    }
}
