//! What every JSON format has in common: the text as a tree, or why there is none.

use std::ops::Range;

use mhlint_json::{self as json, Document, Duplicate, SyntaxFault};
use mhlint_source::Encoding;

/// Why an application cannot read a JSON file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum JsonFault {
    /// Nothing in it.
    Empty,
    /// A byte order mark, which Python's reader rejects.
    ByteOrderMark,
    /// Bytes that are no UTF-8.
    NotUtf8,
    /// A Git LFS pointer.
    LfsPointer,
    /// No JSON.
    Syntax(SyntaxFault),
}

/// Facts on a JSON text, whatever its format.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct JsonFacts {
    /// Keys given twice.
    pub duplicates: Vec<Duplicate>,
    /// How many more of them there are.
    pub duplicates_left_out: usize,
    /// `NaN` and infinities, which only Python accepts.
    pub specials: Vec<Range<usize>>,
    /// Python would take the whole for false: empty object, array, string, 0, null.
    pub falsy: bool,
}

/// Reads a JSON text as the applications do.
///
/// # Errors
/// The fault that keeps an application from reading it.
pub fn parse(text: &[u8], encoding: &Encoding) -> Result<Document, JsonFault> {
    if encoding.lfs_pointer {
        Err(JsonFault::LfsPointer)
    } else if encoding.blank {
        Err(JsonFault::Empty)
    } else if encoding.invalid_utf8_at.is_some() {
        Err(JsonFault::NotUtf8)
    } else if encoding.byte_order_mark {
        Err(JsonFault::ByteOrderMark)
    } else {
        json::parse(text).map_err(JsonFault::Syntax)
    }
}

impl JsonFacts {
    /// Facts of a tree.
    pub fn of(document: &Document) -> Self {
        Self {
            duplicates: document.duplicates.clone(),
            duplicates_left_out: document.duplicates_left_out,
            specials: document.specials.clone(),
            falsy: document.root.is_falsy(),
        }
    }
}
