//! Ranges of vertices to hide stand below the rows.

use super::super::{Check, Rule, RuleCx};
use super::blender;
use mhlint_diag::{Application::Mpfb, Finding, Level, RuleInfo};
use mhlint_repo::Body;

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[(
        Mpfb,
        "counts the ranges as rows, and fails with `KeyError` when it fits the asset",
    )],
    docs: include_str!("ranges_before_verts.md").trim_ascii_end(),
    ..RuleInfo::new(
        "proxy-ranges-before-verts",
        Level::Error,
        "ranges of vertices to hide above the vertex rows",
    )
});

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    blender::list::before_rows(&RULE, body, out);
}
