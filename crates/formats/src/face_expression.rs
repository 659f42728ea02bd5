//! Expressions of MPFB: face units with their strengths
//! (`docs/loaders/mpfb/expressions.md#keys-of-expressions`).

use super::number::python_float;
use super::unfit::{Unfits, Why, below};
use mhlint_json::{Document, Node, Value};

/// The file.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct FaceExpression {
    /// Keys of a file without units.
    pub unread: Unfits,
    /// What no list of expressions survives.
    pub empties: Unfits,
    /// What makes the loader pass over this file.
    pub refused: Unfits,
    /// Units of which the value is no number.
    pub no_numbers: Unfits,
    /// Units with a strength outside 0 to 1.
    pub out_of_range: Unfits,
    /// Whether the tags are a text, of which each letter becomes a tag.
    pub has_letters_for_tags: bool,
    /// All units by name, with the pointers to them.
    pub units: Vec<(String, String)>,
}

/// The units of faces that expressions may move: those of `ARKit`.
#[rustfmt::skip]
pub const UNITS: [&str; 52] = [
    "browDownLeft", "browDownRight", "browInnerUp", "browOuterUpLeft", "browOuterUpRight",
    "cheekPuff", "cheekSquintLeft", "cheekSquintRight", "eyeBlinkLeft", "eyeBlinkRight",
    "eyeLookDownLeft", "eyeLookDownRight", "eyeLookInLeft", "eyeLookInRight", "eyeLookOutLeft",
    "eyeLookOutRight", "eyeLookUpLeft", "eyeLookUpRight", "eyeSquintLeft", "eyeSquintRight",
    "eyeWideLeft", "eyeWideRight", "jawForward", "jawLeft", "jawOpen", "jawRight", "mouthClose",
    "mouthDimpleLeft", "mouthDimpleRight", "mouthFrownLeft", "mouthFrownRight", "mouthFunnel",
    "mouthLeft", "mouthLowerDownLeft", "mouthLowerDownRight", "mouthPressLeft", "mouthPressRight",
    "mouthPucker", "mouthRight", "mouthRollLower", "mouthRollUpper", "mouthShrugLower",
    "mouthShrugUpper", "mouthSmileLeft", "mouthSmileRight", "mouthStretchLeft", "mouthStretchRight",
    "mouthUpperUpLeft", "mouthUpperUpRight", "noseSneerLeft", "noseSneerRight", "tongueOut",
];

/// Units that are kept.
const MOST: usize = 20_000;

/// Takes what the loader would take. `name` and other texts may be anything: it makes a text of
/// them.
pub fn read(document: &Document) -> FaceExpression {
    let root = &document.root;
    let mut expression = FaceExpression::default();
    if !root.is_object() {
        expression.refused.add_type("", root, "an object");
        return expression;
    }
    if let Some(tags) = root.get("tags") {
        match &tags.value {
            Value::Number(..) | Value::Bool(_) => {
                expression.empties.add_type("/tags", tags, "a list");
            }
            Value::String(text) => expression.has_letters_for_tags = !text.is_empty(),
            Value::Null | Value::Array(_) | Value::Object(_) => {}
        }
    }
    if root.get("face_units").is_none() {
        let members = root.effective_members();
        members.iter().for_each(|member| {
            expression
                .unread
                .add(&below("", &member.key), Why::Key(&["face_units"]));
        });
    }
    match root.get("face_units") {
        Some(units) if units.is_object() => expression.take(units),
        Some(units) if !units.is_falsy() => {
            expression
                .empties
                .add_type("/face_units", units, "an object");
        }
        Some(_) | None => {}
    }
    expression
}

impl FaceExpression {
    fn take(&mut self, units: &Node) {
        for member in units.effective_members().into_iter().take(MOST) {
            let pointer = below("/face_units", &member.key);
            match strength(&member.node) {
                None => match member.node.as_str() {
                    Some(text) => self.no_numbers.add(&pointer, Why::Text(text.to_owned())),
                    None => self.no_numbers.add_type(&pointer, &member.node, "a number"),
                },
                Some(value) if !(0.0..=1.0).contains(&value) => {
                    self.out_of_range.add(&pointer, Why::Range(value));
                }
                Some(_) => {}
            }
            self.units.push((member.key.clone(), pointer));
        }
    }
}

/// What Python's `float` makes of it: a text may be a number.
fn strength(node: &Node) -> Option<f64> {
    node.as_python_number()
        .or_else(|| python_float(node.as_str()?.as_bytes()))
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use mhlint_json::parse;

    fn of(text: &str) -> FaceExpression {
        read(&parse(text.as_bytes()).unwrap())
    }

    #[test]
    fn what_the_loader_takes_is_no_fault() {
        for text in [
            "{}",
            r#"{"face_units": null, "tags": null, "name": 5}"#,
            r#"{"face_units": [], "tags": {"a": 1}}"#,
            r#"{"face_units": {"jawOpen": "0.5", "cheekPuff": true, "tongueOut": 0, "eyeWideLeft": 1}, "tags": []}"#,
        ] {
            let found = of(text);
            let faults = [
                &found.empties,
                &found.refused,
                &found.no_numbers,
                &found.out_of_range,
            ];
            assert!(
                faults.iter().all(|faults| faults.all().is_empty()) && !found.has_letters_for_tags,
                "{text}"
            );
        }
    }

    #[test]
    fn faults_are_sorted_by_what_becomes_of_them() {
        assert_eq!(
            of(r#"{"face_units": ["jawOpen"], "tags": 5}"#)
                .empties
                .all()
                .len(),
            2
        );
        assert_eq!(of("[]").refused.all().len(), 1);
        assert!(of(r#"{"tags": "happy"}"#).has_letters_for_tags);
        let found = of(
            r#"{"face_units": {"jawOpen": "wide", "cheekPuff": null, "tongueOut": 1.001, "x": NaN}}"#,
        );
        let pointers = |faults: &Unfits| {
            faults
                .all()
                .iter()
                .map(|one| one.pointer.clone())
                .collect::<Vec<_>>()
        };
        assert_eq!(
            pointers(&found.no_numbers),
            ["/face_units/jawOpen", "/face_units/cheekPuff"]
        );
        assert_eq!(
            pointers(&found.out_of_range),
            ["/face_units/tongueOut", "/face_units/x"]
        );
        assert_eq!(found.units.len(), 4);
    }

    #[test]
    fn the_units_are_sorted() {
        assert!(UNITS.is_sorted());
    }

    proptest! {
        #[test]
        fn no_json_stops_the_reader(text in r#"[\[\]{},:"0-9a-c ]{0,40}"#) {
            let text = format!(r#"{{"face_units": {text}, "tags": {text}}}"#);
            if let Ok(document) = parse(text.as_bytes()) {
                read(&document);
            }
        }
    }
}
