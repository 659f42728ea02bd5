//! A mesh as OBJ text, for one that was packed.

use std::fmt::Write;

use crate::obj::{Face, Mesh, NO_UV};

/// The mesh as a text that [`super::parse`] makes the same mesh of. Numbers are written with
/// the digits that give the same float32 back.
pub fn text_of(mesh: &Mesh) -> String {
    let mut text = String::new();
    for [x, y, z] in &mesh.positions {
        add(&mut text, format_args!("v {x} {y} {z}\n"));
    }
    for [u, v] in &mesh.uvs {
        add(&mut text, format_args!("vt {u} {v}\n"));
    }
    let mut open = None;
    for face in &mesh.faces {
        if open != Some(face.group) {
            open = Some(face.group);
            let name = mesh
                .groups
                .get(face.group as usize)
                .map_or("", |group| group.name.as_str());
            add(&mut text, format_args!("g {name}\n"));
        }
        add_face(&mut text, mesh, *face);
    }
    text
}

fn add_face(text: &mut String, mesh: &Mesh, face: Face) {
    text.push('f');
    for (vertex, uv) in face.of(&mesh.corners).iter().zip(face.of(&mesh.corner_uvs)) {
        let vertex = u64::from(*vertex) + 1;
        match *uv {
            NO_UV => add(text, format_args!(" {vertex}")),
            uv => add(text, format_args!(" {vertex}/{}", u64::from(uv) + 1)),
        }
    }
    text.push('\n');
}

fn add(text: &mut String, part: std::fmt::Arguments<'_>) {
    // A `String` takes whatever is written.
    let _ = text.write_fmt(part);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh_difference::MeshDifference;
    use crate::obj;

    #[test]
    fn a_mesh_comes_back_from_its_text() {
        let text = "v 0 0.1 -3\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 0.25 1\nvt 1 1\ng a\nf 1/1 \
            2/2 3/3\ng b\nf 1 3 4 2\n";
        let mesh = obj::parse(text.as_bytes());
        let again = obj::parse(text_of(&mesh).as_bytes());
        assert!(MeshDifference::between(&mesh, &again).is_none());
        assert_eq!(
            (again.facts, text_of(&mesh).as_str()),
            (obj::parse(text.as_bytes()).facts, text)
        );
    }
}
