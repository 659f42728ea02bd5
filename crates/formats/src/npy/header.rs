//! The header of a `.npy`: a dictionary written as Python would print it.
//!
//! Knows just what such a header is made of: texts, whole numbers, tuples, lists, dictionaries and
//! bare words. Nothing is evaluated. Gets the text, returns the dictionary, or nothing if it is no
//! literal.

/// A value of the header.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Literal {
    /// A text in quotes, or a bare word (`True`).
    Text(String),
    /// A whole number.
    Number(u64),
    /// A tuple or list.
    Items(Vec<Literal>),
    /// A dictionary.
    Members(Vec<(Literal, Literal)>),
}

/// Fields of a dtype can hold dtypes; nobody nests them further than this.
const DEPTH: usize = 16;

/// Parses the text of a header.
pub(super) fn parse_header(text: &[u8]) -> Option<Literal> {
    let mut cursor = Cursor { text, at: 0 };
    let value = cursor.value(DEPTH)?;
    (cursor.peek().is_none() && matches!(value, Literal::Members(_))).then_some(value)
}

impl Literal {
    /// A member of a dictionary.
    pub(super) fn get(&self, key: &str) -> Option<&Self> {
        let Self::Members(members) = self else {
            return None;
        };
        members
            .iter()
            .rev()
            .find(|(name, _)| name.text() == Some(key))
            .map(|(_, value)| value)
    }

    pub(super) fn text(&self) -> Option<&str> {
        if let Self::Text(text) = self {
            Some(text)
        } else {
            None
        }
    }

    pub(super) fn number(&self) -> Option<u64> {
        if let Self::Number(number) = self {
            Some(*number)
        } else {
            None
        }
    }

    /// Items of a tuple or list; of anything else none.
    pub(super) fn items(&self) -> &[Self] {
        if let Self::Items(items) = self {
            items
        } else {
            &[]
        }
    }

    /// Whether the type texts hold one that fits: the value itself, or the second part of a field.
    pub(super) fn any_text(&self, fits: &dyn Fn(&str) -> bool) -> bool {
        match self {
            Self::Text(text) => fits(text),
            Self::Items(fields) => fields
                .iter()
                .filter_map(|field| field.items().get(1))
                .any(|kind| kind.any_text(fits)),
            _ => false,
        }
    }
}

struct Cursor<'a> {
    text: &'a [u8],
    at: usize,
}

impl Cursor<'_> {
    /// The next byte that is no white space.
    fn peek(&mut self) -> Option<u8> {
        while self.text.get(self.at).is_some_and(u8::is_ascii_whitespace) {
            self.at += 1;
        }
        self.text.get(self.at).copied()
    }

    fn eat(&mut self, byte: u8) -> bool {
        let found = self.peek() == Some(byte);
        self.at += usize::from(found);
        found
    }

    fn value(&mut self, depth: usize) -> Option<Literal> {
        let depth = depth.checked_sub(1)?;
        match self.peek()? {
            quote @ (b'\'' | b'"') => self.quoted(quote),
            b'(' => self.items(b')', depth),
            b'[' => self.items(b']', depth),
            b'{' => self.members(depth),
            b'0'..=b'9' => self
                .word()?
                .trim_end_matches('L')
                .parse()
                .ok()
                .map(Literal::Number),
            _ => self.word().map(Literal::Text),
        }
    }

    fn quoted(&mut self, quote: u8) -> Option<Literal> {
        self.at += 1;
        let rest = self.text.get(self.at..)?;
        let length = rest.iter().position(|byte| *byte == quote)?;
        let text = String::from_utf8_lossy(rest.get(..length)?).into_owned();
        self.at += length + 1;
        Some(Literal::Text(text))
    }

    fn word(&mut self) -> Option<String> {
        let rest = self.text.get(self.at..)?;
        let length = rest
            .iter()
            .position(|byte| !byte.is_ascii_alphanumeric())
            .unwrap_or(rest.len());
        self.at += length;
        (length > 0)
            .then(|| String::from_utf8_lossy(rest.get(..length).unwrap_or_default()).into_owned())
    }

    fn items(&mut self, end: u8, depth: usize) -> Option<Literal> {
        self.at += 1;
        let mut items = Vec::new();
        while !self.eat(end) {
            items.push(self.value(depth)?);
            if !self.eat(b',') && self.peek() != Some(end) {
                return None;
            }
        }
        Some(Literal::Items(items))
    }

    fn members(&mut self, depth: usize) -> Option<Literal> {
        self.at += 1;
        let mut members = Vec::new();
        while !self.eat(b'}') {
            let key = self.value(depth)?;
            if !self.eat(b':') {
                return None;
            }
            members.push((key, self.value(depth)?));
            if !self.eat(b',') && self.peek() != Some(b'}') {
                return None;
            }
        }
        Some(Literal::Members(members))
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    #[test]
    fn a_header_of_numpy_is_read() {
        let text =
            b"{'descr': [('index', '<u4'), ('vector', '<f4', (3,))], 'fortran_order': False, 'shape': (7,), }  \n";
        let header = parse_header(text).unwrap();
        let fields = header.get("descr").unwrap().items();
        assert_eq!(fields[1].items()[0].text(), Some("vector"));
        assert_eq!(header.get("shape").unwrap().items(), [Literal::Number(7)]);
        assert_eq!(header.get("fortran_order").unwrap().text(), Some("False"));
    }

    #[test]
    fn broken_literals_are_refused() {
        for text in [
            "",
            "{",
            "{'a'}",
            "{'a': 1 'b': 2}",
            "{'a': }",
            "(1,)",
            "{'a': 1} x",
            "{'a': '1}",
        ] {
            assert_eq!(parse_header(text.as_bytes()), None, "{text}");
        }
        assert_eq!(
            parse_header(format!("{{1:{}", "(".repeat(100_000)).as_bytes()),
            None
        );
    }

    proptest! {
        #[test]
        fn any_bytes_are_read_or_refused(text in "[\\[({'\"})\\],: 0-9aOL<]{0,60}") {
            let _ = parse_header(text.as_bytes());
        }
    }
}
