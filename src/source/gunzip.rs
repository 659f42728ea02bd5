//! Bounded unpacking of gzip files, all members of them.

use std::io::Read;

use flate2::bufread::GzDecoder;

use super::Limits;

/// Why a gzip file could not be unpacked.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum GzipFault {
    /// Truncated, bad checksum, no gzip at all.
    Corrupt(String),
    /// Bytes behind the last member that are no member.
    TrailingGarbage {
        /// How many.
        bytes: usize,
    },
    /// Unpacks beyond the limits; nothing more was unpacked.
    Bomb {
        /// Packed size in bytes.
        packed: u64,
        /// Unpacked bytes at which the work was given up.
        unpacked: u64,
    },
}

const MAGIC: [u8; 2] = [0x1f, 0x8b];
const CHUNK: usize = 64 << 10;

/// Unpacks `packed` within `limits`.
pub fn gunzip(packed: &[u8], limits: &Limits) -> Result<Vec<u8>, GzipFault> {
    let limit = unpacked_limit(packed.len() as u64, limits);
    let mut out = Vec::with_capacity((packed.len() * 4).min(CHUNK * 16));
    let mut rest = packed;
    loop {
        rest = unpack_member(rest, packed.len() as u64, limit, &mut out)?;
        if rest.is_empty() {
            return Ok(out);
        }
        if !rest.starts_with(&MAGIC) {
            return Err(GzipFault::TrailingGarbage { bytes: rest.len() });
        }
    }
}

fn unpacked_limit(packed: u64, limits: &Limits) -> u64 {
    let by_ratio = packed.saturating_mul(limits.unpacked_ratio).max(limits.ratio_free_bytes);
    by_ratio.min(limits.unpacked_bytes)
}

fn unpack_member<'a>(packed: &'a [u8], total: u64, limit: u64, out: &mut Vec<u8>) -> Result<&'a [u8], GzipFault> {
    let mut decoder = GzDecoder::new(packed);
    let room = limit.saturating_sub(out.len() as u64);
    (&mut decoder)
        .take(room.saturating_add(1))
        .read_to_end(out)
        .map_err(|error| GzipFault::Corrupt(error.to_string()))?;
    if out.len() as u64 > limit {
        return Err(GzipFault::Bomb { packed: total, unpacked: out.len() as u64 });
    }
    Ok(decoder.into_inner())
}

#[cfg(test)]
mod tests {
    use std::io::Write;

    use flate2::{Compression, write::GzEncoder};

    use super::*;

    fn pack(bytes: &[u8]) -> Vec<u8> {
        let mut encoder = GzEncoder::new(Vec::new(), Compression::best());
        encoder.write_all(bytes).unwrap();
        encoder.finish().unwrap()
    }

    #[test]
    fn members_are_joined() {
        let packed = [pack(b"one "), pack(b"two")].concat();
        assert_eq!(gunzip(&packed, &Limits::default()).unwrap(), b"one two");
    }

    #[test]
    fn every_truncation_is_corrupt() {
        let packed = pack(b"0 .1 .2 .3\n1 .1 .2 .3\n");
        for length in 0..packed.len() {
            assert!(matches!(gunzip(&packed[..length], &Limits::default()), Err(GzipFault::Corrupt(_))));
        }
    }

    #[test]
    fn garbage_behind_the_end_is_named() {
        let packed = [pack(b"x"), b"junk".to_vec()].concat();
        assert_eq!(gunzip(&packed, &Limits::default()), Err(GzipFault::TrailingGarbage { bytes: 4 }));
    }

    #[test]
    fn zeros_beyond_the_ratio_are_a_bomb() {
        let packed = pack(&vec![0; 20 << 20]);
        assert!(matches!(gunzip(&packed, &Limits::default()), Err(GzipFault::Bomb { .. })));
    }
}
