//! Where values stand in a text, without a tree of it: files of weights become many times as large
//! as one.

use std::collections::BTreeMap;
use std::ops::Range;

use super::reader::{Reader, SyntaxFault};
use mhlint_diag::steps;

/// Values that are looked for, and where they stand: of equal keys the last, as the applications
/// see it.
#[derive(Debug, Default)]
pub struct Spans {
    value: Option<Range<usize>>,
    key: Option<Range<usize>>,
    below: BTreeMap<String, Self>,
}

impl Spans {
    /// Looks for the values that pointers lead to; none is found in a text that is not JSON.
    pub fn of<'p>(text: &[u8], pointers: impl Iterator<Item = &'p str>) -> Self {
        let mut spans = Self::default();
        for pointer in pointers {
            let mut at = &mut spans;
            for step in steps(pointer) {
                at = at.below.entry(step).or_default();
            }
        }
        let mut reader = Reader::new(text);
        let read = spans.read(&mut reader).and_then(|()| reader.finish());
        if read.is_err() {
            spans.forget();
        }
        spans
    }

    /// Span of the value that a pointer leads to.
    pub fn at(&self, pointer: &str) -> Option<Range<usize>> {
        self.find(pointer)?.value.clone()
    }

    /// Span of its key.
    pub fn key_at(&self, pointer: &str) -> Option<Range<usize>> {
        self.find(pointer)?.key.clone()
    }

    fn find(&self, pointer: &str) -> Option<&Self> {
        steps(pointer).try_fold(self, |spans, step| spans.below.get(&step))
    }

    fn forget(&mut self) {
        (self.value, self.key) = (None, None);
        self.below.values_mut().for_each(Self::forget);
    }

    /// Reads a value.
    fn read(&mut self, reader: &mut Reader<'_>) -> Result<(), SyntaxFault> {
        let next = reader.peek();
        let start = reader.offset();
        match next {
            Some(b'{') if !self.below.is_empty() => self.read_object(reader)?,
            Some(b'[') if !self.below.is_empty() => self.read_list(reader)?,
            _ => reader.pass()?,
        }
        self.value = Some(start..reader.offset());
        Ok(())
    }

    fn read_object(&mut self, reader: &mut Reader<'_>) -> Result<(), SyntaxFault> {
        reader.open()?;
        while reader.more(b'}')? {
            let (key, span) = reader.key()?;
            let Some(spans) = self.below.get_mut(&*key) else {
                reader.pass()?;
                continue;
            };
            spans.forget();
            spans.key = Some(span);
            spans.read(reader)?;
        }
        Ok(())
    }

    fn read_list(&mut self, reader: &mut Reader<'_>) -> Result<(), SyntaxFault> {
        let numbered = self
            .below
            .iter_mut()
            .filter_map(|(step, spans)| Some((step.parse::<usize>().ok()?, spans)));
        let mut wanted: BTreeMap<usize, &mut Self> = numbered.collect();
        reader.open()?;
        let mut at = 0;
        while reader.more(b']')? {
            match wanted.get_mut(&at) {
                Some(spans) => spans.read(reader)?,
                None => reader.pass()?,
            }
            at += 1;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::parse;

    #[test]
    fn places_are_those_of_the_document() {
        let text = r#" {"a~/b": {"k": [1], "k": [7, {"x": null}]}, "few": {"k": 1, "k": {"k": 2}}, "list": [7, "s"], "few": {"j": 0}} "#;
        let document = parse(text.as_bytes()).unwrap();
        let pointers = [
            "",
            "/a~0~1b",
            "/a~0~1b/k",
            "/a~0~1b/k/0",
            "/a~0~1b/k/1",
            "/a~0~1b/k/1/x",
            "/few",
            "/few/k",
            "/few/k/k",
            "/few/j",
            "/list/0",
            "/list/1",
            "/list/2",
            "/list/k",
            "/none",
        ];
        let spans = Spans::of(text.as_bytes(), pointers.into_iter());
        for pointer in pointers {
            assert_eq!(
                spans.at(pointer),
                document.at(pointer).map(|node| node.span.clone()),
                "{pointer}"
            );
        }
        assert_eq!(
            spans.key_at("/few/j").map(|span| &text[span]),
            Some("\"j\"")
        );
        assert_eq!(
            (
                spans.key_at(""),
                spans.key_at("/few/k"),
                spans.key_at("/list/0")
            ),
            (None, None, None)
        );
    }

    #[test]
    fn nothing_is_found_in_what_is_no_json() {
        assert_eq!(
            Spans::of(b"{\"a\": 1, \"b\"", ["/a"].into_iter()).at("/a"),
            None
        );
    }
}
