//! `proxy_corrective.json` of MPFB: topologies whose weights it corrects, by uuid
//! (`docs/loaders/mpfb/base-mesh.md#metadata`).

use super::unfit::{NamedAt, Unfits, Why, below, keep};
use mhlint_json::{Document, Node, Value};

/// The only key that is looked for below a uuid.
pub const FLAG: &str = "fix_leftright_weights_for_groups";

/// The file.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct ProxyCorrections {
    /// What stops the loader: it asks whether a key is in a value that can have none.
    pub stops: Unfits,
    /// What it passes over, so that nothing is corrected.
    pub ignored: Unfits,
    /// Flags with another value than `true`, each with that in words: that there is a flag counts.
    pub unread: Vec<NamedAt>,
    /// The uuids of which something is said.
    pub uuids: Vec<NamedAt>,
}

/// Takes what the loader would take.
pub fn read(document: &Document) -> ProxyCorrections {
    let root = &document.root;
    let mut found = ProxyCorrections::default();
    match &root.value {
        Value::Object(_) => {}
        // One looks in vain for a key in them.
        Value::Array(_) | Value::String(_) => found.ignored.add_type("", root, "an object"),
        Value::Null | Value::Bool(_) | Value::Number(..) => {
            found.stops.add_type("", root, "an object");
        }
    }
    for member in root.effective_members() {
        let pointer = below("", &member.key);
        keep(&mut found.uuids, &pointer, &member.key);
        found.take(&pointer, &member.node);
    }
    found
}

impl ProxyCorrections {
    /// What is said of one topology.
    fn take(&mut self, pointer: &str, node: &Node) {
        match &node.value {
            Value::Object(_) => self.take_keys(pointer, node),
            // In a text or a list the flag is looked for as well.
            Value::String(text) if text.contains(FLAG) => {}
            Value::Array(names) if names.iter().any(|name| name.as_str() == Some(FLAG)) => {}
            Value::String(_) | Value::Array(_) => self.ignored.add_type(pointer, node, "an object"),
            Value::Null | Value::Bool(_) | Value::Number(..) => {
                self.stops.add_type(pointer, node, "an object");
            }
        }
    }

    fn take_keys(&mut self, pointer: &str, node: &Node) {
        for member in node.effective_members() {
            let at = below(pointer, &member.key);
            if member.key != FLAG {
                self.ignored.add(&at, Why::Key(&[FLAG]));
                continue;
            }
            match member.node.value {
                Value::Bool(true) => {}
                Value::Bool(false) => keep(&mut self.unread, &at, "`false`"),
                _ => keep(&mut self.unread, &at, member.node.type_word()),
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use mhlint_json::parse;

    fn of(text: &str) -> ProxyCorrections {
        read(&parse(text.as_bytes()).unwrap())
    }

    /// How much there is of each sort: what stops, what is ignored, what is not read.
    fn counts(text: &str) -> [usize; 3] {
        let found = of(text);
        [
            found.stops.all().len(),
            found.ignored.all().len(),
            found.unread.len(),
        ]
    }

    #[test]
    fn that_there_is_a_flag_counts() {
        assert_eq!(
            counts(r#"{"a": {"fix_leftright_weights_for_groups": true}, "b": {}}"#),
            [0, 0, 0]
        );
        assert_eq!(
            counts(r#"{"a": "fix_leftright_weights_for_groups"}"#),
            [0, 0, 0]
        );
        assert_eq!(
            counts(r#"{"a": ["fix_leftright_weights_for_groups"]}"#),
            [0, 0, 0]
        );
        assert_eq!(
            counts(r#"{"a": {"fix_leftright_weights_for_groups": ["hand.l"]}}"#),
            [0, 0, 1]
        );
        assert_eq!(
            counts(r#"{"a": {"fix_leftright_weights_for_groups": false}}"#),
            [0, 0, 1]
        );
        assert_eq!(
            counts(r#"{"a": {"fix_leftright_weight": true}}"#),
            [0, 1, 0]
        );
    }

    #[test]
    fn a_value_without_keys_stops_the_loader() {
        assert_eq!(counts(r#"{"a": true, "b": null, "c": 1}"#), [3, 0, 0]);
        assert_eq!(counts(r#"{"a": "x", "b": []}"#), [0, 2, 0]);
        assert_eq!(
            [counts("null"), counts("3"), counts("[]"), counts("\"a\"")],
            [[1, 0, 0], [1, 0, 0], [0, 1, 0], [0, 1, 0]]
        );
        assert_eq!(of(r#"{"a": {}, "b": {}}"#).uuids.len(), 2);
    }
}
