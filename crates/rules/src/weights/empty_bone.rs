//! Bones without weights.

use super::super::{Check, Rule, RuleCx};
use super::{is_empty, readable};
use mhlint_diag::{
    Application::{Makehuman2, Mpfb},
    Evidence, Finding, Level, Place, RuleInfo,
};
use mhlint_repo::Body;

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[
        (
            Makehuman2,
            "treats such bones as if the file did not list them: they move no vertex",
        ),
        (
            Mpfb,
            "creates no vertex group for the bone: it moves no vertex",
        ),
    ],
    docs: include_str!("empty_bone.md").trim_ascii_end(),
    counts: "bones",
    ..RuleInfo::new(
        "weights-empty-bone",
        Level::Info,
        "a bone has an empty list of weights",
    )
});

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    // Where no bone has an entry, that is the fault (`weights-unweighted-vertex`).
    for (own, weights) in readable(body).filter(|(_, weights)| !is_empty(weights)) {
        let is_meant = |name: &str| body.is_mpfb() && is_root(name);
        let empty = weights
            .bones
            .iter()
            .filter(|bone| bone.listed == 0 && bone.is_list && !is_meant(&bone.name));
        let names: Vec<&str> = empty.map(|bone| bone.name.as_str()).collect();
        let Some(first) = names.first() else { continue };
        let message = match names.len() {
            1 => format!("bone `{first}` has no weights"),
            count => format!(
                "{count} of {} bones have no weights, first `{first}`",
                weights.bones.len()
            ),
        };
        out.push(
            RULE.at(own.file, Place::key(["weights", first]), message)
                .help("remove the bone from the file, or paint its weights")
                .evidence(Evidence::of_cases(&names).out_of(weights.bones.len())),
        );
    }
}

/// Whether a bone is called a root, in whatever rig: nothing moves with that alone.
fn is_root(name: &str) -> bool {
    name.rsplit(':')
        .next()
        .is_some_and(|name| name.eq_ignore_ascii_case("root"))
}
