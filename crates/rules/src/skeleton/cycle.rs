//! Parents must lead to the root, not in a circle.

use super::super::{Check, Rule, RuleCx};
use super::lost::{LOST_AND_WEIGHTED, lost_bones};
use mhlint_diag::{Finding, Level, RuleInfo};
use mhlint_repo::Body;

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: LOST_AND_WEIGHTED,
    docs: "The parents of some bones form a cycle, so that the root cannot be reached from them.\n\n\
        MakeHuman 2 builds a skeleton from its root downwards and never reaches such bones. It drops them without \
        a message. If the weights use one of them, entering pose mode crashes with `KeyError`; otherwise this is a \
        warning. If the only root is part of the cycle, MakeHuman 2 rejects the skeleton.\n\n\
        Give one bone of the cycle a parent outside it. A cycle with bones below it, which are also lost, is \
        reported as `skeleton-unreachable-bone`; a skeleton that consists of nothing but cycles as \
        `skeleton-no-root`.",
    counts: "bones",
    ..RuleInfo::new("skeleton-cycle", Level::Error, "the parents of some bones form a cycle")
});

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    out.extend(lost_bones(&RULE, body, |ring| ring.below.is_empty()));
}
