//! What MPFB knows of its base mesh besides the OBJ: vertex groups, dimensions, mirror table
//! (`docs/loaders/mpfb/base-mesh.md#vertex-groups`, `docs/loaders/mpfb/base-mesh.md#dimensions`,
//! `docs/loaders/mpfb/base-mesh.md#the-mirror-table`).

use std::collections::BTreeSet;

use super::python_int;
use super::unfit::{NamedAt, Unfits, Why, below, keep, nth};
use mhlint_json::{Document, Node, Value};
use mhlint_source::lines;

/// `basemesh_vertex_groups.json`.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct VertexGroups {
    /// What stops the loader.
    pub stops: Unfits,
    /// Groups with their ranges, of which both ends belong to them.
    pub groups: Vec<VertexGroup>,
}

/// A vertex group.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct VertexGroup {
    /// Name.
    pub name: String,
    /// First and last vertices.
    pub ranges: Vec<(i64, i64)>,
}

impl VertexGroup {
    /// Whether it has no vertex of a mesh with so many, if that is known.
    pub fn is_empty(&self, vertices: Option<i64>) -> bool {
        let beyond = |first: i64| vertices.is_some_and(|vertices| first >= vertices);
        self.ranges
            .iter()
            .all(|(first, last)| first > last || beyond(*first))
    }
}

impl VertexGroups {
    /// How many vertices the mesh has that the groups are for, by the last one of any.
    pub fn vertices(&self) -> i64 {
        self.groups
            .iter()
            .flat_map(|group| &group.ranges)
            .map(|(_, last)| last.saturating_add(1))
            .max()
            .unwrap_or(0)
    }
}

/// Groups, and ranges of one, that are kept. The base mesh has fewer vertices.
const MOST: usize = 100_000;

/// Takes what the loader would take.
pub fn groups(document: &Document) -> VertexGroups {
    let root = &document.root;
    let mut found = VertexGroups::default();
    if !root.is_object() {
        found.stops.add_type("", root, "an object");
    }
    for member in root.effective_members().into_iter().take(MOST) {
        let pointer = below("", &member.key);
        if !member.node.is_array() {
            found
                .stops
                .add_type(&pointer, &member.node, "a list of ranges");
        }
        let mut ranges = Vec::new();
        for (at, range) in member.node.elements().iter().enumerate().take(MOST) {
            match whole(range) {
                Some(ends) => ranges.push(ends),
                None => {
                    found
                        .stops
                        .add_type(&nth(&pointer, at), range, "a list of two whole numbers");
                }
            }
        }
        found.groups.push(VertexGroup {
            name: member.key.clone(),
            ranges,
        });
    }
    found
}

/// Both ends of a range; a third number is not read.
fn whole(range: &Node) -> Option<(i64, i64)> {
    let number = |node: &Node| match node.value {
        #[expect(
            clippy::cast_possible_truncation,
            reason = "a number without fraction; no mesh has as many vertices"
        )]
        Value::Number(number, true) => Some(number as i64),
        _ => None,
    };
    match range.elements() {
        [first, last, ..] => Some((number(first)?, number(last)?)),
        _ => None,
    }
}

/// `hm08_config.json`.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct BodyDimensions {
    /// What stops the loader.
    pub stops: Unfits,
    /// Vertex groups that it names, though nobody reads them.
    pub groups: Vec<NamedAt>,
    /// Those that are selected and have no range, where there are ranges.
    pub without_range: Vec<NamedAt>,
}

/// Of each part of the body both ends along x are looked up.
pub fn dimensions(document: &Document) -> BodyDimensions {
    let root = &document.root;
    let mut found = BodyDimensions::default();
    named_groups(root, &mut found);
    let Some(dimensions) = root.get("dimensions") else {
        if root.is_object() {
            found.stops.add("", Why::Lacks("dimensions"));
        } else {
            found.stops.add_type("", root, "an object");
        }
        return found;
    };
    if !dimensions.is_object() {
        found.stops.add_type("/dimensions", dimensions, "an object");
    }
    for member in dimensions.effective_members() {
        let pointer = below("/dimensions", &member.key);
        for key in ["xmin", "xmax"]
            .into_iter()
            .filter(|key| member.node.get(key).is_none())
        {
            found.stops.add(&pointer, Why::Lacks(key));
        }
    }
    found
}

fn named_groups(root: &Node, found: &mut BodyDimensions) {
    let ranges = root.get("groups_by_range");
    let members = ranges.map(Node::effective_members).unwrap_or_default();
    let with_range: BTreeSet<&str> = members.iter().map(|member| member.key.as_str()).collect();
    let select = root
        .get("select_groups")
        .map(Node::effective_members)
        .unwrap_or_default();
    for member in select {
        let pointer = below("/select_groups", &member.key);
        for (at, name) in member.node.elements().iter().enumerate() {
            let Some(name) = name.as_str() else { continue };
            keep(&mut found.groups, &nth(&pointer, at), name);
            if ranges.is_some_and(Node::is_object) && !with_range.contains(name) {
                keep(&mut found.without_range, &nth(&pointer, at), name);
            }
        }
    }
    for member in members {
        keep(
            &mut found.groups,
            &below("/groups_by_range", &member.key),
            &member.key,
        );
    }
}

/// `hm08.mirror`: rows `FROM TO SIDE`.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct MirrorTable {
    /// The first line that cannot be read, and how many there are.
    pub unreadable: Option<(u32, usize)>,
    /// Line, vertex, its counterpart, and the side of the vertex.
    pub rows: Vec<MirrorRow>,
}

impl MirrorTable {
    /// How many vertices the mesh has that the table is for, by the last one of any row.
    pub fn vertices(&self) -> i64 {
        self.rows
            .iter()
            .map(|row| i64::from(row.from.max(row.to)) + 1)
            .max()
            .unwrap_or(0)
    }
}

/// A row of the table.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct MirrorRow {
    /// Its line.
    pub line: u32,
    /// The vertex.
    pub from: u32,
    /// Its counterpart.
    pub to: u32,
    /// `l`, `r` or `m`; any other letter is none of these, nor is [`LONG_SIDE`].
    pub side: u8,
}

/// The side of a row that has a word for it.
pub const LONG_SIDE: u8 = 0;

/// Reads all rows. Three fields with one blank between them: anything else stops the loader.
pub fn mirror(text: &[u8]) -> MirrorTable {
    let mut table = MirrorTable::default();
    for (number, (_, line)) in (1..).zip(lines(text)) {
        if line.trim_ascii().is_empty() {
            continue;
        }
        match row(number, line) {
            Some(row) if table.rows.len() < MOST => table.rows.push(row),
            Some(_) => {}
            None => table.unreadable.get_or_insert((number, 0)).1 += 1,
        }
    }
    table
}

fn row(line: u32, text: &[u8]) -> Option<MirrorRow> {
    let mut fields = text.trim_ascii().split(|byte| *byte == b' ');
    let mut number = || u32::try_from(python_int(fields.next()?)?).ok();
    let (from, to) = (number()?, number()?);
    let side = match fields.next()? {
        [] => return None,
        [letter] => *letter,
        _ => LONG_SIDE,
    };
    Some(MirrorRow {
        line,
        from,
        to,
        side,
    })
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use mhlint_json::parse;

    fn pointers(faults: &Unfits) -> Vec<&str> {
        faults.all().iter().map(|one| &*one.pointer).collect()
    }

    #[test]
    fn ranges_are_pairs_of_whole_numbers() {
        let of = |text: &str| groups(&parse(text.as_bytes()).unwrap());
        let good = of(r#"{"body": [[0, 7], [9, 8, 3]], "none": []}"#);
        assert_eq!(good.groups[0].ranges, [(0, 7), (9, 8)]);
        assert!(good.stops.all().is_empty());
        assert_eq!(good.vertices(), 9);
        let bad = of(r#"{"body": [0, 7], "a": [[5]], "b": [[0.5, 1]], "c": 3}"#);
        assert_eq!(
            pointers(&bad.stops),
            ["/body/0", "/body/1", "/a/0", "/b/0", "/c"]
        );
        assert_eq!(pointers(&of("[]").stops), [""]);
    }

    #[test]
    fn each_part_needs_its_ends() {
        let of = |text: &str| dimensions(&parse(text.as_bytes()).unwrap());
        assert!(
            of(r#"{"dimensions": {"Body": {"xmin": 1, "xmax": 2}}}"#)
                .stops
                .all()
                .is_empty()
        );
        assert_eq!(
            pointers(&of(r#"{"dimensions": {"Body": {"xmax": 2}}}"#).stops),
            ["/dimensions/Body"]
        );
        assert_eq!(pointers(&of("{}").stops), [""]);
        assert_eq!(pointers(&of("[]").stops), [""]);
        let named = of(
            r#"{"dimensions": {}, "select_groups": {"A": ["a", "b"]}, "groups_by_range": {"a": [0, 1]}}"#,
        );
        assert_eq!(
            named
                .groups
                .iter()
                .map(|one| &*one.name)
                .collect::<Vec<_>>(),
            ["a", "b", "a"]
        );
        assert_eq!(
            named
                .without_range
                .iter()
                .map(|one| &*one.pointer)
                .collect::<Vec<_>>(),
            ["/select_groups/A/1"]
        );
    }

    #[test]
    fn fields_of_the_table_are_separated_by_one_blank() {
        let table = mirror(b"0 1 r\n1 0 l\n2 2 m\n\n3  3 m\n4 4\n5\t5 m\n# x\n");
        assert_eq!((table.rows.len(), table.unreadable), (3, Some((5, 4))));
        assert_eq!(table.vertices(), 3);
        assert_eq!(
            table.rows[0],
            MirrorRow {
                line: 1,
                from: 0,
                to: 1,
                side: b'r'
            }
        );
    }

    proptest! {
        #[test]
        fn no_bytes_stop_the_reader(bytes in prop::collection::vec(any::<u8>(), 0..200)) {
            mirror(&bytes);
        }
    }
}
