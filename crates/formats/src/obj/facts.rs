//! Facts on a mesh: what is counted when all its lines have been read
//! (`docs/loaders/makehuman2/base-mesh.md#obj-commands`).
//!
//! Gets the mesh and the lines of its faces, completes the facts; checks nothing.

use std::collections::BTreeSet;
use std::sync::Arc;

use crate::obj::{Face, Mesh, NO_UV};
use mhlint_diag::{Few, Tally};

/// Two texture coordinates of one vertex farther apart than this make a duplicate.
const SEAM_DISTANCE: f32 = 0.001;
/// Names kept of the groups that a re-opened group's faces end up in.
const LANDINGS_KEPT: usize = 3;

/// Facts on a mesh file.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct MeshFacts {
    /// Vertices of the file.
    pub vertices: usize,
    /// Duplicates that loading adds along texture seams.
    pub seam_duplicates: usize,
    /// Names that were opened again, with at least one face behind.
    pub reopened: Vec<Reopened>,
    /// Lines the loader stops at, the first few.
    pub unreadable: Vec<BadLine>,
    /// How many such lines.
    pub unreadable_lines: u64,
    /// What they are known by: the vertex, the texture coordinate, the text of a face.
    pub unreadable_names: Few<String>,
    /// Faces with a vertex or texture coordinate that does not exist (line, number as written).
    pub face_out_of_range: Tally,
    /// Faces with fewer than three corners, which are left out; the loader stops at those that it
    /// draws.
    pub short_faces: Vec<ShortFace>,
    /// Faces with a vertex twice.
    pub repeating: Vec<Repeating>,
    /// Vertices with NaN or infinity (line, vertex).
    pub non_finite: Tally,
    /// Texture coordinates with NaN or infinity (line, number from 0).
    pub non_finite_uvs: Tally,
    /// Vertices no face uses (no line, vertex).
    pub unused: Tally,
    /// Groups that mix faces with and without texture coordinates.
    pub partial_uv: Vec<PartialUv>,
    /// Groups and objects without a name (line).
    pub nameless: Tally,
    /// The name of the last object, with its line.
    pub object: Option<(Box<str>, u32)>,
    /// Faces with more than four corners (line, corners).
    pub ngons: Tally,
    /// Lowest and highest coordinate along each axis, mesh units, of the vertices that the faces of
    /// each group use.
    pub bounds: Vec<Option<Bounds>>,
}

/// Lowest and highest coordinate along each axis.
pub type Bounds = [(f32, f32); 3];

/// A group name that was opened again after another one.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Reopened {
    /// The name.
    pub name: String,
    /// Line of the first such opening.
    pub line: u32,
    /// Faces behind these openings.
    pub faces: usize,
    /// How many of them end up in another group.
    pub strayed: usize,
    /// The other groups, the first few.
    pub lands_in: Vec<Arc<str>>,
}

/// A face with a vertex twice.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Repeating {
    /// Line of the face.
    pub line: u32,
    /// The vertex, from 0.
    pub vertex: u32,
    /// Index of the group of the face.
    pub group: u32,
}

/// A face with fewer than three corners.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ShortFace {
    /// Line of the face.
    pub line: u32,
    /// The line, shortened.
    pub text: String,
    /// Name of the group of the face.
    pub group: String,
}

/// A group of which some faces have texture coordinates.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct PartialUv {
    /// Name of the group.
    pub name: String,
    /// Faces in it.
    pub faces: usize,
    /// Faces that lack texture coordinates at one corner or all.
    pub without: usize,
    /// Line of the first of them.
    pub line: u32,
}

/// A line the loader cannot read.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct BadLine {
    /// Line from 1.
    pub line: u32,
    /// The line, shortened.
    pub text: String,
    /// What is wrong with it.
    pub what: &'static str,
}

impl MeshFacts {
    /// The groups into which faces of another one are put, and those other ones.
    pub fn mixed_groups(&self) -> BTreeSet<&str> {
        let names = self.reopened.iter().flat_map(|reopened| {
            reopened
                .lands_in
                .iter()
                .map(AsRef::as_ref)
                .chain([reopened.name.as_str()])
        });
        names.collect()
    }

    /// Notes that the name `name` was opened again; takes and gives its place in
    /// [`MeshFacts::reopened`].
    pub(super) fn reopen(
        &mut self,
        known: Option<usize>,
        name: &str,
        line: u32,
        lands_in: &Arc<str>,
    ) -> usize {
        let at = known.unwrap_or(self.reopened.len());
        if known.is_none() {
            self.reopened.push(Reopened {
                name: name.to_owned(),
                line,
                faces: 0,
                strayed: 0,
                lands_in: Vec::new(),
            });
        }
        if let Some(Reopened {
            lands_in: groups, ..
        }) = self.reopened.get_mut(at)
            && **lands_in != *name
            && groups.len() < LANDINGS_KEPT
            && !groups.iter().any(|group| group == lands_in)
        {
            groups.push(Arc::clone(lands_in));
        }
        at
    }

    /// Counts what only the whole mesh shows; `lines` are those of the faces, 0 where they have
    /// none.
    pub(crate) fn complete(&mut self, mesh: &Mesh, lines: &[u32]) {
        self.vertices = mesh.positions.len();
        self.reopened.retain(|reopened| reopened.faces > 0);
        self.check_faces(mesh, lines);
        self.repeating = repeating(mesh, lines);
        self.partial_uv = partial_uv(mesh, lines);
        self.bounds = bounds(mesh);
        self.count_unused(mesh);
        self.seam_duplicates = count_seams(mesh);
    }

    /// Faces may name vertices that come later in the file, so ranges are known only now.
    fn check_faces(&mut self, mesh: &Mesh, lines: &[u32]) {
        for (face, line) in mesh.faces.iter().zip(lines) {
            if face.len > 4 {
                self.ngons.add(*line, i64::from(face.len));
            }
            let corners = face.of(&mesh.corners);
            let uvs = face.of(&mesh.corner_uvs);
            let bad_vertex = corners
                .iter()
                .find(|vertex| **vertex as usize >= mesh.positions.len());
            let bad_uv = uvs
                .iter()
                .find(|uv| **uv != NO_UV && **uv as usize >= mesh.uvs.len());
            if let Some(bad) = bad_vertex.or(bad_uv) {
                self.face_out_of_range.add(*line, i64::from(*bad) + 1);
            }
        }
    }

    fn count_unused(&mut self, mesh: &Mesh) {
        let mut used = vec![false; mesh.positions.len()];
        for vertex in &mesh.corners {
            if let Some(used) = used.get_mut(*vertex as usize) {
                *used = true;
            }
        }
        for (index, _) in used.iter().enumerate().filter(|(_, used)| !**used) {
            self.unused.add(0, i64::try_from(index).unwrap_or(i64::MAX));
        }
    }
}

fn bounds(mesh: &Mesh) -> Vec<Option<Bounds>> {
    let mut bounds: Vec<Option<Bounds>> = vec![None; mesh.groups.len()];
    for face in &mesh.faces {
        let Some(bounds) = bounds.get_mut(face.group as usize) else {
            continue;
        };
        for position in face
            .of(&mesh.corners)
            .iter()
            .filter_map(|vertex| mesh.positions.get(*vertex as usize))
        {
            let own = position.map(|part| (part, part));
            *bounds = Some(bounds.map_or(own, |known| joined(&known, &own)));
        }
    }
    bounds
}

/// What holds both.
pub fn joined([ax, ay, az]: &Bounds, [bx, by, bz]: &Bounds) -> Bounds {
    let axis = |one: &(f32, f32), other: &(f32, f32)| (one.0.min(other.0), one.1.max(other.1));
    [axis(ax, bx), axis(ay, by), axis(az, bz)]
}

fn repeating(mesh: &Mesh, lines: &[u32]) -> Vec<Repeating> {
    let mut seen = BTreeSet::new();
    let mut repeated = |face: Face| {
        seen.clear();
        face.of(&mesh.corners)
            .iter()
            .copied()
            .find(|vertex| !seen.insert(*vertex))
    };
    let faces = mesh.faces.iter().zip(lines);
    faces
        .filter_map(|(face, line)| {
            Some(Repeating {
                line: *line,
                vertex: repeated(*face)?,
                group: face.group,
            })
        })
        .collect()
}

/// Texture coordinates are stored group by group; the loader counts on one list per face, or none
/// at all.
fn partial_uv(mesh: &Mesh, lines: &[u32]) -> Vec<PartialUv> {
    let blank = |group: &super::Group| PartialUv {
        name: group.name.clone(),
        faces: 0,
        without: 0,
        line: 0,
    };
    let mut groups: Vec<PartialUv> = mesh.groups.iter().map(blank).collect();
    let mut with = vec![false; groups.len()];
    for (face, line) in mesh.faces.iter().zip(lines) {
        let (Some(group), Some(with)) = (
            groups.get_mut(face.group as usize),
            with.get_mut(face.group as usize),
        ) else {
            continue;
        };
        let uvs = face.of(&mesh.corner_uvs);
        group.faces += 1;
        *with |= uvs.iter().any(|uv| *uv != NO_UV);
        if uvs.contains(&NO_UV) {
            group.without += 1;
            group.line = if group.line == 0 { *line } else { group.line };
        }
    }
    let mixed = groups
        .into_iter()
        .zip(with)
        .filter(|(group, with)| *with && group.without > 0);
    mixed.map(|(group, _)| group).collect()
}

/// The first texture coordinate of a vertex is its own; each other one that is far enough from it
/// makes a duplicate, told apart by index alone.
fn count_seams(mesh: &Mesh) -> usize {
    let mut first: Vec<u32> = vec![NO_UV; mesh.positions.len()];
    let mut others: BTreeSet<(u32, u32)> = BTreeSet::new();
    for (vertex, uv) in mesh
        .corners
        .iter()
        .zip(&mesh.corner_uvs)
        .filter(|(_, uv)| **uv != NO_UV)
    {
        let Some(known) = first.get_mut(*vertex as usize) else {
            continue;
        };
        if *known == NO_UV {
            *known = *uv;
        } else if *known != *uv && !is_near(mesh, *known, *uv) {
            others.insert((*vertex, *uv));
        }
    }
    others.len()
}

fn is_near(mesh: &Mesh, one: u32, other: u32) -> bool {
    match (mesh.uvs.get(one as usize), mesh.uvs.get(other as usize)) {
        (Some(one), Some(other)) => one
            .iter()
            .zip(other)
            .all(|(one, other)| (one - other).abs() <= SEAM_DISTANCE),
        _ => true,
    }
}
