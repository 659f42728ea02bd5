//! Vertices are counted from 0.

use super::super::cause::archived::weigh;
use super::super::{Check, Rule, RuleCx};
use super::{first_row, targets};
use crate::diag::{Application, Finding, Level, RuleInfo};
use crate::repo::Body;

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        breaks: &[(
            Application::Makehuman2,
            "stops at start with an OverflowError and leaves an empty compressedtargets.npz behind, which stops every \
             later start",
        )],
        docs: "A negative vertex index.\n\nMakeHuman 2 stores indices as unsigned numbers of 32 bits. NumPy 2 refuses a negative \
            one, which ends the program at start, whether the target is used or not. With NumPy 1 it becomes an index of \
            about four thousand million, and the program ends when the target is applied. While a sound archive stands for the \
            target its text is not parsed; then this is a warning.\n\nWrite the index that the base \
            mesh has, or remove the row.",
        ..RuleInfo::new("target-negative-index", Level::Error, "a negative vertex index in a target")
    },
    check: Check::Body(run),
};

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for (target, file, facts) in targets(body) {
        let Some((_, index)) = facts.negative.first.first() else { continue };
        let message = match facts.negative.count {
            1 => format!("vertex index {index} is negative"),
            count => format!("{count} vertex indices are negative, the first is {index}"),
        };
        let finding = RULE
            .at(file, first_row(&facts.negative), message)
            .help("vertices count from 0; write the right index or remove the row")
            .evidence(facts.negative.evidence(facts.rows));
        out.push(weigh(target, finding));
    }
}
