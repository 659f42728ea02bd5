//! A word that should be one of a few.

use mhlint_diag::nearest;

/// Says that a word is not known, which one may be meant, and which there are.
pub(super) fn not_one_of(what: &str, text: &str, known: &[&str]) -> String {
    let list = known.join(", ");
    nearest(text, known.iter().copied()).map_or_else(
        || format!("unknown {what} `{text}`; use one of: {list}"),
        |name| format!("unknown {what} `{text}`; did you mean `{name}`? (known: {list})"),
    )
}
