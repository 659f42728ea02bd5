//! Wavefront OBJ as MakeHuman 2 reads it (formats/makehuman2.md §8).
//!
//! Knows `v`, `vt`, `f`, `g`, `o`; everything else is ignored. A new group name opens a group, a name
//! that was open before does not switch back: the faces stay in the group opened last. Vertices used
//! with a second texture coordinate are duplicated behind the real ones ("seam").

use std::collections::BTreeMap;

use serde::Serialize;

use super::fields::fields;
use super::{python_float, python_int};
use crate::diag::Tally;

/// Two texture coordinates of one vertex farther apart than this make a duplicate.
const SEAM_DISTANCE: f32 = 0.001;
/// The group of faces before any `g`.
pub const DEFAULT_GROUP: &str = "mh_default";

/// A mesh.
#[derive(Debug, Clone, Default)]
pub struct Mesh {
    /// Vertex positions in file order, decimetres.
    pub positions: Vec<[f32; 3]>,
    /// Texture coordinates in file order.
    pub uvs: Vec<[f32; 2]>,
    /// Vertex indices of all faces, one after the other, from 0.
    pub corners: Vec<u32>,
    /// Faces.
    pub faces: Vec<Face>,
    /// Groups in order of their opening.
    pub groups: Vec<Group>,
    /// What was counted on the way.
    pub facts: MeshFacts,
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

/// A face group.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
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

/// Facts on a mesh file.
#[derive(Debug, Clone, Default, PartialEq, Serialize)]
pub struct MeshFacts {
    /// Vertices of the file.
    pub vertices: usize,
    /// Duplicates that loading adds along texture seams.
    pub seam_duplicates: usize,
    /// Names that were opened again.
    pub reopened: Vec<Reopened>,
    /// Lines the loader stops at: line, byte range of the field, what is wrong.
    pub unreadable: Vec<BadLine>,
    /// How many such lines.
    pub unreadable_lines: u64,
    /// Faces with a vertex or texture coordinate that does not exist (line, number as written).
    pub face_out_of_range: Tally,
    /// Vertices with NaN or infinity (line, vertex).
    pub non_finite: Tally,
    /// Vertices no face uses.
    pub unused: Tally,
    /// Groups that mix faces with and without texture coordinates.
    pub partial_uv: Vec<String>,
}

/// A group name that was opened a second time.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Reopened {
    /// The name.
    pub name: String,
    /// Line of the second opening.
    pub line: u32,
    /// Group the following faces end up in.
    pub lands_in: String,
    /// How many faces end up there.
    pub faces: usize,
}

/// A line the loader cannot read.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct BadLine {
    /// Line from 1.
    pub line: u32,
    /// The line, shortened.
    pub text: String,
    /// What is wrong with it.
    pub what: &'static str,
}

const BAD_LINES_KEPT: usize = 5;
const LONGEST_TEXT: usize = 60;

/// Parses a mesh.
pub fn parse(text: &[u8]) -> Mesh {
    let mut parser = Parser::default();
    let mut rest = text;
    while !rest.is_empty() {
        let end = rest.iter().position(|byte| matches!(byte, b'\n' | b'\r')).unwrap_or(rest.len());
        let (line, tail) = rest.split_at(end);
        parser.line += 1;
        parser.line(line);
        rest = tail.strip_prefix(b"\r\n").or_else(|| tail.get(1..)).unwrap_or_default();
    }
    parser.finish()
}

#[derive(Default)]
struct Parser {
    mesh: Mesh,
    line: u32,
    by_name: BTreeMap<String, u32>,
    current: Option<u32>,
    reopened: Option<usize>,
    /// Texture coordinate of every corner, `u32::MAX` for none.
    corner_uvs: Vec<u32>,
    face_lines: Vec<u32>,
}

impl Parser {
    fn line(&mut self, line: &[u8]) {
        let fields = fields(line);
        let mut words = fields.iter().map(|(_, word)| *word);
        match words.next() {
            Some(b"v") => self.vertex(line, words),
            Some(b"vt") => self.uv(line, words),
            Some(b"f") => self.face(line, words),
            Some(b"g") => self.group(line, words.next()),
            _ => {}
        }
    }

    fn vertex<'a>(&mut self, line: &[u8], words: impl Iterator<Item = &'a [u8]>) {
        let Some([x, y, z]) = floats::<3>(words) else {
            self.bad(line, "a vertex needs three numbers");
            // The vertex keeps its number, or every later face would be judged wrongly.
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
            self.bad(line, "a texture coordinate needs two numbers");
        }
        self.mesh.uvs.push(uv.unwrap_or_default());
    }

    fn group(&mut self, line: &[u8], name: Option<&[u8]>) {
        let Some(name) = name else {
            self.bad(line, "a group needs a name");
            return;
        };
        let name = String::from_utf8_lossy(name).into_owned();
        if self.by_name.contains_key(&name) {
            let lands_in = self.current.and_then(|group| self.mesh.groups.get(group as usize));
            let lands_in = lands_in.map_or_else(|| DEFAULT_GROUP.to_owned(), |group| group.name.clone());
            self.reopened = (lands_in != name).then_some(self.mesh.facts.reopened.len());
            if self.reopened.is_some() {
                self.mesh.facts.reopened.push(Reopened { name, line: self.line, lands_in, faces: 0 });
            }
            return;
        }
        self.reopened = None;
        self.open(name, self.line);
    }

    fn open(&mut self, name: String, line: u32) -> u32 {
        let index = u32::try_from(self.mesh.groups.len()).unwrap_or(u32::MAX);
        self.by_name.insert(name.clone(), index);
        self.mesh.groups.push(Group { name, line, faces: 0, vertices: None });
        self.current = Some(index);
        index
    }

    fn face<'a>(&mut self, line: &[u8], words: impl Iterator<Item = &'a [u8]>) {
        let start = self.mesh.corners.len();
        for word in words {
            let Some((vertex, uv)) = corner(word) else {
                self.mesh.corners.truncate(start);
                self.corner_uvs.truncate(start);
                self.bad(line, "a face corner is `vertex`, `vertex/uv` or `vertex/uv/normal`, counted from 1");
                return;
            };
            self.mesh.corners.push(vertex);
            self.corner_uvs.push(uv);
        }
        let len = self.mesh.corners.len() - start;
        if len < 3 {
            self.mesh.corners.truncate(start);
            self.corner_uvs.truncate(start);
            self.bad(line, "a face needs three corners");
            return;
        }
        self.add_face(start, len);
    }

    fn add_face(&mut self, start: usize, len: usize) {
        let group = match self.current {
            Some(group) => group,
            None => self.open(DEFAULT_GROUP.to_owned(), 0),
        };
        if let Some(group) = self.mesh.groups.get_mut(group as usize) {
            group.faces += 1;
        }
        if let Some(reopened) = self.reopened.and_then(|at| self.mesh.facts.reopened.get_mut(at)) {
            reopened.faces += 1;
        }
        let bounded = |value: usize| u32::try_from(value).unwrap_or(u32::MAX);
        self.face_lines.push(self.line);
        self.mesh.faces.push(Face { start: bounded(start), len: bounded(len), group });
    }

    fn bad(&mut self, line: &[u8], what: &'static str) {
        let facts = &mut self.mesh.facts;
        facts.unreadable_lines += 1;
        if facts.unreadable.len() < BAD_LINES_KEPT {
            let text = String::from_utf8_lossy(line);
            facts.unreadable.push(BadLine { line: self.line, text: text.chars().take(LONGEST_TEXT).collect(), what });
        }
    }

    fn finish(mut self) -> Mesh {
        self.mesh.facts.vertices = self.mesh.positions.len();
        self.mesh.facts.reopened.retain(|reopened| reopened.faces > 0);
        self.check_faces();
        self.check_uvs();
        self.count_unused();
        self.mesh.facts.seam_duplicates = self.count_seams();
        self.mesh
    }

    /// Faces may name vertices that come later in the file, so ranges are known only now.
    fn check_faces(&mut self) {
        let vertices = self.mesh.positions.len();
        let uvs = self.mesh.uvs.len();
        for (face, line) in self.mesh.faces.iter().zip(&self.face_lines) {
            let run = face.start as usize..(face.start + face.len) as usize;
            let corners = self.mesh.corners.get(run.clone()).unwrap_or_default();
            let corner_uvs = self.corner_uvs.get(run).unwrap_or_default();
            if let Some(group) = self.mesh.groups.get_mut(face.group as usize) {
                group.vertices = widened(group.vertices, corners);
            }
            let bad_vertex = corners.iter().find(|vertex| **vertex as usize >= vertices);
            let bad_uv = corner_uvs.iter().find(|uv| **uv != u32::MAX && **uv as usize >= uvs);
            if let Some(bad) = bad_vertex.or(bad_uv) {
                self.mesh.facts.face_out_of_range.add(*line, i64::from(*bad) + 1);
            }
        }
    }

    fn check_uvs(&mut self) {
        let mut seen = vec![(false, false); self.mesh.groups.len()];
        for face in &self.mesh.faces {
            let run = face.start as usize..(face.start + face.len) as usize;
            let Some((with, without)) = seen.get_mut(face.group as usize) else { continue };
            for uv in self.corner_uvs.get(run).unwrap_or_default() {
                *(if *uv == u32::MAX { &mut *without } else { &mut *with }) = true;
            }
        }
        let mixed = self.mesh.groups.iter().zip(seen).filter(|(_, seen)| *seen == (true, true));
        self.mesh.facts.partial_uv = mixed.map(|(group, _)| group.name.clone()).collect();
    }

    fn count_unused(&mut self) {
        let mut used = vec![false; self.mesh.positions.len()];
        for vertex in &self.mesh.corners {
            if let Some(used) = used.get_mut(*vertex as usize) {
                *used = true;
            }
        }
        for (index, _) in used.iter().enumerate().filter(|(_, used)| !**used) {
            self.mesh.facts.unused.add(0, i64::try_from(index).unwrap_or(i64::MAX));
        }
    }

    fn count_seams(&self) -> usize {
        let mut first: Vec<u32> = vec![u32::MAX; self.mesh.positions.len()];
        let mut others: BTreeMap<u32, Vec<u32>> = BTreeMap::new();
        let mut duplicates = 0;
        for (vertex, uv) in self.mesh.corners.iter().zip(&self.corner_uvs) {
            let Some(known) = first.get_mut(*vertex as usize) else { continue };
            if *known == u32::MAX {
                *known = *uv;
            } else if *known != *uv && !self.same_uv(*known, *uv) {
                let others = others.entry(*vertex).or_default();
                if !others.iter().any(|other| self.same_uv(*other, *uv)) {
                    others.push(*uv);
                    duplicates += 1;
                }
            }
        }
        duplicates
    }

    fn same_uv(&self, a: u32, b: u32) -> bool {
        match (self.mesh.uvs.get(a as usize), self.mesh.uvs.get(b as usize)) {
            (Some([u, v]), Some([s, t])) => (u - s).abs() <= SEAM_DISTANCE && (v - t).abs() <= SEAM_DISTANCE,
            _ => a == b,
        }
    }
}

fn widened(range: Option<(u32, u32)>, corners: &[u32]) -> Option<(u32, u32)> {
    corners.iter().fold(range, |range, vertex| {
        Some(range.map_or((*vertex, *vertex), |(first, last)| (first.min(*vertex), last.max(*vertex))))
    })
}

fn floats<'a, const N: usize>(words: impl Iterator<Item = &'a [u8]>) -> Option<[f32; N]> {
    let mut values = [0.0; N];
    let mut filled = 0;
    for (slot, word) in values.iter_mut().zip(words) {
        #[expect(clippy::cast_possible_truncation, reason = "stored as float32, as the application does")]
        {
            *slot = python_float(word)? as f32;
        }
        filled += 1;
    }
    (filled == N).then_some(values)
}

/// `v`, `v/t`, `v//n`, `v/t/n`: vertex and texture coordinate from 0, `u32::MAX` for no texture coordinate.
fn corner(word: &[u8]) -> Option<(u32, u32)> {
    let mut parts = word.split(|byte| *byte == b'/');
    let vertex = one_based(parts.next()?)?;
    let uv = match parts.next() {
        None | Some(b"") => u32::MAX,
        Some(part) => one_based(part)?,
    };
    Some((vertex, uv))
}

fn one_based(text: &[u8]) -> Option<u32> {
    let number = python_int(text)?;
    u32::try_from(number.checked_sub(1)?).ok().filter(|index| *index != u32::MAX)
}

#[cfg(test)]
mod tests {
    use super::*;

    const SQUARE: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

    #[test]
    fn faces_of_a_reopened_group_stay_in_the_last_one() {
        let text = format!("{SQUARE}g body\nf 1 2 3\ng helper\nf 1 2 4\ng body\nf 2 3 4\nf 1 3 4\n");
        let mesh = parse(text.as_bytes());
        let groups: Vec<_> = mesh.groups.iter().map(|g| (g.name.as_str(), g.faces)).collect();
        assert_eq!(groups, [("body", 1), ("helper", 3)]);
        let [reopened] = mesh.facts.reopened.as_slice() else { panic!("one group") };
        assert_eq!((reopened.name.as_str(), reopened.faces, reopened.line), ("body", 2, 9));
        assert_eq!(reopened.lands_in, "helper");
    }

    #[test]
    fn faces_before_any_group_have_the_default_one() {
        let mesh = parse(format!("{SQUARE}f 1 2 3 4\n").as_bytes());
        assert_eq!(mesh.groups[0].name, DEFAULT_GROUP);
    }

    #[test]
    fn bad_lines_and_ranges_are_counted() {
        let text = format!("{SQUARE}v 1 2\nv nan 0 0\nf 1 2\nf -1 2 3\nf 1 2 9\nf 1/1 2/1 3/1\n");
        let facts = parse(text.as_bytes()).facts;
        assert_eq!((facts.unreadable_lines, facts.vertices), (3, 6));
        assert_eq!(facts.face_out_of_range.first, [(9, 9), (10, 1)]);
        assert_eq!(facts.non_finite.first, [(6, 5)]);
    }

    #[test]
    fn second_uvs_of_a_vertex_make_seam_duplicates() {
        let text = format!("{SQUARE}vt 0 0\nvt 0.0005 0\nvt 0.5 0\nf 1/1 2/1 3/1\nf 1/2 3/3 4/1\n");
        assert_eq!(parse(text.as_bytes()).facts.seam_duplicates, 1);
    }
}
