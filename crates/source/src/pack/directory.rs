//! The list of members at the end of a zip, as Python's `zipfile` reads it.
//!
//! The `zip` library joins members of one name and hides what a name says in bytes, so the list is
//! read here.

use super::PackFault;

/// Members that are listed at most; no pack of assets comes near.
pub(super) const MOST_MEMBERS: usize = 100_000;

/// One row of the list.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Record {
    /// The name as it is stored.
    pub(super) name: Vec<u8>,
    /// Whether the name is marked as UTF-8.
    pub(super) is_utf8: bool,
    pub(super) is_encrypted: bool,
    /// Whether Unix would make a symbolic link of it.
    pub(super) is_link: bool,
    pub(super) method: u16,
    pub(super) crc: u32,
    pub(super) packed: u64,
    pub(super) size: u64,
    /// Where its own header begins.
    pub(super) at: u64,
}

const END: [u8; 4] = *b"PK\x05\x06";
const END_BYTES: usize = 22;
const LONGEST_COMMENT: usize = u16::MAX as usize;
const LARGE_END: [u8; 4] = *b"PK\x06\x06";
const LARGE_END_BYTES: usize = 56;
const LARGE_LOCATOR: [u8; 4] = *b"PK\x06\x07";
const LARGE_LOCATOR_BYTES: usize = 20;
const ROW: [u8; 4] = *b"PK\x01\x02";
const ROW_BYTES: usize = 46;
const HEADER: [u8; 4] = *b"PK\x03\x04";
const HEADER_BYTES: usize = 30;

/// All members in the order of the list.
pub(super) fn records(zip: &[u8]) -> Result<Vec<Record>, PackFault> {
    let (rows, shift) = list(zip)?;
    let mut records = Vec::new();
    let mut at = 0;
    while at < rows.len() {
        if records.len() == MOST_MEMBERS {
            return Err(PackFault::TooMany { most: MOST_MEMBERS });
        }
        let (record, next) = row(rows, at, shift).ok_or(PackFault::List)?;
        records.push(record);
        at = next;
    }
    Ok(records)
}

/// The bytes of the list, and how far everything lies behind where the zip says: there may be
/// something in front of it.
fn list(zip: &[u8]) -> Result<(&[u8], u64), PackFault> {
    let end = end(zip).ok_or(PackFault::NoZip)?;
    let (size, offset) = (
        u64::from(u32_at(zip, end + 12).unwrap_or(0)),
        u64::from(u32_at(zip, end + 16).unwrap_or(0)),
    );
    let (size, offset, end) = large(zip, end).unwrap_or((size, offset, end));
    let start = (end as u64).checked_sub(size).ok_or(PackFault::List)?;
    let shift = start.checked_sub(offset).ok_or(PackFault::List)?;
    let rows = usize::try_from(start)
        .ok()
        .and_then(|start| zip.get(start..end))
        .ok_or(PackFault::List)?;
    Ok((rows, shift))
}

/// Where the end record begins: behind it there may be a comment.
fn end(zip: &[u8]) -> Option<usize> {
    let last = zip.len().checked_sub(END_BYTES)?;
    let first = last.saturating_sub(LONGEST_COMMENT);
    (first..=last)
        .rev()
        .find(|at| zip.get(*at..).is_some_and(|rest| rest.starts_with(&END)))
}

/// The same of a zip with large numbers: size and place of the list, and where the list ends.
fn large(zip: &[u8], end: usize) -> Option<(u64, u64, usize)> {
    let locator = end.checked_sub(LARGE_LOCATOR_BYTES)?;
    zip.get(locator..)?
        .starts_with(&LARGE_LOCATOR)
        .then_some(())?;
    let record = locator.checked_sub(LARGE_END_BYTES)?;
    zip.get(record..)?.starts_with(&LARGE_END).then_some(())?;
    Some((u64_at(zip, record + 40)?, u64_at(zip, record + 48)?, record))
}

fn row(rows: &[u8], at: usize, shift: u64) -> Option<(Record, usize)> {
    let row = rows.get(at..)?;
    row.starts_with(&ROW).then_some(())?;
    let flags = u16_at(row, 8)?;
    let [name, extra, comment] = [28, 30, 32].map(|at| u16_at(row, at).map(usize::from));
    let (name_end, extra_end) = (ROW_BYTES + name?, ROW_BYTES + name? + extra?);
    let sizes = [24, 20, 42].map(|at| u32_at(row, at).map(u64::from));
    let [size, packed, offset] = wide(
        [sizes[0]?, sizes[1]?, sizes[2]?],
        row.get(name_end..extra_end)?,
    );
    let record = Record {
        name: row.get(ROW_BYTES..name_end)?.to_vec(),
        is_utf8: flags & 0x800 != 0,
        is_encrypted: flags & 1 != 0,
        is_link: (u32_at(row, 38)? >> 16) & 0o17_0000 == 0o12_0000,
        method: u16_at(row, 10)?,
        crc: u32_at(row, 16)?,
        packed,
        size,
        at: offset.checked_add(shift)?,
    };
    row.get(..extra_end + comment?)?;
    Some((record, at + extra_end + comment?))
}

/// Numbers that do not fit their places stand in an extra field, in this order.
fn wide(mut numbers: [u64; 3], mut extra: &[u8]) -> [u64; 3] {
    while let (Some(id), Some(length)) = (u16_at(extra, 0), u16_at(extra, 2)) {
        let end = 4 + usize::from(length);
        let field = extra.get(4..end).unwrap_or_default();
        if id == 1 {
            let mut at = 0;
            for number in numbers
                .iter_mut()
                .filter(|number| **number == u64::from(u32::MAX))
            {
                *number = u64_at(field, at).unwrap_or(*number);
                at += 8;
            }
            return numbers;
        }
        extra = extra.get(end..).unwrap_or_default();
    }
    numbers
}

/// The packed bytes of a member: its own header must name it as the list does.
pub(super) fn packed<'z>(zip: &'z [u8], record: &Record) -> Result<&'z [u8], &'static str> {
    const CUT: &str = "its data is missing";
    let header = usize::try_from(record.at)
        .ok()
        .and_then(|at| zip.get(at..))
        .ok_or(CUT)?;
    let lengths = [26, 28].map(|at| u16_at(header, at).map(usize::from));
    let [Some(name), Some(extra)] = lengths else {
        return Err(CUT);
    };
    let named = header.get(HEADER_BYTES..HEADER_BYTES + name).ok_or(CUT)?;
    if !header.starts_with(&HEADER) || named != record.name {
        return Err("its header does not match the list of members");
    }
    let start = HEADER_BYTES + name + extra;
    let length = usize::try_from(record.packed).map_err(|_| CUT)?;
    start
        .checked_add(length)
        .and_then(|end| header.get(start..end))
        .ok_or(CUT)
}

fn u16_at(bytes: &[u8], at: usize) -> Option<u16> {
    bytes
        .get(at..at.checked_add(2)?)?
        .try_into()
        .ok()
        .map(u16::from_le_bytes)
}

fn u32_at(bytes: &[u8], at: usize) -> Option<u32> {
    bytes
        .get(at..at.checked_add(4)?)?
        .try_into()
        .ok()
        .map(u32::from_le_bytes)
}

fn u64_at(bytes: &[u8], at: usize) -> Option<u64> {
    bytes
        .get(at..at.checked_add(8)?)?
        .try_into()
        .ok()
        .map(u64::from_le_bytes)
}
