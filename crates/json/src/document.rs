//! A JSON text as a tree in which every value knows its bytes.

use std::ops::Range;

use serde_json::Value as Plain;

use super::reader::{Reader, SyntaxFault};
use super::room::Room;
use mhlint_diag::{add_step, steps};

/// A parsed text.
#[derive(Debug, Clone, PartialEq)]
pub struct Document {
    /// The top level value.
    pub root: Node,
    /// Keys that occur more than once in one object.
    pub duplicates: Vec<Duplicate>,
    /// How many more of them there are.
    pub duplicates_left_out: usize,
    /// Spans of `NaN` and the infinities.
    pub specials: Vec<Range<usize>>,
}

/// A key given twice; the earlier value is lost.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Duplicate {
    /// Pointer to the member.
    pub pointer: String,
    /// Span of the key whose value is lost.
    pub lost: Range<usize>,
    /// Span of the key that wins.
    pub kept: Range<usize>,
    /// Whether both values are the same, so that nothing is lost.
    pub equal: bool,
}

/// A value and where it stands.
#[derive(Debug, Clone, PartialEq)]
pub struct Node {
    /// Its bytes in the text.
    pub span: Range<usize>,
    /// The value.
    pub value: Value,
}

/// A JSON value.
#[derive(Debug, Clone, PartialEq)]
pub enum Value {
    /// `null`.
    Null,
    /// `true` or `false`.
    Bool(bool),
    /// Any number; the flag tells one that is written as an integer.
    Number(f64, bool),
    /// A string.
    String(String),
    /// An array.
    Array(Vec<Node>),
    /// An object, members in order of the text, duplicates included.
    Object(Vec<Member>),
}

/// A member of an object.
#[derive(Debug, Clone, PartialEq)]
pub struct Member {
    /// The key.
    pub key: String,
    /// Bytes of the key with its quotes.
    pub key_span: Range<usize>,
    /// The value.
    pub node: Node,
}

/// Parses a whole text.
///
/// # Errors
/// The first place at which it is no JSON.
pub fn parse(text: &[u8]) -> Result<Document, SyntaxFault> {
    let reader = Reader::new(text);
    let mut builder = Builder {
        reader,
        duplicates: Vec::new(),
        room: Room::default(),
        pointer: String::new(),
    };
    let root = builder.value()?;
    builder.reader.finish()?;
    let Builder {
        reader,
        duplicates,
        room: Room { left_out, .. },
        ..
    } = builder;
    Ok(Document {
        root,
        duplicates,
        duplicates_left_out: left_out,
        specials: reader.specials,
    })
}

impl Document {
    /// The value a pointer leads to; of equal keys the last, as the applications see it.
    pub fn at(&self, pointer: &str) -> Option<&Node> {
        steps(pointer).try_fold(&self.root, |node, step| node.step(&step))
    }
}

impl Node {
    /// Member of an object by key; the last of equal ones.
    pub fn member(&self, key: &str) -> Option<&Member> {
        self.members().iter().rev().find(|member| member.key == key)
    }

    /// Value of a member by key; the last of equal ones.
    pub fn get(&self, key: &str) -> Option<&Self> {
        self.member(key).map(|member| &member.node)
    }

    /// Members of an object; empty for anything else.
    pub fn members(&self) -> &[Member] {
        if let Value::Object(members) = &self.value {
            members
        } else {
            &[]
        }
    }

    /// Members as the applications see them: of equal keys the value of the last at the place of
    /// the first.
    pub fn effective_members(&self) -> Vec<&Member> {
        let mut effective: Vec<&Member> = Vec::with_capacity(self.members().len());
        let mut seen = std::collections::BTreeMap::new();
        for member in self.members() {
            match seen.entry(member.key.as_str()) {
                std::collections::btree_map::Entry::Vacant(slot) => {
                    slot.insert(effective.len());
                    effective.push(member);
                }
                std::collections::btree_map::Entry::Occupied(slot) => {
                    if let Some(place) = effective.get_mut(*slot.get()) {
                        *place = member;
                    }
                }
            }
        }
        effective
    }

    /// Elements of an array; empty for anything else.
    pub fn elements(&self) -> &[Self] {
        if let Value::Array(elements) = &self.value {
            elements
        } else {
            &[]
        }
    }

    /// The text of a string.
    pub fn as_str(&self) -> Option<&str> {
        if let Value::String(text) = &self.value {
            Some(text)
        } else {
            None
        }
    }

    /// Bytes in the file of a part of a string's text: exact where nothing is escaped, else the
    /// whole value.
    pub fn span_of_text(&self, part: Range<usize>) -> Range<usize> {
        match self.as_str() {
            Some(text) if text.len() + 2 == self.span.len() && part.end <= text.len() => {
                self.span.start + 1 + part.start..self.span.start + 1 + part.end
            }
            _ => self.span.clone(),
        }
    }

    /// The value of a number; `true` counts 1 and `false` 0, as they do in Python.
    pub fn as_python_number(&self) -> Option<f64> {
        match &self.value {
            Value::Number(number, _) => Some(*number),
            Value::Bool(value) => Some(f64::from(u8::from(*value))),
            _ => None,
        }
    }

    /// The value of a number.
    pub fn as_f64(&self) -> Option<f64> {
        if let Value::Number(number, _) = self.value {
            Some(number)
        } else {
            None
        }
    }

    /// The value of a number that is written as an integer; beyond 64 bits it saturates.
    pub fn as_i64(&self) -> Option<i64> {
        match self.value {
            #[expect(
                clippy::cast_possible_truncation,
                reason = "saturates, which is as far out of any range"
            )]
            Value::Number(number, true) => Some(number as i64),
            _ => None,
        }
    }

    /// The value without places: of equal keys the last, and for `NaN` and infinities what stands
    /// for them.
    pub fn plain(&self, non_finite: &Plain) -> Plain {
        match &self.value {
            Value::Null => Plain::Null,
            Value::Bool(value) => Plain::Bool(*value),
            Value::Number(number, false) if !number.is_finite() => non_finite.clone(),
            Value::Number(number, _) => self
                .as_i64()
                .map_or_else(|| Plain::from(*number), Plain::from),
            Value::String(text) => Plain::from(text.as_str()),
            Value::Array(elements) => elements
                .iter()
                .map(|element| element.plain(non_finite))
                .collect(),
            Value::Object(members) => members
                .iter()
                .map(|member| (member.key.clone(), member.node.plain(non_finite)))
                .collect(),
        }
    }

    /// Whether this is an object.
    pub fn is_object(&self) -> bool {
        matches!(self.value, Value::Object(_))
    }

    /// Whether this is an array.
    pub fn is_array(&self) -> bool {
        matches!(self.value, Value::Array(_))
    }

    /// What kind of value it is, for people.
    pub fn type_word(&self) -> &'static str {
        match &self.value {
            Value::Null => "null",
            Value::Bool(_) => "true or false",
            Value::Number(..) => "a number",
            Value::String(_) => "a string",
            Value::Array(_) => "a list",
            Value::Object(_) => "an object",
        }
    }

    /// Whether Python would treat the value as false: `null`, `false`, 0, empty.
    pub fn is_falsy(&self) -> bool {
        match &self.value {
            Value::Null => true,
            Value::Bool(value) => !value,
            Value::Number(number, _) => *number == 0.0,
            Value::String(text) => text.is_empty(),
            Value::Array(elements) => elements.is_empty(),
            Value::Object(members) => members.is_empty(),
        }
    }

    /// Whether both hold the same, wherever they stand.
    fn is_same(&self, other: &Self) -> bool {
        match (&self.value, &other.value) {
            (Value::Array(a), Value::Array(b)) => {
                a.len() == b.len() && a.iter().zip(b).all(|(a, b)| a.is_same(b))
            }
            (Value::Object(a), Value::Object(b)) => {
                let same = |(a, b): (&Member, &Member)| a.key == b.key && a.node.is_same(&b.node);
                a.len() == b.len() && a.iter().zip(b).all(same)
            }
            (a, b) => a == b,
        }
    }

    fn step(&self, step: &str) -> Option<&Self> {
        self.get(step)
            .or_else(|| self.elements().get(step.parse::<usize>().ok()?))
    }
}

struct Builder<'a> {
    reader: Reader<'a>,
    duplicates: Vec<Duplicate>,
    room: Room,
    pointer: String,
}

impl Builder<'_> {
    fn value(&mut self) -> Result<Node, SyntaxFault> {
        let first = self.reader.peek();
        let start = self.reader.offset();
        let value = match first {
            Some(b'{') => self.object()?,
            Some(b'[') => self.array()?,
            Some(b'"') => Value::String(self.reader.string()?.into_owned()),
            _ => self.scalar()?,
        };
        Ok(Node {
            span: start..self.reader.offset(),
            value,
        })
    }

    fn scalar(&mut self) -> Result<Value, SyntaxFault> {
        if let Some((number, integer)) = self.reader.number()? {
            return Ok(Value::Number(number, integer));
        }
        for (word, value) in [
            ("null", Value::Null),
            ("true", Value::Bool(true)),
            ("false", Value::Bool(false)),
        ] {
            if self.reader.literal(word) {
                return Ok(value);
            }
        }
        Err(self.reader.expected("a value"))
    }

    fn array(&mut self) -> Result<Value, SyntaxFault> {
        self.reader.open()?;
        let mut elements = Vec::new();
        while self.reader.more(b']')? {
            let length = self.descend(&elements.len().to_string());
            elements.push(self.value()?);
            self.pointer.truncate(length);
        }
        Ok(Value::Array(elements))
    }

    fn object(&mut self) -> Result<Value, SyntaxFault> {
        self.reader.open()?;
        let mut members: Vec<Member> = Vec::new();
        while self.reader.more(b'}')? {
            let (key, key_span) = self.reader.key()?;
            let length = self.descend(&key);
            let node = self.value()?;
            self.pointer.truncate(length);
            members.push(Member {
                key: key.into_owned(),
                key_span,
                node,
            });
        }
        self.note_duplicates(&members);
        Ok(Value::Object(members))
    }

    fn descend(&mut self, step: &str) -> usize {
        let length = self.pointer.len();
        add_step(&mut self.pointer, step);
        length
    }

    fn note_duplicates(&mut self, members: &[Member]) {
        let mut last = std::collections::BTreeMap::new();
        for member in members {
            if let Some(lost) = last.insert(member.key.as_str(), member)
                && self.room.takes_one()
            {
                let length = self.descend(&member.key);
                self.room.take(&self.pointer);
                self.duplicates.push(Duplicate {
                    pointer: self.pointer.clone(),
                    lost: lost.key_span.clone(),
                    kept: member.key_span.clone(),
                    equal: lost.node.is_same(&member.node),
                });
                self.pointer.truncate(length);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::super::SyntaxKind;
    use super::*;

    fn kind(text: &str) -> SyntaxKind {
        parse(text.as_bytes()).unwrap_err().kind
    }

    #[test]
    fn values_keep_their_spans() {
        let document = parse(br#" {"a": [1, 2.5, "x/y"], "a~/b": null} "#).unwrap();
        assert_eq!(document.at("/a/1").unwrap().as_f64(), Some(2.5));
        assert_eq!(document.at("/a/2").unwrap().span, 16..21);
        assert_eq!(document.at("/a/0").unwrap().as_i64(), Some(1));
        assert_eq!(document.at("/a/1").unwrap().as_i64(), None);
    }

    #[test]
    fn the_last_of_equal_keys_wins_and_is_noted() {
        let document = parse(br#"{"a": {"b": 1, "c": 2, "b": 3}}"#).unwrap();
        assert_eq!(document.at("/a/b").unwrap().as_i64(), Some(3));
        assert_eq!(document.duplicates.len(), 1);
        assert_eq!(
            (
                document.duplicates[0].pointer.as_str(),
                document.duplicates[0].equal
            ),
            ("/a/b", false)
        );
        let twins = parse(br#"{"a": [{"b": 1}], "a":[{"b":1}]}"#).unwrap();
        assert!(twins.duplicates[0].equal);
        let keys: Vec<_> = document
            .root
            .get("a")
            .unwrap()
            .effective_members()
            .iter()
            .map(|m| &m.key)
            .collect();
        assert_eq!(keys, ["b", "c"]);
    }

    #[test]
    fn python_numbers_are_read_and_noted() {
        let document = parse(b"[NaN, -Infinity, 1e400, 007]").unwrap_err();
        assert!(matches!(document.kind, SyntaxKind::Expected { .. }));
        let document = parse(b"[NaN, -Infinity, 1e400]").unwrap();
        assert_eq!(document.specials, [1..4, 6..15]);
        assert_eq!(document.root.elements()[2].as_f64(), Some(f64::INFINITY));
    }

    #[test]
    fn faults_are_named() {
        assert_eq!(kind("[1, 2,]"), SyntaxKind::TrailingComma);
        assert_eq!(kind("[1, // x\n2]"), SyntaxKind::Comment);
        assert_eq!(kind("{} x"), SyntaxKind::TrailingText);
        assert!(matches!(kind("[1"), SyntaxKind::UnexpectedEnd(_)));
        assert!(matches!(kind("[\"a\nb\"]"), SyntaxKind::BadString(_)));
        assert!(matches!(kind("[-]"), SyntaxKind::Expected { .. }));
        assert_eq!(kind(&"[".repeat(1_000_000)), SyntaxKind::TooDeep);
    }

    #[test]
    fn escapes_become_characters() {
        let document = parse(br#""a\u00e9\ud83d\ude00\n\ud800""#).unwrap();
        assert_eq!(document.root.as_str(), Some("aé😀\n\u{fffd}"));
    }

    #[test]
    fn a_part_of_a_text_has_its_bytes_unless_something_is_escaped() {
        let document = parse(br#"["abc", "a\nc"]"#).unwrap();
        let spans = document
            .root
            .elements()
            .iter()
            .map(|node| node.span_of_text(1..2));
        assert_eq!(spans.collect::<Vec<_>>(), [3..4, 8..14]);
    }

    #[test]
    fn truncation_at_any_byte_is_a_fault() {
        let text = br#"{"a": [1, -2.5e3, "x\u0041", true, null], "b": {}}"#;
        for length in 0..text.len() {
            assert!(parse(&text[..length]).is_err(), "{length}");
        }
    }

    proptest! {
        #[test]
        fn no_text_stops_the_reader(bytes in prop::collection::vec(any::<u8>(), 0..200)) {
            let _ = parse(&bytes);
        }

        #[test]
        fn texts_of_json_signs_agree_with_the_library(text in r#"[\[\]{},:"0-9.eE+\- \\untrealsf]{0,24}"#) {
            let ours = parse(text.as_bytes());
            if serde_json::from_str::<serde_json::Value>(&text).is_ok() {
                prop_assert!(ours.is_ok(), "{text}");
            } else if let Ok(document) = ours {
                // Python takes numbers beyond the range of f64 and lone surrogates; nothing else is
                // let through.
                let beyond = text.contains(['e', 'E']) || text.contains("\\u");
                prop_assert!(beyond || !document.specials.is_empty(), "{text}");
            }
        }
    }
}
