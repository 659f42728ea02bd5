//! What to write in place of a value that does not match its schema: first the edit, then what the
//! value means.

use super::super::either;
use super::schema_words::{limit, shape};
use mhlint_json::{Bound, Found, Misfit, SchemaFault, Shape};

/// The edit, behind it the first sentence of what the schema says, as a clause: the others are on
/// what happens without the value.
pub(super) fn edit(fault: &SchemaFault) -> String {
    let edit = imperative(fault);
    match fault.description.as_deref().map(first_sentence) {
        Some(meaning) => format!("{edit}: {}", clause(meaning)),
        None => edit,
    }
}

fn imperative(fault: &SchemaFault) -> String {
    match &fault.fault {
        Misfit::Missing {
            key,
            and_more: true,
        } => format!("add at least `{key}`"),
        Misfit::Missing {
            key,
            and_more: false,
        } => format!("add `{key}`"),
        Misfit::Type {
            found: Found::Text(Some(text)),
            wanted,
            ..
        } if is_number(text) && takes_numbers(wanted) => {
            "remove the quotes around the number".to_owned()
        }
        Misfit::Type {
            wanted, elements, ..
        } => {
            let forms = wanted.iter().map(|wanted| match (wanted, elements) {
                (Shape::Array, Some(elements)) => format!("a list of {}", several(*elements)),
                _ => shape(*wanted).to_owned(),
            });
            format!("write {}", either(&forms.collect::<Vec<_>>()))
        }
        Misfit::Pattern { form, .. } => {
            format!("write {}", form.as_deref().unwrap_or("another form of it"))
        }
        Misfit::Enum { allowed, .. } => format!("write {}", either(allowed)),
        Misfit::Length {
            bound: bound @ Bound::Least(_),
            ..
        } => format!("add elements, {} in all", limit(bound)),
        Misfit::Length {
            bound: bound @ Bound::Most(_),
            ..
        } => format!("remove elements, {} in all", limit(bound)),
        Misfit::Range { bound, .. } => format!("write a number of {}", limit(bound)),
        Misfit::Other(_) => "correct it; `mhlint schema` prints what the format allows".to_owned(),
    }
}

fn is_number(text: &str) -> bool {
    serde_json::from_str::<serde_json::Number>(text).is_ok()
}

fn takes_numbers(wanted: &[Shape]) -> bool {
    wanted
        .iter()
        .any(|shape| matches!(shape, Shape::Integer | Shape::Number))
}

fn several(shape: Shape) -> &'static str {
    match shape {
        Shape::Null => "nulls",
        Shape::Boolean => "true and false",
        Shape::Integer => "whole numbers",
        Shape::Number => "numbers",
        Shape::String => "strings",
        Shape::Array => "lists",
        Shape::Object => "objects",
    }
}

/// A sentence without the capital at its beginning, unless that is the one of a name.
fn clause(sentence: &str) -> String {
    let is_name = ["MakeHuman", "Python", "MPFB"]
        .iter()
        .any(|name| sentence.starts_with(name));
    let mut letters = sentence.chars();
    match letters.next().filter(|_| !is_name) {
        Some(first) => first.to_lowercase().chain(letters).collect(),
        None => sentence.to_owned(),
    }
}

fn first_sentence(text: &str) -> &str {
    text.split_once(". ")
        .map_or(text, |(first, _)| first)
        .trim_end_matches('.')
}

#[cfg(test)]
mod tests {
    use super::*;
    use mhlint_json::{check, parse};

    #[test]
    fn the_edit_comes_before_what_the_value_means() {
        let cases = [
            (
                "modelling",
                r#"{"Age": {"default": "half"}}"#,
                "write a number: slider value after a reset, 0 to 1;",
            ),
            (
                "modelling",
                r#"{"Age": {"default": "0.5"}}"#,
                "remove the quotes around the number: slider value",
            ),
            (
                "modelling",
                r#"{"Age": {"display": {"formula": "val"}}}"#,
                "add `",
            ),
            (
                "base",
                r#"{"visible groups": ["a"], "head-pattern": 5}"#,
                "write a list of strings: beginnings of",
            ),
            (
                "modelling",
                r#"{"Age": {"measure": 5}}"#,
                "write a list of whole numbers or null: vertices",
            ),
            (
                "macro",
                r#"{"macrodef": 5, "components": {}}"#,
                "write a list of objects: macro definitions",
            ),
            (
                "macro",
                r#"{"components": {"a": {}}, "macrodef": []}"#,
                "add at least `pattern`: the `macro` pattern",
            ),
            (
                "geometry",
                r#"{"joint-ranges": {"a": []}}"#,
                "add elements, at least 3 in all",
            ),
        ];
        for (name, text, beginning) in cases {
            let faults = check(name, &parse(text.as_bytes()).unwrap()).faults;
            let helps: Vec<String> = faults.iter().map(edit).collect();
            assert!(
                helps.iter().any(|help| help.starts_with(beginning)),
                "{beginning}: {helps:?}"
            );
        }
    }
}
