//! The bytes of one member, as many as the list of members states and no more.

use std::io::{self, Read, Write};

use flate2::Crc;
use flate2::bufread::DeflateDecoder;

use super::MemberFault;
use super::directory::{Record, packed};

/// Ways to pack: not at all, and the usual one.
const STORED: u16 = 0;
const DEFLATED: u16 = 8;

/// Of a size that a stranger states, this much is taken at once.
const AT_ONCE: u64 = 1 << 20;

/// Whether a member can be unpacked.
pub(super) fn check(zip: &[u8], record: &Record) -> Result<(), MemberFault> {
    unpack_to(zip, record, io::sink())
}

/// The bytes of a member.
pub(super) fn unpack(zip: &[u8], record: &Record) -> Result<Vec<u8>, MemberFault> {
    let mut bytes = Vec::with_capacity(usize::try_from(record.size.min(AT_ONCE)).unwrap_or(0));
    unpack_to(zip, record, &mut bytes).map(|()| bytes)
}

fn unpack_to(zip: &[u8], record: &Record, out: impl Write) -> Result<(), MemberFault> {
    let packed = packed(zip, record).map_err(MemberFault::Damaged)?;
    let mut out = Summed {
        out,
        crc: Crc::new(),
        size: 0,
    };
    // One more, to see that there is more.
    let most = record.size.saturating_add(1);
    let copied = match record.method {
        STORED => io::copy(&mut packed.take(most), &mut out),
        DEFLATED => io::copy(&mut DeflateDecoder::new(packed).take(most), &mut out),
        method => return Err(MemberFault::Method(method)),
    };
    copied.map_err(|_| MemberFault::Damaged("its content is damaged"))?;
    if out.size != record.size {
        return Err(MemberFault::Damaged(
            "it does not have the size in the list of members",
        ));
    }
    if out.crc.sum() != record.crc {
        return Err(MemberFault::Damaged(
            "its content does not match its checksum",
        ));
    }
    Ok(())
}

/// What is written on, counted and summed up.
struct Summed<W> {
    out: W,
    crc: Crc,
    size: u64,
}

impl<W: Write> Write for Summed<W> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let written = self.out.write(bytes)?;
        self.crc.update(bytes.get(..written).unwrap_or_default());
        self.size += written as u64;
        Ok(written)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.out.flush()
    }
}
