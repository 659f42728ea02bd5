//! Parents must lead to the root, not in a circle.

use super::super::{Check, Rule, RuleCx};
use super::lost::{LOST_AND_WEIGHTED, lost_bones};
use crate::diag::{Finding, Level, RuleInfo};
use crate::repo::Body;

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        breaks: LOST_AND_WEIGHTED,
        docs: "MakeHuman 2 builds a skeleton from its root downwards. Bones that are each other's parents are never \
            reached: they are missing in the skeleton, without a message. If the weights mention one, entering \
            pose mode stops with a KeyError; otherwise (`warning`) the bones are just not there. Where the circle takes \
            the only root with it MakeHuman 2 refuses the skeleton.\n\nGive one \
            bone of the circle a parent outside of it. A circle with bones below it, which are lost as well, is \
            reported as `skeleton-unreachable-bone`; a skeleton in which nothing but circles exists as `skeleton-no-root`.",
        ..RuleInfo::new("skeleton-cycle", Level::Error, "the parents of some bones run in a circle")
    },
    check: Check::Body(run),
};

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    out.extend(lost_bones(&RULE, body, |ring| ring.below.is_empty()));
}
