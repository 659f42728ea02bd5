//! `steps` of a component must run from 0 to 1.

use super::super::cause::component::has_special_step;
use super::super::{Check, Rule, RuleCx, enumerated, percent};
use super::component::{is_dead, sound_components, weigh};
use mhlint_diag::{Application::Makehuman2, Finding, Level, Place, RuleInfo};
use mhlint_repo::makehuman2::{Base, View};
use std::cmp::Ordering;

pub(crate) static RULE: Rule = Check::Makehuman2(run).rule(RuleInfo {
    breaks: &[(
        Makehuman2,
        "applies the first value with more than its full weight below the first step, and drops \
         the macrodef above the last",
    )],
    docs: include_str!("steps_range.md").trim_ascii_end(),
    ..RuleInfo::new(
        "macro-steps-range",
        Level::Warning,
        "`steps` of a component do not run from \
        0 to 1",
    )
});

fn run(_: &View<'_>, base: &Base<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some((file, macros)) = base.macro_file() else {
        return;
    };
    for component in sound_components(file, macros).filter(|c| !has_special_step(file, c)) {
        let Some(steps) = &component.steps else {
            continue;
        };
        // A step too many or too few, or one out of order, is the cause; the ends follow from it.
        if steps.len() != component.values.len() || !is_increasing(steps) {
            continue;
        }
        // To fix one end and break the other is another fault.
        let Some((end, fault, effect)) = fault(steps, &component.values) else {
            continue;
        };
        let slider = component
            .pattern
            .as_deref()
            .map(|pattern| format!(" (slider `{pattern}`)"))
            .unwrap_or_default();
        let message = format!("`steps` of `{}`{slider} {end} {fault}", component.name);
        let place = Place::pointer(["components", &component.name, "steps"]);
        let finding = RULE
            .at(file, place, message)
            .key(format!("{} {end}", component.name))
            .help(help(steps));
        let finding = if is_dead(steps) {
            finding.level(Level::Error)
        } else {
            finding
        };
        out.push(weigh(finding.effect(effect), macros, component));
    }
}

fn is_increasing(steps: &[f64]) -> bool {
    steps.is_sorted_by(|a, b| a.partial_cmp(b) == Some(Ordering::Less))
}

/// Which end is wrong, how, and what comes of it.
fn fault(steps: &[f64], values: &[String]) -> Option<(&'static str, String, String)> {
    const NO_INTERVAL: &str = "drops the component and never applies its macrodefs";
    const TOO_EARLY: &str = "never applies the first value with its full weight";
    let ([first, .., last] | [first @ last]) = steps else {
        return Some((
            "are",
            "empty; at least two steps are needed".to_owned(),
            NO_INTERVAL.to_owned(),
        ));
    };
    if steps.len() == 1 {
        return Some((
            "hold",
            format!("only {last}; at least two steps are needed"),
            NO_INTERVAL.to_owned(),
        ));
    }
    if is_dead(steps) {
        let effect = "drops the macrodef unless the slider is at exactly 0";
        return Some(("end", format!("at {last} instead of 1"), effect.to_owned()));
    }
    if last.total_cmp(&1.0).is_lt() {
        let effect = "drops the macrodef when the slider is above the last step";
        Some(("end", format!("at {last} instead of 1"), effect.to_owned()))
    } else if first.partial_cmp(&0.0) == Some(Ordering::Greater) {
        let effect = "applies the first value with more than its full weight when the slider is \
            below the first step";
        Some((
            "begin",
            format!("at {first} instead of 0"),
            effect.to_owned(),
        ))
    } else if first.partial_cmp(&0.0) == Some(Ordering::Less) {
        Some((
            "begin",
            format!("at {first} instead of 0"),
            TOO_EARLY.to_owned(),
        ))
    } else if last.total_cmp(&1.0).is_gt() {
        Some((
            "end",
            format!("at {last} instead of 1"),
            format!("stops at slider value 1: {}", out_of_reach(steps, values)),
        ))
    } else {
        None
    }
}

/// Steps of this size and above were written in per cent.
const PER_CENT: f64 = 10.0;

fn help(steps: &[f64]) -> &'static str {
    if steps.last().is_some_and(|last| *last >= PER_CENT) {
        "divide the steps by 100; they run from 0 to 1"
    } else if steps.iter().filter(|step| **step >= 1.0).count() > 1 {
        "scale the steps so that they run from 0 to 1"
    } else {
        "set the first step to 0 and the last step to 1"
    }
}

/// What the values get whose steps lie above 1, where no slider goes.
fn out_of_reach(steps: &[f64], values: &[String]) -> String {
    let pairs = steps.windows(2).zip(values.iter().skip(1));
    let beyond = pairs.filter_map(|(pair, value)| match pair {
        [low, high] if *high > 1.0 => Some((value, ((1.0 - low) / (high - low)).max(0.0))),
        _ => None,
    });
    let (some, none): (Vec<_>, Vec<_>) = beyond.partition(|(_, share)| *share > 0.0);
    let some = some.iter().map(|(value, share)| {
        format!(
            "`{value}` reaches at most {} of its weight",
            percent(*share)
        )
    });
    let names: Vec<String> = none.iter().map(|(value, _)| format!("`{value}`")).collect();
    let verb = if names.len() == 1 { "gets" } else { "get" };
    let none = (!names.is_empty()).then(|| format!("{} {verb} none", enumerated(&names)));
    some.chain(none).collect::<Vec<_>>().join(", ")
}
