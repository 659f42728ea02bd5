//! Weights of a bone lie on its side.

use super::super::{Check, Rule, RuleCx};
use crate::diag::{Application, Evidence, Finding, Level, Place, RuleInfo};
use crate::eval::measures::Measures;
use crate::repo::Body;

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        breaks: &[(
            Application::Makehuman2,
            "turns the skin of the other side with the bone: bending a hand throws the other one about",
        )],
        docs: "A bone whose name says left or right (`hand.L`, `r-thigh`, `LeftFoot` …) and whose joints lie on that side has its \
            weights on the other half of the mesh, nine tenths of them at least. Left is where x is above 0.\n\nMakeHuman 2 says \
            nothing: it turns these vertices around a bone that is far away, so that the smallest bend throws them far. Mostly \
            left and right were exchanged when the weights were mirrored or exported.\n\nWhere the joints lie on the wrong side as \
            well it is the skeleton's fault: `skeleton-wrong-side`. Exchange the lists of the bone and its partner.",
        ..RuleInfo::new("weights-wrong-side", Level::Warning, "weights on the other half of the mesh than their bone")
    },
    check: Check::Numeric(run),
};

fn run(body: &Body<'_>, measures: &Measures, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some((weights, file)) = measures.weights.as_ref().zip(body.default_weights()) else { return };
    let bones: Vec<&str> =
        weights.wrong_side.iter().filter_map(|bone| measures.bones.get(*bone)).map(String::as_str).collect();
    let Some(first) = bones.first() else { return };
    let message = match bones.len() {
        1 => format!("the weights of bone `{first}` are on the other half of the mesh"),
        count => format!("the weights of {count} bones are on the other half of the mesh, the first is `{first}`"),
    };
    out.push(
        RULE.at(file, Place::key(["weights", first]), message)
            .help("exchange the weights of left and right")
            .evidence(Evidence::of_cases(&bones).out_of(measures.bones.len())),
    );
}
