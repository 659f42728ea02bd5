//! Embedded JSON Schemas: what they hold, and what they say on a document.
//!
//! Validators are built once, on first use. What a fault is made of is in [`super::schema_fault`],
//! which keys nobody reads in [`super::unknown_key`].

use std::sync::{LazyLock, OnceLock};

use serde_json::Value as Plain;

use super::finder::Sorted;
use super::long_keys::LongKeys;
use super::naming::named;
use super::room::Room;
use super::schema_fault::{Misfit, SchemaFault, describe};
use super::{Document, unknown_key};

/// What a schema has to say on a document.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct SchemaFaults {
    /// Values of a wrong shape.
    pub faults: Vec<SchemaFault>,
    /// How many more of them there are.
    pub faults_left_out: usize,
    /// Keys nobody reads.
    pub unknown: Vec<UnknownKey>,
    /// How many more of them there are.
    pub unknown_left_out: usize,
    /// Numbers of the faults, sorted by pointer.
    by_pointer: Vec<usize>,
}

impl SchemaFaults {
    fn new(faults: Vec<SchemaFault>, unknown: Vec<UnknownKey>) -> Self {
        let mut found = Self {
            faults,
            unknown,
            ..Self::default()
        };
        found.by_pointer = (0..found.faults.len()).collect();
        found
            .by_pointer
            .sort_by_key(|number| found.faults.get(*number).map(|fault| &fault.pointer));
        found
    }

    /// The faults of the value at a pointer itself.
    pub fn at(&self, pointer: &str) -> impl Iterator<Item = &SchemaFault> {
        self.sorted_from(pointer)
            .take_while(move |fault| fault.pointer == pointer)
    }

    /// The faults of what is in the value at a pointer.
    pub fn inside<'f>(&'f self, pointer: &str) -> impl Iterator<Item = &'f SchemaFault> + use<'f> {
        let within = format!("{pointer}/");
        self.sorted_from(&within)
            .take_while(move |fault| fault.pointer.starts_with(&within))
    }

    /// Faults in order of their pointers, from this pointer on.
    fn sorted_from<'f>(&'f self, pointer: &str) -> impl Iterator<Item = &'f SchemaFault> + use<'f> {
        let is_before = |number: &usize| {
            self.faults
                .get(*number)
                .is_some_and(|fault| fault.pointer.as_str() < pointer)
        };
        let start = self.by_pointer.partition_point(is_before);
        self.by_pointer
            .iter()
            .skip(start)
            .filter_map(|number| self.faults.get(*number))
    }
}

/// A key that no application reads.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct UnknownKey {
    /// Pointer to the member.
    pub pointer: String,
    /// The same with names for positions in lists.
    pub name: String,
    /// The key.
    pub key: String,
    /// What the object is called in the schema: `Slider`, `Bone`; nothing for the file as a whole.
    pub object: Option<String>,
    /// The known key most like it.
    pub nearest: Option<String>,
    /// Whether its value is an object with something in it.
    pub is_object: bool,
    /// Whether no other key of the same object is unknown.
    pub is_alone: bool,
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
    fn compiled(&self) -> &Compiled {
        self.compiled.get_or_init(|| {
            let tree =
                serde_json::from_str(self.text).expect("invariant: embedded schemas are JSON");
            let validator =
                jsonschema::validator_for(&tree).expect("invariant: embedded schemas are valid");
            Compiled { tree, validator }
        })
    }
}

static SCHEMAS: LazyLock<Vec<Schema>> = LazyLock::new(|| {
    let schema = |(name, text): &(&'static str, &'static str)| Schema {
        name,
        text,
        compiled: OnceLock::new(),
    };
    mhlint_schemas::ALL.iter().map(schema).collect()
});

/// Names of the embedded schemas, sorted.
pub fn schema_names() -> impl Iterator<Item = &'static str> {
    SCHEMAS.iter().map(|schema| schema.name)
}

/// Text of an embedded schema.
pub fn schema_text(name: &str) -> Option<&'static str> {
    find(name).map(|schema| schema.text)
}

/// Checks a document against the embedded schema `name` (`macro`, `mhskel` …). An unknown name fits
/// anything.
pub fn check(name: &str, document: &Document) -> SchemaFaults {
    let Some(schema) = find(name).map(Schema::compiled) else {
        return SchemaFaults::default();
    };
    let mut plain = document.root.plain(&Plain::from(f64::MAX));
    let mut long_keys = LongKeys::default();
    long_keys.shorten(&mut plain);
    let errors = schema.validator.iter_errors(&plain);
    let faults = errors.map(|error| describe(&error, &schema.tree)).collect();
    let (faults, faults_left_out) = kept(empty_objects_once(&plain, faults), &long_keys);
    let (unknown, unknown_left_out) = unknown_key::find(&document.root, &schema.tree);
    let mut found = SchemaFaults {
        faults_left_out,
        unknown_left_out,
        ..SchemaFaults::new(faults, unknown)
    };
    let sorted = &mut Sorted::default();
    found
        .faults
        .iter_mut()
        .for_each(|fault| fault.name = named(document, sorted, &fault.pointer));
    found
        .unknown
        .iter_mut()
        .for_each(|unknown| unknown.name = named(document, sorted, &unknown.pointer));
    found
}

/// The first faults with the pointers of the text, and how many more there are.
fn kept(faults: Vec<SchemaFault>, long_keys: &LongKeys) -> (Vec<SchemaFault>, usize) {
    let mut room = Room::default();
    let mut kept = Vec::with_capacity(faults.len());
    for fault in faults {
        if room.takes_one() {
            let pointer = long_keys.restored(fault.pointer);
            room.take(&pointer);
            kept.push(SchemaFault { pointer, ..fault });
        }
    }
    (kept, room.left_out)
}

/// An object without any member lacks all its keys for one reason: the first of them stands for
/// all.
fn empty_objects_once(root: &Plain, faults: Vec<SchemaFault>) -> Vec<SchemaFault> {
    let is_empty = |pointer: &str| {
        root.pointer(pointer)
            .and_then(Plain::as_object)
            .is_some_and(serde_json::Map::is_empty)
    };
    let mut once: Vec<SchemaFault> = Vec::with_capacity(faults.len());
    for fault in faults {
        let first = once
            .last_mut()
            .filter(|first| first.pointer == fault.pointer && fault.missing().is_some());
        match first.map(|first| &mut first.fault) {
            Some(Misfit::Missing { and_more, .. }) if *and_more || is_empty(&fault.pointer) => {
                *and_more = true;
            }
            _ => once.push(fault),
        }
    }
    once
}

fn find(name: &str) -> Option<&'static Schema> {
    SCHEMAS.iter().find(|schema| schema.name == name)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Found, Shape, parse};

    fn faults(name: &str, text: &str) -> Vec<(String, Misfit)> {
        let found = check(name, &parse(text.as_bytes()).unwrap());
        found
            .faults
            .into_iter()
            .map(|fault| (fault.pointer, fault.fault))
            .collect()
    }

    fn fault(name: &str, text: &str) -> (String, Misfit) {
        let all = faults(name, text);
        assert_eq!(all.len(), 1, "{all:?}");
        all.into_iter().next().unwrap()
    }

    fn wrong_type(found: Found, wanted: &[Shape]) -> Misfit {
        Misfit::Type {
            found,
            wanted: wanted.to_vec(),
            elements: None,
        }
    }

    fn lacks(key: &str, and_more: bool) -> Misfit {
        Misfit::Missing {
            key: key.to_owned(),
            and_more,
        }
    }

    #[test]
    fn every_schema_compiles() {
        assert!(schema_names().is_sorted());
        for schema in SCHEMAS.iter() {
            schema.compiled();
        }
        assert_eq!(schema_text("nothing"), None);
    }

    #[test]
    fn a_wrong_type_says_what_is_there_and_what_is_wanted() {
        let half = Found::Text(Some("half".to_owned()));
        assert_eq!(
            fault("modelling", r#"{"Age": {"default": "half"}}"#),
            (
                "/Age/default".to_owned(),
                wrong_type(half, &[Shape::Number])
            )
        );
        let number = |text: &str| Found::Number(text.to_owned());
        assert_eq!(
            fault("modelling", r#"{"Age": {"measure": [1, 2.5]}}"#),
            (
                "/Age/measure/1".to_owned(),
                wrong_type(number("2.5"), &[Shape::Integer])
            )
        );
        assert_eq!(
            fault("modelling", r#"{"Age": {"rsym": 1}}"#).1,
            wrong_type(number("1"), &[Shape::String, Shape::Null])
        );
        let root = check("macro", &parse(b"[1]").unwrap()).faults;
        assert!(matches!(root.as_slice(), [root] if root.is_wrong_root() && !root.lacks("", "x")));
    }

    #[test]
    fn a_missing_key_is_named() {
        let text = r#"{"components": {}, "macrodef": [{"comp": [], "targets": [{"name": "a"}]}]}"#;
        assert_eq!(
            fault("macro", text),
            ("/macrodef/0/targets/0".to_owned(), lacks("t", false))
        );
        assert_eq!(
            fault("macro", r#"{"macrodef": [{"comp": []}]}"#),
            (String::new(), lacks("components", false))
        );
    }

    #[test]
    fn an_empty_object_is_one_fault() {
        let text = r#"{"components": {"a": {}}, "macrodef": []}"#;
        let all = faults("macro", text);
        assert_eq!(
            all.iter()
                .filter(|(pointer, _)| pointer == "/components/a")
                .count(),
            1,
            "{all:?}"
        );
        assert!(
            all.iter()
                .any(|(_, fault)| matches!(fault, Misfit::Missing { and_more: true, .. })),
            "{all:?}"
        );
    }

    #[test]
    fn faults_are_found_by_the_place_that_they_are_in() {
        let text =
            r#"{"A": {"default": "x", "tip": 1}, "A b": {"default": "x"}, "A/b": 5, "B": 7}"#;
        let found = check("modelling", &parse(text.as_bytes()).unwrap());
        let pointers = |faults: Vec<&SchemaFault>| {
            faults.iter().map(|f| f.pointer.clone()).collect::<Vec<_>>()
        };
        for pointer in ["", "/A", "/A/default", "/A b", "/B", "/A~1b", "/none"] {
            let [at, inside] =
                [found.at(pointer).collect(), found.inside(pointer).collect()].map(pointers);
            let all = || found.faults.iter().map(|fault| fault.pointer.clone());
            let mut expected: Vec<_> = all()
                .filter(|other| other.starts_with(&format!("{pointer}/")))
                .collect();
            expected.sort();
            assert_eq!(
                at,
                all().filter(|other| other == pointer).collect::<Vec<_>>(),
                "{pointer}"
            );
            assert_eq!(inside, expected, "{pointer}");
        }
    }

    #[test]
    fn of_branches_the_closest_speaks() {
        let presets = check(
            "base",
            &parse(br#"{"modifier-presets": {"a/b": "much"}}"#).unwrap(),
        )
        .faults;
        let [much] = presets.as_slice() else {
            panic!("{presets:?}")
        };
        assert_eq!(
            (much.pointer.as_str(), much.other_forms),
            ("/modifier-presets/a~1b", 1)
        );
        let form = Some("a number as a string".to_owned());
        assert_eq!(
            much.fault,
            Misfit::Pattern {
                found: Found::Text(Some("much".to_owned())),
                form
            }
        );
        let (_, fault) = fault("base", r#"{"modifier-presets": {"a": []}}"#);
        assert_eq!(
            fault,
            wrong_type(
                Found::List { is_empty: true },
                &[Shape::Number, Shape::String]
            )
        );
    }

    #[test]
    fn equal_keys_and_python_numbers_are_taken_as_python_does() {
        assert_eq!(
            faults("modelling", r#"{"A": {"default": "x", "default": 1}}"#),
            []
        );
        assert_eq!(
            faults(
                "modelling",
                r#"{"A": {"default": NaN}, "B": {"default": -Infinity}}"#
            ),
            []
        );
    }

    #[test]
    fn the_place_in_the_schema_is_the_same_for_equal_faults() {
        let document = parse(br#"{"A": {"default": "x"}, "B": {"default": []}}"#).unwrap();
        let found = check("modelling", &document).faults;
        assert_eq!(found[0].keyword, found[1].keyword);
        assert!(
            found[0]
                .description
                .as_ref()
                .unwrap()
                .starts_with("Slider value after a reset")
        );
    }
}
