//! `lsym` and `rsym` must name a pattern that exists.

use super::super::{Check, Rule, RuleCx};
use super::{advice, with_patterns};
use crate::diag::{Application, Finding, Level, Place, RuleInfo};
use crate::repo::makehuman2::{Base, View};

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        breaks: &[(Application::Makehuman2, "leaves out the slider when it makes the character symmetric or random")],
        docs: "`rsym` on a left slider and `lsym` on a right one name the partner by its pattern: its `incr`, or \
            `<decr>|<ending of incr>` for a slider with two sides. Not by its key.\n\nAn unknown partner is told to the console only. \
            \"Make symmetric\" skips the slider. With an unknown `rsym` it is never randomised; an unknown \
            `lsym` stops the random character view with a KeyError, which is an error.\n\nWrite the partner's pattern.",
        ..RuleInfo::new("modelling-unknown-symmetry", Level::Error, "`lsym` or `rsym` names no pattern")
    },
    check: Check::Makehuman2(run),
};

fn run(_: &View<'_>, base: &Base<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for bound in with_patterns(base).unwrap_or_default() {
        let slider = bound.slider;
        let (member, partner) = match (&slider.rsym, &slider.lsym) {
            (Some(partner), _) => ("rsym", partner),
            (None, Some(partner)) => ("lsym", partner),
            (None, None) => continue,
        };
        if base.slider(partner).is_some() || base.explains_pattern(partner) {
            continue;
        }
        let message = format!("`{member}` of `{}` names the unknown pattern `{partner}`", slider.key);
        let place = Place::pointer([&slider.key, member]);
        let finding = RULE.at(bound.file, place, message).key(&slider.key).help(advice(base, partner, &cx.suggestions));
        out.push(if member == "lsym" {
            finding.effect("stops with a KeyError when a random character is made")
        } else {
            finding.level(Level::Warning)
        });
    }
}
