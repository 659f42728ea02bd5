//! What to do about a file of the program that is missing.

use mhlint_repo::{FileFacts, Layer};
use mhlint_source::file_name;

/// With other capitals it may be there: a second one beside it would be one too many.
pub(super) fn restoring(layer: &Layer, rel: &str) -> String {
    let other = layer.file_ignoring_case(rel).map(FileFacts::file_name);
    let name = file_name(rel);
    match other.filter(|other| other.eq_ignore_ascii_case(name)) {
        Some(other) => format!("rename `{other}` to `{name}`"),
        None => "restore the file from the download of the program".to_owned(),
    }
}
