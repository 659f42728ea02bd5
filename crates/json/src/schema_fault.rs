//! A validation error as a fact: what was found and what is allowed. Its words are the rules'
//! (`rules/json`).
//!
//! Of the branches of `anyOf` and `oneOf` only the one that comes closest speaks, as people read
//! one sentence and not a tree of alternatives.

use jsonschema::error::{TypeKind, ValidationErrorKind};
use jsonschema::{JsonType, ValidationError};
use serde_json::Value;

/// Longest text that is quoted, in characters.
const QUOTED: usize = 40;

/// A value that does not fit.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SchemaFault {
    /// Pointer to the value.
    pub pointer: String,
    /// The same with names for positions in lists.
    pub name: String,
    /// Place in the schema that it fails at: equal for equal faults of different values.
    pub keyword: String,
    /// What does not fit.
    pub fault: Misfit,
    /// Forms that the schema allows besides the one that the fault is about.
    pub other_forms: usize,
    /// What the schema says about the value, or about the key that is missing.
    pub description: Option<String>,
}

/// What does not fit.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Misfit {
    /// An object lacks a key.
    Missing {
        /// The key, the first of several where the object is empty.
        key: String,
        /// Whether the object is empty and lacks more keys.
        and_more: bool,
    },
    /// A value of another type.
    Type {
        /// What is there.
        found: Found,
        /// The types that would fit, the usual one first.
        wanted: Vec<JsonType>,
        /// The type of the elements of a list that would fit, where the schema gives one.
        elements: Option<JsonType>,
    },
    /// A text of another form.
    Pattern {
        /// What is there.
        found: Found,
        /// What the schema calls the form.
        form: Option<String>,
    },
    /// None of a few values.
    Enum {
        /// What is there.
        found: Found,
        /// The values, as JSON.
        allowed: Vec<String>,
    },
    /// A list with too few or too many elements.
    Length {
        /// How many it has.
        found: usize,
        /// How many are allowed.
        bound: Bound,
    },
    /// A number that is too small or too large.
    Range {
        /// What is there.
        found: Found,
        /// What is allowed.
        bound: Bound,
    },
    /// Anything else, as the validator puts it.
    Other(String),
}

/// A limit, as JSON.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Bound {
    /// No less.
    Least(String),
    /// No more.
    Most(String),
}

/// A value that is there.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Found {
    /// `null`.
    Null,
    /// `true` or `false`.
    Bool(bool),
    /// A number, as JSON.
    Number(String),
    /// A text; `None` if it is long.
    Text(Option<String>),
    /// A list.
    List {
        /// Whether it is empty.
        is_empty: bool,
    },
    /// An object.
    Object,
}

impl SchemaFault {
    /// The key that the object lacks, if that is the fault.
    pub fn missing(&self) -> Option<&str> {
        if let Misfit::Missing { key, .. } = &self.fault {
            Some(key)
        } else {
            None
        }
    }

    /// Whether the object at `pointer` lacks `key`.
    pub fn lacks(&self, pointer: &str, key: &str) -> bool {
        self.pointer == pointer && self.missing() == Some(key)
    }

    /// Whether the whole file is of another type.
    pub fn is_wrong_root(&self) -> bool {
        self.pointer.is_empty() && matches!(self.fault, Misfit::Type { .. })
    }

    /// The value that is there, where it as a whole does not fit.
    pub fn found(&self) -> Option<&Found> {
        match &self.fault {
            Misfit::Type { found, .. }
            | Misfit::Pattern { found, .. }
            | Misfit::Enum { found, .. }
            | Misfit::Range { found, .. } => Some(found),
            Misfit::Missing { .. } | Misfit::Length { .. } | Misfit::Other(_) => None,
        }
    }
}

/// Describes an error of a validator made from `schema`.
pub(super) fn describe(error: &ValidationError<'_>, schema: &Value) -> SchemaFault {
    let (closest, hidden) = closest(error);
    let keyword = closest.schema_path().to_string();
    let (fault, other_forms) = match alternatives(error) {
        Some(wanted) => (
            Misfit::Type {
                found: found(error.instance()),
                wanted,
                elements: None,
            },
            0,
        ),
        None => (misfit(closest, schema), hidden),
    };
    SchemaFault {
        pointer: closest.instance_path().to_string(),
        name: String::new(),
        description: description(&fault, schema, &keyword),
        keyword,
        fault,
        other_forms,
    }
}

/// Branches of an error that offers several forms.
fn branches<'e>(error: &'e ValidationError<'_>) -> &'e [Vec<ValidationError<'static>>] {
    match error.kind() {
        ValidationErrorKind::AnyOf { context } | ValidationErrorKind::OneOfNotValid { context } => {
            context
        }
        _ => &[],
    }
}

/// The error of the branch that comes closest, and how many branches it hides: the deepest counts,
/// then one of the right type, then the one with the fewest errors.
fn closest<'e>(error: &'e ValidationError<'_>) -> (&'e ValidationError<'e>, usize) {
    let branches = branches(error);
    let rank = |branch: &&Vec<ValidationError<'static>>| {
        let depth = branch
            .iter()
            .map(|error| depth(error))
            .max()
            .unwrap_or_default();
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

/// If every branch rejects the type of the value itself, the types of all.
fn alternatives(error: &ValidationError<'_>) -> Option<Vec<JsonType>> {
    let types = branches(error)
        .iter()
        .map(|branch| match branch.as_slice() {
            [inner] if inner.instance_path() == error.instance_path() => types(inner.kind()),
            _ => None,
        });
    let types = types.collect::<Option<Vec<_>>>()?.concat();
    (!types.is_empty()).then_some(types)
}

fn misfit(error: &ValidationError<'_>, schema: &Value) -> Misfit {
    let found = found(error.instance());
    let length = || error.instance().as_array().map_or(0, Vec::len);
    match error.kind() {
        kind @ ValidationErrorKind::Type { .. } => {
            let elements = elements(schema, &error.schema_path().to_string());
            Misfit::Type {
                found,
                wanted: types(kind).unwrap_or_default(),
                elements,
            }
        }
        ValidationErrorKind::Required { property } => Misfit::Missing {
            key: property.as_str().unwrap_or_default().to_owned(),
            and_more: false,
        },
        ValidationErrorKind::Pattern { .. } => Misfit::Pattern {
            found,
            form: text_at(schema, &error.schema_path().to_string(), "title"),
        },
        ValidationErrorKind::Enum { options } => {
            let options = options.as_array().map(Vec::as_slice).unwrap_or_default();
            Misfit::Enum {
                found,
                allowed: options.iter().map(Value::to_string).collect(),
            }
        }
        ValidationErrorKind::Constant { expected_value } => Misfit::Enum {
            found,
            allowed: vec![expected_value.to_string()],
        },
        ValidationErrorKind::MinItems { limit } => Misfit::Length {
            found: length(),
            bound: Bound::Least(limit.to_string()),
        },
        ValidationErrorKind::MaxItems { limit } => Misfit::Length {
            found: length(),
            bound: Bound::Most(limit.to_string()),
        },
        ValidationErrorKind::Minimum { limit } => Misfit::Range {
            found,
            bound: Bound::Least(limit.to_string()),
        },
        ValidationErrorKind::Maximum { limit } => Misfit::Range {
            found,
            bound: Bound::Most(limit.to_string()),
        },
        _ => Misfit::Other(error.to_string()),
    }
}

fn types(kind: &ValidationErrorKind) -> Option<Vec<JsonType>> {
    let ValidationErrorKind::Type { kind } = kind else {
        return None;
    };
    Some(match kind {
        TypeKind::Single(one) => vec![*one],
        TypeKind::Multiple(set) => {
            let mut types: Vec<JsonType> = set.iter().collect();
            // The usual form first: `null` only says that the key may be there without a value.
            types.sort_by_key(|kind| *kind == JsonType::Null);
            types
        }
    })
}

fn found(value: &Value) -> Found {
    match value {
        Value::Null => Found::Null,
        Value::Bool(value) => Found::Bool(*value),
        Value::Number(number) => Found::Number(number.to_string()),
        Value::String(text) => {
            Found::Text((text.chars().nth(QUOTED).is_none()).then(|| text.clone()))
        }
        Value::Array(elements) => Found::List {
            is_empty: elements.is_empty(),
        },
        Value::Object(_) => Found::Object,
    }
}

fn description(fault: &Misfit, schema: &Value, keyword: &str) -> Option<String> {
    let Misfit::Missing { key, .. } = fault else {
        return text_at(schema, keyword, "description");
    };
    let of_key = owner(schema, keyword)?.get("properties")?.get(key)?;
    of_key.get("description")?.as_str().map(str::to_owned)
}

/// The type of the elements of the list that the schema wants.
fn elements(schema: &Value, pointer: &str) -> Option<JsonType> {
    let items = owner(schema, pointer)?.get("items")?;
    let definition = items
        .get("$ref")
        .and_then(Value::as_str)
        .and_then(|place| place.strip_prefix('#'));
    let items = definition.map_or(Some(items), |place| schema.pointer(place))?;
    items.get("type")?.as_str()?.parse().ok()
}

/// The schema object that holds the keyword at `pointer`.
fn owner<'s>(schema: &'s Value, pointer: &str) -> Option<&'s Value> {
    let (object, _) = pointer.rsplit_once('/')?;
    schema.pointer(object)
}

/// A text of the schema object that holds the keyword at `pointer`.
fn text_at(schema: &Value, pointer: &str, member: &str) -> Option<String> {
    owner(schema, pointer)?
        .get(member)?
        .as_str()
        .map(str::to_owned)
}
