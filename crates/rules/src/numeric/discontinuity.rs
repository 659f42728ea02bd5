//! The shape jumps where a slider passes a step.

use std::collections::BTreeSet;

use super::super::{Check, Rule, RuleCx};
use super::{component, has_sound_steps, percent, title};
use mhlint_diag::{
    Application::Makehuman2, Evidence, Finding, Grows, Level, MeasureKind, Place, RuleInfo,
};
use mhlint_eval::measures::Measures;
use mhlint_repo::Body;

pub(crate) static RULE: Rule = Check::Numeric(run).rule(RuleInfo {
    breaks: &[(
        Makehuman2,
        "snaps from one shape to another at this position of the slider",
    )],
    docs: include_str!("discontinuity.md").trim_ascii_end(),
    grows: Grows::more(MeasureKind::Distance),
    ..RuleInfo::new(
        "numeric-discontinuity",
        Level::Warning,
        "the shape jumps where a slider passes a step",
    )
});

fn run(body: &Body<'_>, measures: &Measures, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some((file, macros)) = body.macros else {
        return;
    };
    let mut told: BTreeSet<&str> = BTreeSet::new();
    for jump in &measures.macros.jumps {
        let Some((macrodef, component)) = component(macros, jump.macrodef, jump.position) else {
            continue;
        };
        // Steps out of order or range are the cause then; a component jumps once, whatever uses it.
        if !has_sound_steps(component) || told.contains(component.name.as_str()) {
            continue;
        }
        told.insert(&component.name);
        let pattern = component.pattern.as_deref().unwrap_or_default();
        let message = format!(
            "macrodef `{}` jumps at `{pattern}` = {}: the weight of a target changes by {}",
            title(macrodef),
            jump.at,
            percent(jump.by)
        );
        let place = Place::pointer(["components", &component.name, "steps"]);
        out.push(
            RULE.at(file, place, message)
                .key(&component.name)
                .help("move the steps apart")
                .evidence(
                    Evidence::counted(1).with_worst(jump.by, format!("{pattern} = {}", jump.at)),
                ),
        );
    }
}
