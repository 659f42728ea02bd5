//! Every field of a target row must be a number.

use super::super::cause::archived::weigh;
use super::super::{Check, Rule, RuleCx};
use super::targets;
use super::unreadable_fields::finding;
use crate::diag::{Application::Makehuman2, Finding, Level, RuleInfo};
use crate::repo::Body;

pub(in crate::rules) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[(
        Makehuman2,
        "crashes at start with `ValueError` and leaves an empty compressedtargets.npz that crashes every later \
         start",
    )],
    docs: "A field of a target row is not a number. A row is a vertex index and three decimal numbers with a \
        point.\n\n\
        MakeHuman 2 parses every target below the folder at start, used or not, with Python's `int()` and \
        `float()`. What they reject (words, `1.0` as an index, a decimal comma) crashes it. The empty archive that \
        stays behind must be deleted by hand, even after the target was fixed. While MakeHuman 2 uses a sound \
        archive in place of the text, the text is not parsed: a warning.\n\n\
        Write the field as a number, or remove the row. For a target that nothing uses see `target-breaks-start`.",
    counts: "rows",
    ..RuleInfo::new("target-syntax", Level::Error, "a field of a target row is not a number")
});

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for (target, file, facts) in targets(body) {
        if !target.is_unused {
            out.extend(finding(&RULE, file, facts).map(|finding| weigh(target, finding)));
        }
    }
}
