//! A pull reader over JSON text. [`super::parse`] builds trees with it; bulk formats read through
//! it without a tree.

use std::borrow::Cow;
use std::ops::Range;

use super::naming::named_end;

/// Deepest nesting that is read. Python gives up at about 1000; no asset needs ten.
pub(super) const DEEPEST: u32 = 990;

/// What the first side of a merge conflict begins with.
const CONFLICT: &[u8] = b"<<<<<<< ";

/// Why a text is no JSON.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SyntaxFault {
    /// The offending bytes.
    pub span: Range<usize>,
    /// What kind of fault.
    pub kind: SyntaxKind,
    /// The members and elements it lies in, by name.
    pub within: String,
}

/// The kinds of [`SyntaxFault`].
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum SyntaxKind {
    /// Something else was expected.
    Expected {
        /// What the grammar allows here.
        expected: &'static str,
        /// What is there.
        found: String,
    },
    /// A comma before a closing bracket.
    TrailingComma,
    /// A comment; JSON has none.
    Comment,
    /// A line that git left where it could not merge.
    Conflict,
    /// The file ends inside a string.
    CutText,
    /// A string that does not end on its line, or holds a raw control character or a bad escape.
    BadString(&'static str),
    /// The text ends inside a value.
    UnexpectedEnd(&'static str),
    /// Something follows the top level value.
    TrailingText,
    /// Nested deeper than `DEEPEST`.
    TooDeep,
}

/// Reads tokens from a JSON text.
#[derive(Debug, Clone)]
pub struct Reader<'a> {
    text: &'a [u8],
    at: usize,
    depth: u32,
    /// Whether an array or object was entered and nothing in it asked for yet.
    is_fresh: bool,
    /// Spans of `NaN`, `Infinity` and `-Infinity`, which Python accepts and JSON does not.
    pub specials: Vec<Range<usize>>,
}

type Step<T> = Result<T, SyntaxFault>;

impl<'a> Reader<'a> {
    /// Starts at the beginning of `text`.
    pub fn new(text: &'a [u8]) -> Self {
        Self {
            text,
            at: 0,
            depth: 0,
            is_fresh: false,
            specials: Vec::new(),
        }
    }

    /// The next significant byte, not consumed.
    pub fn peek(&mut self) -> Option<u8> {
        while matches!(self.text.get(self.at), Some(b' ' | b'\t' | b'\n' | b'\r')) {
            self.at += 1;
        }
        self.text.get(self.at).copied()
    }

    /// Offset of the next byte.
    pub fn offset(&self) -> usize {
        self.at
    }

    /// The bytes read since an offset.
    pub fn since(&self, start: usize) -> &'a [u8] {
        self.text.get(start..self.at).unwrap_or_default()
    }

    /// Enters an array or object (the opening bracket is next).
    ///
    /// # Errors
    /// Nesting beyond the limit.
    pub fn open(&mut self) -> Step<()> {
        self.depth += 1;
        if self.depth > DEEPEST {
            return Err(self.fault(self.at..self.at + 1, SyntaxKind::TooDeep));
        }
        self.at += 1;
        self.is_fresh = true;
        Ok(())
    }

    /// After [`Reader::open`] or an element: whether another element follows. Consumes the comma or
    /// the closing bracket.
    ///
    /// # Errors
    /// Anything but a comma or the closing bracket; a comma before it.
    pub fn more(&mut self, close: u8) -> Step<bool> {
        let first = std::mem::take(&mut self.is_fresh);
        match self.peek() {
            Some(byte) if byte == close => {
                self.at += 1;
                self.depth -= 1;
                Ok(false)
            }
            Some(b',') if !first => self.after_comma(close),
            Some(_) if first => Ok(true),
            None => Err(self.end(if close == b']' {
                "`,` or `]`"
            } else {
                "`,` or `}`"
            })),
            Some(_) => Err(self.expected(if close == b']' {
                "`,` or `]`"
            } else {
                "`,` or `}`"
            })),
        }
    }

    fn after_comma(&mut self, close: u8) -> Step<bool> {
        let comma = self.at;
        self.at += 1;
        if self.peek() == Some(close) {
            return Err(self.fault(comma..comma + 1, SyntaxKind::TrailingComma));
        }
        Ok(true)
    }

    /// A member key with its colon. Gives the key and its span (with quotes).
    ///
    /// # Errors
    /// No key in double quotes, or no colon behind it.
    pub fn key(&mut self) -> Step<(Cow<'a, str>, Range<usize>)> {
        if self.peek() != Some(b'"') {
            return Err(self.expected("a key in double quotes"));
        }
        let start = self.at;
        let key = self.string()?;
        let span = start..self.at;
        if self.peek() != Some(b':') {
            return Err(self.expected("`:`"));
        }
        self.at += 1;
        Ok((key, span))
    }

    /// A string (the opening quote is next).
    ///
    /// # Errors
    /// A string that does not end, a raw control character, a bad escape.
    pub fn string(&mut self) -> Step<Cow<'a, str>> {
        let start = self.at + 1;
        let rest = self.text.get(start..).unwrap_or_default();
        let plain = rest
            .iter()
            .position(|byte| matches!(byte, b'"' | b'\\' | 0..=0x1f));
        let Some(length) = plain else {
            return Err(self.fault(self.at..self.text.len(), SyntaxKind::CutText));
        };
        if rest.get(length) == Some(&b'"') {
            self.at = start + length + 1;
            return Ok(String::from_utf8_lossy(
                rest.get(..length).unwrap_or_default(),
            ));
        }
        self.escaped_string().map(Cow::Owned)
    }

    fn escaped_string(&mut self) -> Step<String> {
        let open = self.at;
        self.at += 1;
        let mut out = Vec::new();
        loop {
            match self.text.get(self.at).copied() {
                None => return Err(self.fault(open..self.at, SyntaxKind::CutText)),
                Some(b'"') => break,
                Some(b'\\') => self.escape(&mut out)?,
                Some(b'\n' | b'\r') => {
                    return Err(self.fault(
                        open..self.at,
                        SyntaxKind::BadString("does not end on its line"),
                    ));
                }
                Some(0..=0x1f) => {
                    let what = SyntaxKind::BadString("contains an unescaped control character");
                    return Err(self.fault(self.at..self.at + 1, what));
                }
                Some(byte) => {
                    out.push(byte);
                    self.at += 1;
                }
            }
        }
        self.at += 1;
        Ok(String::from_utf8_lossy(&out).into_owned())
    }

    fn escape(&mut self, out: &mut Vec<u8>) -> Step<()> {
        let plain = match self.text.get(self.at + 1) {
            Some(byte @ (b'"' | b'\\' | b'/')) => *byte,
            Some(b'b') => 8,
            Some(b'f') => 12,
            Some(b'n') => b'\n',
            Some(b'r') => b'\r',
            Some(b't') => b'\t',
            Some(b'u') => return self.unicode_escape(out),
            _ => {
                let end = (self.at + 2).min(self.text.len());
                return Err(self.fault(
                    self.at..end,
                    SyntaxKind::BadString("contains an unknown escape sequence"),
                ));
            }
        };
        out.push(plain);
        self.at += 2;
        Ok(())
    }

    fn unicode_escape(&mut self, out: &mut Vec<u8>) -> Step<()> {
        let high = self.four_digits(self.at)?;
        self.at += 6;
        let mut code = high;
        let low_follows =
            (0xd800..0xdc00).contains(&high) && self.text.get(self.at..self.at + 2) == Some(b"\\u");
        if low_follows {
            let low = self.four_digits(self.at)?;
            if (0xdc00..0xe000).contains(&low) {
                code = 0x10000 + ((high - 0xd800) << 10) + (low - 0xdc00);
                self.at += 6;
            }
        }
        // Python keeps a lone surrogate; no name that we compare can hold one.
        let character = char::from_u32(code).unwrap_or(char::REPLACEMENT_CHARACTER);
        out.extend_from_slice(character.encode_utf8(&mut [0; 4]).as_bytes());
        Ok(())
    }

    fn four_digits(&self, escape: usize) -> Step<u32> {
        let digits = self.text.get(escape + 2..escape + 6).unwrap_or_default();
        std::str::from_utf8(digits)
            .ok()
            .filter(|text| text.len() == 4 && text.bytes().all(|byte| byte.is_ascii_hexdigit()))
            .and_then(|text| u32::from_str_radix(text, 16).ok())
            .ok_or_else(|| {
                let end = (escape + 6).min(self.text.len());
                self.fault(
                    escape..end,
                    SyntaxKind::BadString("contains an invalid `\\u` escape sequence"),
                )
            })
    }

    /// A number; `None` if the next token is none. Gives its value and whether it is written as an
    /// integer. `NaN` and the infinities are accepted as Python does and noted in
    /// [`Reader::specials`].
    ///
    /// # Errors
    /// A sign without a number.
    pub fn number(&mut self) -> Step<Option<(f64, bool)>> {
        self.peek();
        let rest = self.text.get(self.at..).unwrap_or_default();
        for (word, value) in [
            ("NaN", f64::NAN),
            ("Infinity", f64::INFINITY),
            ("-Infinity", f64::NEG_INFINITY),
        ] {
            if rest.starts_with(word.as_bytes()) {
                self.specials.push(self.at..self.at + word.len());
                self.at += word.len();
                return Ok(Some((value, false)));
            }
        }
        let Some((length, integer)) = number_length(rest) else {
            return match rest.first() {
                Some(b'-') => Err(self.expected("a number")),
                _ => Ok(None),
            };
        };
        let digits = rest.get(..length).unwrap_or_default();
        self.at += length;
        Ok(Some((
            fast_float2::parse(digits).unwrap_or(f64::NAN),
            integer,
        )))
    }

    /// `null`, `true` or `false`.
    pub fn literal(&mut self, word: &'static str) -> bool {
        let rest = self.text.get(self.at..).unwrap_or_default();
        let found = rest.starts_with(word.as_bytes());
        if found {
            self.at += word.len();
        }
        found
    }

    /// Reads past a value.
    ///
    /// # Errors
    /// No value, or a fault in it.
    pub fn pass(&mut self) -> Step<()> {
        match self.peek() {
            Some(b'{') => {
                self.open()?;
                while self.more(b'}')? {
                    self.key()?;
                    self.pass()?;
                }
                Ok(())
            }
            Some(b'[') => {
                self.open()?;
                while self.more(b']')? {
                    self.pass()?;
                }
                Ok(())
            }
            Some(b'"') => self.string().map(|_| ()),
            _ => {
                let known = self.number()?.is_some()
                    || ["null", "true", "false"]
                        .iter()
                        .any(|word| self.literal(word));
                if known {
                    Ok(())
                } else {
                    Err(self.expected("a value"))
                }
            }
        }
    }

    /// Makes sure that nothing but white space follows.
    ///
    /// # Errors
    /// Something follows.
    pub fn finish(&mut self) -> Step<()> {
        match self.peek() {
            None => Ok(()),
            Some(b'/' | b'#' | b'<') => Err(self.expected("the end of the text")),
            Some(_) => Err(self.fault(self.at..self.at + 1, SyntaxKind::TrailingText)),
        }
    }

    /// The fault "something else was expected here".
    pub fn expected(&self, expected: &'static str) -> SyntaxFault {
        let rest = self.text.get(self.at..).unwrap_or_default();
        let kind = match rest {
            [] => return self.end(expected),
            [b'/', b'/' | b'*', ..] | [b'#', ..] => SyntaxKind::Comment,
            rest if rest.starts_with(CONFLICT) => SyntaxKind::Conflict,
            _ => SyntaxKind::Expected {
                expected,
                found: next_word(rest),
            },
        };
        let length = match &kind {
            SyntaxKind::Expected { found, .. } => found.len(),
            SyntaxKind::Conflict => CONFLICT.len() - 1,
            _ => 2,
        };
        self.fault(self.at..(self.at + length).min(self.text.len()), kind)
    }

    fn end(&self, expected: &'static str) -> SyntaxFault {
        self.fault(
            self.text.len()..self.text.len(),
            SyntaxKind::UnexpectedEnd(expected),
        )
    }

    fn fault(&self, span: Range<usize>, kind: SyntaxKind) -> SyntaxFault {
        let end = span.end.min(self.text.len());
        let start = span.start.min(end);
        let within = named_end(self.text.get(..start).unwrap_or_default());
        SyntaxFault {
            span: start..end,
            kind,
            within,
        }
    }
}

/// Length of the number at the start of `text` by the JSON grammar, and whether it is an integer.
fn number_length(text: &[u8]) -> Option<(usize, bool)> {
    let digits = |from: usize| {
        let rest = text.get(from..).unwrap_or_default();
        rest.iter().take_while(|byte| byte.is_ascii_digit()).count()
    };
    let mut at = usize::from(text.first() == Some(&b'-'));
    match text.get(at) {
        Some(b'0') => at += 1,
        Some(b'1'..=b'9') => at += digits(at),
        _ => return None,
    }
    let mut integer = true;
    if text.get(at) == Some(&b'.') && digits(at + 1) > 0 {
        at += 1 + digits(at + 1);
        integer = false;
    }
    if matches!(text.get(at), Some(b'e' | b'E')) {
        let sign = usize::from(matches!(text.get(at + 1), Some(b'+' | b'-')));
        let length = digits(at + 1 + sign);
        if length > 0 {
            at += 1 + sign + length;
            integer = false;
        }
    }
    Some((at, integer))
}

fn next_word(text: &[u8]) -> String {
    let length = text
        .iter()
        .position(|byte| {
            matches!(
                byte,
                b' ' | b'\t' | b'\n' | b'\r' | b',' | b':' | b'[' | b']' | b'{' | b'}'
            )
        })
        .unwrap_or(text.len())
        .clamp(1, 24);
    String::from_utf8_lossy(text.get(..length.min(text.len())).unwrap_or_default()).into_owned()
}
