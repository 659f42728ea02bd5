//! `lsym` and `rsym` must name a pattern that exists.

use super::super::{Check, Rule, RuleCx};
use super::{advice, counterpart, with_patterns};
use mhlint_diag::{Application::Makehuman2, Finding, Level, Place, RuleInfo};
use mhlint_repo::makehuman2::{Base, View};

pub(crate) static RULE: Rule = Check::Makehuman2(run).rule(RuleInfo {
    breaks: &[(
        Makehuman2,
        "skips the slider when it makes a character symmetric or random",
    )],
    docs: include_str!("unknown_symmetry.md").trim_ascii_end(),
    ..RuleInfo::new(
        "modelling-unknown-symmetry",
        Level::Error,
        "`lsym` or `rsym` names an unknown pattern",
    )
});

fn run(_: &View<'_>, base: &Base<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for bound in with_patterns(base).unwrap_or_default() {
        let slider = bound.slider;
        let Some((member, partner)) = counterpart(slider) else {
            continue;
        };
        if base.slider(partner).is_some() || base.explains_pattern(partner) {
            continue;
        }
        let message = format!(
            "`{member}` of `{}` names the unknown pattern `{partner}`",
            slider.key
        );
        let place = Place::pointer([&slider.key, member]);
        let finding = RULE
            .at(bound.file, place, message)
            .key(&slider.key)
            .help(advice(base, partner, &cx.suggestions));
        out.push(if member == "lsym" {
            finding.effect("crashes with `KeyError` when it makes a random character")
        } else {
            finding.level(Level::Warning)
        });
    }
}
