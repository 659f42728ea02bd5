//! Which slider shows a target, in words: `head/head-oval = 1`, or the corner of the macro sliders.

use mhlint_diag::{Finding, Place};
use mhlint_repo::{Body, FileFacts, Shown};

/// Adds a setting that applies the target fully, unless nothing uses it.
pub(super) fn with_setting(finding: Finding, body: &Body<'_>, file: &FileFacts) -> Finding {
    let setting = match body.shown_at(file) {
        Some(Shown::At(sliders)) => {
            let sliders: Vec<String> = sliders
                .iter()
                .map(|(name, value)| format!("{name} = {value}"))
                .collect();
            format!("set `{}` to see it", sliders.join(", "))
        }
        Some(Shown::Combination(name)) => format!("set the macro sliders to `{name}` to see it"),
        None => return finding,
    };
    finding.related(&file.path, Place::File, setting)
}
