//! The weights of a vertex should add up to 1.

use super::super::units::length;
use super::super::{Check, Rule, RuleCx};
use super::places::{self, Worst};
use super::{readable_own, unusable_entries};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2, Mpfb},
    Change, Evidence, Finding, Fix, FixKind, Level, Place, Rewrite, RuleInfo,
};
use mhlint_formats::mhw::{FAR_SUMS, SumFacts, Weights};
use mhlint_formats::obj::Mesh;
use mhlint_repo::Body;

const USUAL: &str = "divides the weights of every vertex by their sum, so that the result is right";

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[
        (Makehuman2, USUAL),
        (Makehuman1, USUAL),
        (
            Mpfb,
            "lets Blender divide by the sum when the vertex moves, so that the result is right",
        ),
    ],
    // Every line of the file changes for nothing that anybody sees today.
    fix: FixKind::Unsafe,
    docs: include_str!("not_normalized.md").trim_ascii_end(),
    counts: "vertices",
    ..RuleInfo::new(
        "weights-not-normalized",
        Level::Info,
        "the weights of a vertex do not add up to 1",
    )
});

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    // An entry that cannot be used may be what one vertex lacks; of more vertices it is not the
    // reason.
    let is_explained = |weights: &Weights| {
        unusable_entries(weights).is_none_or(|lost| weights.facts.sum.off <= lost)
    };
    for (own, weights) in readable_own(body).filter(|(_, weights)| !is_explained(weights)) {
        let (sums, vertices) = (&weights.facts.sum, weights.facts.vertices);
        if body.is_mpfb() && deviation(sums.range.0).max(deviation(sums.range.1)) < FIVE_DIGITS {
            continue;
        }
        let Some(worst) = places::worst(body, &sums.vertices, deviation) else {
            continue;
        };
        let evidence =
            Evidence::of_cases(sums.vertices.iter().map(|(vertex, _)| *vertex)).out_of(vertices);
        let evidence =
            evidence.with_worst(f64::from(worst.value), format!("vertex {}", worst.vertex));
        let fix = Fix::new(
            RULE.info.fix,
            "divide the weights of these vertices by their sum",
        );
        let fix = fix.step(&own.file.path, Change::Rewrite(Rewrite::NormalizeWeights));
        let mut finding = RULE.at(
            own.file,
            Place::pointer(["weights"]),
            message(body, weights, &worst),
        );
        for note in [range(sums), Some(effect_on(body, sums, &worst))]
            .into_iter()
            .flatten()
        {
            finding = finding.related(&own.file.path, Place::File, note);
        }
        out.push(
            finding
                .help("normalise the weights")
                .evidence(evidence)
                .fix(fix),
        );
    }
}

/// What is left of sums in files with five digits: Blender divides by them, and nothing is off.
const FIVE_DIGITS: f32 = 2e-4;

fn deviation(sum: f32) -> f32 {
    (sum - 1.0).abs()
}

fn message(body: &Body<'_>, weights: &Weights, worst: &Worst) -> String {
    let (off, vertices) = (weights.facts.sum.off, weights.facts.vertices);
    if off == 1 {
        return format!(
            "the weights of {} add up to {}, not 1",
            body.vertex(worst.vertex),
            worst.value
        );
    }
    let places = worst
        .places
        .as_ref()
        .map(|places| format!(" ({places})"))
        .unwrap_or_default();
    format!("the weights of {off} of {vertices} vertices{places} do not add up to 1")
}

/// How far the sums are off, of several vertices.
fn range(sums: &SumFacts) -> Option<String> {
    let (least, most) = sums.range;
    let range = if most - least < 5e-4 {
        format!("all these sums are {least:.3}")
    } else {
        format!("the sums are {least:.3} to {most:.3}")
    };
    let [(far, limit), (farther, high_limit)] =
        [0, 1].map(|at| (sums.far_off[at], FAR_SUMS[at] * 100.0));
    let are = if far == 1 { "is" } else { "are" };
    let off = format!(
        "{far} {are} off by more than {limit:.0} %, {farther} by more than {high_limit:.0} %"
    );
    (sums.off > 1).then(|| format!("{range}; {off}"))
}

/// What becomes of the worst vertex where the weights are used as they are.
fn effect_on(body: &Body<'_>, sums: &SumFacts, worst: &Worst) -> String {
    let shift = body
        .mesh
        .and_then(|(_, mesh)| shift(mesh, worst.vertex, worst.value))
        .map(length);
    let moves = shift.map(|by| format!("a program that does not normalise moves it by {by}"));
    match (sums.off, moves) {
        (1, Some(moves)) => moves,
        (1, None) => "a program that does not normalise moves it".to_owned(),
        (_, moves) => {
            let worst = format!(
                "{} is worst, with {:.3}",
                body.vertex(worst.vertex),
                worst.value
            );
            [Some(worst), moves]
                .into_iter()
                .flatten()
                .collect::<Vec<_>>()
                .join("; ")
        }
    }
}

/// How far skinning moves a vertex at rest if its weights are used as they are: v' = sum * v.
fn shift(mesh: &Mesh, vertex: u32, sum: f32) -> Option<f32> {
    let [x, y, z] = mesh.positions.get(vertex as usize)?;
    let distance = deviation(sum) * (x * x + y * y + z * z).sqrt();
    distance.is_finite().then_some(distance)
}
