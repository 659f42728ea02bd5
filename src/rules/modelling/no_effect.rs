//! An entry must do something.

use super::super::{Check, Rule, RuleCx};
use super::groups;
use crate::diag::{Application, Finding, Level, Place, RuleInfo};
use crate::formats::modelling::EFFECTS;
use crate::repo::{Base, Repository};

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        breaks: &[(Application::Makehuman2, "shows a slider that does nothing and is never saved")],
        docs: "A slider does something through `incr` and `decr` (targets), `macro` or `barycentric`.\n\nAn entry with none of them gets \
            a slider without a pattern: nothing moves, nothing is saved, no model can set it.\n\nAdd one of the keys, or \
            remove the entry.",
        ..RuleInfo::new("modelling-no-effect", Level::Warning, "neither `incr`, `decr`, `macro` nor `barycentric`")
    },
    check: Check::Base(run),
};

fn run(_: &Repository<'_>, base: &Base<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for bound in groups::hand_made(base) {
        let slider = bound.slider;
        if EFFECTS.iter().any(|key| slider.has(key)) {
            continue;
        }
        let help = match slider.misspelt_effect() {
            Some((key, near)) => format!("is `{key}` meant to be `{near}`?"),
            None => "add `incr`, `macro` or `barycentric`, or remove the entry".to_owned(),
        };
        let message = format!("`{}` has neither `incr`, `decr`, `macro` nor `barycentric`", slider.key);
        out.push(RULE.at(bound.file, Place::key([&slider.key]), message).key(&slider.key).help(help));
    }
}
