//! A validation error in plain words: what was found, what is allowed, what the schema says about it.
//!
//! Of the branches of `anyOf` and `oneOf` only the one that comes closest speaks, as people read one
//! sentence and not a tree of alternatives.

use jsonschema::error::{TypeKind, ValidationErrorKind};
use jsonschema::{JsonType, ValidationError};
use serde_json::Value;

use super::SchemaFault;

/// Longest text that is quoted, in characters.
const QUOTED: usize = 40;

/// Describes an error of a validator made from `schema`.
pub(super) fn describe(error: &ValidationError<'_>, schema: &Value) -> SchemaFault {
    let (closest, hidden) = closest(error);
    let pointer = closest.instance_path().to_string();
    let keyword = closest.schema_path().to_string();
    let wanted = alternatives(error).unwrap_or_else(|| allowed(closest, schema));
    let others = match hidden {
        _ if hidden == 0 || alternatives(error).is_some() => String::new(),
        1 => " (1 other form is allowed)".to_owned(),
        count => format!(" ({count} other forms are allowed)"),
    };
    let message = format!("{} {wanted}{others}", subject(&pointer));
    SchemaFault {
        pointer,
        name: String::new(),
        description: text_at(schema, &keyword, "description"),
        keyword,
        message,
    }
}

/// Branches of an error that offers several forms.
fn branches<'e>(error: &'e ValidationError<'_>) -> &'e [Vec<ValidationError<'static>>] {
    match error.kind() {
        ValidationErrorKind::AnyOf { context } | ValidationErrorKind::OneOfNotValid { context } => context,
        _ => &[],
    }
}

/// The error of the branch that comes closest, and how many branches it hides: the deepest counts, then
/// one of the right type, then the one with the fewest errors.
fn closest<'e>(error: &'e ValidationError<'_>) -> (&'e ValidationError<'e>, usize) {
    let branches = branches(error);
    let rank = |branch: &&Vec<ValidationError<'static>>| {
        let depth = branch.iter().map(|error| depth(error)).max().unwrap_or_default();
        let right_type = !branch.iter().any(|error| is_type(error));
        (depth, right_type, std::cmp::Reverse(branch.len()))
    };
    // Of equal ranks the first branch, which schemas put the usual form in.
    let best = branches.iter().rev().max_by_key(rank);
    let deepest = best.and_then(|branch| branch.iter().rev().max_by_key(|error| depth(error)));
    match deepest {
        Some(inner) => {
            let (found, hidden) = closest(inner);
            (found, hidden + branches.len() - 1)
        }
        None => (error, 0),
    }
}

fn depth(error: &ValidationError<'_>) -> usize {
    error.instance_path().to_string().matches('/').count()
}

fn is_type(error: &ValidationError<'_>) -> bool {
    matches!(error.kind(), ValidationErrorKind::Type { .. })
}

/// If every branch refuses the type of the value itself, the types of all.
fn alternatives(error: &ValidationError<'_>) -> Option<String> {
    let branches = branches(error);
    let types = branches.iter().map(|branch| match branch.as_slice() {
        [inner] if inner.instance_path() == error.instance_path() => types(inner.kind()),
        _ => None,
    });
    let types: Vec<&'static str> = types.collect::<Option<Vec<_>>>()?.into_iter().flatten().collect();
    (!types.is_empty()).then(|| format!("is {}; {} is wanted", found(error.instance()), types.join(" or ")))
}

/// What is there and what is allowed, to follow the name of the value.
fn allowed(error: &ValidationError<'_>, schema: &Value) -> String {
    let is = found(error.instance());
    match error.kind() {
        kind @ ValidationErrorKind::Type { .. } => {
            format!("is {is}; {} is wanted", types(kind).unwrap_or_default().join(" or "))
        }
        ValidationErrorKind::Required { property } => format!("has no `{}`", property.as_str().unwrap_or_default()),
        ValidationErrorKind::Pattern { .. } => {
            let title = text_at(schema, &error.schema_path().to_string(), "title");
            format!("is {is}; {} is wanted", title.as_deref().unwrap_or("another form"))
        }
        ValidationErrorKind::Enum { options } => format!("is {is}; allowed: {}", listed(options)),
        ValidationErrorKind::Constant { expected_value } => format!("is {is}; allowed: {expected_value}"),
        ValidationErrorKind::MinItems { limit } => format!("has {}; at least {limit} are wanted", length(error)),
        ValidationErrorKind::MaxItems { limit } => format!("has {}; at most {limit} are allowed", length(error)),
        ValidationErrorKind::Minimum { limit } => format!("is {is}; at least {limit} is wanted"),
        ValidationErrorKind::Maximum { limit } => format!("is {is}; at most {limit} is allowed"),
        _ => format!("does not fit its format: {error}"),
    }
}

fn types(kind: &ValidationErrorKind) -> Option<Vec<&'static str>> {
    let ValidationErrorKind::Type { kind } = kind else { return None };
    Some(match kind {
        TypeKind::Single(one) => vec![type_name(*one)],
        TypeKind::Multiple(set) => {
            let mut names: Vec<_> = set.iter().map(type_name).collect();
            // The usual form first: `null` only says that the key may be there without a value.
            names.sort_by_key(|name| *name == "null");
            names
        }
    })
}

fn type_name(kind: JsonType) -> &'static str {
    match kind {
        JsonType::Null => "null",
        JsonType::Boolean => "true or false",
        JsonType::Integer => "a whole number",
        JsonType::Number => "a number",
        JsonType::String => "a text",
        JsonType::Array => "a list",
        JsonType::Object => "an object",
    }
}

fn found(value: &Value) -> String {
    match value {
        Value::Null => "null".to_owned(),
        Value::Bool(value) => format!("`{value}`"),
        Value::Number(number) => format!("the number {number}"),
        Value::String(text) if text.is_empty() => "an empty text".to_owned(),
        Value::String(text) if text.chars().count() > QUOTED => "a long text".to_owned(),
        Value::String(text) => format!("the text `{text}`"),
        Value::Array(elements) if elements.is_empty() => "an empty list".to_owned(),
        Value::Array(_) => "a list".to_owned(),
        Value::Object(_) => "an object".to_owned(),
    }
}

fn listed(options: &Value) -> String {
    let options = options.as_array().map(Vec::as_slice).unwrap_or_default();
    options.iter().map(Value::to_string).collect::<Vec<_>>().join(", ")
}

fn length(error: &ValidationError<'_>) -> String {
    match error.instance().as_array().map_or(0, Vec::len) {
        0 => "no element".to_owned(),
        1 => "1 element".to_owned(),
        count => format!("{count} elements"),
    }
}

/// `b[1]` of `a` for `/…/a/b/1`: the value and what it belongs to.
fn subject(pointer: &str) -> String {
    let mut names: Vec<String> = Vec::new();
    for step in pointer.split('/').skip(1) {
        let step = step.replace("~1", "/").replace("~0", "~");
        match names.last_mut() {
            Some(name) if step.bytes().all(|byte| byte.is_ascii_digit()) => *name = format!("{name}[{step}]"),
            _ => names.push(step),
        }
    }
    match names.as_slice() {
        [] => "the file".to_owned(),
        [name] => format!("`{name}`"),
        [.., owner, name] => format!("`{name}` of `{owner}`"),
    }
}

/// A text of the schema object that holds the keyword at `pointer`.
fn text_at(schema: &Value, pointer: &str, member: &str) -> Option<String> {
    let (object, _) = pointer.rsplit_once('/')?;
    schema.pointer(object)?.get(member)?.as_str().map(str::to_owned)
}
