//! Embedded JSON Schemas: what they hold, and what they say on a document.
//!
//! Validators are built once, on first use. How a fault is worded is in [`super::schema_fault`], which
//! keys nobody reads in [`super::unknown_key`].

use std::sync::OnceLock;

use serde::Serialize;
use serde_json::Value as Plain;

use super::finder::Sorted;
use super::naming::named;
use super::{Document, Node, Value, schema_fault, unknown_key};

/// What a schema has to say on a document.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize)]
pub struct SchemaFaults {
    /// Values of a wrong shape.
    pub faults: Vec<SchemaFault>,
    /// Keys nobody reads.
    pub unknown: Vec<UnknownKey>,
}

/// A value that does not fit.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct SchemaFault {
    /// Pointer to the value.
    pub pointer: String,
    /// The same with names for positions in lists.
    #[serde(skip)]
    pub name: String,
    /// Place in the schema that it fails at: equal for equal faults of different values.
    pub keyword: String,
    /// What was found and what is allowed.
    pub message: String,
    /// What the schema says about the value.
    pub description: Option<String>,
}

/// A key that no application reads.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct UnknownKey {
    /// Pointer to the member.
    pub pointer: String,
    /// The same with names for positions in lists.
    #[serde(skip)]
    pub name: String,
    /// The key.
    pub key: String,
    /// What the object is called in the schema: `Slider`, `Bone`; nothing for the file as a whole.
    pub object: Option<String>,
    /// The known key most like it.
    pub nearest: Option<String>,
}

/// A schema of ours.
struct Schema {
    name: &'static str,
    text: &'static str,
    compiled: OnceLock<Compiled>,
}

struct Compiled {
    tree: Plain,
    validator: jsonschema::Validator,
}

impl Schema {
    const fn new(name: &'static str, text: &'static str) -> Self {
        Self { name, text, compiled: OnceLock::new() }
    }

    fn compiled(&self) -> &Compiled {
        self.compiled.get_or_init(|| {
            let tree = serde_json::from_str(self.text).expect("invariant: embedded schemas are JSON");
            let validator = jsonschema::validator_for(&tree).expect("invariant: embedded schemas are valid");
            Compiled { tree, validator }
        })
    }
}

static SCHEMAS: [Schema; 9] = [
    Schema::new("base", include_str!("../../schemas/base.schema.json")),
    Schema::new("config", include_str!("../../schemas/config.schema.json")),
    Schema::new("geometry", include_str!("../../schemas/geometry.schema.json")),
    Schema::new("macro", include_str!("../../schemas/macro.schema.json")),
    Schema::new("mhskel", include_str!("../../schemas/mhskel.schema.json")),
    Schema::new("mhw", include_str!("../../schemas/mhw.schema.json")),
    Schema::new("modelling", include_str!("../../schemas/modelling.schema.json")),
    Schema::new("report", include_str!("../../schemas/report.schema.json")),
    Schema::new("target_cat", include_str!("../../schemas/target_cat.schema.json")),
];

/// Names of the embedded schemas, sorted.
pub fn schema_names() -> impl Iterator<Item = &'static str> {
    SCHEMAS.iter().map(|schema| schema.name)
}

/// Text of an embedded schema.
pub fn schema_text(name: &str) -> Option<&'static str> {
    find(name).map(|schema| schema.text)
}

/// Checks a document against the embedded schema `name` (`macro`, `mhskel` …). An unknown name fits anything.
pub fn check(name: &str, document: &Document) -> SchemaFaults {
    let Some(schema) = find(name).map(Schema::compiled) else { return SchemaFaults::default() };
    let plain = plain(&document.root);
    let errors = schema.validator.iter_errors(&plain);
    let faults = errors.map(|error| schema_fault::describe(&error, &schema.tree)).collect();
    let mut found = SchemaFaults {
        faults: empty_objects_once(&plain, faults),
        unknown: unknown_key::find(&document.root, &schema.tree),
    };
    let sorted = &mut Sorted::default();
    found.faults.iter_mut().for_each(|fault| fault.name = named(document, sorted, &fault.pointer));
    found.unknown.iter_mut().for_each(|unknown| unknown.name = named(document, sorted, &unknown.pointer));
    found
}

/// An object without any member lacks all its keys for one reason: the first of them stands for all.
fn empty_objects_once(root: &Plain, faults: Vec<SchemaFault>) -> Vec<SchemaFault> {
    let is_empty = |fault: &SchemaFault| {
        fault.keyword.ends_with("/required")
            && root.pointer(&fault.pointer).and_then(Plain::as_object).is_some_and(serde_json::Map::is_empty)
    };
    let mut once: Vec<SchemaFault> = Vec::with_capacity(faults.len());
    for fault in faults {
        match once.last_mut() {
            Some(first) if first.pointer == fault.pointer && is_empty(&fault) && is_empty(first) => {
                if !first.message.ends_with(NOR_ELSE) {
                    first.message.push_str(NOR_ELSE);
                }
            }
            _ => once.push(fault),
        }
    }
    once
}

/// Said of an object that lacks several keys and has none.
const NOR_ELSE: &str = ", nor anything else";

fn find(name: &str) -> Option<&'static Schema> {
    SCHEMAS.iter().find(|schema| schema.name == name)
}

/// The tree as the validator takes it: of equal keys the last, `NaN` and infinities as a large number.
fn plain(node: &Node) -> Plain {
    match &node.value {
        Value::Null => Plain::Null,
        Value::Bool(value) => Plain::Bool(*value),
        Value::Number(number, _) => node.as_i64().map_or_else(|| real(*number), Plain::from),
        Value::String(text) => Plain::String(text.clone()),
        Value::Array(elements) => Plain::Array(elements.iter().map(plain).collect()),
        Value::Object(members) => {
            Plain::Object(members.iter().map(|member| (member.key.clone(), plain(&member.node))).collect())
        }
    }
}

fn real(number: f64) -> Plain {
    Plain::from(if number.is_finite() { number } else { f64::MAX })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::json::parse;

    fn faults(name: &str, text: &str) -> Vec<(String, String)> {
        let found = check(name, &parse(text.as_bytes()).unwrap());
        found.faults.into_iter().map(|fault| (fault.pointer, fault.message)).collect()
    }

    fn fault(name: &str, text: &str) -> (String, String) {
        let all = faults(name, text);
        assert_eq!(all.len(), 1, "{all:?}");
        all.into_iter().next().unwrap()
    }

    #[test]
    fn every_schema_compiles() {
        assert!(schema_names().is_sorted());
        for schema in &SCHEMAS {
            schema.compiled();
        }
        assert_eq!(schema_text("nothing"), None);
    }

    #[test]
    fn a_wrong_type_says_what_is_there_and_what_is_wanted() {
        assert_eq!(
            fault("modelling", r#"{"Age": {"default": "half"}}"#),
            ("/Age/default".to_owned(), "`default` of `Age` is the text `half`; a number is wanted".to_owned())
        );
        assert_eq!(
            fault("modelling", r#"{"Age": {"measure": [1, 2.5]}}"#).1,
            "`measure[1]` of `Age` is the number 2.5; a whole number is wanted"
        );
        assert_eq!(fault("macro", "[1]").1, "the file is a list; an object is wanted");
        assert_eq!(
            fault("modelling", r#"{"Age": {"rsym": 1}}"#).1,
            "`rsym` of `Age` is the number 1; a text or null is wanted"
        );
    }

    #[test]
    fn a_missing_key_is_named() {
        let text = r#"{"components": {}, "macrodef": [{"comp": [], "targets": [{"name": "a"}]}]}"#;
        assert_eq!(
            fault("macro", text),
            ("/macrodef/0/targets/0".to_owned(), "`targets[0]` of `macrodef[0]` has no `t`".to_owned())
        );
        assert_eq!(fault("macro", r#"{"macrodef": [{"comp": []}]}"#).1, "the file has no `components`");
    }

    #[test]
    fn of_branches_the_closest_speaks() {
        let (pointer, message) = fault("base", r#"{"modifier-presets": {"a/b": "much"}}"#);
        assert_eq!(pointer, "/modifier-presets/a~1b");
        assert_eq!(
            message,
            "`a/b` of `modifier-presets` is the text `much`; number as text is wanted (1 other form is allowed)"
        );
        let (_, message) = fault("base", r#"{"modifier-presets": {"a": []}}"#);
        assert_eq!(message, "`a` of `modifier-presets` is an empty list; a number or a text is wanted");
    }

    #[test]
    fn equal_keys_and_python_numbers_are_taken_as_python_does() {
        assert_eq!(faults("modelling", r#"{"A": {"default": "x", "default": 1}}"#), []);
        assert_eq!(faults("modelling", r#"{"A": {"default": NaN}, "B": {"default": -Infinity}}"#), []);
    }

    #[test]
    fn the_place_in_the_schema_is_the_same_for_equal_faults() {
        let document = parse(br#"{"A": {"default": "x"}, "B": {"default": []}}"#).unwrap();
        let found = check("modelling", &document).faults;
        assert_eq!(found[0].keyword, found[1].keyword);
        assert!(found[0].description.as_ref().unwrap().starts_with("Slider value after a reset"));
    }
}
