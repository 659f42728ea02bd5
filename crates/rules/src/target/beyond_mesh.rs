//! Rows for vertices that the mesh does not have, in words.

use super::super::Rule;
use super::first_row;
use mhlint_diag::{Evidence, Finding, Tally};
use mhlint_formats::target::TargetFacts;
use mhlint_repo::FileFacts;

/// MPFB passes over rows for vertices that the mesh lacks, and knows no copies at the seams of the
/// UV map.
pub(super) fn ignored(
    rule: &Rule,
    file: &FileFacts,
    facts: &TargetFacts,
    vertices: Option<usize>,
) -> Option<Finding> {
    let (seam, beyond_all) = (&facts.seam, &facts.out_of_range);
    let count = seam.count + beyond_all.count;
    let first_of = if seam.count > 0 { seam } else { beyond_all };
    let mesh = mesh_has(file, vertices);
    let message = match count {
        0 => return None,
        1 => format!("vertex {} does not exist: {mesh}", first(first_of)),
        _ => {
            let largest = facts.max_index.unwrap_or_default();
            format!("{count} rows name vertices that do not exist (up to {largest}): {mesh}")
        }
    };
    let rows = seam.first.iter().chain(&beyond_all.first);
    let mut evidence =
        Evidence::of_unnamed(rows.map(|(line, index)| format!("line {line}: vertex {index}")));
    evidence.count = count;
    let help =
        "export the target again from the base mesh; its other rows may be for another mesh, too";
    Some(
        rule.at(file, first_row(first_of), message)
            .help(help)
            .evidence(evidence.out_of(facts.rows)),
    )
}

pub(super) fn first(tally: &Tally) -> i64 {
    tally.first.first().map_or(0, |(_, index)| *index)
}

pub(super) fn mesh_has(file: &FileFacts, vertices: Option<usize>) -> String {
    let base = file.base().unwrap_or_default();
    vertices.map_or_else(
        || format!("the base mesh `{base}` is smaller"),
        |vertices| format!("base mesh `{base}` has {vertices} vertices"),
    )
}
