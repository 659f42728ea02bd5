//! `[[pack]]`: an OBJ packed as MakeHuman 2's `compile_meshes.py` does it, so that cases need no
//! bytes in hexadecimal.

use std::collections::BTreeMap;
use std::io::{Cursor, Write};

use serde::Deserialize;
use zip::write::{SimpleFileOptions, ZipWriter};

use super::{Edit, pack_asset, project};

/// A mesh to pack.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Pack {
    pub file: String,
    /// The OBJ that it is packed from, as the example has it.
    from: String,
    /// The text of the asset that the mesh is for, if it is one of an asset.
    #[serde(default)]
    asset: String,
    /// Vertices of the base mesh that the mask of the asset is made for, if not those of the
    /// example.
    #[serde(default)]
    base: Option<usize>,
    /// Something in the OBJ, or in the text of an asset, that is otherwise in the archive.
    #[serde(default)]
    find: String,
    #[serde(default)]
    replace: String,
    /// Members that are left out.
    #[serde(default)]
    without: Vec<String>,
}

impl Pack {
    /// The archive.
    pub fn bytes(&self) -> Vec<u8> {
        let obj = std::fs::read_to_string(project("fixtures/makehuman2").join(&self.from)).unwrap();
        let edit = Edit {
            file: self.from.clone(),
            find: self.find.clone(),
            replace: self.replace.clone(),
            all: false,
        };
        if self.asset.is_empty() {
            let obj = if self.find.is_empty() {
                obj
            } else {
                edit.edited(&obj)
            };
            return archive(Packed::of(&obj).members(), &self.without);
        }
        let text =
            std::fs::read_to_string(project("fixtures/makehuman2").join(&self.asset)).unwrap();
        let text = if self.find.is_empty() {
            text
        } else {
            edit.edited(&text)
        };
        let asset = pack_asset::members(&text, self.base.unwrap_or(VERTICES));
        archive(
            Packed::of(&obj).members().into_iter().chain(asset),
            &self.without,
        )
    }
}

/// Vertices of the base mesh of the example.
const VERTICES: usize = 666;

/// An OBJ packed.
pub fn packed(obj: &[u8]) -> Vec<u8> {
    archive(Packed::of(std::str::from_utf8(obj).unwrap()).members(), &[])
}

fn archive(
    members: impl IntoIterator<Item = (&'static str, Vec<u8>)>,
    without: &[String],
) -> Vec<u8> {
    let mut zip = ZipWriter::new(Cursor::new(Vec::new()));
    for (name, array) in members {
        if !without.iter().any(|left_out| left_out == name) {
            let options = SimpleFileOptions::default().last_modified_time(zip::DateTime::default());
            zip.start_file(format!("{name}.npy"), options).unwrap();
            zip.write_all(&array).unwrap();
        }
    }
    zip.finish().unwrap().into_inner()
}

/// A group: faces as vertices and as texture coordinates, both from 0.
#[derive(Default)]
struct Group {
    name: String,
    faces: Vec<Vec<usize>>,
    uvs: Vec<Vec<usize>>,
}

#[derive(Default)]
struct Packed {
    name: String,
    vertices: usize,
    positions: Vec<[f32; 3]>,
    uvs: Vec<[f32; 2]>,
    /// Vertex and copy.
    overflow: Vec<[usize; 2]>,
    groups: Vec<Group>,
}

impl Packed {
    fn of(obj: &str) -> Self {
        let mut packed = Self {
            groups: vec![Group {
                name: "mh_default".to_owned(),
                ..Group::default()
            }],
            ..Self::default()
        };
        let mut texture: Vec<[f64; 2]> = Vec::new();
        for line in obj.lines() {
            let words: Vec<&str> = line.split_whitespace().collect();
            let number = |at: usize| words[at].parse::<f64>().unwrap();
            match words.as_slice() {
                ["v", ..] => packed
                    .positions
                    .push([number(1), number(2), number(3)].map(single)),
                ["vt", ..] => texture.push([number(1), 1.0 - number(2)]),
                ["o", name, ..] => (*name).clone_into(&mut packed.name),
                ["g", name, ..] if packed.groups.iter().all(|group| group.name != *name) => {
                    packed.groups.push(Group {
                        name: (*name).to_owned(),
                        ..Group::default()
                    });
                }
                ["f", corners @ ..] => packed.groups.last_mut().unwrap().add_face(corners),
                _ => {}
            }
        }
        packed.groups.retain(|group| !group.faces.is_empty());
        packed.vertices = packed.positions.len();
        packed.split_seams(&texture);
        packed
    }

    /// Gives each vertex one texture coordinate, and a copy for each other one that is not near.
    fn split_seams(&mut self, texture: &[[f64; 2]]) {
        let mut first: BTreeMap<usize, usize> = BTreeMap::new();
        let mut copies: BTreeMap<(usize, usize), usize> = BTreeMap::new();
        self.uvs = vec![[0.0; 2]; self.vertices];
        for group in &mut self.groups {
            for (face, uvs) in group.faces.iter_mut().zip(&group.uvs) {
                for (vertex, uv) in face.iter_mut().zip(uvs) {
                    let stored = texture[*uv].map(single);
                    if *first.entry(*vertex).or_insert(*uv) == *uv {
                        self.uvs[*vertex] = stored;
                        continue;
                    }
                    let own = self.uvs[*vertex];
                    if (0..2).all(|axis| (f64::from(own[axis]) - texture[*uv][axis]).abs() <= 0.001)
                    {
                        continue;
                    }
                    *vertex = *copies.entry((*vertex, *uv)).or_insert_with(|| {
                        self.overflow.push([*vertex, self.positions.len()]);
                        self.positions.push(self.positions[*vertex]);
                        self.uvs.push(stored);
                        self.positions.len() - 1
                    });
                }
            }
        }
        self.overflow.sort_by_key(|row| row[0]);
    }

    fn members(&self) -> [(&'static str, Vec<u8>); 8] {
        let faces = || self.groups.iter().flat_map(|group| &group.faces);
        let count = |group: &Group| group.faces.iter().map(Vec::len).sum::<usize>();
        let textured = self.groups.iter().filter(|group| !group.uvs.is_empty());
        let counts = [
            self.vertices,
            faces().map(|face| face.len() - 2).sum(),
            faces().count(),
            textured.map(|group| group.faces.len()).sum(),
        ];
        let length = self.name.len();
        let header = format!(
            "[('objname', '|S{length}'), ('numverts', '<i4'), ('prnt', '<i4'), ('fcnt', '<i4'), ('ucnt', '<i4')]"
        );
        let longest = self
            .groups
            .iter()
            .map(|group| group.name.len())
            .max()
            .unwrap_or(1);
        let names = self.groups.iter().flat_map(|group| {
            let mut name = group.name.clone().into_bytes();
            name.resize(longest, 0);
            name
        });
        let mut start = 0;
        let groups = self.groups.iter().flat_map(|group| {
            let row = [
                int(start),
                int(group.faces.len()),
                vec![u8::from(!group.uvs.is_empty())],
            ]
            .concat();
            start += count(group);
            row
        });
        let rows = |rows: usize, width: usize| format!("({rows}, {width})");
        let flat = |rows: usize| format!("({rows},)");
        let stored = self.positions.len();
        [
            (
                "header",
                npy(
                    &header,
                    "(1,)",
                    self.name.bytes().chain(counts.into_iter().flat_map(int)),
                ),
            ),
            (
                "grpNames",
                npy(&format!("'|S{longest}'"), &flat(self.groups.len()), names),
            ),
            (
                "coord",
                npy(
                    "'<f4'",
                    &rows(stored, 3),
                    self.positions
                        .iter()
                        .flatten()
                        .flat_map(|part| part.to_le_bytes()),
                ),
            ),
            (
                "uvs",
                npy(
                    "'<f4'",
                    &rows(stored, 2),
                    self.uvs
                        .iter()
                        .flatten()
                        .flat_map(|part| part.to_le_bytes()),
                ),
            ),
            (
                "overflow",
                npy(
                    "'<u4'",
                    &rows(self.overflow.len(), 2),
                    self.overflow.iter().flatten().flat_map(|one| int(*one)),
                ),
            ),
            (
                "groupinfo",
                npy(
                    "[('f0', '<i4'), ('f1', '<i4'), ('f2', '|b1')]",
                    &flat(self.groups.len()),
                    groups,
                ),
            ),
            (
                "vertsperface",
                npy(
                    "'<i4'",
                    &flat(counts[2]),
                    faces().flat_map(|face| int(face.len())),
                ),
            ),
            (
                "faceverts",
                npy(
                    "'<i4'",
                    &flat(faces().map(Vec::len).sum()),
                    faces().flatten().flat_map(|vertex| int(*vertex)),
                ),
            ),
        ]
    }
}

impl Group {
    fn add_face(&mut self, corners: &[&str]) {
        let numbers = |part: usize| {
            let numbers = corners
                .iter()
                .filter_map(|corner| corner.split('/').nth(part)?.parse::<usize>().ok());
            numbers.map(|number| number - 1).collect::<Vec<_>>()
        };
        self.faces.push(numbers(0));
        let uvs = numbers(1);
        self.uvs.extend((!uvs.is_empty()).then_some(uvs));
    }
}

#[expect(
    clippy::cast_possible_truncation,
    reason = "stored as float32, as the application does"
)]
pub(super) fn single(number: f64) -> f32 {
    number as f32
}

pub(super) fn int(number: usize) -> Vec<u8> {
    i32::try_from(number).unwrap().to_le_bytes().to_vec()
}

/// An array as `NumPy` 1 and 2 write it: the header ends at a multiple of 64 bytes.
pub(super) fn npy(descr: &str, shape: &str, data: impl Iterator<Item = u8>) -> Vec<u8> {
    let mut header = format!("{{'descr': {descr}, 'fortran_order': False, 'shape': {shape}, }}");
    let length = (10 + header.len() + 1).next_multiple_of(64) - 11;
    header.push_str(&" ".repeat(length - header.len()));
    header.push('\n');
    let length = u16::try_from(header.len()).unwrap().to_le_bytes();
    b"\x93NUMPY\x01\x00"
        .iter()
        .copied()
        .chain(length)
        .chain(header.into_bytes())
        .chain(data)
        .collect()
}
