//! Weights of a component must add up to one.

use super::super::{Check, Rule, RuleCx};
use super::{component, has_sound_steps, title};
use crate::diag::{Application, Evidence, Finding, Level, Place, RuleInfo};
use crate::eval::measures::Measures;
use crate::formats::macro_json::Component;
use crate::repo::Body;

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        breaks: &[(
            Application::Makehuman2,
            "applies the shapes of the macrodef with too little or too much weight; nothing is normalised",
        )],
        docs: "MakeHuman 2 blends between the values of a component and multiplies the weights of all components. It normalises \
            nothing, so the weights of each component must add up to one (0.0025 less or more come from its own \
            limits).\n\nThey do not where a component uses only two corners of a triangle slider: the weight of the third \
            corner is given to nobody. After a reset, with 0.33, 0.33 and 0.34, two corners hold two thirds, and with the \
            slider in the third corner nothing of the macrodef applies.\n\nGive the component a value for each corner; \
            combinations of the third one may be `null`. Steps that do not run from 0 to 1, and lists of unequal length, \
            which make wrong sums too, have rules of their own.",
        ..RuleInfo::new("numeric-weights-sum", Level::Warning, "weights of a component that do not add up to one")
    },
    check: Check::Numeric(run),
};

fn run(body: &Body<'_>, measures: &Measures, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some((file, macros)) = body.macros else { return };
    let mut told: Vec<&str> = Vec::new();
    for off in &measures.macros.sums {
        let Some((macrodef, component)) = component(macros, off.macrodef, off.position) else { continue };
        let name = component.name.as_str();
        // A component is wrong once, whatever uses it.
        if told.contains(&name) || !is_unexplained(component) {
            continue;
        }
        told.push(name);
        let at = match off.at {
            Some(at) => format!("at `{}` = {at}", component.pattern.as_deref().unwrap_or_default()),
            None => "after a reset".to_owned(),
        };
        let message = format!("weights of `{name}` in macrodef `{}` add up to {:.2} {at}", title(macrodef), off.sum);
        let member = if component.steps.is_some() { "steps" } else { "sum" };
        out.push(
            RULE.at(file, Place::pointer(["components", name, member]), message)
                .key(format!("{}/{name}", title(macrodef)))
                .help("give every corner of the slider a value; its combinations may be `null`")
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
