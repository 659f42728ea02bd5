//! Bones without weights.

use super::super::{Check, Rule, RuleCx};
use super::{is_empty, readable};
use crate::diag::{Application, Evidence, Finding, Level, Place, RuleInfo};
use crate::repo::Body;

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        breaks: &[
            (Application::Makehuman2, "takes the bone as one that the file does not mention: it moves no vertex"),
            (Application::Makehuman1, "leaves the bone out of the weights: it moves no vertex"),
            (Application::Mpfb, "leaves the bone without a vertex group: it moves no vertex"),
        ],
        docs: "A bone with an empty list means the same as one that is not mentioned. It is harmless, even where \
            the skeleton does not have the bone, but often a sign that painting it was forgotten.\n\nRemove the \
            bone from the file, or paint it.",
        ..RuleInfo::new("weights-empty-bone", Level::Info, "a bone of the weights has no entry")
    },
    check: Check::Body(run),
};

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    // Where no bone has an entry, that is the fault (`weights-unweighted-vertex`).
    for (own, weights) in readable(body).filter(|(_, weights)| !is_empty(weights)) {
        let empty = weights.bones.iter().filter(|bone| bone.listed == 0 && bone.is_list);
        let names: Vec<&str> = empty.map(|bone| bone.name.as_str()).collect();
        let Some(first) = names.first() else { continue };
        let message = match names.len() {
            1 => format!("bone `{first}` has no weights"),
            count => format!("{count} of {} bones have no weights, the first is `{first}`", weights.bones.len()),
        };
        out.push(
            RULE.at(own.file, Place::key(["weights", first]), message)
                .help("remove the bone, or paint it")
                .evidence(Evidence::of_cases(&names).out_of(weights.bones.len())),
        );
    }
}
