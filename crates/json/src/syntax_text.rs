//! Syntax faults in words.

use std::fmt;

use super::SyntaxFault;
use super::reader::{DEEPEST, SyntaxKind};

impl fmt::Display for SyntaxFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.kind {
            SyntaxKind::Expected { expected, found } => match self.invisible() {
                Some(letter) => {
                    write!(
                        f,
                        "expected {expected}, found the invisible character U+{:04X}",
                        u32::from(letter)
                    )
                }
                None => write!(f, "expected {expected}, found `{found}`"),
            },
            SyntaxKind::TrailingComma => f.write_str("comma before the closing bracket"),
            SyntaxKind::Comment => f.write_str("JSON does not allow comments"),
            SyntaxKind::Conflict => f.write_str("unresolved merge conflict"),
            SyntaxKind::CutText => f.write_str("the file ends inside a string"),
            SyntaxKind::BadString(what) => write!(f, "string {what}"),
            SyntaxKind::UnexpectedEnd(expected) => {
                write!(f, "expected {expected}, but the file ends")
            }
            SyntaxKind::TrailingText => {
                f.write_str("unexpected text after the end of the JSON value")
            }
            SyntaxKind::TooDeep => write!(f, "nested deeper than {DEEPEST} levels"),
        }
    }
}

impl SyntaxFault {
    /// The character at the fault, if nobody can see it.
    pub fn invisible(&self) -> Option<char> {
        let SyntaxKind::Expected { found, .. } = &self.kind else {
            return None;
        };
        let is_invisible = |letter: &char| {
            letter.is_control()
                || (letter.is_whitespace() && !letter.is_ascii())
                || matches!(letter, '\u{200b}'..='\u{200f}' | '\u{2060}' | '\u{feff}')
        };
        found.chars().next().filter(is_invisible)
    }
}
