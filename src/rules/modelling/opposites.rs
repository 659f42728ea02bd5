//! A pair of targets makes a two-sided slider only if `base.json` declares its endings.

use std::collections::BTreeMap;

use super::super::cause::schema::is_faulty;
use super::super::{Check, Rule, RuleCx};
use super::with_patterns;
use crate::diag::{Application, Evidence, Finding, Level, Place, RuleInfo};
use crate::repo::makehuman2::{Base, BoundSlider, View};

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        breaks: &[(
            Application::Makehuman2,
            "shows a slider with the increasing side only; the other target cannot be reached",
        )],
        docs: "An entry with `decr` and `incr` becomes a slider with two sides only if `target-opposites` of `base.json` has a pair \
            of endings that both file names end in, each after a `-`.\n\nOtherwise the slider silently loses its negative side, and its pattern is \
            `incr` alone: presets, symmetry and saved models that use `<decr>|<ending>` do not find it.\n\nDeclare the pair, \
            or correct the names. Without `target-opposites` no slider has two sides; that is one finding on `base.json`.",
        ..RuleInfo::new("modelling-opposites", Level::Warning, "`target-opposites` does not cover a pair of targets")
    },
    check: Check::Makehuman2(run),
};

fn run(view: &View<'_>, base: &Base<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some((file, settings)) = base.settings() else { return };
    if is_faulty(file, "target-opposites") {
        return;
    }
    let sliders = with_patterns(base).unwrap_or_default();
    let undeclared: Vec<&BoundSlider<'_>> =
        sliders.iter().filter(|slider| slider.is_undeclared_pair() && !base.lacks_target(slider)).collect();
    if settings.opposites.is_empty() && view.layers.is_checked(file) && undeclared.len() > 1 {
        let message = format!("no `target-opposites`: {} pairs of targets have one side only", undeclared.len());
        let evidence = Evidence::of_cases(undeclared.iter().map(|slider| &slider.slider.key));
        let help = "add `\"target-opposites\": {\"decr\": \"incr\"}` with the endings of the target names";
        out.push(RULE.at(file, Place::File, message).help(help).evidence(evidence));
        return;
    }
    let mut by_endings: BTreeMap<(&str, &str), Vec<&BoundSlider<'_>>> = BTreeMap::new();
    for slider in undeclared {
        let endings = (ending(slider.slider.decr.as_deref()), ending(slider.slider.incr.as_deref()));
        by_endings.entry(endings).or_default().push(slider);
    }
    for ((decr, incr), sliders) in by_endings {
        let Some(first) = sliders.first() else { continue };
        let key = first.slider.key.as_str();
        let message = match sliders.as_slice() {
            [_] => format!("`{key}` has one side only: no pair `{decr}`/`{incr}` in `target-opposites`"),
            more => {
                format!("{} sliders have one side only: no pair `{decr}`/`{incr}` in `target-opposites`", more.len())
            }
        };
        let swapped = settings.opposites.iter().any(|(d, i)| d == incr && i == decr);
        let help = if swapped {
            "`incr` and `decr` are swapped".to_owned()
        } else {
            format!("add `\"{decr}\": \"{incr}\"` to `target-opposites` of base.json, or correct the names")
        };
        out.push(
            RULE.at(first.file, Place::pointer([key, "decr"]), message)
                .key(format!("{decr}/{incr}"))
                .help(help)
                .evidence(Evidence::of_cases(sliders.iter().map(|slider| &slider.slider.key))),
        );
    }
}

/// The part of a target's name behind its last `-`.
fn ending(path: Option<&str>) -> &str {
    let name = path.unwrap_or_default().rsplit('/').next().unwrap_or_default();
    name.rsplit('-').next().unwrap_or(name)
}
