//! The tables of the base mesh of MPFB can be read, and fit the mesh.

use super::super::unfit::findings;
use super::super::{Check, Rule, RuleCx};
use super::{corrections, faces, mirror, vertex_groups};
use mhlint_diag::{Application::Mpfb, Case, Finding, Level, RuleInfo};
use mhlint_discover::Kind;
use mhlint_repo::mpfb::View;

pub(crate) static RULE: Rule = Check::Mpfb(run).rule(RuleInfo {
    breaks: &[(Mpfb, "fails with an exception where it needs the table")],
    docs: include_str!("table.md").trim_ascii_end(),
    ..RuleInfo::new(
        "metadata-table",
        Level::Error,
        "a table of the base mesh that its loader does not take",
    )
});

const NO_START: Case = &[(
    Mpfb,
    Level::Error,
    "fails while the add-on is imported: MPFB cannot be enabled",
)];
const HALF_MADE: Case = &[(
    Mpfb,
    Level::Error,
    "fails with an exception after it fits an asset that has a scale: this one is left half-made",
)];

fn run(view: &View<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for file in view.own(Kind::VertexGroups) {
        let Some(groups) = file.vertex_groups() else {
            continue;
        };
        out.extend(
            findings(&RULE, file, &groups.stops, cx).map(|(_, finding)| finding.case(NO_START)),
        );
        if groups.stops.all().is_empty() {
            vertex_groups::faults(&RULE, view, file, groups, out);
        }
    }
    for file in view.own(Kind::BodyDimensions) {
        let Some(dimensions) = file.body_dimensions() else {
            continue;
        };
        out.extend(
            findings(&RULE, file, &dimensions.stops, cx)
                .map(|(_, finding)| finding.case(HALF_MADE)),
        );
        out.extend(vertex_groups::unknown(&RULE, view, file, dimensions));
    }
    for file in view.own(Kind::MirrorTable) {
        out.extend(
            file.mirror_table()
                .and_then(|table| mirror::fault(&RULE, view, file, table)),
        );
    }
    for file in view.own(Kind::ProxyCorrections) {
        let Some(corrections) = file.proxy_corrections() else {
            continue;
        };
        corrections::faults(&RULE, view, file, corrections, cx, out);
    }
    faces::faults(&RULE, view, out);
}
