//! Weights of a component must add up to one.

use std::collections::BTreeSet;

use super::super::{Check, Rule, RuleCx};
use super::{component, has_sound_steps, title};
use mhlint_diag::{
    Application::Makehuman2, Evidence, Finding, Grows, Level, MeasureKind, Place, RuleInfo,
};
use mhlint_eval::measures::Measures;
use mhlint_formats::macro_json::Component;
use mhlint_repo::Body;

pub(crate) static RULE: Rule = Check::Numeric(run).rule(RuleInfo {
    breaks: &[(
        Makehuman2,
        "applies the shapes of the macrodef too weakly or too strongly; it does not normalise the \
            weights",
    )],
    docs: include_str!("weights_sum.md").trim_ascii_end(),
    grows: Grows::from_one(MeasureKind::Weight),
    ..RuleInfo::new(
        "numeric-weights-sum",
        Level::Warning,
        "the weights of a component do not add \
        up to 1",
    )
});

fn run(body: &Body<'_>, measures: &Measures, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some((file, macros)) = body.macros else {
        return;
    };
    let mut told: BTreeSet<&str> = BTreeSet::new();
    for off in &measures.macros.sums {
        let Some((macrodef, component)) = component(macros, off.macrodef, off.position) else {
            continue;
        };
        let name = component.name.as_str();
        // A component is wrong once, whatever uses it.
        if !is_unexplained(component) || !told.insert(name) {
            continue;
        }
        let at = match off.at {
            Some(at) => format!(
                "at `{}` = {at}",
                component.pattern.as_deref().unwrap_or_default()
            ),
            None => "after a reset".to_owned(),
        };
        let message = format!(
            "weights of `{name}` in macrodef `{}` add up to {:.3} instead of 1 {at}",
            title(macrodef),
            off.sum
        );
        let member = if component.steps.is_some() {
            "steps"
        } else {
            "sum"
        };
        out.push(
            RULE.at(file, Place::pointer(["components", name, member]), message)
                .key(format!("{}/{name}", title(macrodef)))
                .help(
                    "give the component a value for every corner of the slider; its \
                    combinations may be `null`",
                )
                .evidence(Evidence::counted(1).with_worst(off.sum, at)),
        );
    }
}

/// Whether no rule on the lists themselves says why the sum is wrong.
fn is_unexplained(component: &Component) -> bool {
    match (&component.steps, &component.sum) {
        (Some(_), _) => has_sound_steps(component),
        (None, Some(sum)) => sum.len() == component.values.len() && sum.len() < 4,
        (None, None) => false,
    }
}
