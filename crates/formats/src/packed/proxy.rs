//! `.mhpxy`: what is worn as MakeHuman 1 packs it, and reads it in place of the text
//! (`docs/loaders/makehuman1/compiled-clothes.md#members-of-the-archive`).
//!
//! A zip of `.npy`. Gets its members and the size of the base mesh; returns what the text is
//! compared with, or why it cannot be loaded. Keeps no rows.

use crate::fitting_columns::{self, Columns};
use crate::mhclo::RowFacts;
use crate::npy;
use crate::npy::NpyFault;
use crate::npy::table::{Cell, Table};
use crate::npz::Members;
use crate::packed::asset::Mask;
use crate::stored;
use crate::target::MeshSize;

/// What is worn, as it is packed.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct PackedProxy {
    /// `name`, `uuid`.
    pub identity: [Box<str>; 2],
    /// The mesh, the material and the bone weights; empty where there are none.
    pub files: [Box<str>; 3],
    /// `z_depth`; without one it is 50.
    pub z_depth: i64,
    /// How many faces of a vertex the program makes room for: as many as for any mesh where nothing
    /// is said.
    pub max_pole: u64,
    /// What it says of its author and licence.
    pub licence: Licence,
    /// What was counted of its rows.
    pub rows: RowFacts,
    /// Whether only the first vertex of each row is kept.
    pub is_exact: bool,
    /// For each axis that is scaled two vertices and their distance.
    pub scale: [Option<([i64; 2], f32)>; 3],
    /// Runs of vertices that it hides, and of how many.
    pub mask: Option<Mask>,
    /// What it lacks, or cannot be used of it, with the first reason.
    pub fault: Option<(&'static str, Option<NpyFault>)>,
}

/// What comes back of author and licence. Their lengths are written in letters, and read in bytes
/// (`docs/loaders/makehuman1/compiled-clothes.md#licences-that-are-not-ascii`).
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum Licence {
    /// All of it, or nothing was written.
    #[default]
    Whole,
    /// A text behind the licence is cut.
    Cut,
    /// The licence is not found again.
    Lost,
    /// A text ends inside of a letter, which stops the program.
    Broken,
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
    let table = members
        .read(name, |reader| npy::table::read_any(reader, cells))
        .ok_or((name, None))?;
    table.map_err(|fault| (name, Some(fault)))
}

/// The bytes of a text, each of which is an element.
fn bytes(members: &mut Members<'_>, name: &'static str) -> Result<Vec<u8>, Fault> {
    let table = table(members, name, &[Cell::Text])?;
    // One that is 0 is kept as none at all.
    let byte = |row| {
        table
            .text(row, 0)
            .and_then(<[u8]>::first)
            .copied()
            .unwrap_or_default()
    };
    Ok((0..table.rows).map(byte).collect())
}

fn text(members: &mut Members<'_>, name: &'static str) -> Result<Box<str>, Fault> {
    let mut bytes = bytes(members, name)?;
    bytes.retain(|byte| *byte != 0);
    String::from_utf8(bytes)
        .map(Into::into)
        .map_err(|_| (name, Some(NpyFault::NotUtf8)))
}

fn text_if_any(members: &mut Members<'_>, name: &'static str) -> Result<Box<str>, Fault> {
    if members.has(name) {
        text(members, name)
    } else {
        Ok(Box::default())
    }
}

fn integer(members: &mut Members<'_>, name: &'static str) -> Result<i64, Fault> {
    table(members, name, &[Cell::Integer])?
        .integer(0, 0)
        .ok_or((name, Some(NpyFault::Shape)))
}

fn integer_if_any(members: &mut Members<'_>, name: &'static str) -> Result<Option<i64>, Fault> {
    if members.has(name) {
        integer(members, name).map(Some)
    } else {
        Ok(None)
    }
}

/// Several texts: all in one, and where each begins.
fn texts(members: &mut Members<'_>, name: &'static str, starts: &'static str) -> Result<(), Fault> {
    let bytes = bytes(members, name)?;
    let starts = integers(members, starts)?;
    let ends = starts.iter().skip(1).copied().chain([bytes.len()]);
    let is_text = |(start, end): (usize, usize)| {
        let own = bytes.get(start..end.min(bytes.len())).unwrap_or_default();
        std::str::from_utf8(own).is_ok()
    };
    let are_texts = starts.iter().copied().zip(ends).all(is_text);
    if are_texts {
        Ok(())
    } else {
        Err((name, Some(NpyFault::NotUtf8)))
    }
}

fn integers(members: &mut Members<'_>, name: &'static str) -> Result<Vec<usize>, Fault> {
    let table = table(members, name, &[Cell::Integer])?;
    let number = |row| {
        table
            .integer(row, 0)
            .and_then(|number| usize::try_from(number).ok())
            .unwrap_or(usize::MAX)
    };
    Ok((0..table.rows).map(number).collect())
}

/// What the program does not look for is left out, in its order; what it looks for need not be
/// there in part.
fn fill(
    members: &mut Members<'_>,
    proxy: &mut PackedProxy,
    size: Option<MeshSize>,
) -> Result<(), Fault> {
    proxy.identity = [text(members, "name")?, text(members, "uuid")?];
    text(members, "basemesh")?;
    text_if_any(members, "description")?;
    integer_if_any(members, "version")?;
    proxy.licence = licence(members)?;
    texts(members, "tags_str", "tags_idx")?;
    proxy.z_depth = integer_if_any(members, "z_depth")?
        .filter(|depth| *depth != NO_DEPTH)
        .unwrap_or(USUAL_DEPTH);
    let pole = integer_if_any(members, "max_pole")?.and_then(|pole| u64::try_from(pole).ok());
    // As much as none.
    proxy.max_pole = pole.filter(|pole| *pole > 0).unwrap_or(USUAL_POLE);
    if members.has("special_pose_str") {
        texts(members, "special_pose_str", "special_pose_idx")?;
    }
    proxy.is_exact = integer(members, "num_refverts")? != 3;
    rows(members, proxy, size)?;
    if members.has("deleteVerts") {
        let flags = table(members, "deleteVerts", &[Cell::Flag])?;
        proxy.mask = Some(Mask {
            length: flags.rows,
            runs: fitting_columns::runs(&flags),
        });
    }
    scale(members, proxy)?;
    texts(members, "uvLayers_str", "uvLayers_idx")?;
    let material = text_if_any(members, "material_file")?;
    let mesh = text(members, "obj_file")?;
    proxy.files = [
        mesh,
        material,
        text_if_any(members, "vertexBoneWeights_file")?,
    ];
    Ok(())
}

/// Stands for no depth, and the depth of that.
const NO_DEPTH: i64 = -1;
const USUAL_DEPTH: i64 = 50;
/// Faces of a vertex that there is room for in any mesh.
pub const USUAL_POLE: u64 = 8;

/// Texts behind their names, with the lengths of all.
fn licence(members: &mut Members<'_>) -> Result<Licence, Fault> {
    if !members.has("lic_str") || !members.has("lic_idx") {
        return Ok(Licence::Whole);
    }
    let (bytes, lengths) = (bytes(members, "lic_str")?, integers(members, "lic_idx")?);
    let (mut rest, mut has_licence) = (bytes.as_slice(), false);
    for (place, length) in lengths.into_iter().enumerate() {
        let (own, behind) = rest.split_at(length.min(rest.len()));
        rest = behind;
        has_licence |= place % 2 == 0 && own == b"license";
        if std::str::from_utf8(own).is_err() {
            return Ok(Licence::Broken);
        }
    }
    Ok(match (rest.is_empty(), has_licence) {
        (true, _) => Licence::Whole,
        (false, true) => Licence::Cut,
        (false, false) => Licence::Lost,
    })
}

fn rows(
    members: &mut Members<'_>,
    proxy: &mut PackedProxy,
    size: Option<MeshSize>,
) -> Result<(), Fault> {
    let (integers, numbers) = fitting_columns::cells(proxy.is_exact);
    let vertices = table(members, "ref_vIdxs", integers)?;
    let weights = table(members, "weights", numbers)?;
    let offsets = if proxy.is_exact {
        None
    } else {
        Some(table(members, "offsets", numbers)?)
    };
    let fits = weights.rows == vertices.rows
        && offsets.as_ref().is_none_or(|own| own.rows == vertices.rows);
    if !fits {
        return Err(("weights", Some(NpyFault::Shape)));
    }
    proxy.rows = Columns {
        vertices,
        weights,
        offsets,
    }
    .count(size);
    Ok(())
}

/// An axis without a scale is no number. Without the vertices the distances are not looked at.
fn scale(members: &mut Members<'_>, proxy: &mut PackedProxy) -> Result<(), Fault> {
    if !members.has("tmat_scale") || !members.has("tmat_scale_idx") {
        return Ok(());
    }
    let distances = table(members, "tmat_scale", &[Cell::Number])?;
    let vertices = table(members, "tmat_scale_idx", &[Cell::Integer])?;
    let axis = |axis: usize| {
        let distance = distances
            .number(axis, 0)
            .map(stored)
            .filter(|distance| !distance.is_nan())?;
        Some((
            [
                vertices.integer(2 * axis, 0)?,
                vertices.integer(2 * axis + 1, 0)?,
            ],
            distance,
        ))
    };
    proxy.scale = [0, 1, 2].map(axis);
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::npz::samples::{npy, zip_of};
    use crate::packed::asset::{self, Packed};
    use mhlint_source::Limits;

    fn text_of(text: &[u8]) -> Vec<u8> {
        npy("'|S1'", &format!("({},)", text.len()), text)
    }

    fn integers_of(numbers: &[u32]) -> Vec<u8> {
        let bytes: Vec<u8> = numbers
            .iter()
            .flat_map(|number| number.to_le_bytes())
            .collect();
        npy("'<u4'", &format!("({},)", numbers.len()), &bytes)
    }

    fn single(number: u32) -> Vec<u8> {
        npy("'<i4'", "()", &number.to_le_bytes())
    }

    /// What the program looks for, and nothing else.
    fn least() -> Vec<(&'static str, Vec<u8>)> {
        vec![
            ("name.npy", text_of(b"cap")),
            ("uuid.npy", text_of(b"12")),
            ("basemesh.npy", text_of(b"hm08")),
            ("tags_str.npy", text_of(b"")),
            ("tags_idx.npy", integers_of(&[])),
            ("num_refverts.npy", single(1)),
            ("ref_vIdxs.npy", integers_of(&[5, 6])),
            (
                "weights.npy",
                npy("'<f4'", "(2,)", &[0, 0, 128, 63, 0, 0, 128, 63]),
            ),
            ("uvLayers_str.npy", text_of(b"")),
            ("uvLayers_idx.npy", integers_of(&[])),
            ("obj_file.npy", text_of(b"cap.obj")),
        ]
    }

    fn of(members: &[(&str, Vec<u8>)]) -> PackedProxy {
        match asset::parse(&zip_of(members), &Limits::default(), None) {
            Packed::Proxy(proxy) => *proxy,
            other => panic!("{other:?}"),
        }
    }

    fn with(members: &[(&'static str, Vec<u8>)]) -> PackedProxy {
        let is_replaced = |name: &str| members.iter().any(|(own, _)| *own == name);
        let rest = least().into_iter().filter(|(name, _)| !is_replaced(name));
        of(&rest.chain(members.iter().cloned()).collect::<Vec<_>>())
    }

    #[test]
    fn what_is_not_looked_for_need_not_be_there() {
        let proxy = of(&least());
        assert_eq!(
            (proxy.fault, proxy.rows.count, proxy.is_exact),
            (None, 2, true)
        );
        assert_eq!(
            (proxy.z_depth, proxy.max_pole, proxy.licence),
            (50, 8, Licence::Whole)
        );
        assert_eq!(with(&[("z_depth.npy", single(u32::MAX))]).z_depth, 50);
        assert_eq!(with(&[("max_pole.npy", single(0))]).max_pole, 8);
        assert_eq!(
            with(&[("tmat_scale.npy", npy("'<f4'", "(3,)", &[0; 12]))]).scale,
            [None; 3]
        );
        for (name, _) in least() {
            let members: Vec<_> = least()
                .into_iter()
                .filter(|(own, _)| *own != name)
                .collect();
            let missing = Some((name.trim_end_matches(".npy"), None));
            let found = asset::parse(&zip_of(&members), &Limits::default(), None);
            let fault = if let Packed::Proxy(proxy) = found {
                proxy.fault
            } else {
                None
            };
            assert!(
                fault == missing || name == "num_refverts.npy",
                "{name}: {fault:?}"
            );
        }
    }

    #[test]
    fn all_but_three_vertices_a_row_are_one() {
        assert!(with(&[("num_refverts.npy", single(2))]).is_exact);
        let row = |numbers: usize| npy("'<f4'", "(1, 3)", &vec![0; 4 * numbers]);
        let of_three = with(&[
            ("num_refverts.npy", single(3)),
            ("ref_vIdxs.npy", npy("'<u4'", "(1, 3)", &[0; 12])),
            ("weights.npy", row(3)),
            ("offsets.npy", row(3)),
        ]);
        assert_eq!(
            (of_three.fault, of_three.is_exact, of_three.rows.count),
            (None, false, 1)
        );
    }

    #[test]
    fn texts_are_those_of_the_program() {
        let not_utf8 = |name| Some((name, Some(NpyFault::NotUtf8)));
        assert_eq!(
            with(&[("name.npy", text_of(b"c\xffp"))]).fault,
            not_utf8("name")
        );
        let tags = |starts: &[u32]| {
            with(&[
                ("tags_str.npy", text_of("wei\u{df}alt".as_bytes())),
                ("tags_idx.npy", integers_of(starts)),
            ])
            .fault
        };
        assert_eq!((tags(&[0, 5]), tags(&[0, 4])), (None, not_utf8("tags_str")));
        let licence = |text: &str, lengths: &[u32]| {
            with(&[
                ("lic_str.npy", text_of(text.as_bytes())),
                ("lic_idx.npy", integers_of(lengths)),
            ])
            .licence
        };
        assert_eq!(
            licence("authorAnnlicenseCC-BY", &[6, 3, 7, 5]),
            Licence::Whole
        );
        assert_eq!(
            licence("authorGr\u{e4}\u{df}licenseCC-BY", &[6, 4, 7, 5]),
            Licence::Lost
        );
        assert_eq!(
            licence("authorGro\u{df}licenseCC-BY", &[6, 4, 7, 5]),
            Licence::Broken
        );
        assert_eq!(
            licence("licenseCC0authorGro\u{df}e", &[7, 3, 6, 5]),
            Licence::Cut
        );
    }

    #[test]
    fn every_truncation_and_every_changed_byte_is_survived() {
        let bytes = zip_of(&least());
        for at in 0..bytes.len() {
            asset::parse(&bytes[..at], &Limits::default(), None);
            for value in [0, 0x7f, 0xff] {
                let mut changed = bytes.clone();
                changed[at] = value;
                asset::parse(&changed, &Limits::default(), None);
            }
        }
    }
}
