//! A fitted vertex stays with its neighbours.

use super::super::units::length;
use super::super::{Check, Rule, RuleCx};
use super::{Text, is_scaled_wrongly, is_told_by_scale, measured, numbering};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2, Mpfb},
    Evidence, Finding, Grows, Level, MeasureKind, Place, RuleInfo,
};
use mhlint_eval::measures::Measures;
use mhlint_eval::worn::Drift;
use mhlint_repo::Body;

pub(crate) static RULE: Rule = Check::Numeric(run).rule(RuleInfo {
    breaks: &[
        (Makehuman2, "draws a spike, or a dent, at the vertex"),
        (Makehuman1, "draws a spike, or a dent, at the vertex"),
        (Mpfb, "draws a spike, or a dent, at the vertex"),
    ],
    docs: include_str!("fit_drift.md").trim_ascii_end(),
    counts: "vertices",
    grows: Grows::more(MeasureKind::Distance),
    ..RuleInfo::new(
        "proxy-fit-drift",
        Level::Warning,
        "a fitted vertex that leaves its neighbours",
    )
});

fn run(body: &Body<'_>, measures: &Measures, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for (text, measure) in measured(body, measures) {
        let drifts = &measure.shape.drifts;
        let Some(worst) = drifts.first() else {
            continue;
        };
        if is_told_by_scale(body, &text) {
            continue;
        }
        let help = match measure.shape.numbering {
            Some(other) => numbering(other),
            None if is_scaled_wrongly(body, &text) => {
                "correct the distances of the scale lines: they are not those of the base mesh; \
                    or export the asset again"
            }
            None => "correct the row, or export the asset again",
        };
        let named = drifts
            .iter()
            .map(|drift| format!("vertex {}", drift.vertex));
        let evidence = Evidence::of_unnamed(named).out_of(text.clothes.rows.count);
        out.push(
            RULE.at(
                text.file,
                Place::Line(text.clothes.line_of(worst.vertex)),
                message(body, &text, drifts, worst),
            )
            .evidence(evidence.with_worst(worst.away, format!("vertex {}", worst.vertex)))
            .help(help),
        );
    }
}

fn message(body: &Body<'_>, text: &Text<'_, '_>, drifts: &[Drift], worst: &Drift) -> String {
    let tied = text
        .clothes
        .kept
        .get(worst.vertex)
        .map(|row| body.vertex(row.vertices[0]));
    let tied = tied
        .map(|vertex| format!(", tied to {vertex} of the body"))
        .unwrap_or_default();
    let vertex = text.vertex(worst.vertex);
    let away = length(worst.away);
    match drifts.len() {
        1 => format!("fitted, {vertex}{tied}, stands {away} away from where its neighbours put it"),
        count => {
            format!(
                "fitted, {count} vertices stand away from their neighbours, at worst \
                    {vertex}{tied}, by {away}"
            )
        }
    }
}
