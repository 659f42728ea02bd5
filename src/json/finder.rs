//! Many pointers into one text.

use std::collections::BTreeMap;
use std::ops::Range;

use super::document::{Document, Member, Node, steps};

/// Members of an object that are as soon gone through as sorted.
const FEW: usize = 16;

/// Numbers of the members by key, of equal ones the last, for each object by its first byte.
type Sorted = BTreeMap<usize, BTreeMap<String, usize>>;

/// A document of which many places are asked for: the keys of a large object are sorted when it is first passed through.
pub struct Finder {
    document: Document,
    sorted: Sorted,
}

impl Finder {
    /// Looks into a document.
    pub const fn new(document: Document) -> Self {
        Self { document, sorted: Sorted::new() }
    }

    /// The value a pointer leads to; of equal keys the last, as the applications see it.
    pub fn at(&mut self, pointer: &str) -> Option<&Node> {
        find(&self.document.root, &mut self.sorted, pointer)
    }

    /// Span of the key a pointer leads to.
    pub fn key_at(&mut self, pointer: &str) -> Option<Range<usize>> {
        let (parent, _) = pointer.rsplit_once('/')?;
        let key = steps(pointer).last()?;
        let object = find(&self.document.root, &mut self.sorted, parent)?;
        member(object, &mut self.sorted, &key).map(|member| member.key_span.clone())
    }
}

fn find<'n>(root: &'n Node, sorted: &mut Sorted, pointer: &str) -> Option<&'n Node> {
    steps(pointer).try_fold(root, |node, step| match member(node, sorted, &step) {
        Some(member) => Some(&member.node),
        None => node.elements().get(step.parse::<usize>().ok()?),
    })
}

fn member<'n>(node: &'n Node, sorted: &mut Sorted, key: &str) -> Option<&'n Member> {
    let members = node.members();
    if members.len() <= FEW {
        return node.member(key);
    }
    let numbered = || members.iter().enumerate().map(|(number, member)| (member.key.clone(), number)).collect();
    let by_key = sorted.entry(node.span.start).or_insert_with(numbered);
    members.get(*by_key.get(key)?)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::json::parse;

    #[test]
    fn places_are_found_as_in_the_document() {
        let many: Vec<String> = (0..40).map(|number| format!("\"k{}\": [{number}]", number % 30)).collect();
        let text = format!("{{\"a~/b\": {{{}}}, \"few\": {{\"k\": 1, \"k\": 2}}, \"list\": [7]}}", many.join(", "));
        let document = parse(text.as_bytes()).unwrap();
        let mut finder = Finder::new(document.clone());
        let pointers = ["", "/few/k", "/list/0", "/list/1", "/list/k", "/none", "/a~0~1b", "/a~0~1b/none", "/few/k/0"];
        let numbered = (0..40).map(|number| format!("/a~0~1b/k{number}"));
        for pointer in pointers.map(str::to_owned).into_iter().chain(numbered) {
            assert_eq!(finder.at(&pointer), document.at(&pointer), "{pointer}");
            assert_eq!(finder.key_at(&pointer), document.key_at(&pointer), "{pointer}");
        }
        assert_eq!(finder.at("/a~0~1b/k3/0").and_then(Node::as_i64), Some(33));
    }
}
