//! `.mhpose`: a pose or an expression as values of pose units
//! (`docs/loaders/makehuman2/poses.md#mhpose`).

use super::macro_json::text;
use mhlint_json::{Document, Node};

/// The file.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Pose {
    /// Its name, if that is a text.
    pub name: Option<String>,
    /// Its tags, those that are texts.
    pub tags: Vec<String>,
    /// Whether `unit_poses` is there, of whatever type.
    pub has_units: bool,
    /// Whether it has a `license`, of whatever type.
    pub has_license: bool,
    /// What `unit_poses` sets, in file order.
    pub values: Vec<UnitValue>,
}

/// A unit that a pose sets.
#[derive(Debug, Clone, PartialEq)]
pub struct UnitValue {
    /// Its name.
    pub unit: String,
    /// How far it is turned; `None` for what is no number.
    pub value: Option<f64>,
    /// Whether it is an object: a bracket that stands elsewhere, and no unit at all.
    pub is_object: bool,
}

/// Takes what the loader would take.
pub fn read(document: &Document) -> Pose {
    let root = &document.root;
    let units = root.get("unit_poses");
    let members = units
        .map(Node::effective_members)
        .unwrap_or_default()
        .into_iter();
    let tags = root.get("tags").map(Node::elements).unwrap_or_default();
    Pose {
        name: text(root, "name"),
        tags: tags
            .iter()
            .filter_map(Node::as_str)
            .map(str::to_owned)
            .collect(),
        has_units: units.is_some(),
        has_license: root.get("license").is_some(),
        values: members
            .map(|one| UnitValue {
                unit: one.key.clone(),
                value: one.node.as_python_number(),
                is_object: one.node.is_object(),
            })
            .collect(),
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::float_cmp, reason = "tests choose numbers without rounding")]

    use proptest::prelude::*;

    use super::*;
    use mhlint_json::parse;

    fn of(text: &str) -> Pose {
        read(&parse(text.as_bytes()).unwrap())
    }

    #[test]
    fn values_are_numbers_and_truths() {
        let pose = of(
            r#"{"name": "bow", "tags": ["a", 1], "unit_poses": {"a": 0.5, "b": true, "c": "1", "a": -1}}"#,
        );
        let values: Vec<_> = pose
            .values
            .iter()
            .map(|one| (&*one.unit, one.value))
            .collect();
        assert_eq!(values, [("a", Some(-1.0)), ("b", Some(1.0)), ("c", None)]);
        assert_eq!(
            (pose.name.as_deref(), pose.tags.as_slice()),
            (Some("bow"), &["a".to_owned()][..])
        );
        let nested = of(r#"{"unit_poses": {"a": {}, "b": [1], "c": "1"}}"#).values;
        let is_object: Vec<bool> = nested.iter().map(|one| one.is_object).collect();
        assert_eq!(is_object, [true, false, false]);
        assert!(pose.has_units && of(r#"{"unit_poses": []}"#).has_units && !of("[1]").has_units);
    }

    proptest! {
        #[test]
        fn every_value_that_is_written_is_found_again(values in prop::collection::btree_map("[a-z]{1,6}", -2.0..2.0f64, 0..20)) {
            let text = serde_json::json!({ "name": "x", "unit_poses": values }).to_string();
            let found = of(&text).values;
            prop_assert_eq!(found.len(), values.len());
            for one in found {
                prop_assert!((one.value.unwrap() - values[&one.unit]).abs() < 1e-12);
            }
        }

        #[test]
        fn no_json_stops_the_reader(text in r#"[\[\]{},:"0-9a-c ]{0,40}"#) {
            let text = format!(r#"{{"unit_poses": {text}, "tags": {text}}}"#);
            if let Ok(document) = parse(text.as_bytes()) {
                read(&document);
            }
        }
    }
}
