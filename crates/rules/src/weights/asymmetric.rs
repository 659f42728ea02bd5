//! Left bones are weighted as right ones.

use std::collections::BTreeSet;

use super::super::{Check, Rule, RuleCx, percent};
use super::has_unusable_entries;
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2},
    Evidence, Finding, Grows, Level, MeasureKind, Place, RuleInfo,
};
use mhlint_eval::measures::Measures;
use mhlint_formats::mhw::Weights;
use mhlint_repo::Body;

pub(crate) static RULE: Rule = Check::Numeric(run).rule(RuleInfo {
    breaks: &[
        (
            Makehuman2,
            "bends the left and right side differently in mirrored poses",
        ),
        (
            Makehuman1,
            "bends the left and right side differently in mirrored poses",
        ),
    ],
    docs: include_str!("asymmetric.md").trim_ascii_end(),
    counts: "pairs of bones",
    grows: Grows::more(MeasureKind::Weight),
    ..RuleInfo::new(
        "weights-asymmetric",
        Level::Info,
        "left and right bones have different weights",
    )
});

fn run(body: &Body<'_>, measures: &Measures, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some((weights, file)) = measures.weights.as_ref().zip(body.default_weights()) else {
        return;
    };
    // Weights with faulty entries, or of bones that the skeleton drops, are uneven for that reason.
    let is_whole = |weights: &Weights| {
        let facts = &weights.facts;
        let faults = [facts.negative.count, facts.above_one.count];
        let bones: BTreeSet<&String> = measures.bones.iter().collect();
        let known = |name: &String| bones.contains(name);
        !has_unusable_entries(weights)
            && faults == [0; 2]
            && weights.bones.iter().all(|bone| known(&bone.name))
    };
    // Weights on the other side than their bones (`weights-wrong-side`) are uneven for that reason,
    // too.
    if !file.weights().is_some_and(is_whole) || !weights.wrong_side.is_empty() {
        return;
    }
    let name = |bone: usize| measures.bones.get(bone).map_or("", String::as_str);
    let Some(worst) = weights
        .asymmetric
        .iter()
        .max_by(|a, b| a.worst.1.total_cmp(&b.worst.1))
    else {
        return;
    };
    let (vertex, difference) = worst.worst;
    let (bones, by) = (
        format!("`{}` and `{}`", name(worst.left), name(worst.right)),
        percent(f64::from(difference)),
    );
    let vertex_by = format!("{} by {by}", body.vertex(vertex));
    let message = match (weights.asymmetric.len(), worst.vertices) {
        (1, 1) => format!("{bones} have different weights: {vertex_by}"),
        (1, count) => {
            format!("{bones} have different weights at {count} vertices, worst {vertex_by}")
        }
        (count, _) => {
            format!("{count} pairs of bones have different weights, worst {bones}: {vertex_by}")
        }
    };
    let vertices = |count: usize| {
        if count == 1 {
            "1 vertex".to_owned()
        } else {
            format!("{count} vertices")
        }
    };
    let evidence = Evidence::of_cases(
        weights
            .asymmetric
            .iter()
            .map(|pair| format!("{} ({})", name(pair.left), vertices(pair.vertices))),
    );
    out.push(
        RULE.at(file, Place::key(["weights", name(worst.left)]), message)
            .parts(weights.asymmetric.iter().map(|pair| name(pair.left)))
            .help("leave them if that is intended; otherwise mirror the weights of the better side")
            .evidence(evidence.with_worst(
                f64::from(difference),
                format!("{}[{vertex}]", name(worst.left)),
            )),
    );
}
