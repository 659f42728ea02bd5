//! Syntax faults in words.

use std::fmt;

use super::SyntaxFault;
use super::reader::{DEEPEST, SyntaxKind};

impl fmt::Display for SyntaxFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.kind {
            SyntaxKind::Expected { expected, found } => write!(f, "expected {expected}, found `{found}`"),
            SyntaxKind::TrailingComma => f.write_str("a comma before the closing bracket"),
            SyntaxKind::Comment => f.write_str("a comment, which JSON does not have"),
            SyntaxKind::Conflict => f.write_str("a merge conflict that was not resolved"),
            SyntaxKind::CutText => f.write_str("the file ends inside a text"),
            SyntaxKind::BadString(what) => write!(f, "a text that {what}"),
            SyntaxKind::UnexpectedEnd(expected) => write!(f, "the file ends where {expected} is expected"),
            SyntaxKind::TrailingText => f.write_str("something follows after the end of the value"),
            SyntaxKind::TooDeep => write!(f, "nested deeper than {DEEPEST} levels"),
        }
    }
}
