//! Keys that no application reads: a walk over document and schema side by side.
//!
//! An object is checked if its schema lists `properties` and leaves no room for others. A value
//! whose schema is a choice is left alone, as is everything below it.

use std::borrow::Cow;
use std::collections::HashMap;

use serde_json::{Map, Value};

use super::room::Room;
use super::{Node, UnknownKey};
use mhlint_diag::{add_step, nearest};

/// A key that people write because the other formats of the family have it, and what is meant.
const TRAPS: [(&str, [&str; 2]); 1] = [("sym", ["lsym", "rsym"])];

/// The unknown keys below `node`, in order of the text, and how many more there are.
pub(super) fn find(node: &Node, schema: &Value) -> (Vec<UnknownKey>, usize) {
    let mut walk = Walk {
        schema,
        pointer: String::new(),
        found: Vec::new(),
        room: Room::default(),
    };
    walk.value(node, schema);
    mark_alone(&mut walk.found);
    (walk.found, walk.room.left_out)
}

/// Counts the unknown keys of each object once, for whoever asks whether one is alone.
fn mark_alone(found: &mut [UnknownKey]) {
    let mut counts: HashMap<&str, usize> = HashMap::new();
    for key in found.iter() {
        *counts.entry(owner(key)).or_default() += 1;
    }
    let alone: Vec<bool> = found
        .iter()
        .map(|key| counts.get(owner(key)) == Some(&1))
        .collect();
    found
        .iter_mut()
        .zip(alone)
        .for_each(|(key, is_alone)| key.is_alone = is_alone);
}

/// Pointer to the object that a key is in.
fn owner(key: &UnknownKey) -> &str {
    key.pointer.rsplit_once('/').map_or("", |(owner, _)| owner)
}

struct Walk<'s> {
    schema: &'s Value,
    pointer: String,
    found: Vec<UnknownKey>,
    room: Room,
}

impl<'s> Walk<'s> {
    fn value(&mut self, node: &Node, schema: &'s Value) {
        let schema = self.resolved(schema);
        for member in node.effective_members() {
            self.below(&member.key, |walk| {
                match member_schema(&schema, &member.key) {
                    Some(below) => walk.value(&member.node, below),
                    None => walk.note(
                        &schema,
                        &member.key,
                        !member.node.effective_members().is_empty(),
                    ),
                }
            });
        }
        for (index, element) in node.elements().iter().enumerate() {
            let Some(below) = element_schema(&schema, index) else {
                continue;
            };
            self.below(&index.to_string(), |walk| walk.value(element, below));
        }
    }

    fn below(&mut self, step: &str, visit: impl FnOnce(&mut Self)) {
        let length = self.pointer.len();
        add_step(&mut self.pointer, step);
        visit(self);
        self.pointer.truncate(length);
    }

    /// The keywords that apply at a place: those behind a local `$ref`, with its siblings on top.
    fn resolved(&self, schema: &'s Value) -> Keywords<'s> {
        let mut all = Keywords::default();
        let mut next = schema.as_object();
        // Our schemas refer one level deep; the bound only guards against a circle.
        for _ in 0..8 {
            let Some(object) = next else { break };
            all.add(object);
            let target = object
                .get("$ref")
                .and_then(Value::as_str)
                .and_then(|text| text.strip_prefix('#'));
            next = target
                .and_then(|pointer| self.schema.pointer(pointer))
                .and_then(Value::as_object);
        }
        all
    }

    fn note(&mut self, schema: &Keywords<'s>, key: &str, is_object: bool) {
        if !self.room.takes_one() {
            return;
        }
        self.room.take(&self.pointer);
        let known = schema
            .properties
            .iter()
            .flat_map(|properties| properties.keys())
            .map(String::as_str);
        let known: Vec<&str> = known.collect();
        self.found.push(UnknownKey {
            pointer: self.pointer.clone(),
            name: String::new(),
            key: key.to_owned(),
            object: schema
                .title
                .filter(|_| self.pointer.matches('/').count() > 1)
                .map(str::to_owned),
            nearest: meant(key, &known).map(Cow::into_owned),
            is_object,
            is_alone: false,
        });
    }
}

/// What a misspelt key should have been; both where a trap leaves the choice.
fn meant<'k>(key: &str, known: &[&'k str]) -> Option<Cow<'k, str>> {
    // People switch a key off, or mark a note, with a `_` before it.
    if key.starts_with('_') {
        return None;
    }
    let trap = TRAPS
        .iter()
        .find(|(trap, meant)| *trap == key && meant.iter().all(|name| known.contains(name)));
    match trap {
        Some((_, [left, right])) => Some(Cow::Owned(format!("{left}` or `{right}"))),
        None => nearest(key, known.iter().copied()).map(Cow::Borrowed),
    }
}

/// The schema of a member; one that fits anything where the object leaves room, none for an unknown
/// key.
fn member_schema<'s>(schema: &Keywords<'s>, key: &str) -> Option<&'s Value> {
    let named = schema
        .properties
        .iter()
        .find_map(|properties| properties.get(key));
    named
        .or(schema.others)
        .or((schema.properties.is_empty() || schema.has_patterns).then_some(&Value::Null))
}

fn element_schema<'s>(schema: &Keywords<'s>, index: usize) -> Option<&'s Value> {
    let prefix = schema.prefix.and_then(|prefix| prefix.get(index));
    prefix.or(schema.items)
}

/// The keywords of a schema object that say what lies below.
#[derive(Default)]
struct Keywords<'s> {
    properties: Vec<&'s Map<String, Value>>,
    others: Option<&'s Value>,
    has_patterns: bool,
    items: Option<&'s Value>,
    prefix: Option<&'s Vec<Value>>,
    title: Option<&'s str>,
}

impl<'s> Keywords<'s> {
    fn add(&mut self, object: &'s Map<String, Value>) {
        self.properties
            .extend(object.get("properties").and_then(Value::as_object));
        self.others = self.others.or(object.get("additionalProperties"));
        self.has_patterns |= object.contains_key("patternProperties");
        self.items = self.items.or(object.get("items"));
        self.prefix = self
            .prefix
            .or(object.get("prefixItems").and_then(Value::as_array));
        self.title = self.title.or(object.get("title").and_then(Value::as_str));
    }
}

#[cfg(test)]
mod tests {
    use crate::{check, parse};

    fn unknown(name: &str, text: &str) -> Vec<(String, Option<String>)> {
        let found = check(name, &parse(text.as_bytes()).unwrap());
        found
            .unknown
            .into_iter()
            .map(|key| (key.pointer, key.nearest))
            .collect()
    }

    #[test]
    fn keys_are_looked_up_along_references_and_lists() {
        let text = r#"{"macrodef": [{"comps": [], "targets": [{"name": "a", "t": null, "zz": {"q": 1}}]}], "components": {"x/y": {"value": []}}}"#;
        assert_eq!(
            unknown("macro", text),
            [
                ("/macrodef/0/comps".to_owned(), Some("comp".to_owned())),
                ("/macrodef/0/targets/0/zz".to_owned(), None),
                (
                    "/components/x~1y/value".to_owned(),
                    Some("values".to_owned())
                ),
            ]
        );
    }

    #[test]
    fn the_symmetry_key_of_other_formats_is_recognised() {
        assert_eq!(
            unknown(
                "modelling",
                r#"{"A": {"sym": "x", "display": {"slots": 1}}}"#
            ),
            [
                ("/A/sym".to_owned(), Some("lsym` or `rsym".to_owned())),
                ("/A/display/slots".to_owned(), Some("slot".to_owned())),
            ]
        );
    }

    #[test]
    fn a_key_is_alone_in_its_own_object() {
        let text = r#"{"A": {"qqq": 1}, "B": {"qqq": 1, "www": 2}, "C": {"display": {"qqq": 1}, "www": 2}}"#;
        let found = check("modelling", &parse(text.as_bytes()).unwrap()).unknown;
        let alone: Vec<&str> = found
            .iter()
            .filter(|key| key.is_alone)
            .map(|key| key.pointer.as_str())
            .collect();
        assert_eq!(alone, ["/A/qqq", "/C/display/qqq", "/C/www"]);
    }

    #[test]
    fn names_of_things_are_no_keys() {
        assert_eq!(
            unknown(
                "mhw",
                r#"{"weights": {"any bone": [[0, 1]]}, "comment": {"a": 1}}"#
            ),
            []
        );
        assert_eq!(
            unknown(
                "base",
                r#"{"target-opposites": {"a": "b"}, "name": {"free": 1}}"#
            ),
            []
        );
    }
}
