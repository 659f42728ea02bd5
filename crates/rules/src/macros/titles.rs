//! How messages name combinations and macro definitions. Both may have an empty name.

use mhlint_formats::macro_json::Macrodef;

/// A combination: its name, or that it is empty.
pub(super) fn combination(name: &str) -> String {
    if name.is_empty() {
        "the empty name".to_owned()
    } else {
        format!("`{name}`")
    }
}

/// A definition: its components, or its place where it has none.
pub(super) fn macrodef(macrodef: &Macrodef) -> String {
    if macrodef.components.is_empty() {
        format!("{} (no components)", macrodef.index)
    } else {
        format!("`{}`", macrodef.components.join("-"))
    }
}
