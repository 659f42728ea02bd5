//! Every bone must be reachable from the root.

use super::super::{Check, Rule, RuleCx};
use super::lost::{LOST_AND_WEIGHTED, lost_bones};
use crate::diag::{Finding, Level, RuleInfo};
use crate::repo::Body;

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        breaks: LOST_AND_WEIGHTED,
        docs: "A bone that is correct itself is lost when its parents lead into a circle: MakeHuman 2 builds the skeleton from the root downwards and never comes \
            there.\n\nIf the weights mention a lost bone, entering pose mode stops with a KeyError; otherwise \
            (`warning`) the bones are just not there. Where the circle takes \
            the only root with it MakeHuman 2 refuses the skeleton.\n\nThe finding stands at the circle, which is the place to mend. A \
            circle with nothing below it is `skeleton-cycle`.",
        ..RuleInfo::new(
            "skeleton-unreachable-bone",
            Level::Error,
            "bones hang below a circle of parents, cut off from the root",
        )
    },
    check: Check::Body(run),
};

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    out.extend(lost_bones(&RULE, body, |ring| !ring.below.is_empty()));
}
