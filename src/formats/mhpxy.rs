//! `.mhpxy`: what is worn as MakeHuman 1 packs it, and reads it in place of the text (formats/makehuman1.md §10.5).
//!
//! A zip of `.npy`. Gets its members and the size of the base mesh; returns what the text is compared with, or why it cannot
//! be loaded. Keeps no rows.

use super::fitting_columns::{self, Columns};
use super::mhclo::RowFacts;
use super::npy::NpyFault;
use super::npy_table::{self, Cell, Table};
use super::npz::Members;
use super::stored;
use super::target::MeshSize;

/// What is worn, as it is packed.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct PackedProxy {
    /// `name`, `uuid`.
    pub identity: [Box<str>; 2],
    /// The mesh, the material and the bone weights; empty where there are none.
    pub files: [Box<str>; 3],
    /// `z_depth`.
    pub z_depth: i64,
    /// What was counted of its rows.
    pub rows: RowFacts,
    /// Whether only the first vertex of each row is kept.
    pub is_exact: bool,
    /// For each axis that is scaled two vertices and their distance.
    pub scale: [Option<([i64; 2], f32)>; 3],
    /// Runs of vertices that it hides, and of how many.
    pub mask: Option<(usize, Vec<std::ops::Range<usize>>)>,
    /// What it lacks, or cannot be used of it, with the first reason.
    pub fault: Option<(&'static str, Option<NpyFault>)>,
}

/// Whether an archive is that of something worn.
pub(super) fn is_proxy(members: &Members<'_>) -> bool {
    members.has("num_refverts")
}

/// Reads an archive that [`is_proxy`] says is one.
pub(super) fn read(members: &mut Members<'_>, size: Option<MeshSize>) -> PackedProxy {
    let mut proxy = PackedProxy::default();
    proxy.fault = fill(members, &mut proxy, size).err();
    proxy
}

type Fault = (&'static str, Option<NpyFault>);

fn table(members: &mut Members<'_>, name: &'static str, cells: &[Cell]) -> Result<Table, Fault> {
    let table = members.read(name, |reader| npy_table::read_any(reader, cells)).ok_or((name, None))?;
    table.map_err(|fault| (name, Some(fault)))
}

/// A text, of which each byte is an element.
fn text(members: &mut Members<'_>, name: &'static str) -> Result<Box<str>, Fault> {
    let table = table(members, name, &[Cell::Text])?;
    let bytes: Vec<u8> = (0..table.rows).flat_map(|row| table.text(row, 0).unwrap_or_default()).copied().collect();
    Ok(String::from_utf8_lossy(&bytes).into())
}

fn text_if_any(members: &mut Members<'_>, name: &'static str) -> Result<Box<str>, Fault> {
    if members.has(name) { text(members, name) } else { Ok(Box::default()) }
}

fn integer(members: &mut Members<'_>, name: &'static str) -> Result<i64, Fault> {
    table(members, name, &[Cell::Integer])?.integer(0, 0).ok_or((name, Some(NpyFault::Shape)))
}

fn fill(members: &mut Members<'_>, proxy: &mut PackedProxy, size: Option<MeshSize>) -> Result<(), Fault> {
    proxy.identity = [text(members, "name")?, text(members, "uuid")?];
    let mesh = text(members, "obj_file")?;
    proxy.files = [mesh, text_if_any(members, "material_file")?, text_if_any(members, "vertexBoneWeights_file")?];
    proxy.z_depth = integer(members, "z_depth")?;
    proxy.is_exact = integer(members, "num_refverts")? == 1;
    rows(members, proxy, size)?;
    scale(members, proxy)?;
    if members.has("deleteVerts") {
        let flags = table(members, "deleteVerts", &[Cell::Flag])?;
        proxy.mask = Some((flags.rows, fitting_columns::runs(&flags)));
    }
    Ok(())
}

fn rows(members: &mut Members<'_>, proxy: &mut PackedProxy, size: Option<MeshSize>) -> Result<(), Fault> {
    let (integers, numbers) = fitting_columns::cells(proxy.is_exact);
    let vertices = table(members, "ref_vIdxs", integers)?;
    let weights = table(members, "weights", numbers)?;
    let offsets = if proxy.is_exact { None } else { Some(table(members, "offsets", numbers)?) };
    let fits = weights.rows == vertices.rows && offsets.as_ref().is_none_or(|own| own.rows == vertices.rows);
    if !fits {
        return Err(("weights", Some(NpyFault::Shape)));
    }
    proxy.rows = Columns { vertices, weights, offsets }.count(size);
    Ok(())
}

/// An axis without a scale is no number.
fn scale(members: &mut Members<'_>, proxy: &mut PackedProxy) -> Result<(), Fault> {
    if !members.has("tmat_scale") {
        return Ok(());
    }
    let distances = table(members, "tmat_scale", &[Cell::Number])?;
    let vertices = table(members, "tmat_scale_idx", &[Cell::Integer])?;
    let axis = |axis: usize| {
        let distance = distances.number(axis, 0).map(stored).filter(|distance| !distance.is_nan())?;
        Some(([vertices.integer(2 * axis, 0)?, vertices.integer(2 * axis + 1, 0)?], distance))
    };
    proxy.scale = [0, 1, 2].map(axis);
    Ok(())
}
