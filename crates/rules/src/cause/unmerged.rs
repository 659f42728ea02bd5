//! Files with both sides of a merge in them, which `file-merge-conflict` reports: what single lines
//! do follows from that.

use std::collections::BTreeMap;

use mhlint_diag::{Break, Finding};

const CAUSE: &str = "file-merge-conflict";

/// What is found where a line is no line of the format, or is there twice. What else is wrong with
/// a file stays.
const OF_LINES: [&str; 19] = [
    "proxy-keyword-after-verts",
    "proxy-keyword-spelling",
    "proxy-shifted-rows",
    "proxy-syntax",
    "proxy-unknown-keyword",
    "proxy-vertex-count",
    "material-arity",
    "material-duplicate-keyword",
    "material-unknown-keyword",
    "model-arity",
    "model-category",
    "model-syntax",
    "mesh-degenerate-face",
    "mesh-duplicate-face",
    "mesh-syntax",
    "mesh-unused-vertex",
    "bvh-syntax",
    "bvh-channels",
    "bvh-frames",
];

/// Takes away what follows from a merge conflict in the same file, and gives the conflict the worst
/// of its consequences.
pub fn drop_unmerged(findings: &mut Vec<Finding>) {
    let mut worst: BTreeMap<String, Vec<Break>> = findings
        .iter()
        .filter(|one| one.rule == CAUSE)
        .map(|one| (one.path.clone(), one.breaks.clone()))
        .collect();
    if worst.is_empty() {
        return;
    }
    findings.retain(|one| {
        let Some(breaks) = worst
            .get_mut(&one.path)
            .filter(|_| OF_LINES.contains(&one.rule))
        else {
            return true;
        };
        for own in &mut *breaks {
            let same = one
                .breaks
                .iter()
                .find(|other| other.application == own.application);
            if let Some(other) = same.filter(|other| other.level >= own.level) {
                *own = other.clone();
            }
        }
        false
    });
    for one in findings.iter_mut().filter(|one| one.rule == CAUSE) {
        if let Some(breaks) = worst.remove(&one.path) {
            one.level = breaks
                .iter()
                .map(|one| one.level)
                .max()
                .unwrap_or(one.level);
            one.breaks = breaks;
        }
    }
}
