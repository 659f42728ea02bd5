//! Which slider shows a target, in words: `head/head-oval = 1`, or the corner of the macro sliders.

use crate::repo::{Body, FileFacts, Shown};

/// A setting that applies the target fully; `None` if nothing uses it.
pub(super) fn shown_by(body: &Body<'_>, file: &FileFacts) -> Option<String> {
    Some(match body.shown_at(file)? {
        Shown::At(sliders) => {
            sliders.iter().map(|(name, value)| format!("`{name}` = {value}")).collect::<Vec<_>>().join(", ")
        }
        Shown::Combination(name) => format!("the macro combination `{name}`"),
    })
}
