//! Wavefront OBJ as MakeHuman 2 reads it (`docs/loaders/makehuman2/base-mesh.md#obj-commands`).
//!
//! Knows `v`, `vt`, `f`, `g`, `o`; everything else is ignored. A new group name opens a group, a
//! name that was open before does not switch back: the faces stay in the group opened last.
//! Vertices used with a second texture coordinate are duplicated behind the real ones ("seam").

mod facts;
pub mod text;

use std::collections::BTreeMap;
use std::sync::Arc;

use crate::faulty_rows::row_name;
use crate::fields::fields;
pub use crate::obj::facts::{BadLine, Bounds, MeshFacts, Reopened, Repeating, ShortFace, joined};
use crate::target::MeshSize;
use crate::{python_float, python_int, stored};
use mhlint_source::lines;

/// The group of faces before any `g`.
pub const DEFAULT_GROUP: &str = "mh_default";
/// Stands for a corner without texture coordinate.
pub const NO_UV: u32 = u32::MAX;

/// A mesh.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Mesh {
    /// Vertex positions in file order, decimetres.
    pub positions: Vec<[f32; 3]>,
    /// Texture coordinates in file order.
    pub uvs: Vec<[f32; 2]>,
    /// Vertex indices of all faces, one after the other, from 0.
    pub corners: Vec<u32>,
    /// The texture coordinate of each corner, [`NO_UV`] for none.
    pub corner_uvs: Vec<u32>,
    /// Faces.
    pub faces: Vec<Face>,
    /// Groups in order of their opening, the default group first if it has faces.
    pub groups: Vec<Group>,
    /// What was counted on the way.
    pub facts: MeshFacts,
}

impl Mesh {
    /// The vertices of each face.
    pub fn vertices_of_faces(&self) -> impl Iterator<Item = &[u32]> + Clone {
        self.faces.iter().map(|face| face.of(&self.corners))
    }
}

/// A face: a run of [`Mesh::corners`].
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Face {
    /// First corner.
    pub start: u32,
    /// Number of corners.
    pub len: u32,
    /// Index into [`Mesh::groups`] of the group the application puts it into.
    pub group: u32,
}

impl Face {
    /// Its part of a list with an entry for each corner, such as [`Mesh::corners`].
    pub fn of(self, values: &[u32]) -> &[u32] {
        let start = self.start as usize;
        values
            .get(start..start.saturating_add(self.len as usize))
            .unwrap_or_default()
    }
}

/// A face group.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Group {
    /// Name (the first word behind `g`).
    pub name: String,
    /// Line it was opened on, 0 for the default group.
    pub line: u32,
    /// Faces the application puts into it.
    pub faces: usize,
    /// First and last vertex of these faces.
    pub vertices: Option<(u32, u32)>,
}

const BAD_LINES_KEPT: usize = 5;
const LONGEST_TEXT: usize = 60;

/// Parses a mesh.
pub fn parse(text: &[u8]) -> Mesh {
    let mut parser = Parser::default();
    // The default group is open from the start.
    parser.known.insert(DEFAULT_GROUP.to_owned(), None);
    for (_, line) in lines(text) {
        parser.line += 1;
        parser.line(line);
    }
    parser.finish()
}

impl Mesh {
    /// Whether the application gets through the file. Nothing can be measured against a mesh it
    /// stops at.
    pub fn is_sound(&self) -> bool {
        let facts = &self.facts;
        facts.unreadable_lines == 0
            && facts.face_out_of_range.count == 0
            && facts.vertices > 0
            && !self.faces.is_empty()
    }

    /// Makes a face of the corners from `start` on.
    pub(super) fn push_face(&mut self, start: usize, group: u32) {
        let corners = self.corners.get(start..).unwrap_or_default();
        if let Some(group) = self.groups.get_mut(group as usize) {
            group.faces += 1;
            group.vertices = widened(group.vertices, corners);
        }
        let bounded = |value: usize| u32::try_from(value).unwrap_or(u32::MAX);
        self.faces.push(Face {
            start: bounded(start),
            len: bounded(corners.len()),
            group,
        });
    }

    /// How many vertices there are to be moved.
    pub fn size(&self) -> MeshSize {
        let vertices = self.facts.vertices;
        MeshSize {
            vertices,
            with_seams: vertices + self.facts.seam_duplicates,
        }
    }
}

#[derive(Default)]
struct Parser {
    mesh: Mesh,
    line: u32,
    /// Names that were open, with their place in [`MeshFacts::reopened`].
    known: BTreeMap<String, Option<usize>>,
    current: Option<u32>,
    /// Its name, which all groups that are opened again after it share.
    current_name: Option<Arc<str>>,
    /// Name of the last `g`, and its place in [`MeshFacts::reopened`] with 1 if faces now stray.
    named: String,
    reopened: Option<(usize, usize)>,
    /// Line of every face, needed once all vertices are known.
    lines: Vec<u32>,
}

impl Mesh {
    /// Name of the group that a vertex counts for. For findings: walks all faces.
    pub fn group_of(&self, vertex: u32) -> Option<&str> {
        let home = self.homes().get(vertex as usize).copied().flatten()?;
        self.groups
            .get(home as usize)
            .map(|group| group.name.as_str())
    }

    /// For each vertex the number of the group that it counts for, the first that uses it. Walks
    /// all faces.
    pub fn homes(&self) -> Vec<Option<u32>> {
        let mut homes = vec![None; self.positions.len()];
        for face in self
            .faces
            .iter()
            .filter(|face| (face.group as usize) < self.groups.len())
        {
            for vertex in face.of(&self.corners) {
                if let Some(home) = homes.get_mut(*vertex as usize) {
                    home.get_or_insert(face.group);
                }
            }
        }
        homes
    }
}

impl Parser {
    fn line(&mut self, line: &[u8]) {
        let fields = fields(line);
        // The loader skips a keyword without a value before it looks at it.
        let Some(((_, keyword), rest)) = fields.split_first() else {
            return;
        };
        if rest.is_empty() {
            // Only MakeHuman 1 looks for the name before it asks whether there is one.
            if matches!(*keyword, b"g" | b"o") {
                self.mesh.facts.nameless.add(self.line, 0);
            }
            return;
        }
        let mut words = rest.iter().map(|(_, word)| *word);
        match *keyword {
            b"v" => self.vertex(line, words),
            b"vt" => self.uv(line, words),
            b"f" => self.face(line, words),
            b"g" => self.group(words.next().unwrap_or_default()),
            b"o" => {
                let name = words
                    .next()
                    .map(|name| String::from_utf8_lossy(name).into());
                self.mesh.facts.object = name.map(|name| (name, self.line));
            }
            _ => {}
        }
    }

    fn vertex<'a>(&mut self, line: &[u8], words: impl Iterator<Item = &'a [u8]>) {
        let Some([x, y, z]) = floats::<3>(words) else {
            let name = |mesh: &Mesh| format!("v {}", mesh.positions.len());
            self.bad(line, "a vertex needs three numbers", name);
            // The vertex keeps its number, or every later face would be checked wrongly.
            self.mesh.positions.push([0.0; 3]);
            return;
        };
        if ![x, y, z].iter().all(|part| part.is_finite()) {
            let index = i64::try_from(self.mesh.positions.len()).unwrap_or(i64::MAX);
            self.mesh.facts.non_finite.add(self.line, index);
        }
        self.mesh.positions.push([x, y, z]);
    }

    fn uv<'a>(&mut self, line: &[u8], words: impl Iterator<Item = &'a [u8]>) {
        let uv = floats::<2>(words);
        if uv.is_none() {
            let name = |mesh: &Mesh| format!("vt {}", mesh.uvs.len());
            self.bad(line, "a texture coordinate needs two numbers", name);
        }
        if uv.is_some_and(|uv| uv.iter().any(|part| !part.is_finite())) {
            let index = i64::try_from(self.mesh.uvs.len()).unwrap_or(i64::MAX);
            self.mesh.facts.non_finite_uvs.add(self.line, index);
        }
        self.mesh.uvs.push(uv.unwrap_or_default());
    }

    fn group(&mut self, name: &[u8]) {
        let name = String::from_utf8_lossy(name).into_owned();
        if name == self.named {
            return;
        }
        self.reopened = None;
        self.named.clone_from(&name);
        let Some(known) = self.known.get_mut(&name) else {
            self.open(name, self.line);
            return;
        };
        let lands_in = self
            .current_name
            .get_or_insert_with(|| Arc::from(DEFAULT_GROUP));
        let at = self.mesh.facts.reopen(*known, &name, self.line, lands_in);
        *known = Some(at);
        self.reopened = Some((at, usize::from(**lands_in != *name)));
    }

    fn open(&mut self, name: String, line: u32) -> u32 {
        let index = u32::try_from(self.mesh.groups.len()).unwrap_or(u32::MAX);
        self.known.insert(name.clone(), None);
        self.current_name = Some(Arc::from(name.as_str()));
        self.mesh.groups.push(Group {
            name,
            line,
            faces: 0,
            vertices: None,
        });
        self.current = Some(index);
        index
    }

    fn face<'a>(&mut self, line: &[u8], words: impl Iterator<Item = &'a [u8]>) {
        let start = self.mesh.corners.len();
        let fault = words.map(|word| self.corner(word)).find_map(Result::err);
        let len = self.mesh.corners.len() - start;
        if fault.is_none() && len >= 3 {
            self.add_face(start);
            return;
        }
        self.mesh.corners.truncate(start);
        self.mesh.corner_uvs.truncate(start);
        let name = |_: &Mesh| row_name(&fields(line));
        match fault {
            Some(BadCorner::Number(number)) => {
                self.mesh.facts.face_out_of_range.add(self.line, number);
            }
            Some(BadCorner::Text) => {
                self.bad(
                    line,
                    "a face corner is `vertex`, `vertex/uv` or `vertex/uv/normal` in whole numbers",
                    name,
                );
            }
            None => self.short_face(line),
        }
    }

    /// Only faces that are drawn need three corners.
    fn short_face(&mut self, line: &[u8]) {
        let group = self
            .current
            .and_then(|group| self.mesh.groups.get(group as usize));
        let group = group.map_or(DEFAULT_GROUP, |group| group.name.as_str());
        let faces = &mut self.mesh.facts.short_faces;
        // One of each run of a group is enough to tell.
        if faces.last().is_none_or(|last| last.group != group) {
            faces.push(ShortFace {
                line: self.line,
                text: shortened(line),
                group: group.to_owned(),
            });
        }
    }

    fn corner(&mut self, word: &[u8]) -> Result<(), BadCorner> {
        let (vertex, uv) = corner(word)?;
        self.mesh.corners.push(vertex);
        self.mesh.corner_uvs.push(uv);
        Ok(())
    }

    fn add_face(&mut self, start: usize) {
        let group = match self.current {
            Some(group) => group,
            None => self.open(DEFAULT_GROUP.to_owned(), 0),
        };
        if let Some((at, strays)) = self.reopened
            && let Some(reopened) = self.mesh.facts.reopened.get_mut(at)
        {
            reopened.faces += 1;
            reopened.strayed += strays;
        }
        self.lines.push(self.line);
        self.mesh.push_face(start, group);
    }

    fn bad(&mut self, line: &[u8], what: &'static str, name: impl FnOnce(&Mesh) -> String) {
        let mut names = std::mem::take(&mut self.mesh.facts.unreadable_names);
        names.add(|| name(&self.mesh));
        self.mesh.facts.unreadable_names = names;
        let facts = &mut self.mesh.facts;
        facts.unreadable_lines += 1;
        if facts.unreadable.len() < BAD_LINES_KEPT {
            facts.unreadable.push(BadLine {
                line: self.line,
                text: shortened(line),
                what,
            });
        }
    }

    fn finish(mut self) -> Mesh {
        let mut facts = std::mem::take(&mut self.mesh.facts);
        facts.complete(&self.mesh, &self.lines);
        self.mesh.facts = facts;
        self.mesh
    }
}

fn shortened(line: &[u8]) -> String {
    String::from_utf8_lossy(line)
        .chars()
        .take(LONGEST_TEXT)
        .collect()
}

fn widened(range: Option<(u32, u32)>, corners: &[u32]) -> Option<(u32, u32)> {
    corners.iter().fold(range, |range, vertex| {
        Some(range.map_or((*vertex, *vertex), |(first, last)| {
            (first.min(*vertex), last.max(*vertex))
        }))
    })
}

fn floats<'a, const N: usize>(words: impl Iterator<Item = &'a [u8]>) -> Option<[f32; N]> {
    let mut values = [0.0; N];
    let mut filled = 0;
    for (slot, word) in values.iter_mut().zip(words) {
        *slot = stored(python_float(word)?);
        filled += 1;
    }
    (filled == N).then_some(values)
}

/// Why a corner cannot be used.
enum BadCorner {
    /// No whole number.
    Text,
    /// A number below 1: vertices are counted from 1, and never backwards.
    Number(i64),
}

/// `v`, `v/t`, `v//n`, `v/t/n`: vertex and texture coordinate from 0, [`NO_UV`] for no texture
/// coordinate.
fn corner(word: &[u8]) -> Result<(u32, u32), BadCorner> {
    let mut parts = word.split(|byte| *byte == b'/');
    let vertex = one_based(parts.next().unwrap_or_default())?;
    let uv = match parts.next() {
        None | Some(b"") => NO_UV,
        Some(part) => one_based(part)?,
    };
    Ok((vertex, uv))
}

fn one_based(text: &[u8]) -> Result<u32, BadCorner> {
    let number = python_int(text).ok_or(BadCorner::Text)?;
    let index = number
        .checked_sub(1)
        .and_then(|index| u32::try_from(index).ok());
    index
        .filter(|index| *index != NO_UV)
        .ok_or(BadCorner::Number(number))
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    const SQUARE: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

    #[test]
    fn faces_of_a_reopened_group_stay_in_the_last_one() {
        let text = format!(
            "{SQUARE}g body\nf 1 2 3\ng helper\nf 1 2 4\ng body\nf 2 3 4\nf 1 3 4\ng body\nf 1 2 \
                3\n"
        );
        let mesh = parse(text.as_bytes());
        let groups: Vec<_> = mesh
            .groups
            .iter()
            .map(|g| (g.name.as_str(), g.faces))
            .collect();
        assert_eq!(groups, [("body", 1), ("helper", 4)]);
        let [reopened] = mesh.facts.reopened.as_slice() else {
            panic!("one group")
        };
        assert_eq!(
            (reopened.name.as_str(), reopened.faces, reopened.line),
            ("body", 3, 9)
        );
        assert_eq!(
            (reopened.strayed, reopened.lands_in.as_slice()),
            (3, [Arc::from("helper")].as_slice())
        );
    }

    #[test]
    fn the_group_that_faces_land_in_is_named_once() {
        let all = |faces: &str| {
            (0..100)
                .map(|group| format!("g g{group}\n{faces}"))
                .collect::<Vec<_>>()
                .concat()
        };
        let text = format!(
            "{SQUARE}{}g {}\nf 1 2 3\n{}",
            all(""),
            "L".repeat(1000),
            all("f 1 2 3\n")
        );
        let reopened = parse(text.as_bytes()).facts.reopened;
        assert_eq!(reopened.len(), 100);
        assert!(
            reopened
                .iter()
                .all(|one| Arc::ptr_eq(&one.lands_in[0], &reopened[0].lands_in[0]))
        );
    }

    #[test]
    fn a_group_opened_again_may_still_be_the_current_one() {
        let text = format!("{SQUARE}g a\nf 1 2 3\ng b\nf 1 2 3\ng a\nf 1 2 3\ng b\nf 1 2 3\n");
        let facts = parse(text.as_bytes()).facts;
        let reopened: Vec<_> = facts
            .reopened
            .iter()
            .map(|r| (r.name.as_str(), r.faces, r.strayed))
            .collect();
        assert_eq!(reopened, [("a", 1, 1), ("b", 1, 0)]);
    }

    #[test]
    fn a_group_opened_twice_in_a_row_or_without_faces_is_no_matter() {
        let text = format!(
            "{SQUARE}g body\nf 1 2 3\ng body\nf 1 2 4\ng joint\ng body\ng helper\nf 2 3 4\n"
        );
        assert!(parse(text.as_bytes()).facts.reopened.is_empty());
    }

    #[test]
    fn faces_before_any_group_have_the_default_one() {
        let mesh = parse(
            format!("{SQUARE}f 1 2 3 4\ng body\nf 1 2 3\ng mh_default\nf 1 2 3\n").as_bytes(),
        );
        assert_eq!(mesh.groups[0].name, DEFAULT_GROUP);
        assert_eq!(mesh.facts.reopened[0].lands_in, [Arc::from("body")]);
    }

    #[test]
    fn bad_lines_and_ranges_are_counted() {
        let text = format!(
            "{SQUARE}v 1 2\nv nan 0 0\nf 1 2\nf -1 2 3\nf 1 2 9\nf 1/1 2/1 3/1\nf 1 2 x\nf\nv\ng\n"
        );
        let facts = parse(text.as_bytes()).facts;
        assert_eq!((facts.unreadable_lines, facts.vertices), (2, 6));
        let short = ShortFace {
            line: 7,
            text: "f 1 2".to_owned(),
            group: DEFAULT_GROUP.to_owned(),
        };
        assert_eq!(facts.short_faces, [short]);
        assert_eq!(facts.face_out_of_range.first, [(8, -1), (9, 9), (10, 1)]);
        assert_eq!(facts.non_finite.first, [(6, 5)]);
        assert_eq!(facts.unused.first, [(0, 3), (0, 4), (0, 5)]);
    }

    #[test]
    fn second_uvs_of_a_vertex_make_seam_duplicates() {
        let text = format!(
            "{SQUARE}vt 0 0\nvt 0.0005 0\nvt 0.5 0\nvt 0.5 0\nf 1/1 2/1 3/1\nf 1/2 3/3 4/1\nf 1/1 \
                3/4 4/1\n"
        );
        assert_eq!(parse(text.as_bytes()).facts.seam_duplicates, 2);
    }

    #[test]
    fn groups_that_mix_faces_with_and_without_uvs_are_named() {
        let text =
            format!("{SQUARE}vt 0 0\ng a\nf 1/1 2/1 3/1\nf 1 2 3\nf 1/1 2 3\ng b\nf 1 2 3\n");
        let facts = parse(text.as_bytes()).facts;
        let [partial] = facts.partial_uv.as_slice() else {
            panic!("one group")
        };
        assert_eq!(
            (
                partial.name.as_str(),
                partial.faces,
                partial.without,
                partial.line
            ),
            ("a", 3, 2, 8)
        );
    }

    proptest! {
        #[test]
        fn any_bytes_give_a_mesh(bytes in proptest::collection::vec(any::<u8>(), 0..300)) {
            let mesh = parse(&bytes);
            prop_assert_eq!(mesh.facts.vertices, mesh.positions.len());
        }

        #[test]
        fn hostile_faces_stay_inside_the_text(
            words in proptest::collection::vec("(v|vt|f|g|o|s)( \
                (-?[0-9]{1,20}|nan|[0-9]/[0-9]|//|x)){0,5}", 0..20),
        ) {
            let text = words.join("\n");
            let mesh = parse(text.as_bytes());
            prop_assert!(mesh.corners.len() <= text.len());
            prop_assert_eq!(mesh.groups.iter().map(|group| group.faces).sum::<usize>(), mesh.faces.len());
        }

        #[test]
        fn a_truncated_mesh_has_no_more_elements(cut in 0usize..120) {
            let text = format!("{SQUARE}vt 0 0\nvt 1 0\nvt 1 1\ng body\nf 1/1 2/2 3/3\nf 1/1 3/3 \
                4/1\ng helper\nf 4/1 2/2 1/1\n");
            let whole = parse(text.as_bytes());
            let part = parse(&text.as_bytes()[..cut.min(text.len())]);
            prop_assert!(part.positions.len() <= whole.positions.len() && part.faces.len() <= whole.faces.len());
        }
    }
}
