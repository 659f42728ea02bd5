//! What readers of large JSON have in common: they read without a tree.

use super::json_file::{JsonFault, parse};
use mhlint_source::Encoding;

/// What is wrong with a text before its syntax matters.
pub(super) fn text_fault(text: &[u8], encoding: &Encoding) -> Option<JsonFault> {
    let is_refused = encoding.blank
        || encoding.byte_order_mark
        || encoding.lfs_pointer
        || encoding.invalid_utf8_at.is_some();
    // The common reader names these; it never gets as far as the text.
    if is_refused {
        parse(text, encoding).err()
    } else {
        None
    }
}
