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
            "crashes at start with `OverflowError` and leaves an empty compressedtargets.npz that crashes every later \
             start",
        ),
        (Makehuman1, "fails with `IndexError` each time the target is applied, and stops in the middle of the update"),
        (Mpfb, "counts from the end of the mesh: silently moves another vertex"),
    ],
    levels: &[(Mpfb, Level::Warning)],
    docs: "A vertex index in a target is negative.\n\n\
        MakeHuman 2 stores indices as unsigned 32-bit numbers. NumPy 2 rejects a negative one, which crashes the \
        program at start, whether the target is used or not. NumPy 1 turns it into an index of about 4 thousand \
        million, and the program crashes when the target is applied. While MakeHuman 2 uses a sound archive in \
        place of the text, the text is not parsed: a warning.\n\n\
        MPFB counts such an index from the end: -1 is the last vertex of the mesh. One beyond the first vertex stops the \
        target (an error).\n\n\
        Write the index that the base mesh has, or remove the row.",
    counts: "rows, by vertex",
    ..RuleInfo::new("target-negative-index", Level::Error, "a vertex index in a target is negative")
});

const BEFORE_ALL: Case =
    &[(Mpfb, Level::Error, "fails with `IndexError` when the slider moves, and leaves an empty shape key")];

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for (target, file, facts) in targets(body) {
        let Some((_, index)) = facts.negative.first.first() else { continue };
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
        let vertices = body.mesh.and_then(|(_, mesh)| i64::try_from(mesh.facts.vertices).ok());
        let is_before = vertices.is_some_and(|count| facts.negative.first.iter().any(|(_, index)| *index < -count));
        let finding =
            RULE.at(file, first_row(&facts.negative), message).help(help).evidence(facts.negative.evidence(facts.rows));
        out.push(weigh(target, if is_before { finding.case(BEFORE_ALL) } else { finding }));
    }
}
