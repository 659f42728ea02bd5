//! `steps` and `values` of a component must have the same length.

use super::super::{Check, Rule, RuleCx};
use super::component::{is_dead, sound_components, weigh};
use crate::diag::{Application, Finding, Level, Place, RuleInfo};
use crate::repo::makehuman2::{Base, View};

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        breaks: &[(
            Application::Makehuman2,
            "stops with an IndexError when the slider reaches the step without a value",
        )],
        docs: "Each value of a stepped component stands for one position of its slider, given by the entry of `steps` \
            at the same place.\n\nThe loader does not compare the lengths. With fewer values than steps it reads beyond the \
            list as soon as the slider comes to the interval that has no value. With more values than steps nothing stops, but the \
            surplus values and every target named after them are dead (warning); with less than two steps the whole macrodef is.\n\nGive every value exactly one step.",
        ..RuleInfo::new("macro-steps-length", Level::Error, "`steps` and `values` of a component differ in length")
    },
    check: Check::Makehuman2(run),
};

fn run(_: &View<'_>, base: &Base<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some((file, macros)) = base.macro_file() else { return };
    for component in sound_components(file, macros) {
        let Some(steps) = &component.steps else { continue };
        let values = component.values.len();
        if steps.len() == values {
            continue;
        }
        let message = format!("component `{}` has {values} values but {} steps", component.name, steps.len());
        let place = Place::pointer(["components", &component.name, "steps"]);
        let finding = RULE.at(file, place, message).key(&component.name);
        let finding = if steps.len() > values {
            finding.help("name a value for every step, or remove the surplus steps")
        } else {
            let effect = surplus_effect(steps.len());
            let level = if is_dead(steps) { Level::Error } else { Level::Warning };
            let finding = finding.level(level).effect(effect);
            finding.help("give every value a step; the last values cannot be reached now")
        };
        out.push(weigh(finding, macros, component));
    }
}

/// What becomes of values beyond the last step. Two steps are needed for an interval.
fn surplus_effect(steps: usize) -> &'static str {
    match steps {
        0 | 1 => "drops the component without a word: with less than two steps nothing of its macrodefs applies",
        _ => "never reaches the values without a step, nor their targets, and says nothing",
    }
}
