//! The three vertices of a row make a triangle.

use super::super::{Check, Rule, RuleCx};
use super::measured;
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2, Mpfb},
    Evidence, Finding, Level, Place, RuleInfo,
};
use mhlint_eval::measures::Measures;
use mhlint_eval::worn::TripleFault;
use mhlint_repo::Body;

pub(crate) static RULE: Rule = Check::Numeric(run).rule(RuleInfo {
    breaks: &[
        (
            Makehuman2,
            "moves and bends the vertex with fewer vertices of the body than the row was \
            meant to name",
        ),
        (
            Makehuman1,
            "moves and bends the vertex with fewer vertices of the body than the row was \
            meant to name",
        ),
        (
            Mpfb,
            "moves and bends the vertex with fewer vertices of the body than the row was meant \
            to name",
        ),
    ],
    docs: include_str!("degenerate_triple.md").trim_ascii_end(),
    counts: "rows",
    ..RuleInfo::new(
        "proxy-degenerate-triple",
        Level::Warning,
        "three vertices of a row that make \
        no triangle",
    )
});

fn run(body: &Body<'_>, measures: &Measures, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for (text, measure) in measured(body, measures) {
        let faults = &measure.triples.faults;
        let Some((row, fault)) = faults.first() else {
            continue;
        };
        let vertices = text
            .clothes
            .kept
            .get(*row)
            .map(|row| row.vertices)
            .unwrap_or_default();
        let what = match fault {
            TripleFault::One => format!("names vertex {} three times", vertices[0]),
            TripleFault::Two => format!(
                "names a vertex twice: {}, {}, {}",
                vertices[0], vertices[1], vertices[2]
            ),
            TripleFault::Line => {
                format!(
                    "names vertices on one line: {}, {}, {}",
                    vertices[0], vertices[1], vertices[2]
                )
            }
        };
        let message = match faults.len() {
            1 => format!("the row of {} {what}", text.vertex(*row)),
            count => format!(
                "{count} rows name no triangle; the first, of {}, {what}",
                text.vertex(*row)
            ),
        };
        let lines = faults
            .iter()
            .map(|(row, _)| format!("line {}", text.clothes.line_of(*row)));
        let evidence = Evidence::of_unnamed(lines);
        out.push(
            RULE.at(text.file, Place::Line(text.clothes.line_of(*row)), message)
                .evidence(evidence.out_of(text.clothes.rows.count))
                .help(
                    "export the asset again; by hand, name three vertices of one face of the body",
                ),
        );
    }
}
