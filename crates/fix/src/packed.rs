//! Packed files: edits are made in the unpacked text, which is packed again in one way only.

use std::io::{self, Write};

use flate2::{Compression, GzBuilder};

use mhlint_source::{GzipFault, Limits, gunzip};

/// Level of packing. With the time left out and no name stored, equal text gives equal bytes.
const LEVEL: u32 = 9;

/// Whether a file is packed, by its first bytes.
pub fn is_packed(stored: &[u8]) -> bool {
    stored.starts_with(&[0x1f, 0x8b])
}

/// The text of a file as it is stored; packed or not.
///
/// # Errors
/// When it is packed and cannot be unpacked.
pub fn unpack(stored: &[u8], limits: &Limits) -> Result<Vec<u8>, GzipFault> {
    if is_packed(stored) {
        gunzip(stored, limits)
    } else {
        Ok(stored.to_vec())
    }
}

/// Packs a text.
///
/// # Errors
/// Those of the library, which has none when it writes to memory.
pub fn pack(text: &[u8]) -> io::Result<Vec<u8>> {
    let mut encoder = GzBuilder::new()
        .mtime(0)
        .write(Vec::new(), Compression::new(LEVEL));
    encoder.write_all(text)?;
    encoder.finish()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn packing_is_repeatable_and_names_neither_time_nor_file() {
        let packed = pack(b"1 0 .1 0\n").unwrap();
        assert_eq!(packed, pack(b"1 0 .1 0\n").unwrap());
        assert_eq!(
            packed.get(3..8),
            Some([0, 0, 0, 0, 0].as_slice()),
            "flags and time"
        );
        assert_eq!(unpack(&packed, &Limits::default()).unwrap(), b"1 0 .1 0\n");
    }

    #[test]
    fn plain_text_is_its_own_text_and_a_damaged_pack_is_refused() {
        assert_eq!(unpack(b"# a", &Limits::default()).unwrap(), b"# a");
        let packed = pack(b"1 0 .1 0\n").unwrap();
        assert!(unpack(&packed[..12], &Limits::default()).is_err());
    }
}
