//! What the loader drops is too little to be seen.

use super::super::{Check, Rule, RuleCx};
use super::measured::pose_weights;
use crate::diag::{Application, Element, Evidence, Finding, Level, OptionInfo, Place, RuleInfo};
use crate::eval::measures::Measures;
use crate::repo::{Base, Repository};

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        breaks: &[(Application::Makehuman2, "pulls the vertices towards the origin of the scene in pose mode")],
        docs: "After dividing by the sum of a vertex, MakeHuman 2 drops weights that are not above 0.0001. Nobody gets their \
            share: the rest sums to less than 1, and the vertex is pulled towards the origin, farther the farther away it \
            is.\n\nReported once the pull reaches `distance`: a warning; a tenth of it is an info. Less cannot be seen.\n\n\
            Remove the tiny weights and normalise.",
        options: &[OptionInfo {
            name: "distance",
            default: 0.01,
            docs: "pull in mesh units (decimetres) from which it is a warning; a tenth of it is an info",
        }],
        ..RuleInfo::new(
            "weights-lost-after-threshold",
            Level::Warning,
            "vertices lose weight to the threshold of the loader",
        )
    },
    check: Check::Numeric(run),
};

fn run(repository: &Repository<'_>, base: &Base<'_>, measures: &Measures, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some((weights, file)) = measures.weights.as_ref().zip(pose_weights(repository, base)) else { return };
    let Some(worst) = weights.worst_loss else { return };
    let limit = cx.option(&RULE, "distance");
    if worst.pull < limit / 10.0 {
        return;
    }
    let vertex = worst.vertex;
    let message = format!(
        "{} vertices lose weight to the threshold 0.0001, most vertex {vertex}: {:.2} % of its weight, which pulls it {:.4} \
         units towards the origin",
        weights.losing,
        worst.share * 100.0,
        worst.pull
    );
    let vertices = base.mesh.map_or(0, |(_, mesh)| mesh.positions.len());
    let evidence = Evidence { count: weights.losing as u64, ..Evidence::default() }.out_of(vertices);
    let place = Place::Element(Element { kind: "vertex", index: u64::from(vertex) });
    let level = if worst.pull < limit { Level::Info } else { Level::Warning };
    out.push(
        RULE.at(file, place, message)
            .level(level)
            .help("remove the tiny weights and normalise the rest")
            .evidence(evidence.with_worst(worst.pull, format!("vertex {vertex}"))),
    );
}
