//! A vertex far outside the figure at some setting.

use super::super::{Check, Rule, RuleCx};
use super::{at_setting, untold};
use crate::diag::{Application, Confidence, Evidence, Finding, Level, RuleInfo};
use crate::eval::measures::Measures;
use crate::repo::Body;

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        breaks: &[(
            Application::Makehuman2,
            "tears the vertex, and with it faces, joints and clothes, out of the figure",
        )],
        docs: "At some setting of the sliders a vertex lies outside the box around the default character by more than six \
            tenths of its diagonal. The tallest character of MakeHuman's own \
            base stays within 0.41 diagonals.\n\nMostly targets that are sound by themselves add up at a corner of the \
            sliders. The finding stands at the one that moves the vertex most. A single displacement that is larger than \
            the whole mesh, or out of proportion to its target, is `target-oversized-delta` instead.",
        ..RuleInfo::new(
            "numeric-exploded-vertex",
            Level::Warning,
            "a vertex far outside the figure at some slider setting",
        )
    },
    check: Check::Numeric(run),
};

fn run(body: &Body<'_>, measures: &Measures, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some(space) = &measures.space else { return };
    let Some(seen) = untold(body, space, space.exploded.as_ref()) else { return };
    let message = format!(
        "vertex {} lies {:.1} diagonals of the figure outside of it{}",
        seen.element,
        seen.value,
        if seen.count > 1 { format!(", {} more with it", seen.count - 1) } else { String::new() }
    );
    let evidence = Evidence::counted(seen.count);
    out.push(
        at_setting(&RULE, body, seen, &message)
            .key("vertices")
            .parts(seen.elements.iter().copied())
            .confidence(Confidence::Medium)
            .help("look for a missing decimal point or another unit; lengths are decimetres")
            .evidence(evidence.with_worst(seen.value, format!("vertex {}", seen.element))),
    );
}
