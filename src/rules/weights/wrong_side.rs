//! Weights of a bone lie on its side.

use super::super::{Check, Rule, RuleCx};
use crate::diag::{Application::Makehuman2, Evidence, Finding, Level, Place, RuleInfo};
use crate::eval::measures::Measures;
use crate::repo::Body;

pub(in crate::rules) static RULE: Rule = Check::Numeric(run).rule(RuleInfo {
    breaks: &[(
        Makehuman2,
        "rotates the skin of the left/right counterpart with the bone: the smallest bend throws it far off",
    )],
    docs: "A bone whose name says left or right (`hand.L`, `r-thigh`, `LeftFoot` …) and whose joints are on that \
        side has at least nine tenths of its weights on the opposite half of the mesh. Left is where x is above \
        0.\n\n\
        MakeHuman 2 reports nothing: it rotates these vertices around a bone that is far away, so that the \
        smallest bend throws them far off. Usually left and right were swapped when the weights were mirrored or \
        exported. If the joints are on the wrong side as well, the skeleton is wrong: see \
        `skeleton-wrong-side`.\n\n\
        Swap the weights of the bone and its left/right counterpart.",
    counts: "bones",
    ..RuleInfo::new("weights-wrong-side", Level::Warning, "weights are on the opposite half of the mesh")
});

fn run(body: &Body<'_>, measures: &Measures, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some((weights, file)) = measures.weights.as_ref().zip(body.default_weights()) else { return };
    let bones: Vec<&str> =
        weights.wrong_side.iter().filter_map(|bone| measures.bones.get(*bone)).map(String::as_str).collect();
    let Some(first) = bones.first() else { return };
    let message = match bones.len() {
        1 => format!("the weights of bone `{first}` are on the opposite half of the mesh"),
        count => format!("the weights of {count} bones are on the opposite half of the mesh, first `{first}`"),
    };
    out.push(
        RULE.at(file, Place::key(["weights", first]), message)
            .help("swap the weights of the left and right bones")
            .evidence(Evidence::of_cases(&bones).out_of(measures.bones.len())),
    );
}
