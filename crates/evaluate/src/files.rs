//! Single files that are named by path: bytes, JSON trees, and OBJ text with other coordinates.

use std::path::Path;

use super::error::Error;
use mhlint_eval::scene::Scene;
use mhlint_eval::vector::Point;
use mhlint_formats::json_file::{self, JsonFault};
use mhlint_formats::obj::{self, Mesh};
use mhlint_json::{Document, SyntaxFault};
/// A path as messages print it.
pub(super) use mhlint_source::slashed as shown;
use mhlint_source::{Encoding, Limits, Lines, ReadFault, read_file};

/// The bytes of a file.
///
/// # Errors
/// A file that cannot be read, with its path.
pub fn read_text(path: &Path) -> Result<Vec<u8>, Error> {
    read_file(path, &Limits::default())
        .map_err(|fault| Error::file(shown(path), read_cause(&fault)))
}

/// Vertex positions of an OBJ file, decimetres.
///
/// # Errors
/// A file that cannot be read, with its path.
pub fn read_positions(path: &Path) -> Result<Vec<Point>, Error> {
    Ok(obj::parse(&read_text(path)?).positions)
}

/// A JSON file as a tree.
pub(super) fn read_document(path: &Path) -> Result<Document, Error> {
    let bytes = read_text(path)?;
    document(&bytes).map_err(|reason| Error::file(shown(path), reason))
}

/// A JSON text as a tree, or what is wrong with it.
pub(super) fn document(bytes: &[u8]) -> Result<Document, String> {
    json_file::parse(bytes, &Encoding::of(bytes)).map_err(|fault| json_cause(&fault, bytes))
}

/// Why bytes could not be had, in words.
pub(super) fn read_cause(fault: &ReadFault) -> String {
    match fault {
        ReadFault::Unreadable(reason) => reason.clone(),
        ReadFault::TooLarge { size, limit } => {
            format!("it has {size} bytes, more than the limit of {limit}")
        }
    }
}

/// Why a text is no JSON, in words.
pub(super) fn json_cause(fault: &JsonFault, bytes: &[u8]) -> String {
    match fault {
        JsonFault::Empty => "it is empty".to_owned(),
        JsonFault::ByteOrderMark => {
            "it begins with a byte order mark, which Python rejects".to_owned()
        }
        JsonFault::NotUtf8 => "it is not UTF-8".to_owned(),
        JsonFault::LfsPointer => {
            "it is a Git LFS pointer; fetch the file with `git lfs pull`".to_owned()
        }
        JsonFault::Syntax(fault) => syntax_cause(fault, bytes),
    }
}

fn syntax_cause(fault: &SyntaxFault, bytes: &[u8]) -> String {
    let line = Lines::of(bytes).position(fault.span.start).line;
    format!("not valid JSON, line {line}: {fault}")
}

/// Puts vertices, faces and groups of a mesh into a scene. Faces at vertices that it lacks are left
/// out.
pub(super) fn take_mesh(scene: &mut Scene, mesh: &Mesh, is_visible: impl Fn(&str) -> bool) {
    scene.positions.clone_from(&mesh.positions);
    let vertices = mesh.positions.len();
    for group in &mesh.groups {
        scene.groups.push(group.name.clone());
        scene.visible.push(is_visible(&group.name));
    }
    let start = |scene: &Scene| u32::try_from(scene.corners.len()).unwrap_or(u32::MAX);
    for face in &mesh.faces {
        let corners = face.of(&mesh.corners);
        if corners.iter().all(|corner| (*corner as usize) < vertices) {
            scene.face_starts.push(start(scene));
            scene.corners.extend_from_slice(corners);
            scene.face_groups.push(face.group);
        }
    }
    scene.face_starts.push(start(scene));
}

/// An OBJ text whose `v` lines hold other positions, one each; every other line is kept as it is.
///
/// Numbers are written with the digits that give the same float32 back.
pub fn with_positions(obj: &[u8], positions: &[Point]) -> Vec<u8> {
    let mut out = Vec::with_capacity(obj.len());
    let mut next = positions.iter();
    for line in obj.split_inclusive(|byte| *byte == b'\n') {
        let is_vertex = line
            .trim_ascii_start()
            .strip_prefix(b"v")
            .is_some_and(|rest| rest.starts_with(b" ") || rest.starts_with(b"\t"));
        match if is_vertex { next.next() } else { None } {
            Some([x, y, z]) => out.extend_from_slice(format!("v {x} {y} {z}\n").as_bytes()),
            None => out.extend_from_slice(line),
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_vertex_lines_change() {
        let obj = b"# x\nv 1 2 3\r\nvt 0 0\ng a\n v\t4 5 6\nf 1/1 2/1";
        let out = with_positions(obj, &[[0.5, -1.0, 0.1], [7.0, 8.0, 9.0]]);
        assert_eq!(
            String::from_utf8(out).unwrap(),
            "# x\nv 0.5 -1 0.1\nvt 0 0\ng a\nv 7 8 9\nf 1/1 2/1"
        );
    }
}
