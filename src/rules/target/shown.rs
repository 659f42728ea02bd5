//! Which slider shows a target, in words: `head/head-oval = 1`, or the corner of the macro sliders.

use crate::repo::{Body, FileFacts, Shown};

/// The end of a message: a setting that applies the target fully; empty if nothing uses it.
pub(super) fn shown_by(body: &Body<'_>, file: &FileFacts) -> String {
    let setting = match body.shown_at(file) {
        Some(Shown::At(sliders)) => {
            sliders.iter().map(|(name, value)| format!("`{name}` = {value}")).collect::<Vec<_>>().join(", ")
        }
        Some(Shown::Combination(name)) => format!("the macro combination `{name}`"),
        None => return String::new(),
    };
    format!("; seen with {setting}")
}
