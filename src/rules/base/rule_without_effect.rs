//! A rule of the randomizer forbids by being false.

use super::super::{Check, Rule, RuleCx};
use crate::diag::{Application, Finding, Level, Place, RuleInfo};
use crate::repo::makehuman2::{Base, View};

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        breaks: &[(Application::Makehuman2, "calculates the rule and goes on as if it were not there")],
        docs: "A condition in `random.rules` keeps a slider from being moved when its value is exactly `False`. That is what a comparison \
            gives, or `not`. A number is never `False`, not even 0, and neither is a text: with such a condition the slider is moved \
            whatever the other one says.\n\nWrite a comparison, such as `x < 0.5`.",
        ..RuleInfo::new("base-rule-without-effect", Level::Warning, "a condition in `random.rules` that is never false")
    },
    check: Check::Makehuman2(run),
};

fn run(_: &View<'_>, base: &Base<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some((file, settings)) = base.settings() else { return };
    for (key, conditions) in settings.random.iter().flat_map(|random| &random.rules) {
        // What cannot be evaluated is `base-unsafe-rule`.
        for condition in conditions.iter().filter(|condition| condition.fault.is_none() && !condition.can_forbid) {
            let (slider, text) = (condition.slider.as_str(), &condition.expression);
            let message = format!("the rule of `{key}` on `{slider}`, `{text}`, is a value and no condition");
            let place = Place::pointer(["random", "rules", key, slider]);
            out.push(
                RULE.at(file, place, message)
                    .key(format!("{key} {slider}"))
                    .help("write a comparison of `x` with numbers, such as `0.2 < x < 0.75`"),
            );
        }
    }
}
