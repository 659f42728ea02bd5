//! Trees of shader nodes of MPFB, `node_trees/*.json`
//! (`docs/loaders/mpfb/materials.md#node-trees`).
//!
//! A text `$…` is replaced when the tree is built, so that nothing can be said of names with one,
//! nor of nodes and links that are made on a condition.

use std::collections::{BTreeMap, BTreeSet};

use super::unfit::{LoaderFaults, Why, below, nth};
use mhlint_json::{Document, Node, Value};

/// Keys that each node needs.
const OF_EACH: [&str; 3] = ["type", "name", "values"];
/// Keys that nodes of a type need besides.
const OF_TYPE: [(&str, &str); 2] = [
    ("ShaderNodeTexImage", "filename"),
    ("ShaderNodeValue", "value"),
];
/// Both ends of a link.
const ENDS: [&str; 4] = ["from_node", "from_socket", "to_node", "to_socket"];
/// Groups in groups that are followed.
const DEPTH: usize = 16;

/// Takes what the loader would take.
pub fn read(document: &Document) -> LoaderFaults {
    let root = &document.root;
    let mut faults = LoaderFaults::default();
    if !root.is_object() {
        faults.stops.add_type("", root, "an object");
        return faults;
    }
    let mut groups = BTreeSet::new();
    name_groups(root, DEPTH, &mut groups);
    tree(root, "", DEPTH, &groups, &mut faults);
    faults
}

/// The names of all groups: they are made before what uses them.
fn name_groups<'d>(tree: &'d Node, depth: usize, names: &mut BTreeSet<&'d str>) {
    for member in tree
        .get("groups")
        .map(Node::members)
        .unwrap_or_default()
        .iter()
        .take_while(|_| depth > 0)
    {
        names.insert(&member.key);
        name_groups(&member.node, depth - 1, names);
    }
}

fn tree(
    whole: &Node,
    pointer: &str,
    depth: usize,
    groups: &BTreeSet<&str>,
    faults: &mut LoaderFaults,
) {
    for key in ["nodes", "links"]
        .into_iter()
        .filter(|key| whole.get(key).is_none())
    {
        faults.stops.add(pointer, Why::Lacks(key));
    }
    let mut names: BTreeMap<&str, bool> = BTreeMap::new();
    let nodes = below(pointer, "nodes");
    for member in whole
        .get("nodes")
        .map(Node::effective_members)
        .unwrap_or_default()
    {
        node(&member.node, &below(&nodes, &member.key), groups, faults);
        let name = member.node.get("name").and_then(Node::as_str);
        let is_made = member
            .node
            .get("create")
            .is_none_or(|create| create.value == Value::Bool(true));
        names.extend(
            [Some(&*member.key), name]
                .into_iter()
                .flatten()
                .map(|name| (name, is_made)),
        );
    }
    links(whole, pointer, &names, faults);
    let of_groups = below(pointer, "groups");
    let inner = whole
        .get("groups")
        .map(Node::effective_members)
        .unwrap_or_default();
    for member in inner.into_iter().take_while(|_| depth > 0) {
        tree(
            &member.node,
            &below(&of_groups, &member.key),
            depth - 1,
            groups,
            faults,
        );
    }
}

fn node(node: &Node, pointer: &str, groups: &BTreeSet<&str>, faults: &mut LoaderFaults) {
    if !node.is_object() {
        return faults.stops.add_type(pointer, node, "an object");
    }
    let kind = node.get("type").and_then(Node::as_str).unwrap_or_default();
    let own = OF_TYPE
        .iter()
        .filter(|(of, _)| *of == kind)
        .map(|(_, key)| *key);
    for key in OF_EACH
        .into_iter()
        .chain(own)
        .filter(|key| node.get(key).is_none())
    {
        faults.stops.add(pointer, Why::Lacks(key));
    }
    let group = node
        .get("group_name")
        .and_then(Node::as_str)
        .filter(|_| kind == "ShaderNodeGroup");
    if let Some(group) = group.filter(|group| !group.contains('$') && !groups.contains(group)) {
        faults.stops.add(
            &below(pointer, "group_name"),
            Why::Unknown(group.to_owned()),
        );
    }
}

fn links(tree: &Node, pointer: &str, names: &BTreeMap<&str, bool>, faults: &mut LoaderFaults) {
    let pointer = below(pointer, "links");
    let (mut inputs, mut all) = (BTreeSet::new(), BTreeSet::new());
    for (at, link) in tree
        .get("links")
        .map(Node::elements)
        .unwrap_or_default()
        .iter()
        .enumerate()
    {
        let text = |key| {
            link.get(key)
                .and_then(Node::as_str)
                .filter(|text| !text.contains('$'))
        };
        let ends = [
            ("from_node", text("from_node")),
            ("to_node", text("to_node")),
        ];
        for (key, name) in ends.iter().filter_map(|(key, name)| Some((key, (*name)?))) {
            if !names.contains_key(name) {
                faults.ignored.add(
                    &below(&nth(&pointer, at), key),
                    Why::Unknown(name.to_owned()),
                );
            }
        }
        let is_made = link.get("disabled").is_none_or(Node::is_falsy);
        // The same link again is made where the first one is, whatever that depends on.
        let whole = ENDS.map(|key| link.get(key).and_then(Node::as_str));
        let condition = link.get("disabled").and_then(Node::as_str);
        let is_copy = (is_made || condition.is_some())
            && whole.iter().all(Option::is_some)
            && !all.insert((whole, condition));
        let is_always = is_made
            && ends
                .iter()
                .all(|(_, name)| name.is_some_and(|name| names.get(name) == Some(&true)));
        let input = text("to_node").zip(text("to_socket")).filter(|_| is_always);
        let is_second = input.is_some_and(|input| !inputs.insert(input));
        if let [.., Some(node), Some(socket)] = whole
            && (is_copy || is_second)
        {
            faults.stops.add(
                &nth(&pointer, at),
                Why::SecondLink(format!("`{socket}` of `{node}`")),
            );
        }
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::unfit::Unfits;
    use mhlint_json::parse;

    fn pointers(faults: &Unfits) -> Vec<&str> {
        faults.all().iter().map(|one| &*one.pointer).collect()
    }

    fn of(nodes: &str, links: &str, groups: &str) -> LoaderFaults {
        let text =
            format!(r#"{{"nodes": {{{nodes}}}, "links": [{links}], "groups": {{{groups}}}}}"#);
        read(&parse(text.as_bytes()).unwrap())
    }

    const A: &str = r#""a": {"type": "X", "name": "a", "values": {}}"#;
    const B: &str = r#""b": {"type": "X", "name": "b", "values": {}, "create": "$has_b"}"#;

    fn link(from: &str, more: &str) -> String {
        format!(
            r#"{{"from_node": "{from}", "from_socket": "s", "to_node": "a", "to_socket": "t"{more}}}"#
        )
    }

    #[test]
    fn links_on_a_condition_do_not_collide() {
        let nodes = format!("{A}, {B}");
        for second in [link("b", ""), link("a", r#", "disabled": "$x""#)] {
            assert_eq!(
                of(&nodes, &format!("{}, {second}", link("a", "")), ""),
                LoaderFaults::default(),
                "{second}"
            );
        }
        let conditional = link("a", r#", "disabled": "$x""#);
        let copied = of(&nodes, &format!("{conditional}, {conditional}"), "");
        assert_eq!(pointers(&copied.stops), ["/links/1"]);
        let twice = of(&nodes, &format!("{}, {}", link("a", ""), link("a", "")), "");
        assert_eq!(pointers(&twice.stops), ["/links/1"]);
        assert_eq!(
            pointers(&of(A, &link("c", ""), "").ignored),
            ["/links/0/from_node"]
        );
    }

    #[test]
    fn nodes_need_their_keys() {
        let image =
            r#""i": {"type": "ShaderNodeTexImage", "name": "i", "values": {}}, "n": {"name": "n"}"#;
        let found = of(image, "", r#""g": {"nodes": {"x": 5}, "links": []}"#);
        assert_eq!(
            pointers(&found.stops),
            ["/nodes/i", "/nodes/n", "/nodes/n", "/groups/g/nodes/x"]
        );
        let group = |name| {
            format!(
                r#""g": {{"type": "ShaderNodeGroup", "name": "g", "values": {{}}, "group_name": "{name}"}}"#
            )
        };
        let groups = r#""known": {"nodes": {}, "links": []}"#;
        assert_eq!(
            pointers(&of(&group("other"), "", groups).stops),
            ["/nodes/g/group_name"]
        );
        assert_eq!(of(&group("known"), "", groups), LoaderFaults::default());
        assert_eq!(of(&group("$known"), "", groups), LoaderFaults::default());
        assert_eq!(pointers(&read(&parse(b"{}").unwrap()).stops), ["", ""]);
    }

    proptest! {
        #[test]
        fn no_json_stops_the_reader(text in r#"[\[\]{},:"0-9a-c ]{0,40}"#) {
            let text = format!(r#"{{"nodes": {text}, "links": {text}, "groups": {{"a": {text}}}}}"#);
            if let Ok(document) = parse(text.as_bytes()) {
                read(&document);
            }
        }
    }
}
