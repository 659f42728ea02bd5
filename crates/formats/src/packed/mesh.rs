//! `.npz` beside an OBJ: the mesh as MakeHuman 1 packs it, and reads it in place of the text
//! (`docs/loaders/makehuman1/base-mesh.md#packed-meshes`).
//!
//! A zip of `.npy`. Gets its members, returns the mesh as its OBJ would give it, but for where
//! texture coordinates lie, or why it cannot be loaded.

use crate::asset_mesh::{AssetMesh, KeptFaces};
use crate::mhbin::MeshFault;
use crate::npy;
use crate::npy::table::{Cell, Table};
use crate::npy::{NpyFault, read_layout};
use crate::npz::Members;
use crate::obj::{Group, Mesh, NO_UV};
use crate::stored;

/// Everything that the program cannot do without: archives of 1.0 do not say how many faces of a
/// vertex they keep, and a mesh without texture coordinates has none at its faces.
const MEMBERS: [&str; 8] = [
    "coord", "vface", "nfaces", "texco", "fvert", "group", "fgstr", "fgidx",
];
const MAX_FACES: &str = "MAX_FACES";

/// Whether an archive is a mesh.
pub(crate) fn is_mesh(members: &Members<'_>) -> bool {
    members.has("coord") && members.has("fvert")
}

/// Reads a packed mesh that [`is_mesh`] says is one.
///
/// # Errors
/// When the application could not load it.
pub(crate) fn read(members: &mut Members<'_>) -> Result<AssetMesh, MeshFault> {
    let (mesh, kept) = open(members, &Groups::default())?;
    Ok(AssetMesh {
        kept_faces: Some(kept),
        ..AssetMesh::of(mesh)
    })
}

/// The same of a base mesh, which is kept whole, with its groups.
///
/// # Errors
/// As in [`read`].
pub(crate) fn read_base(members: &mut Members<'_>) -> Result<AssetMesh, MeshFault> {
    let groups = Groups::read(members).unwrap_or_default();
    let (mesh, kept) = open(members, &groups)?;
    let whole = Some(Box::new(mesh.clone()));
    Ok(AssetMesh {
        kept_faces: Some(kept),
        whole,
        ..AssetMesh::of(mesh)
    })
}

fn open(members: &mut Members<'_>, groups: &Groups) -> Result<(Mesh, KeptFaces), MeshFault> {
    let missing: Vec<&str> = MEMBERS
        .into_iter()
        .filter(|name| !members.has(name))
        .collect();
    if !missing.is_empty() {
        return Err(MeshFault::Missing(missing));
    }
    let coord = table(members, "coord", &[Cell::Number; 3])?;
    let faces = table(members, "fvert", &[Cell::Integer; 4])?;
    let uvs = table(members, "texco", &[Cell::Number; 2])?;
    // Without texture coordinates there is no such member.
    let of_faces = if members.has("fuvs") {
        Some(table(members, "fuvs", &[Cell::Integer; 4])?)
    } else {
        None
    };
    let kept = kept_faces(members, coord.rows)?;
    Ok((build(&coord, &faces, &uvs, of_faces.as_ref(), groups), kept))
}

/// The groups of faces.
#[derive(Default)]
struct Groups {
    names: Vec<String>,
    /// The group of each face.
    of_faces: Vec<u32>,
}

impl Groups {
    /// All names are one text: another member says where each begins, one behind the other.
    fn read(members: &mut Members<'_>) -> Option<Self> {
        let mut own = |name, cell| table(members, name, &[cell]).ok();
        let (of_faces, letters, starts) = (
            own("group", Cell::Integer)?,
            own("fgstr", Cell::Text)?,
            own("fgidx", Cell::Integer)?,
        );
        let number = |table: &Table, row| usize::try_from(table.integer(row, 0)?).ok();
        let start = |row| {
            if row < starts.rows {
                number(&starts, row)
            } else {
                Some(letters.rows)
            }
        };
        let letter = |at| letters.text(at, 0).unwrap_or_default();
        let name = |row| {
            let (from, to) = (start(row)?, start(row + 1)?);
            // Whatever the numbers are, no letter belongs to two names, and none lies beyond the
            // text.
            let letters = (from <= to && to <= letters.rows).then_some(from..to)?;
            Some(
                String::from_utf8_lossy(&letters.flat_map(letter).copied().collect::<Vec<u8>>())
                    .into_owned(),
            )
        };
        let names: Vec<String> = (0..starts.rows).map(name).collect::<Option<_>>()?;
        let group =
            |row| u32::try_from(number(&of_faces, row).filter(|group| *group < names.len())?).ok();
        let of_faces = (0..of_faces.rows).map(group).collect::<Option<_>>()?;
        Some(Self { names, of_faces })
    }
}

/// A row for each vertex, and a column for each face that is kept of it.
fn kept_faces(members: &mut Members<'_>, vertices: usize) -> Result<KeptFaces, MeshFault> {
    let misfit = |name| MeshFault::Member(name, NpyFault::Shape);
    let shape = members.read("vface", |reader| Ok(read_layout(reader)?.shape));
    let shape = shape
        .ok_or_else(|| misfit("vface"))?
        .map_err(|fault| MeshFault::Member("vface", fault))?;
    let columns = match *shape.as_slice() {
        [rows, columns] if rows == vertices as u64 => columns,
        _ => return Err(misfit("vface")),
    };
    let stated = if members.has(MAX_FACES) {
        let first = table(members, MAX_FACES, &[Cell::Integer])?.integer(0, 0);
        Some(
            first
                .and_then(|first| u64::try_from(first).ok())
                .ok_or_else(|| misfit(MAX_FACES))?,
        )
    } else {
        None
    };
    let kept = KeptFaces { columns, stated };
    if stated.is_none_or(|stated| kept.holds(stated)) {
        Ok(kept)
    } else {
        Err(misfit("vface"))
    }
}

fn table(
    members: &mut Members<'_>,
    name: &'static str,
    cells: &[Cell],
) -> Result<Table, MeshFault> {
    let table = members.read(name, |reader| npy::table::read(reader, cells));
    let table = table.ok_or_else(|| MeshFault::Missing(vec![name]))?;
    table.map_err(|fault| MeshFault::Member(name, fault))
}

/// Triangles have their first vertex once more at the end.
fn build(
    coord: &Table,
    faces: &Table,
    uvs: &Table,
    of_faces: Option<&Table>,
    groups: &Groups,
) -> Mesh {
    let cell = |row, cell| coord.number(row, cell).map_or(0.0, stored);
    let positions: Vec<[f32; 3]> = (0..coord.rows)
        .map(|row| [0, 1, 2].map(|axis| cell(row, axis)))
        .collect();
    let vertices = positions.len();
    let uv_at = |row| [0, 1].map(|axis| uvs.number(row, axis).map_or(0.0, stored));
    let mut mesh = Mesh {
        positions,
        uvs: (0..uvs.rows).map(uv_at).collect(),
        ..Mesh::default()
    };
    let group = |name: &str| Group {
        name: name.to_owned(),
        line: 0,
        faces: 0,
        vertices: None,
    };
    mesh.groups
        .extend(groups.names.iter().map(|name| group(name)));
    if mesh.groups.is_empty() {
        mesh.groups.push(group(""));
    }
    for row in 0..faces.rows {
        let corners = [0, 1, 2, 3].map(|corner| faces.integer(row, corner).unwrap_or(-1));
        let count = if corners[0] == corners[3] { 3 } else { 4 };
        let known = |corner: &i64| {
            u32::try_from(*corner)
                .ok()
                .filter(|own| (*own as usize) < vertices)
        };
        let corners: Option<Vec<u32>> = corners.iter().take(count).map(known).collect();
        match corners {
            Some(corners) => {
                let first = mesh.corners.len();
                let uv = |corner| u32::try_from(of_faces?.integer(row, corner)?).ok();
                mesh.corner_uvs
                    .extend((0..count).map(|corner| uv(corner).unwrap_or(NO_UV)));
                mesh.corners.extend(corners);
                mesh.push_face(first, groups.of_faces.get(row).copied().unwrap_or_default());
            }
            None => mesh
                .facts
                .face_out_of_range
                .add(0, i64::try_from(row).unwrap_or(i64::MAX)),
        }
    }
    let mut counts = std::mem::take(&mut mesh.facts);
    counts.complete(&mesh, &vec![0; mesh.faces.len()]);
    mesh.facts = counts;
    mesh
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::npz::samples::{npy, zip_of};
    use crate::obj;
    use crate::packed::asset::{self, Packed};
    use mhlint_source::Limits;

    fn members() -> Vec<(&'static str, Vec<u8>)> {
        let floats = |numbers: &[f32]| {
            numbers
                .iter()
                .flat_map(|own| own.to_le_bytes())
                .collect::<Vec<u8>>()
        };
        let numbers = |numbers: &[u32]| {
            numbers
                .iter()
                .flat_map(|own| own.to_le_bytes())
                .collect::<Vec<u8>>()
        };
        let rest = ["nfaces", "texco", "group", "fgstr", "fgidx"];
        let coord = floats(&[0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 1.0, 0.0]);
        let mut members = vec![
            ("coord.npy", npy("'<f4'", "(4, 3)", &coord)),
            (
                "fvert.npy",
                npy("'<u4'", "(2, 4)", &numbers(&[0, 1, 2, 3, 0, 1, 2, 0])),
            ),
            ("vface.npy", npy("'<u4'", "(4, 8)", &[0; 128])),
            ("MAX_FACES.npy", npy("'<i8'", "(1,)", &8_i64.to_le_bytes())),
        ];
        let names = rest.map(|name| format!("{name}.npy"));
        members.extend(names.map(|name| (&*name.leak(), npy("'<f4'", "(0, 2)", b""))));
        members
    }

    fn parse(bytes: &[u8]) -> Result<AssetMesh, MeshFault> {
        match asset::parse(bytes, &Limits::default(), None) {
            Packed::Mesh(mesh) => mesh.map(|mesh| *mesh),
            Packed::Unopened(fault) => Err(MeshFault::Archive(fault)),
            _ => Err(MeshFault::Missing(Vec::new())),
        }
    }

    #[test]
    fn it_is_the_mesh_of_its_text() {
        let mesh = parse(&zip_of(&members())).unwrap();
        let text = AssetMesh::of(obj::parse(
            b"v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\nf 1 2 3\n",
        ));
        assert_eq!((mesh.print, mesh.positions), (text.print, text.positions));
    }

    /// The names of the groups of a base mesh with a text `bodyhead` of eight letters.
    fn groups(starts: &[u32], of_faces: [u16; 2]) -> Vec<String> {
        let mut members = members();
        let mut set = |name: &str, array: Vec<u8>| {
            members.iter_mut().find(|(own, _)| *own == name).unwrap().1 = array;
        };
        let bytes: Vec<u8> = starts
            .iter()
            .flat_map(|start| start.to_le_bytes())
            .collect();
        set(
            "fgidx.npy",
            npy("'<u4'", &format!("({},)", starts.len()), &bytes),
        );
        set("fgstr.npy", npy("'|S1'", "(8,)", b"bodyhead"));
        set(
            "group.npy",
            npy("'<u2'", "(2,)", &of_faces.map(u16::to_le_bytes).concat()),
        );
        match asset::parse_base(&zip_of(&members), &Limits::default()) {
            Packed::Mesh(Ok(mesh)) => mesh
                .whole
                .unwrap()
                .groups
                .into_iter()
                .map(|group| group.name)
                .collect(),
            other => panic!("{other:?}"),
        }
    }

    #[test]
    fn groups_lie_one_behind_the_other_in_their_text() {
        assert_eq!(groups(&[0, 4], [0, 1]), ["body", "head"]);
        assert_eq!(groups(&[0, 8], [0, 0]), ["bodyhead", ""]);
        // Else there is one for all: names that overlap, that never end, and groups that do not
        // exist.
        for (starts, of_faces) in [
            (&[4, 0][..], [0, 1]),
            (&[0, 9], [0, 0]),
            (&[0, u32::MAX, 0, u32::MAX], [0, 1]),
            (&[0, 4], [0, 2]),
        ] {
            assert_eq!(groups(starts, of_faces), [""], "{starts:?} {of_faces:?}");
        }
    }

    #[test]
    fn how_many_faces_are_kept_need_not_be_said() {
        let without = |left_out: &str| {
            let members: Vec<_> = members()
                .into_iter()
                .filter(|(name, _)| *name != left_out)
                .collect();
            parse(&zip_of(&members)).map(|mesh| mesh.kept_faces)
        };
        assert_eq!(
            without(""),
            Ok(Some(KeptFaces {
                columns: 8,
                stated: Some(8)
            }))
        );
        assert_eq!(
            without("MAX_FACES.npy"),
            Ok(Some(KeptFaces {
                columns: 8,
                stated: None
            }))
        );
        let with = |name: &str, array: Vec<u8>| {
            let mut members = members();
            members.iter_mut().find(|(own, _)| *own == name).unwrap().1 = array;
            parse(&zip_of(&members)).map(|mesh| mesh.kept_faces)
        };
        let more = npy("'<i8'", "(1,)", &16_i64.to_le_bytes());
        assert_eq!(
            with("MAX_FACES.npy", more),
            Err(MeshFault::Member("vface", NpyFault::Shape))
        );
        let bare = npy("'<i8'", "()", &8_i64.to_le_bytes());
        assert_eq!(
            with("MAX_FACES.npy", bare),
            Err(MeshFault::Member("MAX_FACES", NpyFault::Shape))
        );
        let fewer = npy("'<u4'", "(3, 8)", &[0; 96]);
        assert_eq!(
            with("vface.npy", fewer),
            Err(MeshFault::Member("vface", NpyFault::Shape))
        );
    }

    #[test]
    fn what_cannot_be_loaded_is_named() {
        let mut short = members();
        short.pop();
        assert_eq!(
            parse(&zip_of(&short)),
            Err(MeshFault::Missing(vec!["fgidx"]))
        );
        let mut beyond = members();
        beyond[1].1 = npy("'<u4'", "(1, 4)", &[9; 16]);
        assert!(!parse(&zip_of(&beyond)).unwrap().is_sound());
        let bytes = zip_of(&members());
        for at in 0..bytes.len() {
            let mut changed = bytes.clone();
            changed[at] ^= 0xff;
            drop(parse(&changed));
            assert!(parse(&bytes[..at]).is_err());
        }
    }
}
