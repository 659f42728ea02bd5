//! Patterns that stand for the names of many targets.

use super::super::macros::combination_patterns::{cover, index, is_walkable};
use mhlint_repo::mpfb::Request;
use mhlint_repo::mpfb::loops::{Loop, Name};

/// Few patterns for the missing targets of a loop.
pub(super) fn patterns_of(
    own: &Loop,
    lists: &[Vec<Name<'_>>],
    missing: &[&Request<'_>],
) -> Vec<String> {
    let sizes: Vec<usize> = lists.iter().map(Vec::len).collect();
    if !is_walkable(&sizes) {
        return missing
            .iter()
            .map(|request| request.target.clone())
            .collect();
    }
    let mut member = vec![false; sizes.iter().product()];
    for request in missing {
        if let Some(cell) = member.get_mut(index(&sizes, &request.names)) {
            *cell = true;
        }
    }
    let word = |list: &[Name<'_>], values: &[usize]| {
        let words: Vec<&str> = values
            .iter()
            .filter_map(|value| list.get(*value))
            .map(|name| name.text)
            .collect();
        match words.as_slice() {
            [] => "*".to_owned(),
            [only] => (*only).to_owned(),
            several => format!("({})", several.join("|")),
        }
    };
    let patterns = cover(&sizes, &member).into_iter().map(|pattern| {
        let words: Vec<String> = lists
            .iter()
            .zip(&pattern.values)
            .map(|(list, values)| word(list, values))
            .collect();
        format!("{}{}", own.prefix, words.join("-"))
    });
    patterns.collect()
}
