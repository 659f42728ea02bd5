//! `geometry.json`: vertex ranges of a base mesh, read by offline tools only
//! (`docs/loaders/makehuman2/base.md#geometryjson`).

use mhlint_json::{Document, Node};

/// The file.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Geometry {
    /// Name of a part, first and last vertex.
    pub geometry_ranges: Vec<Range>,
    /// Name of a joint (group name without `joint-`), first and last vertex.
    pub joint_ranges: Vec<Range>,
}

/// A named vertex range, both ends inclusive.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Range {
    /// The name.
    pub name: String,
    /// First and last vertex, if they are integers.
    pub ends: Option<(i64, i64)>,
}

/// Takes what the tools would take.
pub fn read(document: &Document) -> Geometry {
    Geometry {
        geometry_ranges: ranges(document.root.get("geometry-ranges")),
        joint_ranges: ranges(document.root.get("joint-ranges")),
    }
}

fn ranges(node: Option<&Node>) -> Vec<Range> {
    let members = node
        .map(Node::effective_members)
        .unwrap_or_default()
        .into_iter();
    members
        .map(|member| Range {
            name: member.key.clone(),
            ends: match member.node.elements() {
                [first, last, ..] => first.as_i64().zip(last.as_i64()),
                _ => None,
            },
        })
        .collect()
}
