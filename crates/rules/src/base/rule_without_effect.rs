//! A rule of the randomizer forbids by being false.

use super::super::{Check, Rule, RuleCx};
use mhlint_diag::{Application::Makehuman2, Finding, Level, Place, RuleInfo};
use mhlint_repo::makehuman2::{Base, View};

pub(crate) static RULE: Rule = Check::Makehuman2(run).rule(RuleInfo {
    breaks: &[(
        Makehuman2,
        "evaluates the condition but moves the slider every time",
    )],
    docs: include_str!("rule_without_effect.md").trim_ascii_end(),
    ..RuleInfo::new(
        "base-rule-without-effect",
        Level::Warning,
        "a condition in `random.rules` is never `False`",
    )
});

fn run(_: &View<'_>, base: &Base<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some((file, settings)) = base.settings() else {
        return;
    };
    for (key, conditions) in settings.random.iter().flat_map(|random| &random.rules) {
        // What cannot be evaluated is `base-unsafe-rule`.
        for condition in conditions
            .iter()
            .filter(|condition| condition.fault.is_none() && !condition.can_forbid)
        {
            let (slider, text) = (condition.slider.as_str(), &condition.expression);
            let message =
                format!("the condition of `{key}` on `{slider}` can never be `False`: `{text}`");
            let place = Place::pointer(["random", "rules", key, slider]);
            out.push(
                RULE.at(file, place, message)
                    .key(format!("{key} {slider}"))
                    .help("compare `x` with numbers, such as `0.2 < x < 0.75`"),
            );
        }
    }
}
