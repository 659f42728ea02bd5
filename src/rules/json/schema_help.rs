//! What to write in place of a value that does not match its schema: first the edit, then what the value means.

use super::schema_words::{limit, shape};
use crate::json::{Bound, Found, Misfit, SchemaFault, Shape};

/// The edit, behind it the first sentence of what the schema says: the others are on what happens without the value.
pub(super) fn edit(fault: &SchemaFault) -> String {
    let edit = imperative(fault);
    match fault.description.as_deref().map(first_sentence) {
        Some(meaning) => format!("{edit}. {meaning}."),
        None => edit,
    }
}

fn imperative(fault: &SchemaFault) -> String {
    match &fault.fault {
        Misfit::Missing { key, and_more: true } => format!("add at least `{key}`"),
        Misfit::Missing { key, and_more: false } => format!("add `{key}`"),
        Misfit::Type { found: Found::Text(Some(text)), wanted, .. } if is_number(text) && takes_numbers(wanted) => {
            "remove the quotes around the number".to_owned()
        }
        Misfit::Type { wanted, elements, .. } => {
            // Null is as good as no key.
            let values = wanted.iter().filter(|shape| **shape != Shape::Null || wanted.len() == 1);
            let forms = values.map(|wanted| match (wanted, elements) {
                (Shape::Array, Some(elements)) => format!("a list of {}", several(*elements)),
                _ => shape(*wanted).to_owned(),
            });
            format!("write {}", forms.collect::<Vec<_>>().join(" or "))
        }
        Misfit::Pattern { form, .. } => format!("write {}", form.as_deref().unwrap_or("another form of it")),
        Misfit::Enum { allowed, .. } => format!("write {}", allowed.join(" or ")),
        Misfit::Length { bound: bound @ Bound::Least(_), .. } => format!("add elements, {} in all", limit(bound)),
        Misfit::Length { bound: bound @ Bound::Most(_), .. } => format!("remove elements, {} in all", limit(bound)),
        Misfit::Range { bound, .. } => format!("write a number of {}", limit(bound)),
        Misfit::Other(_) => "correct it; `mhlint schema` prints what the format allows".to_owned(),
    }
}

fn is_number(text: &str) -> bool {
    serde_json::from_str::<serde_json::Number>(text).is_ok()
}

fn takes_numbers(wanted: &[Shape]) -> bool {
    wanted.iter().any(|shape| matches!(shape, Shape::Integer | Shape::Number))
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

fn first_sentence(text: &str) -> &str {
    text.split_once(". ").map_or(text, |(first, _)| first).trim_end_matches('.')
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::json::{check, parse};

    #[test]
    fn the_edit_comes_before_what_the_value_means() {
        let cases = [
            ("modelling", r#"{"Age": {"default": "half"}}"#, "write a number. Slider value after a reset, 0 to 1;"),
            ("modelling", r#"{"Age": {"default": "0.5"}}"#, "remove the quotes around the number. Slider value"),
            ("modelling", r#"{"Age": {"display": {"formula": "val"}}}"#, "add `"),
            ("base", r#"{"visible groups": ["a"], "head-pattern": 5}"#, "write a list of strings. Beginnings of"),
            ("modelling", r#"{"Age": {"measure": 5}}"#, "write a list of whole numbers. Vertices"),
            ("macro", r#"{"macrodef": 5, "components": {}}"#, "write a list of objects. Every definition is"),
            ("macro", r#"{"components": {"a": {}}, "macrodef": []}"#, "add at least `pattern`. With `steps`"),
            ("geometry", r#"{"joint-ranges": {"a": []}}"#, "add elements, at least 3 in all"),
        ];
        for (name, text, beginning) in cases {
            let faults = check(name, &parse(text.as_bytes()).unwrap()).faults;
            let helps: Vec<String> = faults.iter().map(edit).collect();
            assert!(helps.iter().any(|help| help.starts_with(beginning)), "{beginning}: {helps:?}");
        }
    }
}
