//! Parents must lead to the root, not in a circle.

use super::super::{Check, Rule, RuleCx};
use super::lost::{LOST_AND_WEIGHTED, lost_bones};
use mhlint_diag::{Finding, Level, RuleInfo};
use mhlint_repo::Body;

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: LOST_AND_WEIGHTED,
    docs: include_str!("cycle.md").trim_ascii_end(),
    counts: "bones",
    ..RuleInfo::new(
        "skeleton-cycle",
        Level::Error,
        "the parents of some bones form a cycle",
    )
});

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    out.extend(lost_bones(&RULE, body, |ring| ring.below.is_empty()));
}
