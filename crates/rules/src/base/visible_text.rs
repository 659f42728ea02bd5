//! `visible groups` as one text: Python's `in` asks a text for parts, a list for elements.

use super::super::Rule;
use mhlint_diag::{Evidence, Finding, Level, Place};
use mhlint_repo::FileFacts;

/// The key.
pub(super) const MEMBER: &str = "visible groups";
/// What follows where no group is drawn.
pub(super) const INVISIBLE: &str = "shows no figure and a height of 0 cm, without a message; \
    the glTF export crashes with `ValueError`";

/// Letters of a text in which all groups of the mesh are looked for: groups times letters have no
/// end. Texts of real files have a few dozen.
const LOOKED_AT: usize = 4096;

/// The finding on a text, of a mesh that draws the faces of `drawn`.
pub(super) fn finding<'m>(
    rule: &Rule,
    file: &FileFacts,
    text: &str,
    drawn: impl Iterator<Item = &'m str>,
) -> Finding {
    let end = text.char_indices().nth(LOOKED_AT).map(|(end, _)| end);
    let looked_at = end.and_then(|end| text.get(..end)).unwrap_or(text);
    let shown: Vec<&str> = drawn.filter(|group| looked_at.contains(*group)).collect();
    let finding = |message: String| {
        let names: Vec<String> = text
            .split_whitespace()
            .map(|name| format!("\"{name}\""))
            .collect();
        let help = format!("write a list: `[{}]`", names.join(", "));
        rule.at(file, Place::pointer([MEMBER]), message)
            .key(MEMBER)
            .help(help)
    };
    if shown.is_empty() && end.is_none() {
        return finding(format!(
            "`visible groups` is the string `{text}`, which contains no group name"
        ))
        .effect(INVISIBLE);
    }
    let level = if shown == [text] {
        Level::Info
    } else {
        Level::Warning
    };
    let finding = finding("`visible groups` is a string, expected a list".to_owned())
        .level(level)
        .effect("draws every group whose name is part of the string");
    if shown.is_empty() {
        return finding;
    }
    finding.evidence(Evidence::of_cases(shown))
}
