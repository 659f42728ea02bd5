//! A component has either `steps` or `sum`.

use super::super::{Check, Rule, RuleCx};
use super::component::{sound_components, unknown_patterns, weigh};
use crate::diag::{Application, Finding, Level, Place, RuleInfo, pointer};
use crate::json::UnknownKey;
use crate::repo::FileFacts;
use crate::repo::makehuman2::{Base, View};

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        breaks: &[(Application::Makehuman2, "stops with a KeyError without either; with both it never reads `sum`")],
        docs: "A component reads one slider, divided by `steps`, or the three corners of a triangle slider, named \
            by `sum`.\n\nMakeHuman 2 looks for `steps` first. If they are there, `sum` is ignored, and `pattern` \
            is taken for the pattern of one slider; if there is no such slider, the component is dropped and its \
            macrodefs never apply. With neither of the two it stops with a KeyError.\n\nKeep the one that fits \
            the slider.",
        ..RuleInfo::new("macro-steps-and-sum", Level::Error, "a component has both `steps` and `sum`, or neither")
    },
    check: Check::Makehuman2(run),
};

/// What a key of the component was meant to be, if it is nearly one of the two.
fn misspelt(file: &FileFacts, component: &str) -> Option<String> {
    let own = pointer(&["components", component]);
    let is_own = |key: &&UnknownKey| key.pointer.rsplit_once('/').is_some_and(|(owner, _)| owner == own);
    let meant = |key: &UnknownKey| key.nearest.clone().filter(|near| near == "steps" || near == "sum");
    let mut keys = file.schema.unknown.iter().filter(is_own);
    keys.find_map(|key| Some(format!("is `{}` meant to be `{}`?", key.key, meant(key)?)))
}

fn run(_: &View<'_>, base: &Base<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some((file, macros)) = base.macro_file() else { return };
    for component in sound_components(file, macros) {
        let name = &component.name;
        let finding = match (&component.steps, &component.sum) {
            (Some(_), Some(_)) => {
                let dead = !unknown_patterns(base, component).is_empty();
                let (level, effect) = if dead {
                    (Level::Error, "ignores `sum`, finds no slider for `pattern`, and never applies the macrodefs")
                } else {
                    (Level::Warning, "ignores `sum`")
                };
                let place = Place::key(["components", name, "sum"]);
                RULE.at(file, place, format!("component `{name}` has both `steps` and `sum`"))
                    .level(level)
                    .effect(effect)
                    .help("remove `sum` for a plain slider, `steps` for a triangle slider")
            }
            (None, None) => {
                let place = Place::key(["components", name]);
                RULE.at(file, place, format!("component `{name}` has neither `steps` nor `sum`"))
                    .effect("stops at start with a KeyError")
                    .help(misspelt(file, name).unwrap_or_else(|| {
                        "add `steps` with a slider position for each value, or `sum` for a triangle slider".to_owned()
                    }))
            }
            _ => continue,
        };
        out.push(weigh(finding.key(name), macros, component));
    }
}
