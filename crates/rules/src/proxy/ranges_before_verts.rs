//! Ranges of vertices to hide stand below the rows.

use super::super::{Check, Rule, RuleCx};
use super::blender;
use mhlint_diag::{Application::Mpfb, Finding, Level, RuleInfo};
use mhlint_repo::Body;

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[(Mpfb, "counts the ranges as rows, and fails with `KeyError` when it fits the asset")],
    docs: "`delete_verts` with ranges such as `5 - 7` stands above `verts`.\n\n\
        MPFB counts these ranges as vertex rows, so that the first row has another number than 0 and no row fits its \
        vertex. Single numbers do no harm.\n\n\
        Put `delete_verts` below the vertex rows, behind an empty line.",
    ..RuleInfo::new("proxy-ranges-before-verts", Level::Error, "ranges of vertices to hide above the vertex rows")
});

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    blender::list::before_rows(&RULE, body, out);
}
