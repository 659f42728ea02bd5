//! `.npy`: one array of target rows as `NumPy` stores it, read without `NumPy`'s dangers.
//!
//! Gets the bytes of a stream, returns the number of rows and the hash of their content, or why the
//! application could not use them (formats/makehuman2.md §6.2). Object arrays are refused by their
//! header: loading them would mean running a pickle. No size in the header is trusted.

use std::io::{ErrorKind, Read};

use super::content_hash::ContentHash;
use super::npy_header::{Literal, parse_header};
use super::stored;

/// Why an array cannot be used as a target.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum NpyFault {
    /// No array of `NumPy`.
    NotNpy,
    /// A header that `NumPy` refuses.
    Header,
    /// Holds Python objects; `NumPy` refuses to unpickle them.
    Object,
    /// No field of this name.
    MissingField(&'static str),
    /// A field of another type or length than a target needs, with its type.
    WrongType(&'static str, String),
    /// Not one row behind the other.
    Shape,
    /// Ends before its last row.
    Truncated,
    /// Cannot be unpacked.
    Damaged(String),
}

/// What an array holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Rows {
    /// How many rows.
    pub count: u64,
    /// Hash as of a text target with the same rows.
    pub content: u64,
}

const MAGIC: &[u8] = b"\x93NUMPY";
/// `NumPy`'s own bound on the text of a header.
const HEADER_BYTES: usize = 10_000;
/// A row of a target has 16 bytes, 32 in the widest types; a stranger's row may hold more fields.
const ROW_BYTES: usize = 4096;

/// Reads an array to its end.
pub(super) fn read(reader: &mut impl Read) -> Result<Rows, NpyFault> {
    let layout = read_layout(reader)?;
    let mut row = vec![0; layout.row_bytes];
    let mut hash = ContentHash::default();
    for _ in 0..layout.rows {
        fill(reader, &mut row).map_err(|fault| fault.unwrap_or(NpyFault::Truncated))?;
        let (index, delta) = layout.row(&row).ok_or(NpyFault::Header)?;
        if let Ok(index) = u32::try_from(index) {
            hash.add(index, delta);
        }
    }
    // The checksum of a zip member is only compared at its end.
    std::io::copy(reader, &mut std::io::sink()).map_err(|error| NpyFault::Damaged(error.to_string()))?;
    Ok(Rows { count: layout.rows, content: hash.finish() })
}

/// Fills the buffer; the fault is `None` where the stream just ends.
fn fill(reader: &mut impl Read, buffer: &mut [u8]) -> Result<(), Option<NpyFault>> {
    reader.read_exact(buffer).map_err(|error| match error.kind() {
        ErrorKind::UnexpectedEof => None,
        _ => Some(NpyFault::Damaged(error.to_string())),
    })
}

struct Layout {
    rows: u64,
    row_bytes: usize,
    index: Field,
    vector: Field,
}

#[derive(Clone, Copy)]
struct Field {
    offset: usize,
    kind: u8,
    bytes: usize,
    big_endian: bool,
}

fn read_layout(reader: &mut impl Read) -> Result<Layout, NpyFault> {
    let none_is = |fault: NpyFault| move |found: Option<NpyFault>| found.unwrap_or(fault);
    let mut start = [0; 8];
    fill(reader, &mut start).map_err(none_is(NpyFault::NotNpy))?;
    let [.., major, _] = start;
    if !start.starts_with(MAGIC) {
        return Err(NpyFault::NotNpy);
    }
    let mut length = [0; 4];
    let width = if major == 1 { 2 } else { 4 };
    fill(reader, length.get_mut(..width).unwrap_or_default()).map_err(none_is(NpyFault::Truncated))?;
    let length = u32::from_le_bytes(length) as usize;
    if !(1..=3).contains(&major) || length > HEADER_BYTES {
        return Err(NpyFault::Header);
    }
    let mut text = vec![0; length];
    fill(reader, &mut text).map_err(none_is(NpyFault::Truncated))?;
    layout(&parse_header(&text).ok_or(NpyFault::Header)?)
}

fn layout(header: &Literal) -> Result<Layout, NpyFault> {
    let descr = header.get("descr").ok_or(NpyFault::Header)?;
    if descr.any_text(&|text| text.trim_start_matches(['<', '>', '|', '=']).starts_with('O')) {
        return Err(NpyFault::Object);
    }
    let mut row_bytes = 0_usize;
    let (mut index, mut vector) = (None, None);
    for field in descr.items() {
        let [name, kind, shape @ ..] = field.items() else { return Err(NpyFault::Header) };
        let (Some(name), Some(kind)) = (name.text(), kind.text()) else { return Err(NpyFault::Header) };
        let values = shape
            .first()
            .map_or(Some(1), |shape| shape.items().iter().try_fold(1_u64, |all, part| all.checked_mul(part.number()?)));
        let values = values.and_then(|values| usize::try_from(values).ok()).ok_or(NpyFault::Header)?;
        let scalar = Field::of(kind, row_bytes).ok_or(NpyFault::Header)?;
        match name {
            "index" => index = Some((scalar.integer(values), kind)),
            "vector" => vector = Some((scalar.number(values), kind)),
            _ => {}
        }
        row_bytes =
            values.checked_mul(scalar.bytes).and_then(|bytes| bytes.checked_add(row_bytes)).unwrap_or(usize::MAX);
    }
    let usable = |name: &'static str, found: Option<(Option<Field>, &str)>| {
        let (field, kind) = found.ok_or(NpyFault::MissingField(name))?;
        field.ok_or_else(|| NpyFault::WrongType(name, kind.to_owned()))
    };
    let (index, vector) = (usable("index", index)?, usable("vector", vector)?);
    let [rows] = header.get("shape").map(Literal::items).unwrap_or_default() else { return Err(NpyFault::Shape) };
    let rows = rows.number().ok_or(NpyFault::Header)?;
    if row_bytes > ROW_BYTES { Err(NpyFault::Header) } else { Ok(Layout { rows, row_bytes, index, vector }) }
}

impl Layout {
    fn row(&self, row: &[u8]) -> Option<(i64, [f32; 3])> {
        let index = self.index.value(row, 0)?;
        let mut delta = [0.0; 3];
        for (at, part) in delta.iter_mut().enumerate() {
            *part = stored(self.vector.value(row, at)?);
        }
        #[expect(clippy::cast_possible_truncation, reason = "saturates; indices fit 32 bits or are left out")]
        Some((index as i64, delta))
    }
}

impl Field {
    /// The scalar type of a type text such as `<u4`.
    fn of(text: &str, offset: usize) -> Option<Self> {
        let big_endian = text.starts_with('>');
        let (kind, bytes) = text.trim_start_matches(['<', '>', '|', '=']).split_at_checked(1)?;
        let kind = *kind.as_bytes().first()?;
        let bytes = bytes.parse().ok().filter(|bytes| *bytes <= ROW_BYTES)?;
        // Unicode texts count characters of four bytes.
        Some(Self { offset, kind, bytes: if kind == b'U' { bytes * 4 } else { bytes }, big_endian })
    }

    fn integer(self, values: usize) -> Option<Self> {
        (values == 1 && matches!((self.kind, self.bytes), (b'u' | b'i', 1 | 2 | 4 | 8))).then_some(self)
    }

    fn number(self, values: usize) -> Option<Self> {
        (values == 3 && matches!((self.kind, self.bytes), (b'f', 4 | 8) | (b'u' | b'i', 1 | 2 | 4 | 8))).then_some(self)
    }

    /// Value number `at` of the field. 64 bit integers beyond 2^53 are rounded: far beyond any vertex.
    fn value(self, row: &[u8], at: usize) -> Option<f64> {
        let start = self.offset + at * self.bytes;
        let stored = row.get(start..start + self.bytes)?;
        let mut bytes = [0; 8];
        for (to, from) in bytes.iter_mut().zip(0..self.bytes) {
            *to = *stored.get(if self.big_endian { self.bytes - 1 - from } else { from })?;
        }
        let bits = u64::from_le_bytes(bytes);
        let unused = 64 - 8 * u32::try_from(self.bytes).ok()?;
        Some(match (self.kind, self.bytes) {
            (b'f', 4) => f64::from(f32::from_bits(u32::try_from(bits).ok()?)),
            (b'f', _) => f64::from_bits(bits),
            (b'i', _) => ((bits << unused).cast_signed() >> unused) as f64,
            _ => bits as f64,
        })
    }
}
