//! `steps` and `values` of a component must have the same length.

use super::super::{Check, Rule, RuleCx, counted};
use super::component::{is_dead, sound_components, weigh};
use mhlint_diag::{Application::Makehuman2, Finding, Level, Place, RuleInfo};
use mhlint_repo::makehuman2::{Base, View};

pub(crate) static RULE: Rule = Check::Makehuman2(run).rule(RuleInfo {
    breaks: &[(
        Makehuman2,
        "crashes with `IndexError` when the slider reaches a step without a value",
    )],
    docs: include_str!("steps_length.md").trim_ascii_end(),
    ..RuleInfo::new(
        "macro-steps-length",
        Level::Error,
        "`steps` and `values` of a component differ in length",
    )
});

fn run(_: &View<'_>, base: &Base<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some((file, macros)) = base.macro_file() else {
        return;
    };
    for component in sound_components(file, macros) {
        let Some(steps) = &component.steps else {
            continue;
        };
        let values = component.values.len();
        if steps.len() == values {
            continue;
        }
        let (all, steps_of) = (counted(values, "value"), counted(steps.len(), "step"));
        let message = format!("component `{}` has {all} but {steps_of}", component.name);
        let place = Place::pointer(["components", &component.name, "steps"]);
        let finding = RULE.at(file, place, message).key(&component.name);
        let finding = if steps.len() > values {
            finding.help("add a value for every step, or remove the surplus steps")
        } else {
            let effect = surplus_effect(steps.len());
            let level = if is_dead(steps) {
                Level::Error
            } else {
                Level::Warning
            };
            let finding = finding.level(level).effect(effect);
            finding.help(
                "add a step for every value, or remove the last values and their combinations, \
                    which are never used",
            )
        };
        out.push(weigh(finding, macros, component));
    }
}

/// What becomes of values beyond the last step. Two steps are needed for an interval.
fn surplus_effect(steps: usize) -> &'static str {
    match steps {
        0 | 1 => {
            "silently drops the component: with fewer than two steps, nothing of its macrodefs \
                applies"
        }
        _ => "never uses the values without a step, nor their targets",
    }
}
