//! The rules as data, for whoever lists, explains or configures them.

use crate::diag::RuleInfo;
use crate::rules::RULES;

/// The declared halves of all rules, sorted by id.
pub fn rule_infos() -> Vec<&'static RuleInfo> {
    RULES.iter().map(|rule| &rule.info).collect()
}
