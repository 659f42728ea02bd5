//! A whole `.npy` array as rows of cells, for what has to be looked at in no particular order.
//!
//! Gets the stream of a member and what its rows must be made of, returns the bytes as they are:
//! they take no more memory than was unpacked, whatever the header says.

use std::io::Read;

use crate::npy::{Field, Layout, NpyFault, Scalar, finish, read_layout};

/// What a cell of a row must be.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Cell {
    Integer,
    Number,
    Flag,
    /// A text of single bytes.
    Text,
}

/// Rows of cells.
pub(crate) struct Table {
    /// How many rows.
    pub(crate) rows: usize,
    /// Where the cells of a row are.
    cells: Vec<Scalar>,
    element: usize,
    /// Elements of a row, and whether those of a column stand together.
    width: usize,
    by_column: bool,
    bytes: Vec<u8>,
}

/// Reads an array to its end.
pub(crate) fn read(reader: &mut impl Read, cells: &[Cell]) -> Result<Table, NpyFault> {
    read_shaped(reader, cells, false)
}

/// The same, where a single value without a shape is one row.
pub(crate) fn read_any(reader: &mut impl Read, cells: &[Cell]) -> Result<Table, NpyFault> {
    read_shaped(reader, cells, true)
}

fn read_shaped(
    reader: &mut impl Read,
    cells: &[Cell],
    takes_values: bool,
) -> Result<Table, NpyFault> {
    let layout = read_layout(reader)?;
    let (rows, width) = match *layout.shape.as_slice() {
        [] if takes_values => (1, 1),
        [rows] => (rows, 1),
        [rows, width] if layout.is_plain() && cells.len() > 1 => (rows, width),
        _ => return Err(NpyFault::Shape),
    };
    let scalars = fitting(
        &layout,
        usize::try_from(width).map_err(|_| NpyFault::Shape)?,
        cells,
    )?;
    let bytes = read_bytes(reader, rows, width, layout.bytes)?;
    finish(reader)?;
    let rows = usize::try_from(rows).map_err(|_| NpyFault::Header)?;
    let width = usize::try_from(width).map_err(|_| NpyFault::Header)?;
    Ok(Table {
        rows,
        cells: scalars,
        element: layout.bytes,
        width,
        by_column: layout.by_column,
        bytes,
    })
}

impl Layout {
    fn is_plain(&self) -> bool {
        matches!(self.fields.as_slice(), [only] if only.name.is_empty())
    }
}

/// Where the cells of a row are, if they are what they must be.
fn fitting(layout: &Layout, width: usize, cells: &[Cell]) -> Result<Vec<Scalar>, NpyFault> {
    let fields: Vec<&Field> = match layout.fields.as_slice() {
        [plain] if layout.is_plain() => cells.iter().map(|_| plain).collect(),
        fields => fields.iter().collect(),
    };
    if fields.len() != cells.len() || layout.is_plain() && width != cells.len() {
        return Err(NpyFault::Shape);
    }
    let scalar = |(field, cell): (&&Field, &Cell)| {
        let is_fit = field.values == 1 && cell.takes(field.scalar);
        is_fit
            .then_some(field.scalar)
            .ok_or_else(|| NpyFault::WrongType("", field.type_text.clone()))
    };
    fields.iter().zip(cells).map(scalar).collect()
}

/// The bytes of all elements. What the header promises is no size to reserve.
fn read_bytes(
    reader: &mut impl Read,
    rows: u64,
    width: u64,
    element: usize,
) -> Result<Vec<u8>, NpyFault> {
    if element == 0 && rows > 0 {
        return Err(NpyFault::Header);
    }
    let promised = (element as u64)
        .checked_mul(width)
        .and_then(|row| row.checked_mul(rows));
    let promised = promised.ok_or(NpyFault::Truncated)?;
    let mut bytes = Vec::new();
    reader
        .take(promised)
        .read_to_end(&mut bytes)
        .map_err(|error| NpyFault::Damaged(error.to_string()))?;
    if bytes.len() as u64 == promised {
        Ok(bytes)
    } else {
        Err(NpyFault::Truncated)
    }
}

impl Cell {
    fn takes(self, scalar: Scalar) -> bool {
        match self {
            Self::Integer => scalar.is_integer(),
            Self::Number => scalar.is_number(),
            Self::Flag => scalar.is_flag(),
            Self::Text => scalar.is_text(),
        }
    }
}

impl Table {
    /// The number in a cell.
    pub(crate) fn number(&self, row: usize, cell: usize) -> Option<f64> {
        self.cells.get(cell)?.value(self.element(row, cell)?, 0)
    }

    /// The whole number in a cell.
    #[expect(
        clippy::cast_possible_truncation,
        reason = "saturates, beyond everything that it can be compared with"
    )]
    pub(crate) fn integer(&self, row: usize, cell: usize) -> Option<i64> {
        Some(self.number(row, cell)? as i64)
    }

    /// The text in a cell, without the zeros behind it.
    pub(crate) fn text(&self, row: usize, cell: usize) -> Option<&[u8]> {
        let stored = self.cells.get(cell)?.stored(self.element(row, cell)?, 0)?;
        let length = stored
            .iter()
            .rposition(|byte| *byte != 0)
            .map_or(0, |last| last + 1);
        stored.get(..length)
    }

    fn element(&self, row: usize, cell: usize) -> Option<&[u8]> {
        let place = match (self.width, self.by_column) {
            (1, _) => row,
            (_, true) => cell.checked_mul(self.rows)?.checked_add(row)?,
            (width, false) => row.checked_mul(width)?.checked_add(cell)?,
        };
        let start = place.checked_mul(self.element)?;
        self.bytes.get(start..start.checked_add(self.element)?)
    }
}
