//! What a text file is before any format looks at it: encoding, byte order mark, stand-ins.

use serde::Serialize;

/// First bytes of the stand-in that Git LFS leaves when the content was not fetched.
const LFS_POINTER: &[u8] = b"version https://git-lfs.github.com/spec/";
const BYTE_ORDER_MARK: &[u8] = b"\xef\xbb\xbf";

/// Facts on the bytes of a file.
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize)]
pub struct Encoding {
    /// Starts with a UTF-8 byte order mark.
    pub byte_order_mark: bool,
    /// Offset of the first byte that is not UTF-8.
    pub invalid_utf8_at: Option<usize>,
    /// The content is a Git LFS pointer.
    pub lfs_pointer: bool,
    /// Nothing but white space.
    pub blank: bool,
}

impl Encoding {
    /// Looks at all bytes once.
    pub fn of(bytes: &[u8]) -> Self {
        Self {
            byte_order_mark: bytes.starts_with(BYTE_ORDER_MARK),
            invalid_utf8_at: std::str::from_utf8(bytes).err().map(|error| error.valid_up_to()),
            lfs_pointer: bytes.starts_with(LFS_POINTER),
            blank: bytes.iter().all(u8::is_ascii_whitespace),
        }
    }
}
