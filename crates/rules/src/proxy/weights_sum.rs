//! The weights of a vertex row sum to 1.

use super::super::units::length;
use super::super::{Check, Rule, RuleCx};
use super::{Text, blender, texts};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2, Mpfb},
    Case, Finding, Grows, Level, MeasureKind, Place, RuleInfo,
};
use mhlint_repo::Body;

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[
        (
            Makehuman2,
            "pulls the vertex towards the origin of the world, away from the body",
        ),
        (
            Makehuman1,
            "pulls the vertex towards the origin of the world, away from the body",
        ),
        (
            Mpfb,
            "pulls the vertex towards the origin of the world, away from the body",
        ),
    ],
    docs: include_str!("weights_sum.md").trim_ascii_end(),
    grows: Grows::from_one(MeasureKind::Weight),
    ..RuleInfo::new(
        "proxy-weights-sum",
        Level::Warning,
        "the weights of a vertex row do not sum to 1",
    )
});

const SMALL: Case = &[
    (
        Makehuman2,
        Level::Info,
        "moves the vertices by a few millimetres at most",
    ),
    (
        Makehuman1,
        Level::Warning,
        "pulls the vertices towards the origin, by a few millimetres at most",
    ),
];
const BEYOND: Case = &[
    (
        Makehuman2,
        Level::Warning,
        "pushes the vertex away from the origin of the world, off the body",
    ),
    (
        Makehuman1,
        Level::Warning,
        "pushes the vertex away from the origin of the world, off the body",
    ),
];
const SLIGHT: Case = &[(
    Makehuman1,
    Level::Info,
    "moves the vertices by less than a millimetre",
)];

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    if body.is_mpfb() {
        return blender::rows::sums(&RULE, body, out);
    }
    for text in texts(body).filter(|text| !text.reading.stops()) {
        let rows = &text.clothes.rows;
        // Sums that few decimals explain are told where there are no others.
        let is_slight = rows.coarse_sums.count == 0;
        let sums = if is_slight {
            &rows.off_sums
        } else {
            &rows.coarse_sums
        };
        let (Some((line, _)), Some((vertex, sum))) = (sums.first.first(), rows.worst_sum) else {
            continue;
        };
        if is_slight && !text.is_makehuman1() {
            continue;
        }
        let finding = RULE.at(
            text.file,
            Place::Line(*line),
            message(sums.count, &text.vertex(vertex), sum, is_slight)
                + &moved(body, &text, vertex, sum),
        );
        let finding = finding.evidence(
            sums.evidence(rows.count)
                .with_worst(sum, format!("vertex {vertex}")),
        );
        let finding = finding
            .help("export the asset again, or correct the weights so that each row sums to 1");
        out.push(match (is_slight, rows.visible_sums) {
            (true, _) => finding.case(SLIGHT),
            (false, 0) => finding.case(SMALL),
            _ if sum > 1.0 => finding.case(BEYOND),
            _ => finding,
        });
    }
}

/// How far the vertex is from where a sum of 1 would put it.
fn moved(body: &Body<'_>, text: &Text<'_, '_>, vertex: u64, sum: f64) -> String {
    let row = usize::try_from(vertex)
        .ok()
        .and_then(|vertex| text.clothes.kept.get(vertex));
    let away = row.zip(body.whole_mesh()).and_then(|(row, mesh)| {
        let [a, b, c] = row
            .vertices
            .map(|vertex| mesh.positions.get(vertex as usize));
        let share = |weight: f32| {
            if sum == 0.0 {
                1.0 / 3.0
            } else {
                f64::from(weight) / sum
            }
        };
        let off =
            [a?, b?, c?]
                .into_iter()
                .zip(row.weights)
                .fold([0.0; 3], |off, (point, weight)| {
                    [0, 1, 2].map(|axis| {
                        off[axis] + f64::from(point[axis]) * (f64::from(weight) - share(weight))
                    })
                });
        Some(off.iter().map(|part| part * part).sum::<f64>().sqrt()).filter(|away| away.is_finite())
    });
    away.map(|away| format!(", which moves it by {}", length(away)))
        .unwrap_or_default()
}

fn message(count: u64, vertex: &str, sum: f64, is_slight: bool) -> String {
    let digits = if is_slight { 5 } else { 3 };
    match count {
        1 => format!(
            "the fitting weights of {vertex} of the asset sum to {sum:.digits$} instead of 1"
        ),
        _ => format!(
            "the fitting weights of {count} vertices of the asset do not sum to 1, at worst \
                {sum:.digits$} ({vertex})"
        ),
    }
}
