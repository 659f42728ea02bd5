//! Files with both sides of a merge in them, which `file-merge-conflict` reports: what single lines do follows from that.

use std::collections::BTreeMap;

use crate::diag::{Break, Finding};

const CAUSE: &str = "file-merge-conflict";

/// Takes away what follows from a merge conflict in the same file, and gives the conflict the worst of its consequences.
pub(crate) fn drop_unmerged(findings: &mut Vec<Finding>) {
    let mut worst: BTreeMap<String, Vec<Break>> =
        findings.iter().filter(|one| one.rule == CAUSE).map(|one| (one.path.clone(), one.breaks.clone())).collect();
    if worst.is_empty() {
        return;
    }
    let is_of_lines = |one: &Finding| {
        let is_apart = ["file-", "archive-", "library-", "overlay-"].iter().any(|family| one.rule.starts_with(family));
        one.rule != CAUSE && !is_apart
    };
    findings.retain(|one| {
        let Some(breaks) = worst.get_mut(&one.path).filter(|_| is_of_lines(one)) else { return true };
        for own in &mut *breaks {
            let same = one.breaks.iter().find(|other| other.application == own.application);
            if let Some(other) = same.filter(|other| other.level >= own.level) {
                *own = other.clone();
            }
        }
        false
    });
    for one in findings.iter_mut().filter(|one| one.rule == CAUSE) {
        if let Some(breaks) = worst.remove(&one.path) {
            one.level = breaks.iter().map(|one| one.level).max().unwrap_or(one.level);
            one.breaks = breaks;
        }
    }
}
