//! The JSON Schema of `mhlint.toml`, made from the table of keys and the rules.

use serde_json::{Map, Value, json};

use super::keys::{FILE, Key, Shape};
use mhlint_diag::{Edition, RuleInfo};

/// The schema: editors complete keys, rules and options with it.
pub fn schema(rules: &[&RuleInfo]) -> Value {
    let mut schema = object(FILE, rules);
    let head = [
        (
            "$schema",
            json!("https://json-schema.org/draft/2020-12/schema"),
        ),
        ("title", json!("mhlint.toml")),
        (
            "description",
            json!(
                "Configuration of mhlint. Globs and paths are relative to the folder of this file."
            ),
        ),
    ];
    let mut all = Map::new();
    all.extend(head.map(|(key, value)| (key.to_owned(), value)));
    all.append(schema.as_object_mut().unwrap_or(&mut Map::new()));
    let ids: Vec<&str> = rules.iter().map(|rule| rule.id).collect();
    all.insert(
        "$defs".to_owned(),
        json!({
            "level": { "enum": ["error", "warning", "info", "off"] },
            "rule": {
                "description": "A rule, or a glob of rules such as `macro-*`.",
                "anyOf": [{ "enum": ids }, { "type": "string", "pattern": "[*?\\[{]" }]
            }
        }),
    );
    Value::Object(all)
}

fn object(keys: &[Key], rules: &[&RuleInfo]) -> Value {
    let properties: Map<String, Value> = keys
        .iter()
        .map(|key| (key.name.to_owned(), property(key, rules)))
        .collect();
    let required: Vec<&str> = keys
        .iter()
        .filter(|key| key.required)
        .map(|key| key.name)
        .collect();
    let mut object =
        json!({ "type": "object", "properties": properties, "additionalProperties": false });
    if !required.is_empty()
        && let Some(members) = object.as_object_mut()
    {
        members.insert("required".to_owned(), json!(required));
    }
    object
}

fn property(key: &Key, rules: &[&RuleInfo]) -> Value {
    let mut property = shape(key.shape, rules);
    if let Some(members) = property.as_object_mut() {
        members.insert("description".to_owned(), json!(key.docs));
    }
    property
}

fn shape(shape: Shape, rules: &[&RuleInfo]) -> Value {
    let rule = json!({ "$ref": "#/$defs/rule" });
    match shape {
        Shape::FailOn => json!({ "enum": ["error", "warning", "info", "never"] }),
        Shape::Count => json!({ "type": "integer", "minimum": 0 }),
        Shape::CountTo(most) => json!({ "type": "integer", "minimum": 0, "maximum": most }),
        Shape::Flag => json!({ "type": "boolean" }),
        Shape::Text | Shape::Path | Shape::Glob => json!({ "type": "string" }),
        Shape::Paths => {
            json!({ "anyOf": [
                { "type": "string" },
                { "type": "array", "items": { "type": "string" } },
            ] })
        }
        Shape::Globs | Shape::Texts => json!({ "type": "array", "items": { "type": "string" } }),
        Shape::Rule => rule,
        Shape::Rules => json!({ "type": "array", "items": rule }),
        Shape::Applications => {
            json!({ "type": "array", "items": { "enum": Edition::all() } })
        }
        Shape::Date => json!({ "type": "string", "format": "date" }),
        Shape::Levels => json!({
            "type": "object",
            "propertyNames": rule,
            "additionalProperties": { "$ref": "#/$defs/level" }
        }),
        Shape::Options => options(rules),
        Shape::Table(keys) => object(keys, rules),
        Shape::Tables(keys) => json!({ "type": "array", "items": object(keys, rules) }),
    }
}

/// A table for each rule that has options.
fn options(rules: &[&RuleInfo]) -> Value {
    let with_options = rules.iter().filter(|rule| !rule.options.is_empty());
    let properties = with_options.map(|rule| {
        let options = rule.options.iter().map(|option| {
            let value = json!({
                "type": "number", "minimum": 0,
                "default": option.default, "description": option.docs,
            });
            (option.name.to_owned(), value)
        });
        let options: Map<String, Value> = options.collect();
        let table = json!({
            "type": "object", "description": rule.summary,
            "properties": options, "additionalProperties": false
        });
        (rule.id.to_owned(), table)
    });
    let properties: Map<String, Value> = properties.collect();
    json!({ "type": "object", "properties": properties, "additionalProperties": false })
}
