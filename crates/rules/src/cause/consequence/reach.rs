//! Rows go by places in the schemas: each of them must be met by a value that some file can have.

#![cfg(test)]

use serde_json::Value;

use super::values::{self, Row};
use super::{makehuman1_values, makehuman2_keys, makehuman2_values, mpfb};
use mhlint_discover::Kind;
use mhlint_formats::Format;
use mhlint_json::Found;

/// Keywords of a schema that a value may fail.
const ASSERTIONS: [&str; 14] = [
    "type",
    "required",
    "enum",
    "const",
    "pattern",
    "minimum",
    "maximum",
    "exclusiveMinimum",
    "exclusiveMaximum",
    "minItems",
    "maxItems",
    "minLength",
    "oneOf",
    "anyOf",
];

fn schema(kind: Kind) -> Value {
    let name = Format::of(kind).schema.unwrap();
    let (_, text) = mhlint_schemas::ALL
        .iter()
        .find(|(known, _)| *known == name)
        .unwrap();
    serde_json::from_str(text).unwrap()
}

/// Places of a schema at which a value may fail, with the keyword's value.
fn places(schema: &Value) -> Vec<(String, &Value)> {
    let mut open = vec![(String::new(), schema)];
    let mut found = Vec::new();
    while let Some((at, node)) = open.pop() {
        match node {
            Value::Object(members) => {
                for (key, member) in members {
                    let below = format!("{at}/{}", key.replace('~', "~0").replace('/', "~1"));
                    if ASSERTIONS.contains(&key.as_str()) && !at.ends_with("/properties") {
                        found.push((below.clone(), member));
                    }
                    open.push((below, member));
                }
            }
            Value::Array(members) => {
                open.extend(
                    members
                        .iter()
                        .enumerate()
                        .map(|(index, member)| (format!("{at}/{index}"), member)),
                );
            }
            _ => {}
        }
    }
    found
}

/// One value of each sort, with the name of its type; nothing for a fault without a value.
fn samples() -> Vec<(&'static str, Option<Found>)> {
    let text = |text: &str| Some(Found::Text(Some(text.to_owned())));
    let number = |number: &str| Some(Found::Number(number.to_owned()));
    let list = |is_empty| Some(Found::List { is_empty });
    vec![
        ("", None),
        ("null", Some(Found::Null)),
        ("boolean", Some(Found::Bool(false))),
        ("boolean", Some(Found::Bool(true))),
        ("number", number("0")),
        ("number", number("7.5")),
        ("string", text("")),
        ("string", text("a word")),
        ("array", list(true)),
        ("array", list(false)),
        ("object", Some(Found::Object)),
    ]
}

/// Whether a value of this type can fail a keyword.
fn fails(place: &str, wanted: &Value, sort: &str) -> bool {
    match place.rsplit('/').next().unwrap_or_default() {
        "type" if sort.is_empty() => false,
        "type" => match wanted {
            Value::String(wanted) => wanted != sort,
            Value::Array(wanted) => !wanted.iter().any(|one| one == sort),
            _ => false,
        },
        "pattern" => sort == "string",
        "minimum" | "maximum" | "exclusiveMinimum" | "exclusiveMaximum" => sort == "number",
        "required" | "minItems" | "maxItems" | "minLength" => sort.is_empty(),
        _ => true,
    }
}

/// Rows that no value meets: their place is not in the schema, or rows above them take all.
fn unmet(rows: &[Row]) -> Vec<String> {
    let is_met = |row: &Row| {
        let schema = schema(row.kind);
        places(&schema).into_iter().any(|(place, wanted)| {
            samples().iter().any(|(sort, found)| {
                let first = values::first_row(rows, row.kind, &place, found.as_ref());
                fails(&place, wanted, sort) && first.is_some_and(|first| std::ptr::eq(first, row))
            })
        })
    };
    rows.iter()
        .filter(|row| !is_met(row))
        .map(|row| format!("{:?} {} {:?}", row.kind, row.keyword, row.consequence))
        .collect()
}

#[test]
fn every_row_is_met_by_a_value() {
    let rows = [
        unmet(&makehuman2_values::ROWS),
        unmet(&makehuman1_values::ROWS),
    ];
    assert_eq!(rows.concat(), Vec::<String>::new());
}

#[test]
fn every_row_of_mpfb_has_its_place() {
    let tables = [
        (Kind::MacroParts, mpfb::MACRO_PARTS.as_slice()),
        (Kind::TargetCatalog, mpfb::CATALOG.as_slice()),
    ];
    for (kind, rows) in tables {
        let schema = schema(kind);
        for (beginning, _) in rows {
            let is_met = |(place, _): &(String, &Value)| place.starts_with(beginning);
            assert!(places(&schema).iter().any(is_met), "{kind:?} {beginning}");
        }
    }
}

/// What stops MPFB in its catalogue, where no row says anything else.
const STOPS_MPFB: [&str; 9] = [
    "/type",
    "/$defs/section/",
    "/$defs/category/type",
    "/$defs/category/required",
    "/$defs/category/properties/name/",
    "/$defs/category/properties/label/",
    "/$defs/category/if/",
    "/$defs/sided/",
    "/$defs/unsided/",
];

#[test]
fn every_place_of_the_catalogue_of_mpfb_says_what_it_comes_to() {
    let schema = schema(Kind::TargetCatalog);
    let rows = mpfb::CATALOG.iter().map(|(beginning, _)| *beginning);
    let known: Vec<&str> = rows.chain(STOPS_MPFB).collect();
    let is_new = |place: &&String| !known.iter().any(|beginning| place.starts_with(beginning));
    let new: Vec<String> = places(&schema)
        .into_iter()
        .map(|(place, _)| place)
        .collect();
    let new: Vec<&String> = new.iter().filter(is_new).collect();
    assert!(
        new.is_empty(),
        "a row in `CATALOG` or in `STOPS_MPFB`: {new:?}"
    );
}

#[test]
fn every_key_stands_in_its_schema() {
    for row in &makehuman2_keys::ROWS {
        let schema = schema(row.kind);
        for key in row.meant.split("` or `") {
            assert!(has_key(&schema, key), "{:?} {key}", row.kind);
        }
    }
}

/// Whether any object of the schema describes the key.
fn has_key(schema: &Value, key: &str) -> bool {
    match schema {
        Value::Object(members) => {
            let own = members.get("properties");
            own.is_some_and(|properties| properties.get(key).is_some())
                || members.values().any(|member| has_key(member, key))
        }
        Value::Array(members) => members.iter().any(|member| has_key(member, key)),
        _ => false,
    }
}
