//! Changes of a JSON text that leave every other byte as it is: a value, elements of a list.

use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;

use super::{Finder, Node};
use mhlint_diag::Edit;

/// Puts a text, or `null`, in the place of the value at `pointer`.
pub fn set_value(finder: &mut Finder, pointer: &str, text: Option<&str>) -> Option<Edit> {
    let node = finder.at(pointer)?;
    let value = text.map_or(serde_json::Value::Null, Into::into).to_string();
    (node.as_str() != text).then(|| Edit::replacement(node.span.clone(), value))
}

/// Gives the member at `pointer` another key.
pub fn set_key(finder: &mut Finder, pointer: &str, key: &str) -> Option<Edit> {
    Some(Edit::replacement(
        finder.key_at(pointer)?,
        serde_json::Value::from(key).to_string(),
    ))
}

/// Takes the elements at `pointers` out of their lists.
pub fn remove_elements(text: &[u8], finder: &mut Finder, pointers: &[&str]) -> Vec<Edit> {
    let mut by_list: BTreeMap<&str, BTreeSet<usize>> = BTreeMap::new();
    for (list, position) in pointers
        .iter()
        .filter_map(|pointer| pointer.rsplit_once('/'))
    {
        by_list
            .entry(list)
            .or_default()
            .extend(position.parse::<usize>());
    }
    let mut edits = Vec::new();
    for (pointer, gone) in by_list {
        if let Some(list) = finder.at(pointer) {
            let span = |at: usize| list.elements().get(at).map(|element| element.span.clone());
            edits.extend(removals(text, list, (list.elements().len(), &span), &gone));
        }
    }
    edits
}

/// How many parts there are, and where each of them stands.
pub(crate) type Spans<'p> = (usize, &'p dyn Fn(usize) -> Option<Range<usize>>);

/// Takes parts out of a list or object: the parts at the positions `gone`, with one comma each.
///
/// A part that shares its line with the one before leaves that line; a part alone on its lines
/// takes them along.
pub fn removals(text: &[u8], whole: &Node, parts: Spans<'_>, gone: &BTreeSet<usize>) -> Vec<Edit> {
    let (count, _) = parts;
    let gone = || gone.range(..count).copied();
    if count > 0 && gone().count() == count {
        return vec![Edit::removal(
            whole.span.start + 1..whole.span.end.saturating_sub(1),
        )];
    }
    let mut runs: Vec<Range<usize>> = Vec::new();
    for at in gone() {
        match runs.last_mut().filter(|run| run.end == at) {
            Some(run) => run.end += 1,
            None => runs.push(at..at + 1),
        }
    }
    runs.into_iter()
        .filter_map(|run| run_removal(text, parts, run))
        .collect()
}

/// Takes neighbouring parts out; others remain.
fn run_removal(text: &[u8], (_, part): Spans<'_>, run: Range<usize>) -> Option<Edit> {
    let first = part(run.start)?;
    let last = part(run.end.checked_sub(1)?)?;
    let before = run.start.checked_sub(1).and_then(part);
    let shares_line = |before: &Range<usize>| {
        text.get(before.end..first.start)
            .is_some_and(|between| !between.iter().any(|byte| matches!(byte, b'\n' | b'\r')))
    };
    match (before, part(run.end)) {
        (Some(before), Some(_)) if shares_line(&before) => {
            Some(Edit::removal(before.end..last.end))
        }
        (_, Some(next)) => Some(Edit::removal(first.start..next.start)),
        (Some(before), None) => Some(Edit::removal(before.end..last.end)),
        (None, None) => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::parse;

    fn edited(text: &str, mut edits: Vec<Edit>) -> String {
        edits.sort_by_key(|edit| std::cmp::Reverse(edit.range.start));
        let mut bytes = text.as_bytes().to_vec();
        for edit in edits {
            bytes.splice(edit.range, edit.text);
        }
        String::from_utf8(bytes).unwrap()
    }

    fn without(text: &str, pointers: &[&str]) -> String {
        edited(
            text,
            remove_elements(
                text.as_bytes(),
                &mut Finder::new(parse(text.as_bytes()).unwrap()),
                pointers,
            ),
        )
    }

    #[test]
    fn a_value_changes_and_its_surroundings_do_not() {
        let text = "{ \"a\" : [ \"x\\\\y\",1.50 ] }";
        let mut finder = Finder::new(parse(text.as_bytes()).unwrap());
        let mut set = |value| {
            edited(
                text,
                set_value(&mut finder, "/a/0", value).into_iter().collect(),
            )
        };
        assert_eq!(set(Some("x/y")), "{ \"a\" : [ \"x/y\",1.50 ] }");
        assert_eq!(set(Some("\"")), "{ \"a\" : [ \"\\\"\",1.50 ] }");
        assert_eq!(set(None), "{ \"a\" : [ null,1.50 ] }");
        assert_eq!(set(Some("x\\y")), text, "nothing to do");
    }

    #[test]
    fn elements_on_one_line_leave_it() {
        assert_eq!(without("[1, 2,  3]", &["/0"]), "[2,  3]");
        assert_eq!(without("[1, 2,  3]", &["/1"]), "[1,  3]");
        assert_eq!(without("[1, 2,  3]", &["/2", "/1"]), "[1]");
        assert_eq!(without("[1, 2,  3]", &["/2", "/0"]), "[2]");
        assert_eq!(without("[ 1 ]", &["/0"]), "[]");
    }

    #[test]
    fn elements_take_their_own_lines_along() {
        assert_eq!(without("[\n  1,\n  2,\n  3\n]", &["/1"]), "[\n  1,\n  3\n]");
        assert_eq!(without("[\n  1,\n  2,\n  3\n]", &["/2"]), "[\n  1,\n  2\n]");
        assert_eq!(
            without("[\n  1, 2,\n  3, 4\n]", &["/1"]),
            "[\n  1,\n  3, 4\n]"
        );
        assert_eq!(
            without("[\n  1, 2,\n  3, 4\n]", &["/2"]),
            "[\n  1, 2,\n  4\n]"
        );
    }

    #[test]
    fn what_is_not_there_is_left_alone() {
        assert_eq!(without("[1]", &["/7", "/x", "/0/0", ""]), "[1]");
    }
}
