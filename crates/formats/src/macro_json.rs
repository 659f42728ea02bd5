//! `macro.json`: components, macro definitions, and the table from combination names to target
//! files.
//!
//! The loader checks nothing (`docs/loaders/makehuman2/macros.md#structure`); members of a wrong
//! type are left out here and reported by the schema.

use std::collections::{BTreeSet, HashMap};
use std::sync::Arc;

use mhlint_json::{Document, Node, Value};

/// The file.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct MacroFile {
    /// Components in file order.
    pub components: Vec<Component>,
    /// Macro definitions in file order.
    pub macrodefs: Vec<Macrodef>,
    /// Names of the components that some definition uses.
    pub used: BTreeSet<String>,
    /// Whether these are more macros than can be compared with one another: they are then not
    /// checked, and that is said.
    pub is_too_large: bool,
}

/// Most names that are compared with each component and each definition: every rule on macros does
/// so. The macros of a whole character come to a thirtieth of it.
const MOST_COMPARED: usize = 1 << 18;
/// Most combinations of all definitions together, those with a component left out included. A
/// definition that has more alone is not walked. The macros of a whole character come to a
/// hundredth.
const MOST_COMBINATIONS: usize = 1 << 20;
/// Most values of all definitions, times the places in all names at which one of them may stand:
/// that many are tried where names are spelled with the components. The macros of a whole character
/// come to a tenth.
const MOST_SPELLED: usize = 1 << 22;

impl MacroFile {
    fn new(components: Vec<Component>, macrodefs: Vec<Macrodef>) -> Self {
        let names: usize = macrodefs
            .iter()
            .map(|macrodef| macrodef.components.len() + macrodef.links.len())
            .sum();
        // A definition without names is looked at all the same.
        let names = names.max(macrodefs.len());
        let compared = names.saturating_mul(components.len() + macrodefs.len());
        let is_too_large = compared > MOST_COMPARED
            || combinations(&components, &macrodefs) > MOST_COMBINATIONS
            || spelled(&components, &macrodefs) > MOST_SPELLED;
        let names = macrodefs.iter().flat_map(|macrodef| &macrodef.components);
        Self {
            used: names.cloned().collect(),
            components,
            macrodefs,
            is_too_large,
        }
    }
}

fn spelled(components: &[Component], macrodefs: &[Macrodef]) -> usize {
    let values: HashMap<&str, usize> = components
        .iter()
        .map(|own| (own.name.as_str(), own.values.len()))
        .collect();
    let names = macrodefs.iter().flat_map(|macrodef| &macrodef.components);
    let values: usize = names.filter_map(|name| values.get(name.as_str())).sum();
    let links = macrodefs.iter().flat_map(|macrodef| &macrodef.links);
    let places: usize = links
        .map(|link| link.name.bytes().filter(|byte| *byte == b'-').count() + 1)
        .sum();
    values.saturating_mul(places)
}

fn combinations(components: &[Component], macrodefs: &[Macrodef]) -> usize {
    let values: HashMap<&str, usize> = components
        .iter()
        .map(|own| (own.name.as_str(), own.values.len()))
        .collect();
    let value_count = |name: &String| values.get(name.as_str()).copied().unwrap_or(0);
    let of_one = macrodefs.iter().map(|macrodef| {
        macrodef.components.iter().fold(1, |all: usize, name| {
            all.saturating_mul(value_count(name) + 1)
        })
    });
    of_one
        .filter(|all| *all <= MOST_COMBINATIONS)
        .fold(0, usize::saturating_add)
}

/// A component: a dimension of the cross product.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Component {
    /// Its key.
    pub name: String,
    /// Pattern of the slider that drives it; the beginning of three patterns with `sum`.
    pub pattern: Option<String>,
    /// Names of its values.
    pub values: Vec<String>,
    /// Slider positions of the values. Presence alone decides for the stepped branch.
    pub steps: Option<Vec<f64>>,
    /// Ends of the patterns of a barycentric set.
    pub sum: Option<Vec<String>>,
}

/// A macro definition.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Macrodef {
    /// Position in the file; `macro_influence` counts by it.
    pub index: usize,
    /// Display name; no application reads it.
    pub name: Option<String>,
    /// Names of the components in order.
    pub components: Vec<String>,
    /// Folder as written.
    pub folder: Option<String>,
    /// Folder that is used: of the previous definition if there is none.
    pub effective_folder: Option<Arc<str>>,
    /// Entries with `name` and `t`; others are skipped by the loader.
    pub links: Vec<Link>,
    /// Positions of entries without `name` or without `t`.
    pub incomplete: Vec<usize>,
    /// Names of entries that give no usable `t`: meant to be listed, reported by the schema.
    pub unusable: Vec<String>,
    /// Whether one of the links leads to a file.
    pub has_target: bool,
    /// `t` of entries without a usable `name`: meant to be listed as well.
    pub nameless: Vec<String>,
}

/// An entry of `targets`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Link {
    /// Position in `targets`.
    pub index: usize,
    /// Name of the combination.
    pub name: String,
    /// File below the folder without suffix, `None` for a deliberate "no morph".
    pub target: Option<String>,
}

impl Macrodef {
    /// Pointer to a link's member.
    pub fn link_pointer(&self, link: &Link, member: &str) -> String {
        format!("{}/{member}", self.entry_pointer(link))
    }

    /// Pointer to a link.
    pub fn entry_pointer(&self, link: &Link) -> String {
        format!("/macrodef/{}/targets/{}", self.index, link.index)
    }
}

/// Takes what the loader would take.
pub fn read(document: &Document) -> MacroFile {
    let root = &document.root;
    MacroFile::new(
        root.get("components").map(components).unwrap_or_default(),
        root.get("macrodef").map(macrodefs).unwrap_or_default(),
    )
}

fn components(node: &Node) -> Vec<Component> {
    let members = node.effective_members().into_iter();
    members
        .map(|member| Component {
            name: member.key.clone(),
            pattern: text(&member.node, "pattern"),
            values: member
                .node
                .get("values")
                .and_then(texts)
                .unwrap_or_default(),
            steps: member.node.get("steps").map(numbers),
            sum: member.node.get("sum").and_then(texts),
        })
        .collect()
}

fn macrodefs(node: &Node) -> Vec<Macrodef> {
    let mut folder: Option<Arc<str>> = None;
    let mut all = Vec::new();
    for (index, node) in node.elements().iter().enumerate() {
        let own = text(node, "folder");
        folder = own.as_deref().map(Arc::from).or(folder);
        let mut macrodef = Macrodef {
            index,
            name: text(node, "name"),
            components: node.get("comp").and_then(texts).unwrap_or_default(),
            folder: own,
            effective_folder: folder.clone(),
            ..Macrodef::default()
        };
        read_links(node, &mut macrodef);
        all.push(macrodef);
    }
    all
}

fn read_links(node: &Node, macrodef: &mut Macrodef) {
    let entries = node.get("targets").map(Node::elements).unwrap_or_default();
    for (index, entry) in entries.iter().enumerate() {
        if let (
            Some(name),
            None | Some(Value::Bool(_) | Value::Number(..) | Value::Array(_) | Value::Object(_)),
        ) = (text(entry, "name"), entry.get("t").map(|t| &t.value))
        {
            macrodef.unusable.push(name);
        }
        match (text(entry, "name"), entry.get("t").map(|t| &t.value)) {
            (None, Some(Value::String(target))) => {
                macrodef.nameless.push(target.clone());
                macrodef.incomplete.push(index);
            }
            (Some(name), Some(Value::Null)) => macrodef.links.push(Link {
                index,
                name,
                target: None,
            }),
            (Some(name), Some(Value::String(target))) => {
                macrodef.has_target = true;
                macrodef.links.push(Link {
                    index,
                    name,
                    target: Some(target.clone()),
                });
            }
            (None, _) | (_, None) => macrodef.incomplete.push(index),
            // `t` of another type stops the program; the schema says so.
            (Some(_), Some(_)) => {}
        }
    }
}

/// Text member of an object.
pub(super) fn text(node: &Node, key: &str) -> Option<String> {
    node.get(key).and_then(Node::as_str).map(str::to_owned)
}

/// An array of texts; elements of other types are left out.
pub(super) fn texts(node: &Node) -> Option<Vec<String>> {
    let elements = node.is_array().then(|| node.elements())?;
    Some(
        elements
            .iter()
            .filter_map(Node::as_str)
            .map(str::to_owned)
            .collect(),
    )
}

/// An array of numbers; elements of other types are left out.
pub(super) fn numbers(node: &Node) -> Vec<f64> {
    node.elements().iter().filter_map(Node::as_f64).collect()
}

/// A `t` without the suffix that the loader adds itself, or never reads.
pub fn without_suffix(name: &str) -> &str {
    name.trim_end_matches(".gz").trim_end_matches(".target")
}

#[cfg(test)]
mod tests {
    use super::*;
    use mhlint_json::parse;

    #[test]
    fn a_missing_folder_is_inherited() {
        let text = br#"{"components": {}, "macrodef": [
            {"folder": "a", "comp": ["x"], "targets": [{"name": "n", "t": null}, {"name": "m"}]},
            {"comp": [], "targets": [{"name": "n", "t": "f"}]}]}"#;
        let file = read(&parse(text).unwrap());
        let [first, second] = file.macrodefs.as_slice() else {
            panic!("two")
        };
        assert_eq!(
            (
                first.incomplete.as_slice(),
                first.links[0].target.as_deref()
            ),
            ([1].as_slice(), None)
        );
        assert_eq!(
            (second.folder.as_deref(), second.effective_folder.as_deref()),
            (None, Some("a"))
        );
        assert_eq!(
            second.link_pointer(&second.links[0], "t"),
            "/macrodef/1/targets/0/t"
        );
    }

    #[test]
    fn too_many_macros_to_compare_or_to_walk_are_too_large() {
        let names = |count: usize| vec!["c".to_owned(); count];
        let component = Component {
            name: "c".to_owned(),
            values: names(3),
            ..Component::default()
        };
        let is_too_large = |macrodefs: usize, names: Vec<String>| {
            let macrodef = Macrodef {
                components: names,
                ..Macrodef::default()
            };
            MacroFile::new(vec![component.clone()], vec![macrodef; macrodefs]).is_too_large
        };
        // Names compared with definitions; then combinations: 4^10 once and twice, and 4^11, which
        // are never walked.
        assert!(!is_too_large(511, names(1)) && is_too_large(512, names(1)));
        // Two components of 16 values, and a name of as many places as may be tried, or one more.
        let spelled = |places: usize| {
            let components = ["a", "b"].map(|name| Component {
                name: name.to_owned(),
                values: names(16),
                ..Component::default()
            });
            let link = Link {
                index: 0,
                name: "-".repeat(places - 1),
                target: None,
            };
            let names = vec!["a".to_owned(), "b".to_owned()];
            let macrodef = Macrodef {
                components: names,
                links: vec![link],
                ..Macrodef::default()
            };
            MacroFile::new(components.to_vec(), vec![macrodef]).is_too_large
        };
        assert!(!spelled(MOST_SPELLED / 32) && spelled(MOST_SPELLED / 32 + 1));
        assert!(
            !is_too_large(1, names(10))
                && is_too_large(2, names(10))
                && !is_too_large(9, names(11))
        );
    }

    #[test]
    fn wrong_types_are_left_out() {
        let file = read(&parse(br#"{"components": [1], "macrodef": {"a": 1}}"#).unwrap());
        assert_eq!(file, MacroFile::default());
    }
}
