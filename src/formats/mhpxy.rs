//! `.mhpxy`: what is worn as MakeHuman 1 packs it, and reads it in place of the text (formats/makehuman1.md §10.5).
//!
//! A zip of `.npy`. Gets bytes, limits and the size of the base mesh; returns what the text is compared with, or why it cannot
//! be loaded. Keeps no rows.

use super::mhclo::{Reference, RowFacts};
use super::npy::NpyFault;
use super::npy_table::{self, Cell, Table};
use super::npz::{self, Zip};
use super::stored;
use super::target::MeshSize;
use crate::source::Limits;

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

/// Whether an archive with these members is that of something worn.
pub(super) fn is_proxy(names: &[String]) -> bool {
    names.iter().any(|name| name == "num_refverts")
}

/// Reads an archive that [`is_proxy`] says is one, within `limits`.
pub(super) fn parse(zip: Zip<'_>, names: Vec<String>, room: u64, size: Option<MeshSize>) -> PackedProxy {
    let mut proxy = PackedProxy::default();
    let mut members = Members { zip, names, room };
    if let Err(fault) = fill(&mut members, &mut proxy, size) {
        proxy.fault = Some(fault);
    }
    proxy
}

/// How much may be unpacked of an archive of so many bytes.
pub(super) fn room(bytes: usize, limits: &Limits) -> u64 {
    limits.of_arrays().unpacked_limit(bytes as u64)
}

type Fault = (&'static str, Option<NpyFault>);

struct Members<'b> {
    zip: Zip<'b>,
    names: Vec<String>,
    room: u64,
}

impl Members<'_> {
    fn has(&self, name: &str) -> bool {
        self.names.iter().any(|own| own == name)
    }

    fn read(&mut self, name: &'static str, cells: &[Cell]) -> Result<Table, Fault> {
        let place = self.names.iter().rposition(|own| own == name).ok_or((name, None))?;
        let (table, used) =
            npz::read_member(&mut self.zip, place, self.room, |reader| npy_table::read_any(reader, cells));
        self.room = self.room.saturating_sub(used);
        table.map_err(|fault| (name, Some(fault)))
    }

    /// A text, of which each byte is an element.
    fn text(&mut self, name: &'static str) -> Result<Box<str>, Fault> {
        let table = self.read(name, &[Cell::Text])?;
        let bytes: Vec<u8> = (0..table.rows).flat_map(|row| table.text(row, 0).unwrap_or_default()).copied().collect();
        Ok(String::from_utf8_lossy(&bytes).into())
    }

    fn text_if_any(&mut self, name: &'static str) -> Result<Box<str>, Fault> {
        if self.has(name) { self.text(name) } else { Ok(Box::default()) }
    }

    fn integer(&mut self, name: &'static str) -> Result<i64, Fault> {
        let table = self.read(name, &[Cell::Integer])?;
        table.integer(0, 0).ok_or((name, Some(NpyFault::Shape)))
    }
}

fn fill(members: &mut Members<'_>, proxy: &mut PackedProxy, size: Option<MeshSize>) -> Result<(), Fault> {
    proxy.identity = [members.text("name")?, members.text("uuid")?];
    let mesh = members.text("obj_file")?;
    proxy.files = [mesh, members.text_if_any("material_file")?, members.text_if_any("vertexBoneWeights_file")?];
    proxy.z_depth = members.integer("z_depth")?;
    proxy.is_exact = members.integer("num_refverts")? == 1;
    rows(members, proxy, size)?;
    scale(members, proxy)?;
    if members.has("deleteVerts") {
        let flags = members.read("deleteVerts", &[Cell::Flag])?;
        proxy.mask = Some((flags.rows, runs(&flags)));
    }
    Ok(())
}

fn rows(members: &mut Members<'_>, proxy: &mut PackedProxy, size: Option<MeshSize>) -> Result<(), Fault> {
    let (integers, numbers): (&[Cell], &[Cell]) =
        if proxy.is_exact { (&[Cell::Integer], &[Cell::Number]) } else { (&[Cell::Integer; 3], &[Cell::Number; 3]) };
    let vertices = members.read("ref_vIdxs", integers)?;
    let weights = members.read("weights", numbers)?;
    let offsets = if proxy.is_exact { None } else { Some(members.read("offsets", numbers)?) };
    let fits = weights.rows == vertices.rows && offsets.as_ref().is_none_or(|own| own.rows == vertices.rows);
    if !fits {
        return Err(("weights", Some(NpyFault::Shape)));
    }
    proxy.rows = RowFacts { mesh: size, ..RowFacts::default() };
    for row in 0..vertices.rows {
        let of = |table: &Table, cell| table.number(row, cell).map_or(0.0, stored);
        let vertex = |cell| vertices.integer(row, cell).unwrap_or_default();
        let axes = [0, 1, 2];
        let reference = if proxy.is_exact {
            Reference { vertices: [vertex(0); 3], weights: [of(&weights, 0), 0.0, 0.0], offset: [0.0; 3], line: 0 }
        } else {
            let offset = offsets.as_ref().map_or([0.0; 3], |offsets| axes.map(|axis| of(offsets, axis)));
            Reference { vertices: axes.map(vertex), weights: axes.map(|axis| of(&weights, axis)), offset, line: 0 }
        };
        proxy.rows.count(&reference, !proxy.is_exact);
    }
    Ok(())
}

/// An axis without a scale is no number.
fn scale(members: &mut Members<'_>, proxy: &mut PackedProxy) -> Result<(), Fault> {
    if !members.has("tmat_scale") {
        return Ok(());
    }
    let distances = members.read("tmat_scale", &[Cell::Number])?;
    let vertices = members.read("tmat_scale_idx", &[Cell::Integer])?;
    let axis = |axis: usize| {
        let distance = distances.number(axis, 0).map(stored).filter(|distance| !distance.is_nan())?;
        Some(([vertices.integer(2 * axis, 0)?, vertices.integer(2 * axis + 1, 0)?], distance))
    };
    proxy.scale = [0, 1, 2].map(axis);
    Ok(())
}

/// Runs of flags that are set.
fn runs(flags: &Table) -> Vec<std::ops::Range<usize>> {
    let mut runs: Vec<std::ops::Range<usize>> = Vec::new();
    for vertex in (0..flags.rows).filter(|row| flags.number(*row, 0).is_some_and(|flag| flag != 0.0)) {
        match runs.last_mut().filter(|last| last.end == vertex) {
            Some(last) => last.end += 1,
            None => runs.push(vertex..vertex + 1),
        }
    }
    runs
}
