//! `.npy`: an array as `NumPy` stores it, read without `NumPy`'s dangers.
//!
//! Gets the bytes of a stream, returns what the array is made of, and its bytes where they are
//! asked for, or why it cannot be used. Object arrays are rejected by their header: loading them
//! would mean running a pickle. No size in the header is trusted.

mod header;
pub(crate) mod table;

use std::io::{ErrorKind, Read};

use crate::npy::header::{Literal, parse_header};

/// Why an array cannot be used for what it is in the archive for.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum NpyFault {
    /// No array of `NumPy`.
    NotNpy,
    /// A header that `NumPy` rejects.
    Header,
    /// Holds Python objects; `NumPy` refuses to unpickle them.
    Object,
    /// No field of this name.
    MissingField(&'static str),
    /// A field of another type or length than needed, with its type. A plain array is a field
    /// without a name.
    WrongType(&'static str, String),
    /// Not one row behind the other, or rows of another length than needed.
    Shape,
    /// Ends before its last row.
    Truncated,
    /// A text that is no UTF-8.
    NotUtf8,
    /// Cannot be unpacked.
    Damaged(String),
}

const MAGIC: &[u8] = b"\x93NUMPY";
/// `NumPy`'s own bound on the text of a header.
const HEADER_BYTES: usize = 10_000;
/// A row of a target has 16 bytes, 32 in the widest types; a stranger's row may hold more fields.
const ROW_BYTES: usize = 4096;

/// What an array is made of.
pub(super) struct Layout {
    /// Numbers of elements, for each dimension.
    pub(super) shape: Vec<u64>,
    /// Fields of an element; one without a name if it is a plain value.
    pub(super) fields: Vec<Field>,
    /// Bytes of an element.
    pub(super) bytes: usize,
    /// Whether the elements of a column stand together, not those of a row.
    pub(super) by_column: bool,
}

/// A field of an element.
#[derive(Debug)]
pub(super) struct Field {
    pub(super) name: String,
    /// Its type as the header writes it.
    pub(super) type_text: String,
    /// How many values it has.
    pub(super) values: usize,
    pub(super) scalar: Scalar,
}

/// One value in the bytes of an element.
#[derive(Debug, Clone, Copy)]
pub(super) struct Scalar {
    offset: usize,
    kind: u8,
    bytes: usize,
    big_endian: bool,
}

/// Reads the header of an array, up to its first row.
pub(super) fn read_layout(reader: &mut impl Read) -> Result<Layout, NpyFault> {
    let none_is = |fault: NpyFault| move |found: Option<NpyFault>| found.unwrap_or(fault);
    let mut start = [0; 8];
    fill(reader, &mut start).map_err(none_is(NpyFault::NotNpy))?;
    let [.., major, _] = start;
    if !start.starts_with(MAGIC) {
        return Err(NpyFault::NotNpy);
    }
    let mut length = [0; 4];
    let width = if major == 1 { 2 } else { 4 };
    fill(reader, length.get_mut(..width).unwrap_or_default())
        .map_err(none_is(NpyFault::Truncated))?;
    let length = u32::from_le_bytes(length) as usize;
    if !(1..=3).contains(&major) || length > HEADER_BYTES {
        return Err(NpyFault::Header);
    }
    let mut text = vec![0; length];
    fill(reader, &mut text).map_err(none_is(NpyFault::Truncated))?;
    Layout::of(&parse_header(&text).ok_or(NpyFault::Header)?)
}

/// Fills the buffer; the fault is `None` where the stream just ends.
pub(super) fn fill(reader: &mut impl Read, buffer: &mut [u8]) -> Result<(), Option<NpyFault>> {
    reader
        .read_exact(buffer)
        .map_err(|error| match error.kind() {
            ErrorKind::UnexpectedEof => None,
            _ => Some(NpyFault::Damaged(error.to_string())),
        })
}

/// Reads what is left: the checksum of a zip member is only compared at its end.
pub(super) fn finish(reader: &mut impl Read) -> Result<(), NpyFault> {
    std::io::copy(reader, &mut std::io::sink())
        .map(drop)
        .map_err(|error| NpyFault::Damaged(error.to_string()))
}

impl Layout {
    fn of(header: &Literal) -> Result<Self, NpyFault> {
        let descr = header.get("descr").ok_or(NpyFault::Header)?;
        if descr.any_text(&|text| {
            text.trim_start_matches(['<', '>', '|', '='])
                .starts_with('O')
        }) {
            return Err(NpyFault::Object);
        }
        let mut bytes = 0;
        let fields = match descr.text() {
            Some(plain) => Field::new("", plain, 1, &mut bytes).map(|field| vec![field]),
            None => descr
                .items()
                .iter()
                .map(|field| Field::of(field, &mut bytes))
                .collect(),
        };
        let shape = header.get("shape").map(Literal::items).unwrap_or_default();
        let shape: Option<Vec<u64>> = shape.iter().map(Literal::number).collect();
        let by_column = header.get("fortran_order").and_then(Literal::text) == Some("True");
        match (fields, shape) {
            (Some(fields), Some(shape)) if bytes <= ROW_BYTES => Ok(Self {
                shape,
                fields,
                bytes,
                by_column,
            }),
            _ => Err(NpyFault::Header),
        }
    }
}

impl Field {
    /// A field as a header writes it: name, type, and how many values it has if that is not one.
    fn of(field: &Literal, offset: &mut usize) -> Option<Self> {
        let [name, kind, shape @ ..] = field.items() else {
            return None;
        };
        let values = shape.first().map_or(Some(1), |shape| {
            shape
                .items()
                .iter()
                .try_fold(1_u64, |all, part| all.checked_mul(part.number()?))
        });
        Self::new(
            name.text()?,
            kind.text()?,
            usize::try_from(values?).ok()?,
            offset,
        )
    }

    /// A field behind the first `offset` bytes of an element, which then are more.
    fn new(name: &str, type_text: &str, values: usize, offset: &mut usize) -> Option<Self> {
        let scalar = Scalar::of(type_text, *offset)?;
        *offset = values
            .checked_mul(scalar.bytes)
            .and_then(|bytes| bytes.checked_add(*offset))
            .unwrap_or(usize::MAX);
        Some(Self {
            name: name.to_owned(),
            type_text: type_text.to_owned(),
            values,
            scalar,
        })
    }
}

impl Scalar {
    /// The scalar type of a type text such as `<u4`.
    fn of(text: &str, offset: usize) -> Option<Self> {
        let big_endian = text.starts_with('>');
        // Another way to write a truth value.
        let text = if text.trim_start_matches(['<', '>', '|', '=']) == "?" {
            "|b1"
        } else {
            text
        };
        let (kind, bytes) = text
            .trim_start_matches(['<', '>', '|', '='])
            .split_at_checked(1)?;
        let kind = *kind.as_bytes().first()?;
        let bytes = bytes.parse().ok().filter(|bytes| *bytes <= ROW_BYTES)?;
        // Unicode texts count characters of four bytes.
        Some(Self {
            offset,
            kind,
            bytes: if kind == b'U' { bytes * 4 } else { bytes },
            big_endian,
        })
    }

    pub(super) fn is_integer(self) -> bool {
        matches!((self.kind, self.bytes), (b'u' | b'i', 1 | 2 | 4 | 8))
    }

    pub(super) fn is_number(self) -> bool {
        self.is_integer() || matches!((self.kind, self.bytes), (b'f', 4 | 8))
    }

    /// Whether it is a truth value, or a number that can be taken for one.
    pub(super) fn is_flag(self) -> bool {
        self.is_number() || matches!((self.kind, self.bytes), (b'b', 1))
    }

    /// Whether it is a text of single bytes.
    pub(super) fn is_text(self) -> bool {
        self.kind == b'S'
    }

    /// Number `at` of the values of the field. 64 bit integers beyond 2^53 are rounded: far beyond
    /// any vertex.
    pub(super) fn value(self, element: &[u8], at: usize) -> Option<f64> {
        let stored = self.stored(element, at)?;
        let mut bytes = [0; 8];
        for (to, from) in bytes.iter_mut().zip(0..self.bytes) {
            *to = *stored.get(if self.big_endian {
                self.bytes - 1 - from
            } else {
                from
            })?;
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

    /// The bytes of a value.
    pub(super) fn stored(self, element: &[u8], at: usize) -> Option<&[u8]> {
        let start = self.offset.checked_add(at.checked_mul(self.bytes)?)?;
        element.get(start..start.checked_add(self.bytes)?)
    }
}
