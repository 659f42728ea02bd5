//! `steps` of a component must increase strictly.

use super::super::cause::component::has_special_step;
use super::super::{Check, Rule, RuleCx};
use super::component::{is_dead, reach, sound_components, weigh};
use mhlint_diag::{Application::Makehuman2, Finding, Level, Place, RuleInfo};
use mhlint_repo::makehuman2::{Base, View};
use std::cmp::Ordering;

pub(crate) static RULE: Rule = Check::Makehuman2(run).rule(RuleInfo {
    breaks: &[(
        Makehuman2,
        "crashes with `ZeroDivisionError` when the slider is at or below two equal first steps; \
         with other steps out of order, it uses the wrong values",
    )],
    docs: include_str!("steps_order.md").trim_ascii_end(),
    ..RuleInfo::new(
        "macro-steps-order",
        Level::Error,
        "`steps` of a component do not increase \
        strictly",
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
        let Some((at, a, b)) = first_fault(steps) else {
            continue;
        };
        let equal = a.partial_cmp(&b) == Some(Ordering::Equal);
        let message = format!(
            "`steps` of `{}` do not increase: {a} is followed by {b}",
            component.name
        );
        let place = Place::pointer([
            "components",
            &component.name,
            "steps",
            &(at + 1).to_string(),
        ]);
        let mut finding = RULE
            .at(file, place, message)
            .key(&component.name)
            .help("sort the steps together with their values, from 0 to 1, without equal steps");
        if is_dead(steps) && !equal {
            finding = finding
                .effect("drops every macro of the component unless its slider is at exactly 0");
        } else if equal && at == 0 {
            finding = finding.effect(
                "crashes with `ZeroDivisionError` when the slider is at or below these steps",
            );
        } else {
            finding = finding.level(Level::Warning).effect(loss(steps, equal));
        }
        out.push(weigh(finding, macros, component));
    }
}

/// What steps that repeat or fall come to.
fn loss(steps: &[f64], equal: bool) -> String {
    match reach(steps) {
        Some(reach) if reach < 1.0 => {
            format!("never uses some of the intervals, and drops the macros above {reach}")
        }
        _ if equal => "makes the shape jump at this position".to_owned(),
        _ => "never uses some of the intervals".to_owned(),
    }
}

/// The first pair that does not increase, with its position. NaN never does.
fn first_fault(steps: &[f64]) -> Option<(usize, f64, f64)> {
    let mut pairs = steps.iter().zip(steps.iter().skip(1)).enumerate();
    pairs
        .find(|(_, (a, b))| a.partial_cmp(b) != Some(Ordering::Less))
        .map(|(at, (a, b))| (at, *a, *b))
}
