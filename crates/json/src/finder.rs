//! Many pointers into one text.

use std::collections::BTreeMap;
use std::ops::Range;

use super::document::{Document, Member, Node};
use mhlint_diag::steps;

/// Members of an object that are as soon gone through as sorted.
const FEW: usize = 16;

/// Members of large objects by key, sorted when one is first passed through.
#[derive(Default)]
pub(super) struct Sorted {
    /// Numbers of the members, of equal ones the last, for each object by its first byte.
    objects: BTreeMap<usize, BTreeMap<String, usize>>,
    /// Members gone through: a bound on the work, for tests.
    #[cfg(test)]
    passed: usize,
}

/// A document of which many places are asked for.
pub struct Finder {
    document: Document,
    sorted: Sorted,
}

impl Finder {
    /// Looks into a document.
    pub fn new(document: Document) -> Self {
        Self {
            document,
            sorted: Sorted::default(),
        }
    }

    /// The value a pointer leads to; of equal keys the last, as the applications see it.
    pub fn at(&mut self, pointer: &str) -> Option<&Node> {
        self.sorted.find(&self.document.root, pointer)
    }

    /// Span of the key a pointer leads to.
    pub fn key_at(&mut self, pointer: &str) -> Option<Range<usize>> {
        let (parent, _) = pointer.rsplit_once('/')?;
        let key = steps(pointer).last()?;
        let object = self.sorted.find(&self.document.root, parent)?;
        self.sorted
            .member(object, &key)
            .map(|member| member.key_span.clone())
    }
}

impl Sorted {
    fn find<'n>(&mut self, root: &'n Node, pointer: &str) -> Option<&'n Node> {
        steps(pointer).try_fold(root, |node, step| self.step(node, &step))
    }

    /// A member of an object, or an element of a list.
    pub(super) fn step<'n>(&mut self, node: &'n Node, step: &str) -> Option<&'n Node> {
        match self.member(node, step) {
            Some(member) => Some(&member.node),
            None => node.elements().get(step.parse::<usize>().ok()?),
        }
    }

    pub(super) fn member<'n>(&mut self, node: &'n Node, key: &str) -> Option<&'n Member> {
        let members = node.members();
        #[cfg(test)]
        if members.len() <= FEW || !self.objects.contains_key(&node.span.start) {
            self.passed += members.len();
        }
        if members.len() <= FEW {
            return node.member(key);
        }
        let numbered = || {
            members
                .iter()
                .enumerate()
                .map(|(number, member)| (member.key.clone(), number))
                .collect()
        };
        let by_key = self.objects.entry(node.span.start).or_insert_with(numbered);
        members.get(*by_key.get(key)?)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::parse;

    #[test]
    fn places_are_found_as_in_the_document() {
        let many: Vec<String> = (0..40)
            .map(|number| format!("\"k{}\": [{number}]", number % 30))
            .collect();
        let text = format!(
            "{{\"a~/b\": {{{}}}, \"few\": {{\"k\": 1, \"k\": 2}}, \"list\": [7]}}",
            many.join(", ")
        );
        let document = parse(text.as_bytes()).unwrap();
        let mut finder = Finder::new(document.clone());
        let pointers = [
            "",
            "/few/k",
            "/list/0",
            "/list/1",
            "/list/k",
            "/none",
            "/a~0~1b",
            "/a~0~1b/none",
            "/few/k/0",
        ];
        let numbered = (0..40).map(|number| format!("/a~0~1b/k{number}"));
        for pointer in pointers.map(str::to_owned).into_iter().chain(numbered) {
            assert_eq!(finder.at(&pointer), document.at(&pointer), "{pointer}");
        }
        assert_eq!(finder.at("/a~0~1b/k3/0").and_then(Node::as_i64), Some(33));
        for (pointer, key) in [
            ("/a~0~1b", "\"a~/b\""),
            ("/few/k", "\"k\""),
            ("/a~0~1b/k3", "\"k3\""),
        ] {
            let last = text.rfind(&format!("{key}: "));
            assert_eq!(
                finder
                    .key_at(pointer)
                    .map(|span| (Some(span.start), &text[span])),
                last.map(|at| (Some(at), key))
            );
        }
        assert_eq!(
            (
                finder.key_at(""),
                finder.key_at("/none"),
                finder.key_at("/list/0")
            ),
            (None, None, None)
        );
    }

    #[test]
    fn members_are_gone_through_once_however_many_are_asked_for() {
        let members = |value: &str| {
            (0..20_000)
                .map(|at| format!("\"k{at}\": {value}"))
                .collect::<Vec<_>>()
                .join(", ")
        };
        let text = format!(
            "{{\"wide\": {{{}}}, \"deep\": {{{}}}}}",
            members("7"),
            members("{\"default\": \"x\"}")
        );
        let mut finder = Finder::new(parse(text.as_bytes()).unwrap());
        for at in 0..20_000 {
            assert!(finder.at(&format!("/wide/k{at}")).is_some());
            assert!(finder.at(&format!("/deep/k{at}/default")).is_some());
            assert!(finder.key_at(&format!("/wide/k{at}")).is_some());
        }
        // The two large objects once; the top and the object with one member each time.
        assert_eq!(finder.sorted.passed, 2 * 20_000 + 3 * 20_000 * 2 + 20_000);
    }
}
