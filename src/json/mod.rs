//! JSON as the applications read it, with positions.
//!
//! Python's dialect (`NaN`, `Infinity`, duplicate keys with the last one winning) plus byte spans of
//! every value, which `serde_json` does not keep. No asset knowledge here.

mod document;
mod edit;
mod finder;
mod long_keys;
mod naming;
mod reader;
mod room;
mod schema;
mod schema_fault;
mod spans;
mod syntax_text;
mod unknown_key;

pub(crate) use jsonschema::JsonType as Shape;

pub(crate) use document::{Document, Duplicate, Member, Node, Value, parse};
pub(crate) use edit::{removals, remove_elements, set_key, set_value};
pub(crate) use finder::Finder;
pub(crate) use reader::{Reader, SyntaxFault, SyntaxKind};
pub(crate) use schema::{SchemaFaults, UnknownKey, check, schema_names, schema_text};
pub(crate) use schema_fault::{Bound, Found, Misfit, SchemaFault};
pub(crate) use spans::Spans;
