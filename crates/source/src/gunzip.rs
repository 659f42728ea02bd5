//! Bounded unpacking of gzip files, all members of them.

use std::io::{self, Read, Write};

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
///
/// # Errors
/// Why it cannot be unpacked, or that it would not fit the limits.
pub fn gunzip(packed: &[u8], limits: &Limits) -> Result<Vec<u8>, GzipFault> {
    let mut out = Vec::with_capacity((packed.len() * 4).min(CHUNK * 16));
    unpack(packed, limits, &mut out)?;
    Ok(out)
}

/// The same if it comes to `most` bytes at most; `None` for more, of which nothing is kept.
///
/// # Errors
/// As [`gunzip`].
pub fn gunzip_at_most(
    packed: &[u8],
    limits: &Limits,
    most: usize,
) -> Result<Option<Vec<u8>>, GzipFault> {
    let mut kept = Kept {
        bytes: Vec::new(),
        most,
        is_whole: true,
    };
    unpack(packed, limits, &mut kept)?;
    Ok(kept.is_whole.then_some(kept.bytes))
}

/// Bytes as long as they are few.
struct Kept {
    bytes: Vec<u8>,
    most: usize,
    is_whole: bool,
}

impl Write for Kept {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.is_whole &= self.bytes.len() + bytes.len() <= self.most;
        if self.is_whole {
            self.bytes.extend_from_slice(bytes);
        } else {
            self.bytes = Vec::new();
        }
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

fn unpack(packed: &[u8], limits: &Limits, out: &mut impl Write) -> Result<u64, GzipFault> {
    let total = packed.len() as u64;
    let limit = limits.unpacked_limit(total);
    let mut unpacked = 0;
    let mut rest = packed;
    loop {
        let mut decoder = GzDecoder::new(rest);
        let mut bounded = (&mut decoder).take(limit.saturating_sub(unpacked).saturating_add(1));
        unpacked +=
            io::copy(&mut bounded, out).map_err(|error| GzipFault::Corrupt(error.to_string()))?;
        if unpacked > limit {
            return Err(GzipFault::Bomb {
                packed: total,
                unpacked,
            });
        }
        rest = decoder.into_inner();
        // Python passes over zeros at the end, too.
        if rest.iter().all(|byte| *byte == 0) {
            return Ok(unpacked);
        }
        if !rest.starts_with(&MAGIC) {
            return Err(GzipFault::TrailingGarbage { bytes: rest.len() });
        }
    }
}

#[cfg(test)]
mod tests {
    use flate2::{Compression, write::GzEncoder};
    use proptest::prelude::*;

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
            assert!(matches!(
                gunzip(&packed[..length], &Limits::default()),
                Err(GzipFault::Corrupt(_))
            ));
        }
    }

    #[test]
    fn garbage_behind_the_end_is_named() {
        let packed = [pack(b"x"), b"junk".to_vec()].concat();
        assert_eq!(
            gunzip(&packed, &Limits::default()),
            Err(GzipFault::TrailingGarbage { bytes: 4 })
        );
    }

    #[test]
    fn zeros_beyond_the_ratio_are_a_bomb() {
        let packed = pack(&vec![0; 20 << 20]);
        assert!(matches!(
            gunzip(&packed, &Limits::default()),
            Err(GzipFault::Bomb { .. })
        ));
    }

    #[test]
    fn a_small_file_of_very_many_zeros_stops_at_the_limit() {
        let packed = pack(&vec![0; 128 << 20]);
        let limits = Limits {
            unpacked_bytes: 32 << 20,
            unpacked_ratio: u64::MAX,
            ..Limits::default()
        };
        let fault = gunzip(&packed, &limits).unwrap_err();
        assert_eq!(
            fault,
            GzipFault::Bomb {
                packed: packed.len() as u64,
                unpacked: (32 << 20) + 1
            }
        );
        assert_eq!(gunzip(&packed, &limits), Err(fault));
    }

    #[test]
    fn the_limit_counts_all_members_together() {
        let packed = [pack(&[b'a'; 60]), pack(&[b'b'; 60])].concat();
        let limits = |bytes| Limits {
            unpacked_bytes: bytes,
            ..Limits::default()
        };
        assert_eq!(
            gunzip(&packed, &limits(120)).map(|bytes| bytes.len()),
            Ok(120)
        );
        assert!(matches!(
            gunzip(&packed, &limits(119)),
            Err(GzipFault::Bomb { .. })
        ));
    }

    #[test]
    fn only_one_layer_is_unpacked() {
        let inner = pack(b"inner");
        assert_eq!(gunzip(&pack(&inner), &Limits::default()).unwrap(), inner);
    }

    proptest! {
        #[test]
        fn what_was_packed_comes_back(bytes in proptest::collection::vec(any::<u8>(), 0..2000)) {
            let packed = pack(&bytes);
            prop_assert_eq!(gunzip(&packed, &Limits::default()).map(|out| out.len()), Ok(bytes.len()));
            prop_assert_eq!(gunzip(&packed, &Limits::default()).unwrap(), bytes);
        }

        #[test]
        fn noise_never_panics_nor_passes_the_limit(
            noise in proptest::collection::vec(any::<u8>(), 0..300),
            at in 0_usize..60,
        ) {
            let mut packed = pack(&[b'x'; 5000]);
            let at = at.min(packed.len());
            packed.splice(at.., noise);
            let limits = Limits { unpacked_bytes: 1000, ..Limits::default() };
            if let Ok(bytes) = gunzip(&packed, &limits) {
                prop_assert!(bytes.len() <= 1000);
            }
        }
    }
}
