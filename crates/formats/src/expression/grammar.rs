//! The allow list as a grammar: recursive descent over tokens, with just enough types to see bombs
//! coming.
//!
//! No tree is kept. Every rule of the grammar gives what the next one has to know of an operand:
//! number or text, a literal, whether a power is in it. Depth is bounded; long chains are loops.

use std::ops::Range;

use super::operand::{Operand, Results};
use super::token::{Lexeme, Lexer, Token};
use super::{Fault, FaultKind};

/// Deepest nesting of parentheses, signs and powers; Python's own parser stops at about this.
const DEEPEST: u32 = 100;
/// Largest exponent written as a number: a screen of digits at most.
const LARGEST_EXPONENT: f64 = 16.0;
/// Most digits `round` is asked for; a double has seventeen.
const MOST_DIGITS: f64 = 20.0;
/// Digits of a width and a precision with the point between them, that are taken for a layout and
/// not for a bomb.
const LONGEST_LAYOUT: usize = 4;
/// Keywords that cannot begin an operand.
const KEYWORDS: [&str; 30] = [
    "if", "else", "elif", "and", "or", "not", "in", "is", "for", "while", "import", "from", "def",
    "class", "return", "del", "pass", "break", "continue", "global", "nonlocal", "assert", "raise",
    "try", "except", "finally", "with", "as", "async", "yield",
];

type Parsed = Result<Operand, Fault>;

/// Checks an expression in which only `variable` is a known name.
///
/// # Errors
/// The first thing that is not on the allow list.
pub fn check(text: &str, variable: &str) -> Result<(), Fault> {
    results(text, variable).map(drop)
}

/// The types that the value of an expression may have.
///
/// # Errors
/// As [`check`].
pub fn results(text: &str, variable: &str) -> Result<Results, Fault> {
    let mut lexer = Lexer::new(text);
    let next = lexer.next()?;
    let mut parser = Parser {
        lexer,
        next,
        variable,
        depth: 0,
        by_variable: None,
    };
    let operand = parser.expression()?;
    if parser.next.token != Token::End {
        return Err(parser.unexpected());
    }
    match parser.by_variable {
        Some(span) => Err(Parser::raises(
            span,
            format!("divides by `{variable}`, which can be 0"),
        )),
        None => Ok(operand.results),
    }
}

/// Whether a text in quotes has one `%` layout for a number, narrower than a thousand.
fn is_layout(text: &str) -> bool {
    let mut rest = text;
    let mut layouts = 0;
    while let Some((_, after)) = rest.split_once('%') {
        if let Some(after) = after.strip_prefix('%') {
            rest = after;
            continue;
        }
        let layout = after.trim_start_matches(['-', '+', ' ', '0', '#']);
        let digits = layout.len()
            - layout
                .trim_start_matches(|c: char| c.is_ascii_digit() || c == '.')
                .len();
        let Some(code) = layout.get(digits..).and_then(|code| code.chars().next()) else {
            return false;
        };
        if digits > LONGEST_LAYOUT || !"dieEfFgGs".contains(code) {
            return false;
        }
        layouts += 1;
        rest = layout.get(digits + 1..).unwrap_or_default();
    }
    layouts == 1
}

struct Parser<'a> {
    lexer: Lexer<'a>,
    next: Lexeme,
    variable: &'a str,
    depth: u32,
    /// The first division by the variable alone that no condition stands beside.
    by_variable: Option<Range<usize>>,
}

const NO_DIGITS: &str = "rounds to a number of digits that is not an integer";

impl<'a> Parser<'a> {
    fn advance(&mut self) -> Result<Range<usize>, Fault> {
        let next = self.lexer.next()?;
        Ok(std::mem::replace(&mut self.next, next).span)
    }

    fn word(&self) -> &'a str {
        if self.next.token == Token::Name {
            self.lexer.slice(&self.next.span)
        } else {
            ""
        }
    }

    fn operator(&self) -> &'static str {
        if let Token::Operator(operator) = self.next.token {
            operator
        } else {
            ""
        }
    }

    fn foreign(span: Range<usize>, what: impl Into<String>) -> Fault {
        Fault::new(FaultKind::Foreign, span, what)
    }

    fn raises(span: Range<usize>, what: impl Into<String>) -> Fault {
        Fault::new(FaultKind::Raises, span, what)
    }

    fn endless(span: Range<usize>, what: impl Into<String>) -> Fault {
        Fault::new(FaultKind::Endless, span, what)
    }

    /// Says what is wrong with a token that the grammar has no place for.
    fn unexpected(&self) -> Fault {
        let span = self.next.span.clone();
        let shown = self.lexer.slice(&span);
        match self.next.token {
            Token::End => Fault::new(FaultKind::Syntax, span, "ends too early"),
            Token::Operator("&" | "|" | "^" | "~" | "<<" | ">>" | "@") => Fault::new(
                FaultKind::Mistyped,
                span,
                format!("uses `{shown}`, which does not work on decimal numbers"),
            ),
            Token::Name if shown == "in" => {
                Fault::new(FaultKind::Mistyped, span, "uses `in` on numbers".to_owned())
            }
            Token::Operator(",") => Fault::new(FaultKind::Pair, span, "contains a comma"),
            Token::Operator("[" | "{" | ":=" | "." | "...") => {
                Self::foreign(span, format!("uses `{shown}`"))
            }
            Token::Name if matches!(shown, "is" | "for" | "async") => {
                Self::foreign(span, format!("uses `{shown}`"))
            }
            _ => Fault::new(
                FaultKind::Syntax,
                span,
                format!("has an unexpected `{shown}`"),
            ),
        }
    }

    fn deeper(&mut self) -> Result<(), Fault> {
        self.depth += 1;
        if self.depth > DEEPEST {
            let what = format!("is nested deeper than {DEEPEST} levels");
            return Err(Fault::new(FaultKind::Syntax, self.next.span.clone(), what));
        }
        Ok(())
    }

    /// `a if condition else b if condition else c`.
    fn expression(&mut self) -> Parsed {
        self.deeper()?;
        let before = self.by_variable.clone();
        let mut result = self.either("or", |parser| parser.either("and", Self::inversion))?;
        while self.word() == "if" {
            self.advance()?;
            self.either("or", |parser| parser.either("and", Self::inversion))?;
            if self.word() != "else" {
                return Err(self.unexpected());
            }
            self.advance()?;
            result =
                result.either(self.either("or", |parser| parser.either("and", Self::inversion))?);
            // The condition may keep the variable from being 0.
            self.by_variable.clone_from(&before);
        }
        self.depth -= 1;
        Ok(result)
    }

    fn either(&mut self, word: &str, part: fn(&mut Self) -> Parsed) -> Parsed {
        let before = self.by_variable.clone();
        let mut result = part(self)?;
        while self.word() == word {
            self.advance()?;
            result = result.either(part(self)?);
            self.by_variable.clone_from(&before);
        }
        Ok(result)
    }

    fn inversion(&mut self) -> Parsed {
        let mut inverted = false;
        while self.word() == "not" {
            self.advance()?;
            inverted = true;
        }
        let operand = self.comparison()?;
        Ok(if inverted {
            Operand {
                power: operand.power,
                ..Operand::TRUTH
            }
        } else {
            operand
        })
    }

    fn comparison(&mut self) -> Parsed {
        let mut left = self.sum()?;
        let mut compared = false;
        let mut power = left.power;
        while let operator @ ("==" | "!=" | "<" | "<=" | ">" | ">=") = self.operator() {
            let span = self.advance()?;
            let right = self.sum()?;
            if !matches!(operator, "==" | "!=") && left.clashes_with(right) {
                return Err(Self::raises(span, "compares a string with a number"));
            }
            power |= right.power;
            (left, compared) = (right, true);
        }
        Ok(if compared {
            Operand {
                power,
                ..Operand::TRUTH
            }
        } else {
            left
        })
    }

    fn sum(&mut self) -> Parsed {
        let mut left = self.term()?;
        while let operator @ ("+" | "-") = self.operator() {
            let span = self.advance()?;
            let right = self.term()?;
            if operator == "+" && left.clashes_with(right) {
                return Err(Self::raises(span, "adds a string and a number"));
            }
            if operator == "-" && (left.is_text() || right.is_text()) {
                return Err(Self::raises(span, "uses a string in a subtraction"));
            }
            left = left.calculated(right);
        }
        Ok(left)
    }

    fn term(&mut self) -> Parsed {
        let mut left = self.factor()?;
        while let operator @ ("*" | "/" | "//" | "%") = self.operator() {
            let span = self.advance()?;
            let right = self.factor()?;
            match operator {
                "*" if left.may_be_text() || right.may_be_text() => {
                    return Err(Self::endless(span, "repeats a string"));
                }
                "%" if left.is_layout && !right.may_be_text() => {
                    left = Operand {
                        power: left.power,
                        ..Operand::TEXT
                    };
                    continue;
                }
                "%" if left.may_be_text() => {
                    return Err(Self::endless(span, "formats a string with `%`"));
                }
                _ if left.is_text() || right.is_text() => {
                    return Err(Self::raises(span, "uses a string in a division"));
                }
                "/" | "//" | "%" if right.literal.is_some_and(|(value, _)| value == 0.0) => {
                    return Err(Self::raises(span, "divides by zero"));
                }
                "/" | "//" | "%" if right.variable => drop(self.by_variable.get_or_insert(span)),
                _ => {}
            }
            left = left.calculated(right);
            if operator == "/" {
                left = Operand {
                    power: left.power,
                    ..Operand::FRACTION
                };
            }
        }
        Ok(left)
    }

    fn factor(&mut self) -> Parsed {
        let mut sign = None;
        while let operator @ ("+" | "-") = self.operator() {
            let span = self.advance()?;
            let negative =
                sign.as_ref().is_some_and(|(_, negative)| *negative) != (operator == "-");
            sign = Some((span, negative));
        }
        let operand = self.power()?;
        let Some((span, negative)) = sign else {
            return Ok(operand);
        };
        if operand.is_text() {
            return Err(Self::raises(span, "puts a sign before a string"));
        }
        let literal = operand
            .literal
            .map(|(value, integer)| (if negative { -value } else { value }, integer));
        Ok(Operand { literal, ..operand })
    }

    fn power(&mut self) -> Parsed {
        let base = self.operand()?;
        if self.operator() != "**" {
            return Ok(base);
        }
        let span = self.advance()?;
        self.deeper()?;
        let exponent = self.factor()?;
        self.depth -= 1;
        if base.is_text() || exponent.is_text() {
            return Err(Self::raises(span, "raises a string to a power"));
        }
        let bounded = exponent.variable
            || exponent
                .literal
                .is_some_and(|(value, _)| value.abs() <= LARGEST_EXPONENT);
        if !bounded || base.power || exponent.power {
            return Err(Self::endless(span, "raises to a power without a limit"));
        }
        let is_whole = base.results == Results::WHOLE
            && exponent
                .literal
                .is_some_and(|(value, whole)| whole && value >= 0.0);
        let results = if is_whole {
            Results::WHOLE
        } else {
            Results::FRACTION
        };
        Ok(Operand {
            power: true,
            ..Operand::of(results)
        })
    }

    fn operand(&mut self) -> Parsed {
        let operand = match self.next.token {
            Token::Number(value, integer) => {
                self.advance()?;
                let results = if integer {
                    Results::WHOLE
                } else {
                    Results::FRACTION
                };
                Operand {
                    literal: Some((value, integer)),
                    ..Operand::of(results)
                }
            }
            Token::Text => {
                let span = self.advance()?;
                let is_single = self.next.token != Token::Text;
                while self.next.token == Token::Text {
                    self.advance()?;
                }
                let is_layout = is_single && is_layout(self.lexer.slice(&span));
                Operand {
                    is_layout,
                    ..Operand::TEXT
                }
            }
            Token::Name => self.name()?,
            Token::Operator("(") => self.parenthesis()?,
            _ => return Err(self.unexpected()),
        };
        match self.operator() {
            "." => Err(self.attribute()),
            "[" => Err(Self::foreign(
                self.next.span.clone(),
                "reads an element with `[`",
            )),
            "(" => Err(Self::foreign(self.next.span.clone(), "calls a value")),
            _ => Ok(operand),
        }
    }

    fn attribute(&mut self) -> Fault {
        let dot = self.next.span.clone();
        match self.advance() {
            Ok(_) if self.next.token == Token::Name => Self::foreign(
                dot.start..self.next.span.end,
                format!("reads the attribute `{}`", self.word()),
            ),
            _ => Self::foreign(dot, "reads an attribute"),
        }
    }

    fn parenthesis(&mut self) -> Parsed {
        self.advance()?;
        let operand = self.expression()?;
        if self.operator() != ")" {
            return Err(self.unexpected());
        }
        self.advance()?;
        Ok(operand)
    }

    fn name(&mut self) -> Parsed {
        let word = self.word();
        if KEYWORDS.contains(&word) {
            return Err(Fault::new(
                FaultKind::Syntax,
                self.next.span.clone(),
                format!("has an unexpected `{word}`"),
            ));
        }
        let span = self.advance()?;
        match word {
            "True" | "False" => Ok(Operand::TRUTH),
            _ if word == self.variable => Ok(Operand {
                variable: true,
                ..Operand::FRACTION
            }),
            "round" | "str" if self.operator() == "(" => self.call(word, &span),
            "lambda" => Err(Self::foreign(span, "defines a function with `lambda`")),
            _ if self.operator() == "(" => Err(Self::foreign(span, format!("calls `{word}`"))),
            _ => Err(Self::foreign(span, format!("reads the name `{word}`"))),
        }
    }

    fn call(&mut self, function: &str, name: &Range<usize>) -> Parsed {
        self.advance()?;
        let mut arguments: Vec<Operand> = Vec::new();
        while self.operator() != ")" {
            arguments.push(self.argument()?);
            match self.operator() {
                "," => self.advance()?,
                ")" => break,
                _ => return Err(self.unexpected()),
            };
        }
        let call = name.start..self.next.span.end;
        self.advance()?;
        match (function, arguments.as_slice()) {
            ("str", [value]) => Ok(Operand {
                power: value.power,
                ..Operand::TEXT
            }),
            ("round", [value]) => Self::rounded(*value, call).map(|value| Operand {
                power: value.power,
                ..Operand::WHOLE
            }),
            ("round", [value, digits]) => {
                Self::digits(*digits, call.clone())?;
                Self::rounded(*value, call)
            }
            _ => Err(Self::raises(
                call,
                format!("calls `{function}` with {} arguments", arguments.len()),
            )),
        }
    }

    fn argument(&mut self) -> Parsed {
        let span = self.next.span.clone();
        if matches!(self.operator(), "*" | "**") {
            return Err(Self::foreign(
                span,
                format!("unpacks with `{}`", self.operator()),
            ));
        }
        let is_keyword = self.next.token == Token::Name
            && self
                .lexer
                .clone()
                .next()
                .is_ok_and(|lexeme| lexeme.token == Token::Operator("="));
        if is_keyword {
            return Err(Self::foreign(
                span,
                format!("passes `{}` as a keyword argument", self.word()),
            ));
        }
        self.expression()
    }

    fn rounded(value: Operand, call: Range<usize>) -> Parsed {
        if value.is_text() {
            return Err(Self::raises(call, "rounds a string"));
        }
        Ok(Operand {
            power: value.power,
            ..Operand::of(value.results.rounded())
        })
    }

    fn digits(digits: Operand, call: Range<usize>) -> Result<(), Fault> {
        match digits.literal {
            Some((value, true)) if value.abs() <= MOST_DIGITS => Ok(()),
            Some((_, false)) => Err(Self::raises(call, NO_DIGITS)),
            None if digits.variable || digits.is_text() => Err(Self::raises(call, NO_DIGITS)),
            _ => Err(Self::endless(
                call,
                "rounds to a number of digits without a limit",
            )),
        }
    }
}
