//! Vertices are counted from 0.

use super::super::cause::archived::weigh;
use super::super::{Check, Rule, RuleCx};
use super::{first_row, targets};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2, Mpfb},
    Case, Finding, Level, RuleInfo,
};
use mhlint_repo::Body;

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[
        (
            Makehuman2,
            "crashes at start with `OverflowError` and leaves an empty compressedtargets.npz that \
             crashes every later start",
        ),
        (
            Makehuman1,
            "fails with `IndexError` each time the target is applied, and stops in the \
            middle of the update",
        ),
        (
            Mpfb,
            "counts from the end of the mesh: silently moves another vertex",
        ),
    ],
    levels: &[(Mpfb, Level::Warning)],
    docs: include_str!("negative_index.md").trim_ascii_end(),
    counts: "rows, by vertex",
    ..RuleInfo::new(
        "target-negative-index",
        Level::Error,
        "a vertex index in a target is negative",
    )
});

const BEFORE_ALL: Case = &[(
    Mpfb,
    Level::Error,
    "fails with `IndexError` when the slider moves, and leaves an empty shape key",
)];

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for (target, file, facts) in targets(body) {
        let Some((_, index)) = facts.negative.first.first() else {
            continue;
        };
        let message = match facts.negative.count {
            1 => format!("vertex index {index} is negative"),
            count => format!("{count} vertex indices are negative, first {index}"),
        };
        let help = if body.is_mpfb() || body.is_makehuman1() {
            "correct the index (vertices are counted from 0), or remove the row"
        } else {
            "correct the index (vertices are counted from 0), or remove the row; \
             after a crash also delete compressedtargets.npz"
        };
        let vertices = body
            .mesh
            .and_then(|(_, mesh)| i64::try_from(mesh.facts.vertices).ok());
        let is_before = vertices.is_some_and(|count| {
            facts
                .negative
                .first
                .iter()
                .any(|(_, index)| *index < -count)
        });
        let finding = RULE
            .at(file, first_row(&facts.negative), message)
            .help(help)
            .evidence(facts.negative.evidence(facts.rows));
        out.push(weigh(
            target,
            if is_before {
                finding.case(BEFORE_ALL)
            } else {
                finding
            },
        ));
    }
}
