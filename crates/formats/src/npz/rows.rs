//! The rows of a target in an archive (`docs/loaders/makehuman2/targets.md#the-archive`).
//!
//! Gets the stream of a member, returns the number of rows and the hash of their content, or why
//! the application could not use them.

use std::io::Read;

use crate::npy::{Layout, NpyFault, Scalar, fill, finish, read_layout};
use crate::stored;
use crate::target::content_hash::ContentHash;

/// What an array of target rows holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Rows {
    /// How many rows.
    pub count: u64,
    /// Hash as of a text target with the same rows.
    pub content: u64,
}

/// Reads an array to its end.
pub(super) fn read(reader: &mut impl Read) -> Result<Rows, NpyFault> {
    let layout = read_layout(reader)?;
    let (index, vector) = (
        field(&layout, "index", 1, Scalar::is_integer)?,
        field(&layout, "vector", 3, Scalar::is_number)?,
    );
    let [count] = layout.shape.as_slice() else {
        return Err(NpyFault::Shape);
    };
    let mut row = vec![0; layout.bytes];
    let mut hash = ContentHash::default();
    for _ in 0..*count {
        fill(reader, &mut row).map_err(|fault| fault.unwrap_or(NpyFault::Truncated))?;
        let index = index.value(&row, 0).ok_or(NpyFault::Header)?;
        let mut delta = [0.0; 3];
        for (at, part) in delta.iter_mut().enumerate() {
            *part = stored(vector.value(&row, at).ok_or(NpyFault::Header)?);
        }
        if let Some(index) = vertex(index) {
            hash.add(index, delta);
        }
    }
    finish(reader)?;
    Ok(Rows {
        count: *count,
        content: hash.finish(),
    })
}

/// The field of a name; of several the last.
fn field(
    layout: &Layout,
    name: &'static str,
    values: usize,
    fits: fn(Scalar) -> bool,
) -> Result<Scalar, NpyFault> {
    let found = layout
        .fields
        .iter()
        .rev()
        .find(|field| field.name == name)
        .ok_or(NpyFault::MissingField(name))?;
    let usable = found.values == values && fits(found.scalar);
    if usable {
        Ok(found.scalar)
    } else {
        Err(NpyFault::WrongType(name, found.type_text.clone()))
    }
}

/// The vertex of a row, if it is a number that a mesh could have.
#[expect(
    clippy::cast_possible_truncation,
    reason = "saturates; indices fit 32 bits or are left out"
)]
fn vertex(index: f64) -> Option<u32> {
    u32::try_from(index as i64).ok()
}
