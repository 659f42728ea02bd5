//! `base.mhbin`: a base mesh as `compile_meshes.py` packs it. MakeHuman 2 reads it in place of
//! `base.obj` (`docs/loaders/makehuman2/base-mesh.md#which-file-is-read`,
//! `docs/loaders/makehuman2/compiled-clothes.md#members`).
//!
//! A zip of `.npy`. Vertices with several texture coordinates stand again behind the real ones;
//! `overflow` says whose copies they are. Gets bytes and limits, returns the mesh as an OBJ would
//! give it, or why it cannot be loaded.

use crate::npy;
use crate::npy::NpyFault;
use crate::npy::table::{Cell, Table};
use crate::npz::{self, ArchiveFault};
use crate::obj::{Group, Mesh, NO_UV};
use crate::stored;
use mhlint_source::Limits;

/// Why a packed mesh cannot be loaded.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum MeshFault {
    /// It cannot be opened.
    Archive(ArchiveFault),
    /// It unpacks beyond the limits.
    Oversized,
    /// Members that it lacks: the application rejects it.
    Missing(Vec<&'static str>),
    /// A member that cannot be used.
    Member(&'static str, NpyFault),
    /// Members that do not fit together.
    Misfit(Misfit),
}

/// What does not fit together.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Misfit {
    /// No row in `header`, no vertex, or a count below zero.
    Header,
    /// Fewer of something than there have to be: how many there are, and how many there should be.
    Short(Part, usize, usize),
    /// A name of a group that is no UTF-8.
    GroupName(String),
    /// Faces with more corners than there are, or groups with more faces.
    Faces,
    /// A face with so many corners, fewer than three.
    SmallFace(i64),
    /// A row of `overflow` with a position that does not exist.
    Overflow(i64),
    /// A position behind the vertices that is a copy of none.
    Copy(usize),
}

/// Something that there can be too little of.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Part {
    /// Positions in `coord`, for the vertices that `header` states.
    Positions,
    /// Texture coordinates, for the positions.
    Uvs,
    /// Triangles that `header` states, for the faces.
    Triangles,
    /// Names, for the groups.
    GroupNames,
    /// Groups, for the names.
    Groups,
}

/// Everything that is looked for, and what its rows are made of.
const MEMBERS: [(&str, &[Cell]); 8] = [
    (
        "header",
        &[
            Cell::Text,
            Cell::Integer,
            Cell::Integer,
            Cell::Integer,
            Cell::Integer,
        ],
    ),
    ("grpNames", &[Cell::Text]),
    ("coord", &[Cell::Number; 3]),
    ("uvs", &[Cell::Number; 2]),
    ("overflow", &[Cell::Integer; 2]),
    ("groupinfo", &[Cell::Integer, Cell::Integer, Cell::Flag]),
    ("vertsperface", &[Cell::Integer]),
    ("faceverts", &[Cell::Integer]),
];

/// What a number of a mesh takes in memory at least, however small it is in the archive.
const NUMBER_BYTES: u64 = 4;

/// Reads a packed mesh within `limits`, which are those of arrays.
///
/// # Errors
/// When the application could not load it, or not all of it.
pub fn parse(bytes: &[u8], limits: &Limits) -> Result<Mesh, MeshFault> {
    let members = read_members(bytes, limits)?;
    let members: &[Table; 8] = members
        .as_slice()
        .try_into()
        .map_err(|_| MeshFault::Missing(Vec::new()))?;
    build(members).map_err(MeshFault::Misfit)
}

fn read_members(bytes: &[u8], limits: &Limits) -> Result<Vec<Table>, MeshFault> {
    let mut zip = npz::open(bytes).map_err(MeshFault::Archive)?;
    let names: Vec<String> = (0..zip.len())
        .map(|index| npz::member_name(&zip, index))
        .collect();
    let place = |member: &str| names.iter().rposition(|name| name == member);
    let missing: Vec<&str> = MEMBERS
        .iter()
        .map(|(name, _)| *name)
        .filter(|name| place(name).is_none())
        .collect();
    if !missing.is_empty() {
        return Err(MeshFault::Missing(missing));
    }
    let mut room = limits.of_arrays().unpacked_limit(bytes.len() as u64);
    let mut read = |(name, cells): (&'static str, &[Cell])| {
        let index = place(name).unwrap_or_default();
        let (table, used) = npz::read_member(&mut zip, index, room, |reader| {
            npy::table::read(reader, cells)
        });
        let numbers = table
            .as_ref()
            .map_or(0, |table| table.rows.saturating_mul(cells.len()));
        room = room
            .checked_sub(used.max(NUMBER_BYTES * numbers as u64))
            .ok_or(MeshFault::Oversized)?;
        table.map_err(|fault| MeshFault::Member(name, fault))
    };
    MEMBERS.into_iter().map(&mut read).collect()
}

fn build(
    [header, names, coord, uvs, overflow, groups, sizes, corners]: &[Table; 8],
) -> Result<Mesh, Misfit> {
    let header = Header::of(header)?;
    let vertices = header.vertices;
    Part::Positions.suffice(coord.rows, vertices)?;
    Part::Uvs.suffice(uvs.rows, if header.has_uvs { coord.rows } else { 0 })?;
    let copies = coord.rows - vertices;
    let cell = |table: &Table, row, cell| table.number(row, cell).map_or(0.0, stored);
    let position = |vertex| [0, 1, 2].map(|axis| cell(coord, vertex, axis));
    // Packed with v from the top.
    let uv = |row| [cell(uvs, row, 0), 1.0 - cell(uvs, row, 1)];
    let mut mesh = Mesh {
        positions: (0..vertices).map(position).collect(),
        ..Mesh::default()
    };
    mesh.uvs = (0..if header.has_uvs { uvs.rows } else { 0 })
        .map(uv)
        .collect();
    let faces = Faces {
        header,
        vertices,
        sources: sources(overflow, vertices, copies)?,
        sizes,
        corners,
    };
    faces.fill(&mut mesh, names, groups)?;
    complete(&mut mesh, copies);
    Ok(mesh)
}

impl Part {
    fn suffice(self, there: usize, needed: usize) -> Result<(), Misfit> {
        if there < needed {
            Err(Misfit::Short(self, there, needed))
        } else {
            Ok(())
        }
    }
}

/// Counts what rules ask for.
fn complete(mesh: &mut Mesh, copies: usize) {
    let mut facts = std::mem::take(&mut mesh.facts);
    facts.complete(mesh, &vec![0; mesh.faces.len()]);
    for (vertex, position) in mesh.positions.iter().enumerate() {
        if !position.iter().all(|part| part.is_finite()) {
            facts
                .non_finite
                .add(0, i64::try_from(vertex).unwrap_or(i64::MAX));
        }
    }
    facts.seam_duplicates = copies;
    mesh.facts = facts;
}

/// The counts of `header`.
#[derive(Clone, Copy)]
struct Header {
    vertices: usize,
    triangles: usize,
    has_uvs: bool,
}

impl Header {
    fn of(header: &Table) -> Result<Self, Misfit> {
        let count = |cell| {
            header
                .integer(0, cell)
                .and_then(|count| usize::try_from(count).ok())
                .ok_or(Misfit::Header)
        };
        let (vertices, triangles, _, uv_faces) = (count(1)?, count(2)?, count(3)?, count(4)?);
        if vertices == 0 {
            Err(Misfit::Header)
        } else {
            Ok(Self {
                vertices,
                triangles,
                has_uvs: uv_faces > 0,
            })
        }
    }
}

/// The vertex that each copy is one of.
fn sources(overflow: &Table, vertices: usize, copies: usize) -> Result<Vec<u32>, Misfit> {
    let mut sources: Vec<Option<u32>> = vec![None; copies];
    for row in 0..overflow.rows {
        let position = |cell| {
            let position = overflow.integer(row, cell).unwrap_or(-1);
            let found = usize::try_from(position)
                .ok()
                .filter(|found| *found < vertices + copies);
            found.ok_or(Misfit::Overflow(position))
        };
        let (source, copy) = (position(0)?, position(1)?);
        let slot = copy
            .checked_sub(vertices)
            .and_then(|copy| sources.get_mut(copy));
        match (slot, u32::try_from(source)) {
            (Some(slot), Ok(number)) if source < vertices => *slot = Some(number),
            _ => return Err(Misfit::Copy(copy)),
        }
    }
    let source = |(copy, source): (usize, Option<u32>)| source.ok_or(Misfit::Copy(vertices + copy));
    sources.into_iter().enumerate().map(source).collect()
}

/// The faces of all groups.
struct Faces<'t> {
    header: Header,
    vertices: usize,
    sources: Vec<u32>,
    sizes: &'t Table,
    corners: &'t Table,
}

impl Faces<'_> {
    fn fill(&self, mesh: &mut Mesh, names: &Table, groups: &Table) -> Result<(), Misfit> {
        Part::GroupNames.suffice(names.rows, groups.rows)?;
        Part::Groups.suffice(groups.rows, names.rows)?;
        let mut next = 0;
        // Each corner is of one face: without this a small archive could make many faces of few
        // corners.
        let mut left = self.corners.rows;
        for row in 0..groups.rows {
            mesh.groups.push(Group {
                name: name(names, row)?,
                line: 0,
                faces: 0,
                vertices: None,
            });
            let mut start = groups
                .integer(row, 0)
                .and_then(|at| usize::try_from(at).ok())
                .ok_or(Misfit::Faces)?;
            let has_uvs = self.header.has_uvs && groups.number(row, 2) != Some(0.0);
            for _ in 0..groups.integer(row, 1).unwrap_or_default() {
                let size = self.size(next)?;
                left = left.checked_sub(size).ok_or(Misfit::Faces)?;
                self.push(mesh, start, size, has_uvs)?;
                (start, next) = (start + size, next + 1);
            }
        }
        let triangles = mesh
            .faces
            .iter()
            .map(|face| (face.len as usize).saturating_sub(2))
            .sum();
        Part::Triangles.suffice(self.header.triangles, triangles)
    }

    fn size(&self, face: usize) -> Result<usize, Misfit> {
        let corners = self.sizes.integer(face, 0).ok_or(Misfit::Faces)?;
        usize::try_from(corners)
            .ok()
            .filter(|size| *size >= 3)
            .ok_or(Misfit::SmallFace(corners))
    }

    /// Makes a face of the group opened last. One with a vertex that does not exist is counted.
    fn push(
        &self,
        mesh: &mut Mesh,
        start: usize,
        size: usize,
        has_uvs: bool,
    ) -> Result<(), Misfit> {
        let first = mesh.corners.len();
        for row in start..start.checked_add(size).ok_or(Misfit::Faces)? {
            let position = self.corners.integer(row, 0).ok_or(Misfit::Faces)?;
            let Some((vertex, uv)) = self.corner(position) else {
                mesh.facts.face_out_of_range.add(0, position);
                mesh.corners.truncate(first);
                mesh.corner_uvs.truncate(first);
                return Ok(());
            };
            mesh.corners.push(vertex);
            mesh.corner_uvs.push(if has_uvs { uv } else { NO_UV });
        }
        mesh.push_face(
            first,
            u32::try_from(mesh.groups.len() - 1).unwrap_or(u32::MAX),
        );
        Ok(())
    }

    /// The vertex at a position, and its texture coordinate.
    fn corner(&self, position: i64) -> Option<(u32, u32)> {
        let number = u32::try_from(position).ok()?;
        let copy = (number as usize).checked_sub(self.vertices);
        Some((
            copy.map_or(Some(number), |copy| self.sources.get(copy).copied())?,
            number,
        ))
    }
}

fn name(names: &Table, row: usize) -> Result<String, Misfit> {
    let bytes = names.text(row, 0).unwrap_or_default();
    String::from_utf8(bytes.to_vec())
        .map_err(|fault| Misfit::GroupName(String::from_utf8_lossy(fault.as_bytes()).into_owned()))
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::mesh_difference::MeshDifference;
    use crate::npz::samples::{npy, npy_in_order, zip_of};
    use crate::obj;

    /// Two triangles; vertices 0 and 2 have a copy each, because the second has other texture
    /// coordinates there.
    const OBJ: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0.5\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 0.5\nvt 0.5 0.5\nvt 0.25 0.5\n\
        g body\nf 1/1 2/2 3/3\ng joint\nf 1/4 3/5 4/6\n";

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

    fn header(counts: [i32; 4]) -> Vec<u8> {
        let descr = "[('objname', '|S3'), ('numverts', '<i4'), ('prnt', '<i4'), ('fcnt', '<i4'), \
            ('ucnt', '<i4')]";
        npy(descr, "(1,)", &[b"imp".as_slice(), &ints(&counts)].concat())
    }

    fn groups(rows: &[(i32, i32, u8)]) -> Vec<u8> {
        let data: Vec<u8> = rows
            .iter()
            .flat_map(|row| [ints(&[row.0, row.1]), vec![row.2]].concat())
            .collect();
        npy(
            "[('f0', '<i4'), ('f1', '<i4'), ('f2', '|b1')]",
            &format!("({},)", rows.len()),
            &data,
        )
    }

    const POSITIONS: [f32; 18] = [
        0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 1.0, 0.5, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0,
    ];
    const UVS: [f32; 12] = [0.0, 1.0, 1.0, 1.0, 1.0, 0.0, 0.25, 0.5, 0.0, 0.5, 0.5, 0.5];

    /// What the program packs of the OBJ.
    fn members() -> Vec<(&'static str, Vec<u8>)> {
        vec![
            ("header.npy", header([4, 2, 2, 2])),
            ("grpNames.npy", npy("'|S5'", "(2,)", b"body\0joint")),
            ("coord.npy", npy("'<f4'", "(6, 3)", &floats(&POSITIONS))),
            ("uvs.npy", npy("'<f4'", "(6, 2)", &floats(&UVS))),
            ("overflow.npy", npy("'<u4'", "(2, 2)", &ints(&[0, 4, 2, 5]))),
            ("groupinfo.npy", groups(&[(0, 1, 1), (3, 1, 1)])),
            ("vertsperface.npy", npy("'<i4'", "(2,)", &ints(&[3, 3]))),
            (
                "faceverts.npy",
                npy("'<i4'", "(6,)", &ints(&[0, 1, 2, 4, 5, 3])),
            ),
        ]
    }

    fn parsed(bytes: &[u8]) -> Result<Mesh, MeshFault> {
        parse(bytes, &Limits::default())
    }

    /// The mesh with another member in the place of one.
    fn with(name: &str, member: Vec<u8>) -> Result<Mesh, MeshFault> {
        let mut members = members();
        members
            .iter_mut()
            .find(|(own, _)| *own == format!("{name}.npy"))
            .unwrap()
            .1 = member;
        parsed(&zip_of(&members))
    }

    fn misfit(name: &str, member: Vec<u8>) -> Misfit {
        match with(name, member) {
            Err(MeshFault::Misfit(misfit)) => misfit,
            other => panic!("{other:?}"),
        }
    }

    #[test]
    fn a_packed_mesh_is_that_of_its_obj() {
        let (packed, text) = (
            parsed(&zip_of(&members())).unwrap(),
            obj::parse(OBJ.as_bytes()),
        );
        assert_eq!(
            MeshDifference::between(&packed, &text),
            MeshDifference::default()
        );
        assert_eq!(
            (packed.size(), &packed.corners),
            (text.size(), &text.corners)
        );
        let of = |mesh: &Mesh| {
            mesh.groups
                .iter()
                .map(|group| (group.name.clone(), group.vertices))
                .collect::<Vec<_>>()
        };
        assert_eq!(of(&packed), of(&text));
        assert!(
            packed.is_sound()
                && packed.facts.partial_uv.is_empty()
                && packed.facts.unused.count == 0
        );
    }

    #[test]
    fn other_types_and_orders_mean_the_same() {
        let mesh = parsed(&zip_of(&members())).unwrap();
        let same =
            |found: Result<Mesh, MeshFault>| assert_eq!(found.unwrap().positions, mesh.positions);
        let wide: Vec<u8> = POSITIONS
            .iter()
            .flat_map(|value| f64::from(*value).to_be_bytes())
            .collect();
        same(with("coord", npy("'>f8'", "(6, 3)", &wide)));
        let columns: Vec<f32> = (0..18).map(|at| POSITIONS[at % 6 * 3 + at / 6]).collect();
        same(with(
            "coord",
            npy_in_order("'<f4'", "True", "(6, 3)", &floats(&columns)),
        ));
    }

    #[test]
    fn a_mesh_without_texture_has_neither_coordinates_nor_copies() {
        let mut plain = members();
        for (name, member) in &mut plain {
            match *name {
                "header.npy" => *member = header([6, 2, 2, 0]),
                "uvs.npy" => *member = npy("'<f4'", "(0, 2)", &[]),
                "overflow.npy" => *member = npy("'<u4'", "(0, 2)", &[]),
                _ => {}
            }
        }
        let mesh = parsed(&zip_of(&plain)).unwrap();
        assert_eq!(
            (
                mesh.size().with_seams,
                mesh.uvs.len(),
                mesh.corner_uvs.first()
            ),
            (6, 0, Some(&NO_UV))
        );
    }

    #[test]
    fn what_cannot_be_loaded_is_named() {
        assert_eq!(parsed(b""), Err(MeshFault::Archive(ArchiveFault::Empty)));
        assert!(matches!(
            parsed(b"not a zip\n"),
            Err(MeshFault::Archive(ArchiveFault::NotZip(_)))
        ));
        let some: Vec<_> = members()
            .into_iter()
            .filter(|(name, _)| !name.starts_with('u'))
            .collect();
        assert_eq!(parsed(&zip_of(&some)), Err(MeshFault::Missing(vec!["uvs"])));
        let member = |name, member| match with(name, member) {
            Err(MeshFault::Member(own, fault)) if own == name => fault,
            other => panic!("{other:?}"),
        };
        assert_eq!(member("coord", b"text".to_vec()), NpyFault::NotNpy);
        assert_eq!(
            member("coord", npy("'|O'", "(6, 3)", b"\x80\x04.")),
            NpyFault::Object
        );
        assert_eq!(
            member("coord", npy("'<f4'", "(18,)", &floats(&POSITIONS))),
            NpyFault::Shape
        );
        assert_eq!(
            member("coord", npy("'<f4'", "(9, 2)", &floats(&POSITIONS))),
            NpyFault::Shape
        );
        assert_eq!(
            member("coord", npy("'<f4'", "(7, 3)", &floats(&POSITIONS))),
            NpyFault::Truncated
        );
        let wrong = NpyFault::WrongType("", "<f4".to_owned());
        assert_eq!(
            member("faceverts", npy("'<f4'", "(6,)", &floats(&POSITIONS))),
            wrong
        );
        assert_eq!(
            member("groupinfo", npy("'<i4'", "(2,)", &ints(&[0, 3]))),
            NpyFault::Shape
        );
    }

    #[test]
    fn what_does_not_fit_together_is_named() {
        assert_eq!(misfit("header", header([0, 2, 2, 2])), Misfit::Header);
        assert_eq!(misfit("header", header([4, -1, 2, 2])), Misfit::Header);
        assert_eq!(
            misfit("header", header([7, 2, 2, 2])),
            Misfit::Short(Part::Positions, 6, 7)
        );
        assert_eq!(
            misfit("header", header([4, 1, 2, 2])),
            Misfit::Short(Part::Triangles, 1, 2)
        );
        assert_eq!(
            misfit("uvs", npy("'<f4'", "(5, 2)", &floats(&UVS))),
            Misfit::Short(Part::Uvs, 5, 6)
        );
        assert_eq!(
            misfit("groupinfo", groups(&[(0, 1, 1)])),
            Misfit::Short(Part::Groups, 1, 2)
        );
        assert_eq!(
            misfit("grpNames", npy("'|S4'", "(1,)", b"body")),
            Misfit::Short(Part::GroupNames, 1, 2)
        );
        assert_eq!(
            misfit("grpNames", npy("'|S1'", "(2,)", b"a\xff")),
            Misfit::GroupName("\u{fffd}".to_owned())
        );
        assert_eq!(
            misfit("groupinfo", groups(&[(0, 1, 1), (4, 1, 1)])),
            Misfit::Faces
        );
        assert_eq!(
            misfit("groupinfo", groups(&[(0, 1, 1), (3, 2, 1)])),
            Misfit::Faces
        );
        assert_eq!(
            misfit("groupinfo", groups(&[(0, 1, 1), (-1, 1, 1)])),
            Misfit::Faces
        );
        assert_eq!(
            misfit("vertsperface", npy("'<i4'", "(2,)", &ints(&[3, 2]))),
            Misfit::SmallFace(2)
        );
        assert_eq!(
            misfit("overflow", npy("'<i4'", "(2, 2)", &ints(&[0, 4, 2, 6]))),
            Misfit::Overflow(6)
        );
        assert_eq!(
            misfit("overflow", npy("'<i4'", "(1, 2)", &ints(&[0, 4]))),
            Misfit::Copy(5)
        );
        assert_eq!(
            misfit("overflow", npy("'<i4'", "(2, 2)", &ints(&[0, 4, 4, 5]))),
            Misfit::Copy(5)
        );
    }

    #[test]
    fn faces_and_positions_that_cannot_be_drawn_are_counted() {
        let mesh = with(
            "faceverts",
            npy("'<i4'", "(6,)", &ints(&[0, 1, 6, -1, 5, 3])),
        )
        .unwrap();
        assert_eq!(
            (&mesh.facts.face_out_of_range.first, mesh.faces.len()),
            (&vec![(0, 6), (0, -1)], 0)
        );
        let mut positions = POSITIONS;
        positions[4] = f32::NAN;
        let mesh = with("coord", npy("'<f4'", "(6, 3)", &floats(&positions))).unwrap();
        assert_eq!(mesh.facts.non_finite.first, [(0, 1)]);
        let twice = with(
            "faceverts",
            npy("'<i4'", "(6,)", &ints(&[0, 1, 4, 4, 5, 3])),
        )
        .unwrap();
        assert_eq!(
            (twice.facts.repeating.len(), twice.facts.repeating[0].vertex),
            (1, 0)
        );
    }

    #[test]
    fn nothing_is_reserved_for_what_a_header_promises() {
        for shape in [
            "(1000000000000000000, 3)",
            "(18446744073709551615, 3)",
            "(4000000000, 3)",
        ] {
            let found = with("coord", npy("'<f4'", shape, &floats(&POSITIONS)));
            assert_eq!(
                found,
                Err(MeshFault::Member("coord", NpyFault::Truncated)),
                "{shape}"
            );
        }
        let endless = npy("'|S0'", "(1000000000000000000,)", b"");
        assert_eq!(
            with("grpNames", endless),
            Err(MeshFault::Member("grpNames", NpyFault::Header))
        );
        assert_eq!(
            misfit("groupinfo", groups(&[(0, i32::MAX, 1), (3, 1, 1)])),
            Misfit::Faces
        );
    }

    #[test]
    fn corners_are_not_taken_twice() {
        assert_eq!(
            misfit("vertsperface", npy("'<i4'", "(2,)", &ints(&[6, 3]))),
            Misfit::Faces
        );
        let same = with("groupinfo", groups(&[(0, 1, 1), (0, 1, 1)])).unwrap();
        assert_eq!(same.faces.len(), 2);
    }

    #[test]
    fn a_bomb_is_given_up() {
        let mut members = members();
        members[2].1.extend(vec![0; 1_000_000]);
        let limits = Limits {
            unpacked_bytes: 10_000,
            ..Limits::default()
        };
        assert_eq!(parse(&zip_of(&members), &limits), Err(MeshFault::Oversized));
    }

    #[test]
    fn every_truncation_and_every_changed_byte_is_survived() {
        let bytes = zip_of(&members());
        for length in 0..bytes.len() {
            assert!(matches!(
                parsed(&bytes[..length]),
                Err(MeshFault::Archive(_))
            ));
        }
        for at in 0..bytes.len() {
            for value in [0, 0x7f, 0xff] {
                let mut changed = bytes.clone();
                changed[at] = value;
                let _ = parsed(&changed);
            }
        }
    }

    proptest! {
        #[test]
        fn any_bytes_are_read_or_refused(bytes in proptest::collection::vec(any::<u8>(), 0..300)) {
            prop_assert!(parsed(&bytes).is_err());
        }

        #[test]
        fn any_numbers_are_read_or_refused(
            which in 0..8_usize, counts in proptest::collection::vec(-9..9_i32, 4), rows in proptest::collection::vec(-9..9_i32, 0..12),
        ) {
            let names = ["header", "overflow", "groupinfo", "vertsperface", "faceverts", "coord", "uvs", "grpNames"];
            let data = ints(&rows);
            let half = rows.len() / 2;
            let member = match names[which] {
                "header" => header([counts[0], counts[1], counts[2], counts[3]]),
                "overflow" | "uvs" => npy("'<i4'", &format!("({half}, 2)"), &data),
                "groupinfo" => groups(&[(counts[0], counts[1], 1), (counts[2], counts[3], 0)]),
                "coord" => npy("'<i4'", &format!("({}, 3)", rows.len() / 3), &data),
                "grpNames" => npy("'|S4'", &format!("({},)", rows.len()), &data),
                _ => npy("'<i4'", &format!("({},)", rows.len()), &data),
            };
            if let Ok(mesh) = with(names[which], member) {
                prop_assert!(mesh.corners.iter().all(|vertex| (*vertex as usize) < mesh.positions.len()));
                prop_assert_eq!(mesh.corners.len(), mesh.corner_uvs.len());
            }
        }
    }
}
