//! A vertex far outside the figure at some setting.

use super::super::units::length;
use super::super::{Check, Rule, RuleCx};
use super::{at_setting, untold};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2, Mpfb},
    Confidence, Evidence, Finding, Grows, Level, MeasureKind, RuleInfo,
};
use mhlint_eval::measures::Measures;
use mhlint_eval::survey::Trouble;
use mhlint_repo::Body;

pub(crate) static RULE: Rule = Check::Numeric(run).rule(RuleInfo {
    breaks: &[
        (
            Makehuman2,
            "tears such vertices out of the figure, together with their faces, joints and clothes",
        ),
        (
            Makehuman1,
            "tears such vertices out of the figure, together with their faces, joints and clothes",
        ),
        (
            Mpfb,
            "tears such vertices out of the figure, together with their faces, joints and clothes",
        ),
    ],
    docs: include_str!("exploded_vertex.md").trim_ascii_end(),
    counts: "vertices",
    grows: Grows::more(MeasureKind::Distance),
    ..RuleInfo::new(
        "numeric-exploded-vertex",
        Level::Warning,
        "a vertex lies far outside the figure at some slider setting",
    )
});

fn run(body: &Body<'_>, measures: &Measures, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some(seen) = untold(body, measures, Trouble::Exploded) else {
        return;
    };
    let (vertex, by) = (
        body.vertex(seen.element),
        length(seen.length.unwrap_or(f64::NAN)),
    );
    let message = match seen.count {
        1 => format!("{vertex} lies {by} outside the figure"),
        count => format!("{count} vertices lie outside the figure, {vertex} farthest, by {by}"),
    };
    let evidence = Evidence::counted(seen.count);
    out.push(
        at_setting(&RULE, body, seen, &message)
            .key("vertices")
            .parts(seen.elements.iter().copied())
            .confidence(Confidence::Medium)
            .help(
                "correct the numbers; a decimal point may be missing or the unit wrong: lengths \
                are in decimetres",
            )
            .evidence(evidence.with_worst(seen.value, format!("vertex {}", seen.element))),
    );
}
