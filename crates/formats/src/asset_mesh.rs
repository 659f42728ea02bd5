//! The mesh of an asset (`docs/loaders/makehuman2/base-mesh.md#obj-commands`,
//! `docs/loaders/makehuman2/clothes.md#rows`): what is counted of it, a print to compare it by, and
//! its faces. Where its vertices lie does not matter to applications, which fit them to the base
//! mesh; it tells what shape the author drew.

use std::fmt::Display;

use xxhash_rust::xxh3::xxh3_64;

use super::obj::{Face, Mesh, MeshFacts, NO_UV, Repeating};

/// A mesh without its texture coordinates.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct AssetMesh {
    /// What was counted.
    pub facts: MeshFacts,
    /// Faces with three corners or more.
    pub faces: usize,
    /// Texture coordinates.
    pub uvs: usize,
    /// Whether any face has some.
    pub has_uvs: bool,
    /// Names of groups with faces that are not ASCII, with the lines where they are opened.
    pub odd_groups: Vec<(String, u32)>,
    /// Where there are several groups with faces, their names with their first and last vertex.
    pub groups: Vec<(Box<str>, (u32, u32))>,
    /// The vertex with most faces, and how many it has.
    pub pole: Option<(u32, u32)>,
    /// The same for those that share an edge with it, of vertices with five faces and more.
    pub neighbours: Option<(u32, u32)>,
    /// Faces that repeat the corners of an earlier one.
    pub repeated: usize,
    /// Faces with a vertex twice: the first of them, and how many.
    pub degenerate: Option<(Repeating, usize)>,
    /// What it is compared by.
    pub print: MeshPrint,
    /// Vertices as drawn, in file order.
    pub positions: Box<[[f32; 3]]>,
    /// Vertices of all faces, one after the other.
    pub corners: Box<[u32]>,
    /// Where each face begins in `corners`, and one entry for the end.
    pub face_starts: Box<[u32]>,
    /// What an archive of MakeHuman 1 has room for.
    pub kept_faces: Option<KeptFaces>,
    /// All of it, where it is a base mesh.
    pub whole: Option<Box<Mesh>>,
}

/// How many faces of a vertex an archive of MakeHuman 1 has room for
/// (`docs/loaders/makehuman1/base-mesh.md#packed-meshes`).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct KeptFaces {
    /// The columns of its table.
    pub columns: u64,
    /// What it says itself; archives of 1.0 leave that to the asset.
    pub stated: Option<u64>,
}

impl KeptFaces {
    /// Whether the program gets as many as it makes room for. It cuts off more, and gives up at
    /// fewer.
    pub const fn holds(self, asked: u64) -> bool {
        let asked = if let Some(stated) = self.stated {
            stated
        } else {
            asked
        };
        self.columns >= asked
    }
}

/// Tells meshes with other faces apart, in whatever order these stand.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct MeshPrint {
    /// Vertices, without UV-seam duplicates.
    pub vertices: usize,
    /// Faces.
    pub faces: usize,
    /// Of the corners of all faces.
    corners: u64,
}

impl AssetMesh {
    /// What is kept of a mesh.
    pub fn of(mut mesh: Mesh) -> Self {
        let mut facts = std::mem::take(&mut mesh.facts);
        let repeating = std::mem::take(&mut facts.repeating);
        let counts = faces_of_vertices(&mesh);
        let odd = mesh
            .groups
            .iter()
            .filter(|group| group.faces > 0 && !group.name.is_ascii());
        Self {
            faces: mesh.faces.len(),
            uvs: mesh.uvs.len(),
            has_uvs: mesh.corner_uvs.iter().any(|uv| *uv != NO_UV),
            groups: ranges(&mesh),
            odd_groups: odd.map(|group| (group.name.clone(), group.line)).collect(),
            pole: most(&counts),
            neighbours: neighbours(&mesh, &counts),
            repeated: repeated(&mesh),
            degenerate: repeating.first().map(|first| (*first, repeating.len())),
            print: MeshPrint::of(&mesh),
            face_starts: face_starts(&mesh),
            positions: mesh.positions.into(),
            corners: mesh.corners.into(),
            facts,
            kept_faces: None,
            whole: None,
        }
    }

    /// How many vertices faces use; all if there are no faces.
    pub fn used(&self) -> usize {
        let unused = usize::try_from(self.facts.unused.count).unwrap_or(usize::MAX);
        if self.faces == 0 {
            self.facts.vertices
        } else {
            self.facts.vertices.saturating_sub(unused)
        }
    }

    /// A vertex with the group that it belongs to, where that is sure.
    pub fn named(&self, vertex: impl TryInto<u32> + Display + Copy) -> String {
        let number = vertex.try_into().unwrap_or(u32::MAX);
        let mut homes = self
            .groups
            .iter()
            .filter(|(_, (first, last))| (*first..=*last).contains(&number));
        match (homes.next(), homes.next()) {
            (Some((group, _)), None) => format!("vertex {vertex} (`{group}`)"),
            _ => format!("vertex {vertex}"),
        }
    }

    /// Whether an application gets through the file, be there groups of which some faces alone have
    /// texture coordinates.
    pub fn is_sound(&self) -> bool {
        let facts = &self.facts;
        let stops = facts.unreadable_lines > 0
            || facts.face_out_of_range.count > 0
            || !facts.short_faces.is_empty();
        !stops && facts.vertices > 0
    }
}

/// Groups with faces that are kept. Assets have a few.
const MOST_GROUPS: usize = 256;

fn ranges(mesh: &Mesh) -> Vec<(Box<str>, (u32, u32))> {
    let used = mesh
        .groups
        .iter()
        .filter_map(|group| Some((group.name.as_str().into(), group.vertices?)));
    let used: Vec<_> = used.take(MOST_GROUPS + 1).collect();
    if (2..=MOST_GROUPS).contains(&used.len()) {
        used
    } else {
        Vec::new()
    }
}

/// Faces follow one another in [`Mesh::corners`].
fn face_starts(mesh: &Mesh) -> Box<[u32]> {
    let end = u32::try_from(mesh.corners.len()).unwrap_or(u32::MAX);
    mesh.faces
        .iter()
        .map(|face| face.start)
        .chain([end])
        .collect()
}

/// How many faces each vertex has.
fn faces_of_vertices(mesh: &Mesh) -> Vec<u32> {
    let mut faces = vec![0_u32; mesh.positions.len()];
    for vertex in mesh.faces.iter().flat_map(|face| face.of(&mesh.corners)) {
        if let Some(count) = faces.get_mut(*vertex as usize) {
            *count = count.saturating_add(1);
        }
    }
    faces
}

/// The first of the vertices with the highest count, and that.
fn most(counts: &[u32]) -> Option<(u32, u32)> {
    let most = counts.iter().copied().max().filter(|most| *most > 0)?;
    let vertex = counts.iter().position(|count| *count == most)?;
    Some((u32::try_from(vertex).ok()?, most))
}

/// Vertices with fewer faces have hardly more neighbours.
const MANY_FACES: u32 = 5;

/// The first of the vertices with most neighbours, and how many.
fn neighbours(mesh: &Mesh, faces: &[u32]) -> Option<(u32, u32)> {
    let has_many = |vertex: u32| {
        faces
            .get(vertex as usize)
            .is_some_and(|count| *count >= MANY_FACES)
    };
    let mut pairs: Vec<(u32, u32)> = Vec::new();
    for face in &mesh.faces {
        let corners = face.of(&mesh.corners);
        for (one, other) in corners.iter().zip(corners.iter().cycle().skip(1)) {
            pairs.extend(
                [(*one, *other), (*other, *one)]
                    .into_iter()
                    .filter(|(one, other)| has_many(*one) && one != other),
            );
        }
    }
    pairs.sort_unstable();
    pairs.dedup();
    let runs = pairs
        .chunk_by(|one, other| one.0 == other.0)
        .filter_map(|run| Some((run.first()?.0, run.len())));
    let (vertex, count) = runs.rev().max_by_key(|(_, count)| *count)?;
    Some((vertex, u32::try_from(count).ok()?))
}

fn repeated(mesh: &Mesh) -> usize {
    let mut prints: Vec<u64> = mesh
        .faces
        .iter()
        .map(|face| print_of_set(face.of(&mesh.corners)))
        .collect();
    let all = prints.len();
    prints.sort_unstable();
    prints.dedup();
    all - prints.len()
}

/// Of corners in whatever order.
fn print_of_set(corners: &[u32]) -> u64 {
    let mut sorted = corners.to_vec();
    sorted.sort_unstable();
    let bytes: Vec<u8> = sorted
        .iter()
        .flat_map(|corner| corner.to_le_bytes())
        .collect();
    xxh3_64(&bytes)
}

impl MeshPrint {
    /// The print of a mesh.
    pub fn of(mesh: &Mesh) -> Self {
        let corners = mesh
            .faces
            .iter()
            .map(|face| print_of(mesh, *face))
            .fold(0, u64::wrapping_add);
        Self {
            vertices: mesh.positions.len(),
            faces: mesh.faces.len(),
            corners,
        }
    }

    /// Whether another mesh has other corners.
    pub fn has_other_corners(&self, other: &Self) -> bool {
        self.corners != other.corners
    }
}

/// The print of the vertices of a face.
fn print_of(mesh: &Mesh, face: Face) -> u64 {
    xxh3_64(
        &face
            .of(&mesh.corners)
            .iter()
            .flat_map(|corner| corner.to_le_bytes())
            .collect::<Vec<u8>>(),
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::obj;

    fn of(text: &str) -> AssetMesh {
        AssetMesh::of(obj::parse(text.as_bytes()))
    }

    const FACES: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\n";

    #[test]
    fn prints_differ_with_faces_and_not_with_their_order_or_places() {
        let mesh = of(&format!("{FACES}f 1/1 2/2 3/3\nf 1/1 3/3 4/2\n"));
        let turned = of(&format!(
            "{}f 1/1 3/3 4/2\nf 1/1 2/2 3/3\n",
            FACES.replace("v 1 0 0", "v 9 0 nan")
        ));
        assert_eq!(mesh.print, turned.print);
        let other = of(&format!("{FACES}f 1/1 2/2 3/3\nf 1/1 3/3 4/1\n"));
        assert!(!mesh.print.has_other_corners(&other.print));
        assert!(
            mesh.print
                .has_other_corners(&of(&format!("{FACES}f 1/1 2/2 3/3\nf 1/1 2/2 4/1\n")).print)
        );
    }

    #[test]
    fn poles_and_repeated_faces_are_counted() {
        let mesh = of(&format!("{FACES}f 1 2 3\nf 1 3 4\nf 3 2 1\nf 1 4 2\n"));
        assert_eq!(
            (mesh.pole, mesh.repeated, mesh.neighbours),
            (Some((0, 4)), 1, None)
        );
        let fan = of(
            "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 3 0 0\nv 4 0 0\nv 5 0 0\nv 6 0 0\nf 1 2 3\nf 1 3 4\nf 1 \
                4 5\nf 1 5 6\nf 1 6 7\n",
        );
        assert_eq!((fan.pole, fan.neighbours), (Some((0, 5)), Some((0, 6))));
        assert_eq!((of(FACES).pole, of(FACES).repeated), (None, 0));
        let named = of(&format!("{FACES}g\no\ng a\nf 1 2 3 4 1\n"));
        assert_eq!(
            (named.facts.nameless.count, named.facts.ngons.count),
            (2, 1)
        );
    }

    #[test]
    fn a_vertex_is_named_with_its_group_where_there_are_several() {
        let one = of(&format!("{FACES}g only\nf 1 2 3\n"));
        assert_eq!((one.groups.len(), one.named(1)), (0, "vertex 1".to_owned()));
        let two = of(&format!("{FACES}g a\nf 1 2 3\ng b\nf 3 4 1\n"));
        let three = of(
            "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 2 0 0\nv 3 0 0\nv 3 1 0\ng a\nf 1 2 3\ng b\nf 4 5 6\n",
        );
        assert_eq!(
            (two.named(1_u64), three.named(4_u64)),
            ("vertex 1".to_owned(), "vertex 4 (`b`)".to_owned())
        );
        assert_eq!(three.named(99_i64), "vertex 99");
    }

    #[test]
    fn what_the_loader_stops_at_is_not_sound() {
        for (faces, is_sound) in [
            ("f 1 2 3\n", true),
            ("f 1/1 2/2 3/3\nf 1 2 3\n", true),
            ("f 1 2\n", false),
            ("f 1 2 9\n", false),
            ("f 1 2 -1\n", false),
            ("f 1 2 3%\n", false),
            ("f 1/nan 2 3\n", false),
            ("vt 0,5 1\nf 1 2 3\n", false),
            ("vt nan 1\nf 1 2 3 4\n", true),
            ("f 1 2 3 \\\n 4\n", false),
        ] {
            assert_eq!(
                of(&format!("{FACES}{faces}")).is_sound(),
                is_sound,
                "{faces}"
            );
        }
        assert!(!of("<html>\n").is_sound());
    }

    #[test]
    fn a_mesh_of_a_million_lines_is_counted() {
        let text = "v 1 2 3\nf 1 2 99999999\nf 1\n".repeat(330_000);
        let mesh = of(&text);
        assert_eq!(
            (mesh.facts.vertices, mesh.facts.face_out_of_range.count),
            (330_000, 330_000)
        );
        assert!(mesh.facts.short_faces.len() < 2);
    }
}
