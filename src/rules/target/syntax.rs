//! Every field of a target row must be a number.

use super::super::cause::archived::weigh;
use super::super::{Check, Rule, RuleCx};
use super::targets;
use super::unreadable_fields::finding;
use crate::diag::{Application, Finding, Level, RuleInfo};
use crate::repo::Body;

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        breaks: &[(
            Application::Makehuman2,
            "stops at start with a ValueError and leaves an empty compressedtargets.npz behind, which stops every later start",
        )],
        docs: "A row of a target is a vertex index and three decimal numbers with a point.\n\nMakeHuman 2 reads every target below \
            the folder at start, used or not, and hands the fields to Python's `int()` and `float()`. What they refuse \
            (words, `1.0` as an index, a decimal comma) ends the program. The empty archive that stays behind must be \
            deleted by hand, even after the target was mended.\n\nWhile a sound archive stands for the target its text is not parsed; then this is a warning. \
            Write the field as a number or remove the row. For a target \
            that nothing uses see `target-breaks-start`.",
        ..RuleInfo::new("target-syntax", Level::Error, "a field of a target row is no number")
    },
    check: Check::Body(run),
};

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for (target, file, facts) in targets(body) {
        if !target.is_unused {
            out.extend(finding(&RULE, file, facts).map(|finding| weigh(target, finding)));
        }
    }
}
