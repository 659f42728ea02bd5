//! Every bone must be reachable from the root.

use super::super::{Check, Rule, RuleCx};
use super::lost::{LOST_AND_WEIGHTED, lost_bones};
use mhlint_diag::{Finding, Level, RuleInfo};
use mhlint_repo::Body;

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: LOST_AND_WEIGHTED,
    docs: "A bone is correct itself but lost, because its parents lead into a cycle.\n\n\
        MakeHuman 2 builds the skeleton from the root downwards, never reaches the bone, and drops it without a \
        message. If the weights use a lost bone, entering pose mode crashes with `KeyError`; otherwise this is a \
        warning. If the only root is part of the cycle, MakeHuman 2 rejects the skeleton.\n\n\
        The finding is reported at the cycle, which is the place to fix: give one of its bones a parent outside \
        it. A cycle with nothing below it is `skeleton-cycle`.",
    counts: "bones",
    ..RuleInfo::new(
        "skeleton-unreachable-bone",
        Level::Error,
        "bones below a cycle of parents cannot be reached from the root",
    )
});

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    out.extend(lost_bones(&RULE, body, |ring| !ring.below.is_empty()));
}
