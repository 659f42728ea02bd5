//! JSON as the applications read it, with positions.
//!
//! Python's dialect (`NaN`, `Infinity`, duplicate keys with the last one winning) plus byte spans
//! of every value, which `serde_json` does not keep. No asset knowledge here.

// Only a few modules may use files, streams and the environment, and they allow this lint
// themselves; tests may use everything.
#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

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

pub use jsonschema::JsonType as Shape;

pub use document::{Document, Duplicate, Member, Node, Value, parse};
pub use edit::{removals, remove_elements, set_key, set_value};
pub use finder::Finder;
pub use reader::{Reader, SyntaxFault, SyntaxKind};
pub use schema::{SchemaFaults, UnknownKey, check, schema_names, schema_text};
pub use schema_fault::{Bound, Found, Misfit, SchemaFault};
pub use spans::Spans;
