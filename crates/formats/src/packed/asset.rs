//! `.mhbin` of an asset: what MakeHuman 2 writes beside it when it is put on, and reads in its
//! place from then on (`docs/loaders/makehuman2/compiled-clothes.md#members`).
//!
//! A zip of `.npy`. Gets bytes, limits and the size of the base mesh; returns what the text is
//! compared with, or why it cannot be loaded. Keeps no rows.

use super::mesh;
use crate::asset_mesh::{AssetMesh, MeshPrint};
use crate::fitting_columns::{self, Columns};
use crate::mhbin::{self, MeshFault};
use crate::mhclo::RowFacts;
use crate::npy;
use crate::npy::NpyFault;
use crate::npy::table::{Cell, Table};
use crate::npz::{ArchiveFault, Members};
use crate::packed::proxy::{self, PackedProxy};
use crate::stored;
use crate::target::MeshSize;
use mhlint_source::Limits;

/// Any archive that is neither a base mesh nor one of targets.
#[derive(Debug, Clone, PartialEq)]
pub enum Packed {
    /// It cannot be opened.
    Unopened(ArchiveFault),
    /// One without a member `asset`: whatever it is, it is not that of an asset.
    Other,
    /// That of an asset.
    Asset(Box<PackedAsset>),
    /// What MakeHuman 1 makes of something worn.
    Proxy(Box<PackedProxy>),
    /// What MakeHuman 1 makes of a mesh.
    Mesh(Result<Box<AssetMesh>, MeshFault>),
}

impl Packed {
    /// What is worn, if the archive is that of MakeHuman 1 and can be loaded.
    pub fn proxy_of(packed: Option<&Self>) -> Option<&PackedProxy> {
        let Self::Proxy(proxy) = packed? else {
            return None;
        };
        proxy.fault.is_none().then_some(&**proxy)
    }
}

/// An asset as it is packed.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct PackedAsset {
    /// `name`, `uuid`, `author`, `description`, `license`, of which the first two are its identity.
    pub texts: [Box<str>; 5],
    /// `z_depth`.
    pub z_depth: i64,
    /// The material, and the bone weights; empty where there are none.
    pub files: [Box<str>; 2],
    /// What was counted of its rows.
    pub rows: RowFacts,
    /// Whether only the first vertex of each row is kept.
    pub is_exact: bool,
    /// Axes with a scale: vertices and distance.
    pub scale: Option<[(i64, i64, f32); 3]>,
    /// The vertices that it hides: of how many, and which runs.
    pub mask: Option<Mask>,
    /// Its mesh.
    pub print: MeshPrint,
    /// Members that are missing or cannot be used, with the first reason.
    pub faults: Vec<PackedFault>,
}

/// The vertices that an asset hides.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Mask {
    /// Vertices of the base mesh that it was made for.
    pub length: usize,
    /// Runs of those that are hidden.
    pub runs: Vec<std::ops::Range<usize>>,
}

/// Why an asset cannot be loaded from its archive.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum PackedFault {
    /// `asset` cannot be used: the scan of the library reads it.
    Asset(NpyFault),
    /// A member that is not there.
    Missing(&'static str),
    /// A member that cannot be used.
    Member(&'static str, NpyFault),
    /// The mesh in it.
    Mesh(MeshFault),
}

const ASSET: [Cell; 10] = [
    Cell::Text,
    Cell::Text,
    Cell::Text,
    Cell::Text,
    Cell::Text,
    Cell::Integer,
    Cell::Integer,
    Cell::Integer,
    Cell::Text,
    Cell::Text,
];

/// Reads an archive within `limits`.
pub fn parse(bytes: &[u8], limits: &Limits, size: Option<MeshSize>) -> Packed {
    let mut members = match Members::open(bytes, limits) {
        Ok(members) => members,
        Err(fault) => return Packed::Unopened(fault),
    };
    if members.has("asset") {
        return Packed::Asset(Box::new(asset(&mut members, bytes, limits, size)));
    }
    // What MakeHuman 1 packs has no member of that name.
    if proxy::is_proxy(&members) {
        return Packed::Proxy(Box::new(proxy::read(&mut members, size)));
    }
    if mesh::is_mesh(&members) {
        return Packed::Mesh(mesh::read(&mut members).map(Box::new));
    }
    Packed::Other
}

/// Reads the archive of a base mesh of MakeHuman 1 within `limits`: the mesh is kept whole.
pub fn parse_base(bytes: &[u8], limits: &Limits) -> Packed {
    match Members::open(bytes, limits) {
        Ok(mut members) if mesh::is_mesh(&members) => {
            Packed::Mesh(mesh::read_base(&mut members).map(Box::new))
        }
        Ok(_) => Packed::Other,
        Err(fault) => Packed::Unopened(fault),
    }
}

fn read(
    members: &mut Members<'_>,
    name: &'static str,
    cells: &[Cell],
) -> Result<Table, PackedFault> {
    let table = members
        .read(name, |reader| npy::table::read(reader, cells))
        .ok_or(PackedFault::Missing(name))?;
    table.map_err(|fault| {
        if name == "asset" {
            PackedFault::Asset(fault)
        } else {
            PackedFault::Member(name, fault)
        }
    })
}

fn asset(
    members: &mut Members<'_>,
    bytes: &[u8],
    limits: &Limits,
    size: Option<MeshSize>,
) -> PackedAsset {
    let mut asset = PackedAsset::default();
    let refused = head(members, &mut asset)
        .and_then(|()| rows(members, &mut asset, size))
        .and_then(|()| scale(members, &mut asset))
        .and_then(|()| mask(members, &mut asset));
    asset.faults.extend(refused.err());
    match mhbin::parse(bytes, limits) {
        Ok(mesh) => asset.print = MeshPrint::of(&mesh),
        Err(fault) => asset.faults.push(PackedFault::Mesh(fault)),
    }
    asset
}

fn head(members: &mut Members<'_>, asset: &mut PackedAsset) -> Result<(), PackedFault> {
    let table = read(members, "asset", &ASSET)?;
    if table.rows == 0 {
        return Err(PackedFault::Asset(NpyFault::Shape));
    }
    asset.texts = [0, 1, 2, 3, 8].map(|cell| text(&table, cell));
    asset.is_exact = table.integer(0, 5) != Some(3);
    asset.z_depth = table.integer(0, 7).unwrap_or_default();
    let files = read(members, "files", &[Cell::Text, Cell::Text])?;
    asset.files = [0, 1].map(|cell| text(&files, cell));
    Ok(())
}

fn text(table: &Table, cell: usize) -> Box<str> {
    String::from_utf8_lossy(table.text(0, cell).unwrap_or_default()).into()
}

fn rows(
    members: &mut Members<'_>,
    asset: &mut PackedAsset,
    size: Option<MeshSize>,
) -> Result<(), PackedFault> {
    let (integers, numbers) = fitting_columns::cells(asset.is_exact);
    let vertices = read(members, "ref_vIdxs", integers)?;
    let weights = read(members, "weights", numbers)?;
    let offsets = if asset.is_exact {
        None
    } else {
        Some(read(members, "offsets", numbers)?)
    };
    // The weights of single vertices are copied into a column of that length.
    let fits = match &offsets {
        Some(offsets) => offsets.rows.min(weights.rows) >= vertices.rows,
        None => weights.rows == vertices.rows,
    };
    if !fits {
        return Err(PackedFault::Member("weights", NpyFault::Shape));
    }
    asset.rows = Columns {
        vertices,
        weights,
        offsets,
    }
    .count(size);
    Ok(())
}

fn scale(members: &mut Members<'_>, asset: &mut PackedAsset) -> Result<(), PackedFault> {
    if !members.has("scale") {
        return Ok(());
    }
    let table = read(
        members,
        "scale",
        &[Cell::Integer, Cell::Integer, Cell::Number],
    )?;
    let axis = |row| {
        let vertex = |cell| table.integer(row, cell).unwrap_or_default();
        (
            vertex(0),
            vertex(1),
            table.number(row, 2).map_or(0.0, stored),
        )
    };
    asset.scale = (table.rows >= 3).then(|| [0, 1, 2].map(axis));
    Ok(())
}

fn mask(members: &mut Members<'_>, asset: &mut PackedAsset) -> Result<(), PackedFault> {
    if !members.has("deleteVerts") {
        return Ok(());
    }
    let table = read(members, "deleteVerts", &[Cell::Flag])?;
    asset.mask = Some(Mask {
        length: table.rows,
        runs: fitting_columns::runs(&table),
    });
    Ok(())
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::npz::samples::{npy, zip_of};

    fn floats(values: &[f32]) -> Vec<u8> {
        values
            .iter()
            .flat_map(|value| value.to_le_bytes())
            .collect()
    }

    fn ints(values: &[i32]) -> Vec<u8> {
        values
            .iter()
            .flat_map(|value| value.to_le_bytes())
            .collect()
    }

    fn members() -> Vec<(&'static str, Vec<u8>)> {
        let asset = "[('name', '|S3'), ('uuid', '|S2'), ('author', '|S1'), ('description', '|S1'), ('meshtype', '|S1'), \
            ('refverts', '<i4'), ('version', '<i4'), ('zdepth', '<i4'), ('license', '|S1'), \
            ('tags', '|S1')]";
        let row = [b"hatu1ade".as_slice(), &ints(&[3, 110, 60]), b"lt"].concat();
        let files = npy("[('material', '|S2'), ('weight', '|S1')]", "(1,)", b"m\0\0");
        vec![
            ("asset.npy", npy(asset, "(1,)", &row)),
            ("files.npy", files),
            (
                "ref_vIdxs.npy",
                npy("'<u4'", "(2, 3)", &ints(&[0, 1, 2, 9, 1, 2])),
            ),
            (
                "weights.npy",
                npy("'<f4'", "(2, 3)", &floats(&[1.0, 0.0, 0.0, 0.5, 0.25, 0.0])),
            ),
            ("offsets.npy", npy("'<f4'", "(2, 3)", &floats(&[0.0; 6]))),
            ("deleteVerts.npy", npy("'|b1'", "(5,)", &[0, 1, 1, 0, 1])),
        ]
    }

    fn of(members: &[(&str, Vec<u8>)]) -> Packed {
        parse(
            &zip_of(members),
            &Limits::default(),
            Some(MeshSize {
                vertices: 4,
                with_seams: 5,
            }),
        )
    }

    fn read(members: &[(&str, Vec<u8>)]) -> PackedAsset {
        match of(members) {
            Packed::Asset(asset) => *asset,
            other => panic!("{other:?}"),
        }
    }

    #[test]
    fn an_asset_is_counted() {
        let asset = read(&members());
        assert_eq!(
            (
                &*asset.texts[0],
                &*asset.texts[1],
                &*asset.files[0],
                asset.z_depth
            ),
            ("hat", "u1", "m", 60)
        );
        assert_eq!(
            (
                asset.rows.count,
                asset.rows.out_of_range.count,
                asset.rows.visible_sums
            ),
            (2, 1, 1)
        );
        assert_eq!(
            asset.mask,
            Some(Mask {
                length: 5,
                runs: vec![1..3, 4..5]
            })
        );
        assert!(matches!(
            asset.faults.as_slice(),
            [PackedFault::Mesh(MeshFault::Missing(_))]
        ));
    }

    #[test]
    fn a_truth_value_may_be_written_with_a_question_mark() {
        let mut other = members();
        other[5].1 = npy("'?'", "(5,)", &[0, 1, 1, 0, 1]);
        assert_eq!(read(&other).mask, read(&members()).mask);
    }

    #[test]
    fn what_is_missing_is_named() {
        let without = |left_out: &str| {
            let members: Vec<_> = members()
                .into_iter()
                .filter(|(name, _)| *name != left_out)
                .collect();
            read(&members).faults.first().cloned()
        };
        assert_eq!(
            without("weights.npy"),
            Some(PackedFault::Missing("weights"))
        );
        assert_eq!(
            without("offsets.npy"),
            Some(PackedFault::Missing("offsets"))
        );
        assert_eq!(of(&members()[1..]), Packed::Other);
        assert_eq!(
            parse(b"", &Limits::default(), None),
            Packed::Unopened(ArchiveFault::Empty)
        );
        let mut plain = members();
        plain[0].1 = npy("'<f4'", "(2,)", &floats(&[0.0, 1.0]));
        assert!(matches!(
            read(&plain).faults.first(),
            Some(PackedFault::Asset(_))
        ));
    }

    #[test]
    fn every_truncation_and_every_changed_byte_is_survived() {
        let bytes = zip_of(&members());
        for length in 0..bytes.len() {
            parse(&bytes[..length], &Limits::default(), None);
        }
        for at in 0..bytes.len() {
            for value in [0, 0x7f, 0xff] {
                let mut changed = bytes.clone();
                changed[at] = value;
                parse(&changed, &Limits::default(), None);
            }
        }
    }

    proptest! {
        #[test]
        fn any_bytes_are_read_or_refused(bytes in proptest::collection::vec(any::<u8>(), 0..300)) {
            parse(&bytes, &Limits::default(), None);
        }
    }
}
