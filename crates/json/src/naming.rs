//! Names of places in a JSON that stay when elements are added before them: a pointer in which an
//! element of a list goes by its own name.

use super::Document;
use super::document::{Node, Value};
use super::finder::Sorted;
use mhlint_diag::{add_step, steps};

/// Members that name the object they stand in.
const NAMES: [&str; 2] = ["name", "title"];
/// Longest name of one step, in characters.
const LONGEST: usize = 48;

/// The pointer with names for positions in lists; `*` for an element without one. `sorted` is of
/// the same document.
pub(super) fn named(document: &Document, sorted: &mut Sorted, pointer: &str) -> String {
    let mut node = Some(&document.root);
    let mut out = String::new();
    for step in steps(pointer) {
        let next = node.and_then(|node| sorted.step(node, &step));
        let is_list = node.is_some_and(|node| matches!(node.value, Value::Array(_)));
        match next.filter(|_| is_list) {
            Some(element) => {
                out.push('/');
                out.extend(
                    element_name(element, sorted)
                        .as_deref()
                        .unwrap_or("*")
                        .chars()
                        .take(LONGEST),
                );
            }
            None => add_step(&mut out, &step),
        }
        node = next;
    }
    out
}

fn element_name(element: &Node, sorted: &mut Sorted) -> Option<String> {
    match &element.value {
        Value::Object(_) => {
            NAMES
                .iter()
                .find_map(|key| match &sorted.member(element, key)?.node.value {
                    Value::String(name) => Some(name.clone()),
                    _ => None,
                })
        }
        Value::String(text) => Some(text.clone()),
        Value::Number(number, _) => Some(number.to_string()),
        _ => None,
    }
}

/// The same for the end of a text that is broken behind it: the members and elements that are open
/// there.
pub(super) fn named_end(text: &[u8]) -> String {
    let mut open: Vec<Open> = Vec::new();
    let mut at = 0;
    while let Some(byte) = text.get(at) {
        let start = at;
        at += 1;
        match byte {
            b'{' | b'[' => open.push(Open {
                is_list: *byte == b'[',
                ..Open::default()
            }),
            b'}' | b']' => close(&mut open),
            b'"' => {
                at = string_end(text, at);
                let string = text.get(start + 1..at).unwrap_or_default();
                at += 1;
                open.last_mut()
                    .into_iter()
                    .for_each(|inner| inner.string(string));
            }
            b':' => open
                .last_mut()
                .into_iter()
                .for_each(|inner| inner.in_value = true),
            b',' => open
                .last_mut()
                .into_iter()
                .for_each(|inner| inner.in_value = false),
            byte if is_plain(*byte) => {
                at += text
                    .get(at..)
                    .unwrap_or_default()
                    .iter()
                    .take_while(|byte| is_plain(**byte))
                    .count();
                let word = text.get(start..at).unwrap_or_default();
                open.last_mut()
                    .filter(|inner| inner.is_list)
                    .into_iter()
                    .for_each(|inner| inner.element(word));
            }
            _ => {}
        }
    }
    let shown = |bytes: &[u8]| {
        String::from_utf8_lossy(bytes)
            .chars()
            .take(LONGEST)
            .collect::<String>()
    };
    open.iter()
        .map(|inner| format!("/{}:{}", shown(inner.name), shown(inner.last)))
        .collect::<Vec<_>>()
        .concat()
}

/// A list or object that is not closed.
#[derive(Default)]
struct Open<'t> {
    is_list: bool,
    in_value: bool,
    /// What it is called: its member `name`, or the first element of a list (the vertex of a
    /// weight).
    name: &'t [u8],
    /// The last key or element.
    last: &'t [u8],
}

impl<'t> Open<'t> {
    fn string(&mut self, text: &'t [u8]) {
        if self.is_list {
            self.element(text);
        } else if !self.in_value {
            self.last = text;
        } else if NAMES.iter().any(|key| key.as_bytes() == self.last) {
            self.name = text;
        }
    }

    fn element(&mut self, text: &'t [u8]) {
        self.last = text;
        if self.name.is_empty() {
            self.name = text;
        }
    }
}

fn close(open: &mut Vec<Open<'_>>) {
    let closed = open.pop();
    if let (Some(closed), Some(outer)) = (closed, open.last_mut().filter(|outer| outer.is_list)) {
        outer.last = closed.name;
    }
}

fn string_end(text: &[u8], from: usize) -> usize {
    let mut at = from;
    while let Some(byte) = text.get(at).filter(|byte| **byte != b'"') {
        at += if *byte == b'\\' { 2 } else { 1 };
    }
    at.min(text.len())
}

fn is_plain(byte: u8) -> bool {
    byte.is_ascii_alphanumeric() || matches!(byte, b'+' | b'-' | b'.')
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::parse;

    #[test]
    fn elements_go_by_their_names() {
        let document =
            parse(br#"{"a": [{"title": "x", "cat": 1}, [1, "two"], {}], "7": 0}"#).unwrap();
        let all = ["/a/0/cat", "/a/0/gone", "/a/1/1", "/a/2", "/7", ""]
            .map(|pointer| named(&document, &mut Sorted::default(), pointer));
        assert_eq!(all, ["/a/x/cat", "/a/x/gone", "/a/*/two", "/a/*", "/7", ""]);
    }

    #[test]
    fn the_end_of_a_broken_text_is_named_whatever_its_layout() {
        let ends = [
            (r#"{"a": [{"name": "x", "t": [0.5, 1"#, "/:a/:/x:t/0.5:1"),
            (
                "{\"a\":\n\n[ {\"name\":\"x\",\"t\":[ 0.5,1 ",
                "/:a/:/x:t/0.5:1",
            ),
            (
                r#"{"weights": {"head": [[158, 1.0], [159, 0.5]"#,
                "/:weights/:head/:159",
            ),
            (
                r#"{"weights": {"head": [[158, 1.0]"#,
                "/:weights/:head/:158",
            ),
            (r#"{"a": "b\"c", "d"#, "/:d"),
            ("]}", ""),
        ];
        for (text, name) in ends {
            assert_eq!(named_end(text.as_bytes()), name, "{text}");
        }
    }
}
