//! The rules as data, for whoever lists, explains or configures them.

use crate::diag::RuleInfo;
use crate::rules::{Check, RULES};

/// The declared halves of all rules, sorted by id.
pub fn rule_infos() -> Vec<&'static RuleInfo> {
    RULES.iter().map(|rule| &rule.info).collect()
}

/// Whether a rule is about ignores, settings and the baseline, and about no asset.
pub(super) fn is_upkeep(rule: &str) -> bool {
    RULES.iter().any(|known| known.info.id == rule && matches!(known.check, Check::Upkeep(_)))
}
