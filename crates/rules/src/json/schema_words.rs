//! A schema fault in plain words.

use super::super::{counted, either};
use mhlint_diag::steps;
use mhlint_json::{Bound, Found, Misfit, SchemaFault, Shape};

/// What was found and what is allowed, in one sentence.
pub(super) fn sentence(fault: &SchemaFault) -> String {
    format!("{} {}", subject(&fault.pointer), predicate(fault))
}

/// What a value has none of, where that is the fault: part of the key of a finding, which baselines
/// hold. So these words stay as they are, whatever a message says.
pub(super) fn lack(fault: &SchemaFault) -> Option<String> {
    match &fault.fault {
        Misfit::Missing { key, and_more } => {
            let more = if *and_more { ", nor anything else" } else { "" };
            Some(format!("`{key}`{}{more}", others(fault)))
        }
        Misfit::Length { found: 0, bound } => {
            let limit = match bound {
                Bound::Least(limit) => format!("at least {limit} are wanted"),
                Bound::Most(limit) => format!("at most {limit} are allowed"),
            };
            Some(format!("element; {limit}{}", others(fault)))
        }
        _ => None,
    }
}

fn predicate(fault: &SchemaFault) -> String {
    let is = fault.found().map(found).unwrap_or_default();
    let says = match &fault.fault {
        Misfit::Missing {
            key,
            and_more: true,
        } => format!("is empty, expected at least `{key}`"),
        Misfit::Missing {
            key,
            and_more: false,
        } => format!("has no `{key}`"),
        Misfit::Type { wanted, .. } => {
            format!(
                "is {is}, expected {}",
                either(&wanted.iter().copied().map(shape).collect::<Vec<_>>())
            )
        }
        Misfit::Pattern { form, .. } => format!(
            "is {is}, expected {}",
            form.as_deref().unwrap_or("another form")
        ),
        Misfit::Enum { allowed, .. } => format!("is {is}, expected {}", either(allowed)),
        Misfit::Length { found: 0, bound } => format!("has no elements, expected {}", limit(bound)),
        Misfit::Length { found, bound } => format!(
            "has {}, expected {}",
            counted(found, "element"),
            limit(bound)
        ),
        Misfit::Range { bound, .. } => format!("is {is}, expected {}", limit(bound)),
        Misfit::Other(text) => format!("does not match its format: {text}"),
    };
    says + &others(fault)
}

fn others(fault: &SchemaFault) -> String {
    match fault.other_forms {
        0 => String::new(),
        1 => " (1 other form is allowed)".to_owned(),
        count => format!(" ({count} other forms are allowed)"),
    }
}

pub(super) fn limit(bound: &Bound) -> String {
    match bound {
        Bound::Least(limit) => format!("at least {limit}"),
        Bound::Most(limit) => format!("at most {limit}"),
    }
}

pub(super) fn shape(shape: Shape) -> &'static str {
    match shape {
        Shape::Null => "null",
        Shape::Boolean => "true or false",
        Shape::Integer => "a whole number",
        Shape::Number => "a number",
        Shape::String => "a string",
        Shape::Array => "a list",
        Shape::Object => "an object",
    }
}

fn found(found: &Found) -> String {
    match found {
        Found::Null => "null".to_owned(),
        Found::Bool(value) => format!("`{value}`"),
        Found::Number(number) => format!("the number {number}"),
        Found::Text(None) => "a long string".to_owned(),
        Found::Text(Some(text)) if text.is_empty() => "an empty string".to_owned(),
        Found::Text(Some(text)) => format!("the string `{text}`"),
        Found::List { is_empty: true } => "an empty list".to_owned(),
        Found::List { is_empty: false } => "a list".to_owned(),
        Found::Object => "an object".to_owned(),
    }
}

/// `b[1]` of `a` for `/…/a/b/1`: the value and what it belongs to.
fn subject(pointer: &str) -> String {
    let mut names: Vec<String> = Vec::new();
    for step in steps(pointer) {
        match names.last_mut() {
            Some(name) if step.bytes().all(|byte| byte.is_ascii_digit()) => {
                *name = format!("{name}[{step}]");
            }
            _ => names.push(step),
        }
    }
    match names.as_slice() {
        [] => "the file".to_owned(),
        [name] => format!("`{name}`"),
        [.., owner, name] => format!("`{name}` of `{owner}`"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use mhlint_json::{check, parse};

    fn said(name: &str, text: &str) -> String {
        let faults = check(name, &parse(text.as_bytes()).unwrap()).faults;
        faults.iter().map(sentence).collect::<Vec<_>>().join("\n")
    }

    #[test]
    fn a_wrong_type_says_what_is_there_and_what_is_wanted() {
        let cases = [
            (
                "modelling",
                r#"{"Age": {"default": "half"}}"#,
                "`default` of `Age` is the string `half`, expected a number",
            ),
            (
                "modelling",
                r#"{"Age": {"measure": [1, 2.5]}}"#,
                "`measure[1]` of `Age` is the number 2.5, expected a whole number",
            ),
            ("macro", "[1]", "the file is a list, expected an object"),
            (
                "modelling",
                r#"{"Age": {"rsym": 1}}"#,
                "`rsym` of `Age` is the number 1, expected a string or null",
            ),
            (
                "base",
                r#"{"modifier-presets": {"a/b": "much"}}"#,
                "`a/b` of `modifier-presets` is the string `much`, expected a number as a string \
                 (1 other form is allowed)",
            ),
            (
                "base",
                r#"{"modifier-presets": {"a": []}}"#,
                "`a` of `modifier-presets` is an empty list, expected a number or a string",
            ),
        ];
        for (name, text, words) in cases {
            assert_eq!(said(name, text), words);
        }
    }

    #[test]
    fn what_is_missing_is_named() {
        let text = r#"{"components": {}, "macrodef": [{"comp": [], "targets": [{"name": "a"}]}]}"#;
        assert_eq!(
            said("macro", text),
            "`targets[0]` of `macrodef[0]` has no `t`"
        );
        assert_eq!(
            said("macro", r#"{"macrodef": [{"comp": []}]}"#),
            "the file has no `components`"
        );
        let empty = r#"{"components": {"a": {}}, "macrodef": []}"#;
        assert_eq!(
            said("macro", empty),
            "`a` of `components` is empty, expected at least `pattern`"
        );
        let short = r#"{"joint-ranges": {"a": []}}"#;
        assert!(
            said("geometry", short)
                .contains("`a` of `joint-ranges` has no elements, expected at least 3")
        );
    }
}
