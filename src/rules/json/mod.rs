//! Rules on the text and the shape of any JSON.

pub(super) mod duplicate_key;
pub(super) mod schema;
mod schema_words;
pub(super) mod syntax;
mod told_keys;
pub(super) mod too_deep;
pub(super) mod unknown_key;
