//! Tokens of a Python expression: text to numbers, texts, names and operators with their bytes.
//!
//! Follows Python's tokenizer where it matters for the allow list: string prefixes, escapes,
//! underscores in numbers, line ends, comments. Never panics and never recurses.

use std::ops::Range;

use super::{Fault, FaultKind};

/// A token and its bytes.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Lexeme {
    pub(super) token: Token,
    pub(super) span: Range<usize>,
}

/// A token.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Token {
    /// A number: its value, and whether it is written as an integer.
    Number(f64, bool),
    /// A text.
    Text,
    /// A name or keyword; the bytes say which.
    Name,
    /// An operator or bracket.
    Operator(&'static str),
    /// The end of the expression.
    End,
}

/// Longest first. What is here and not in the grammar is Python, but not on the allow list.
const OPERATORS: [&str; 38] = [
    "...", "**", "//", "==", "!=", "<=", ">=", ":=", "<<", ">>", "->", "+=", "-=", "*=", "/=",
    "%=", "<", ">", "+", "-", "*", "/", "%", "(", ")", ",", "&", "|", "^", "~", "@", "[", "]", "{",
    "}", ".", "=", ":",
];
/// Keywords that may follow a number without a blank.
const AFTER_NUMBER: [&str; 8] = ["if", "else", "and", "or", "in", "is", "not", "for"];

#[cfg(test)]
thread_local! {
    static PASSED: std::cell::Cell<usize> = const { std::cell::Cell::new(0) };
}

/// Bytes that were gone through, counted in tests.
#[cfg(test)]
fn went_through(bytes: usize) {
    PASSED.set(PASSED.get() + bytes);
}

#[cfg(not(test))]
const fn went_through(_: usize) {}

/// Splits an expression.
#[derive(Debug, Clone)]
pub(super) struct Lexer<'a> {
    text: &'a str,
    at: usize,
    /// What of the text is more than white space, found once: an expression may have any number of
    /// line ends.
    inner: Range<usize>,
    /// Open parentheses: inside them line ends are blanks.
    open: u32,
}

impl<'a> Lexer<'a> {
    pub(super) fn new(text: &'a str) -> Self {
        went_through(text.len());
        let inner = text.len() - text.trim_start().len()..text.trim_end().len();
        Self {
            text,
            at: 0,
            inner,
            open: 0,
        }
    }

    /// The bytes of a span.
    pub(super) fn slice(&self, span: &Range<usize>) -> &'a str {
        self.text.get(span.clone()).unwrap_or_default()
    }

    /// The next token; at the end [`Token::End`] again and again.
    pub(super) fn next(&mut self) -> Result<Lexeme, Fault> {
        self.skip_blanks()?;
        let start = self.at;
        let Some(first) = self.peek() else {
            return Ok(Lexeme {
                token: Token::End,
                span: start..start,
            });
        };
        let token = match first {
            '\'' | '"' => self.string(start, false)?,
            '0'..='9' => self.number()?,
            '.' if self.byte(1).is_some_and(|byte| byte.is_ascii_digit()) => self.number()?,
            first if is_name_start(first) => self.name()?,
            _ => self.operator()?,
        };
        Ok(Lexeme {
            token,
            span: start..self.at,
        })
    }

    fn rest(&self) -> &'a str {
        self.text.get(self.at..).unwrap_or_default()
    }

    fn peek(&self) -> Option<char> {
        self.rest().chars().next()
    }

    fn byte(&self, ahead: usize) -> Option<u8> {
        self.text.as_bytes().get(self.at + ahead).copied()
    }

    fn syntax(&self, span: Range<usize>, what: impl Into<String>) -> Fault {
        Fault::new(
            FaultKind::Syntax,
            span.start..span.end.min(self.text.len()),
            what,
        )
    }

    fn skip_blanks(&mut self) -> Result<(), Fault> {
        loop {
            let rest = self.rest();
            let blanks = rest.len() - rest.trim_start_matches([' ', '\t', '\x0c']).len();
            went_through(blanks + 1);
            self.at += blanks;
            match self.peek() {
                Some('#') => self.at += self.rest().find(['\n', '\r']).unwrap_or(self.rest().len()),
                Some('\\') if matches!(self.byte(1), Some(b'\n')) => self.at += 2,
                Some('\n' | '\r') if self.is_line_end_harmless() => self.at += 1,
                Some('\n' | '\r') => {
                    return Err(self.syntax(self.at..self.at + 1, "continues after a line end"));
                }
                _ => return Ok(()),
            }
        }
    }

    /// Inside parentheses, before the first token and after the last, line ends mean nothing.
    fn is_line_end_harmless(&self) -> bool {
        self.open > 0 || self.at <= self.inner.start || self.at >= self.inner.end
    }

    fn name(&mut self) -> Result<Token, Fault> {
        let start = self.at;
        let rest = self.rest();
        self.at += rest
            .find(|c: char| !is_name_start(c) && !c.is_numeric())
            .unwrap_or(rest.len());
        if !matches!(self.peek(), Some('\'' | '"')) {
            return Ok(Token::Name);
        }
        let prefix = self
            .text
            .get(start..self.at)
            .unwrap_or_default()
            .to_ascii_lowercase();
        match prefix.as_str() {
            "r" => self.string(start, true),
            "u" => self.string(start, false),
            "f" | "fr" | "rf" | "t" | "tr" | "rt" => Err(Fault::new(
                FaultKind::Foreign,
                start..self.at + 1,
                "contains a string that begins with `f`: its braces are code",
            )),
            "b" | "br" | "rb" => Err(Fault::new(
                FaultKind::Foreign,
                start..self.at + 1,
                "contains a bytes literal",
            )),
            _ => Ok(Token::Name),
        }
    }

    /// A text from its opening quote on; `start` is where its prefix begins.
    fn string(&mut self, start: usize, raw: bool) -> Result<Token, Fault> {
        let quote = self.byte(0).unwrap_or(b'\'');
        let triple = self.byte(1) == Some(quote) && self.byte(2) == Some(quote);
        self.at += if triple { 3 } else { 1 };
        loop {
            match self.peek() {
                None => {
                    return Err(
                        self.syntax(start..self.at, "contains a string without a closing quote")
                    );
                }
                Some('\n' | '\r') if !triple => {
                    return Err(
                        self.syntax(start..self.at, "contains a string without a closing quote")
                    );
                }
                Some('\0') => {
                    return Err(self.syntax(self.at..self.at + 1, "contains a null character"));
                }
                Some('\\') => self.escape(raw)?,
                Some(character) if character == char::from(quote) => {
                    if !triple || (self.byte(1) == Some(quote) && self.byte(2) == Some(quote)) {
                        self.at += if triple { 3 } else { 1 };
                        return Ok(Token::Text);
                    }
                    self.at += 1;
                }
                Some(character) => self.at += character.len_utf8(),
            }
        }
    }

    fn escape(&mut self, raw: bool) -> Result<(), Fault> {
        let start = self.at;
        self.at += 1;
        let Some(character) = self.peek() else {
            return Ok(());
        };
        self.at += character.len_utf8();
        let digits = match character {
            'x' => 2,
            'u' => 4,
            'U' => 8,
            'N' if !raw => {
                return Err(Fault::new(
                    FaultKind::Foreign,
                    start..self.at,
                    "contains a `\\N` escape sequence",
                ));
            }
            _ => return Ok(()),
        };
        let hex = self
            .rest()
            .bytes()
            .take(digits)
            .take_while(u8::is_ascii_hexdigit)
            .count();
        if raw || hex == digits {
            return Ok(());
        }
        Err(self.syntax(
            start..self.at + hex,
            "contains an incomplete escape sequence",
        ))
    }

    fn number(&mut self) -> Result<Token, Fault> {
        let start = self.at;
        let radix = match (
            self.byte(0),
            self.byte(1).map(|byte| byte.to_ascii_lowercase()),
        ) {
            (Some(b'0'), Some(b'x')) => 16,
            (Some(b'0'), Some(b'o')) => 8,
            (Some(b'0'), Some(b'b')) => 2,
            _ => 10,
        };
        let token = if radix == 10 {
            self.decimal()
        } else {
            self.based(radix)
        };
        let written = self.text.get(start..self.at).unwrap_or_default();
        if matches!(self.byte(0), Some(b'j' | b'J')) {
            return Err(Fault::new(
                FaultKind::Foreign,
                start..self.at + 1,
                "contains an imaginary number",
            ));
        }
        let is_whole =
            matches!(token, Some(Token::Number(value, true)) if radix == 10 && value != 0.0);
        let leading_zero = is_whole && written.starts_with('0');
        let misplaced = written.contains("__") || written.ends_with('_') || written.contains("_.");
        match token {
            Some(token) if !leading_zero && !misplaced && self.ends_cleanly() => Ok(token),
            _ => Err(self.syntax(start..self.at.max(start + 1), "contains a malformed number")),
        }
    }

    fn based(&mut self, radix: u32) -> Option<Token> {
        self.at += 2;
        let rest = self.rest();
        let length = rest
            .find(|c: char| !c.is_digit(radix) && c != '_')
            .unwrap_or(rest.len());
        self.at += length;
        let digits: String = rest.get(..length)?.chars().filter(|c| *c != '_').collect();
        let value = digits.chars().filter_map(|c| c.to_digit(radix));
        let value = value.fold(0.0, |value, digit| {
            value * f64::from(radix) + f64::from(digit)
        });
        (!digits.is_empty()).then_some(Token::Number(value, true))
    }

    fn decimal(&mut self) -> Option<Token> {
        let start = self.at;
        self.digits();
        let mut integer = true;
        if self.byte(0) == Some(b'.') {
            integer = false;
            self.at += 1;
            self.digits();
        }
        let sign = usize::from(matches!(self.byte(1), Some(b'+' | b'-')));
        if matches!(self.byte(0), Some(b'e' | b'E'))
            && self
                .byte(1 + sign)
                .is_some_and(|byte| byte.is_ascii_digit())
        {
            integer = false;
            self.at += 1 + sign;
            self.digits();
        }
        let written = self.text.get(start..self.at)?;
        let plain: String = written.chars().filter(|c| *c != '_').collect();
        plain
            .parse()
            .ok()
            .map(|value| Token::Number(value, integer))
    }

    fn digits(&mut self) {
        let rest = self.rest();
        self.at += rest
            .find(|c: char| !c.is_ascii_digit() && c != '_')
            .unwrap_or(rest.len());
    }

    /// No name begins right behind a number, unless it is a keyword that may.
    fn ends_cleanly(&self) -> bool {
        let rest = self.rest();
        let word = rest.get(
            ..rest
                .find(|c: char| !is_name_start(c) && !c.is_numeric())
                .unwrap_or(rest.len()),
        );
        word.is_none_or(|word| word.is_empty() || AFTER_NUMBER.contains(&word))
    }

    fn operator(&mut self) -> Result<Token, Fault> {
        let rest = self.rest();
        let Some(found) = OPERATORS
            .iter()
            .find(|operator| rest.starts_with(**operator))
        else {
            let length = rest.chars().next().map_or(0, char::len_utf8);
            let shown: String = rest.chars().take(1).flat_map(char::escape_debug).collect();
            return Err(self.syntax(
                self.at..self.at + length,
                format!("contains `{shown}`, which is not valid Python"),
            ));
        };
        match *found {
            "(" => self.open += 1,
            ")" => self.open = self.open.saturating_sub(1),
            _ => {}
        }
        self.at += found.len();
        Ok(Token::Operator(found))
    }
}

fn is_name_start(character: char) -> bool {
    character == '_' || character.is_alphabetic()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn line_ends_are_gone_through_once_however_many_there_are() {
        let text = "\n".repeat(30_000);
        let before = PASSED.get();
        assert_eq!(
            Lexer::new(&text).next().map(|lexeme| lexeme.token),
            Ok(Token::End)
        );
        let passed = PASSED.get() - before;
        assert!(passed <= 3 * text.len(), "{passed}");
    }

    #[test]
    fn line_ends_mean_nothing_before_after_and_inside_parentheses() {
        let fails = |text: &str| {
            let mut lexer = Lexer::new(text);
            loop {
                match lexer.next() {
                    Ok(Lexeme {
                        token: Token::End, ..
                    }) => return false,
                    Ok(_) => {}
                    Err(_) => return true,
                }
            }
        };
        for text in ["", " \n ", "\n\r 1\n \u{a0}"] {
            assert_eq!(fails(text), text.contains('\u{a0}'), "{text:?}");
        }
        assert!(!fails("\n(1\n)\n") && fails("1\n+1") && fails("# a\n1") && !fails("1 # a\n"));
    }

    #[test]
    fn a_line_end_is_not_compared_with_the_rest_of_the_text() {
        // The ends of the text are looked for once; what is left for each line end are two
        // comparisons of numbers.
        let lexer = Lexer::new("\n\n 1 \n\n");
        assert_eq!(lexer.inner, 3..4);
    }
}
