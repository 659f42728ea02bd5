//! A target for the left is the mirror image of the one for the right.

use super::super::{Check, Rule, RuleCx};
use super::shown::shown_by;
use crate::diag::{Application, Case, Element, Evidence, Finding, Level, Place, RuleInfo};
use crate::eval::measures::{Measures, PairMeasure};
use crate::repo::Body;

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        breaks: &[(
            Application::Makehuman2,
            "gives the two sides different shapes for the same setting of their sliders",
        )],
        docs: "Two targets that are named alike but for `l` and `r` (`left` and `right`) move mirrored vertices differently.\n\n\
            Which vertices mirror each other is found from the base mesh. Displacements may differ by 0.0025 units, which is \
            rounding. When only helper geometry differs, the body is right and only clothes and hair that are fitted to \
            those helpers are uneven: an info.\n\nMirror one of the two targets and save it over the other.",
        ..RuleInfo::new("target-asymmetric-pair", Level::Warning, "left and right targets are no mirror images")
    },
    check: Check::Numeric(run),
};

const ON_HELPERS: Case = &[(
    Application::Makehuman2,
    Level::Info,
    "fits clothes and hair unevenly at the helpers that differ; the body is even",
)];

fn run(body: &Body<'_>, measures: &Measures, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    out.extend(measures.pairs.iter().filter_map(|pair| finding(body, pair)));
}

fn finding(body: &Body<'_>, pair: &PairMeasure) -> Option<Finding> {
    let left = body.target(&pair.left)?.file;
    let right = body.target(&pair.right)?.file;
    // A side that moves nothing at all is a finding of its own.
    if [left, right].iter().any(|file| file.target().is_some_and(|facts| facts.moving == 0)) {
        return None;
    }
    let on_body = !pair.body.different.is_empty();
    let difference = if on_body { &pair.body } else { &pair.difference };
    let different = difference.different.len();
    let (vertex, worst) = difference.worst.filter(|_| different > 0)?;
    let on = if on_body { "vertices of the body differ" } else { "vertices differ, all on helpers" };
    let shown = shown_by(body, left).map(|setting| format!(" (seen at {setting})")).unwrap_or_default();
    let message = format!(
        "not the mirror image of `{}`: {different} of {} {on}, most vertex {vertex} by {worst:.3} units{shown}",
        right.file_name(),
        difference.compared,
    );
    let place = Place::Element(Element { kind: "vertex", index: u64::from(vertex) });
    let evidence = Evidence::counted(different);
    let finding = RULE
        .at(left, place, message)
        .parts(&difference.different)
        .between([&left.path, &right.path])
        .related(&right.path, Place::File, "its partner")
        .help("mirror one of the two and save it over the other")
        .evidence(evidence.out_of(difference.compared).with_worst(worst, format!("vertex {vertex}")));
    Some(if on_body { finding } else { finding.case(ON_HELPERS) })
}
