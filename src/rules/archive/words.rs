//! What is wrong with an archive, in words.

use crate::diag::{Application, Case, Level};
use crate::formats::mhbin::{MeshFault, Misfit, Part};
use crate::formats::npz::{ArchiveFault, NpyFault};
use crate::repo::{FileFacts, View, parent};

const REFUSED: Case = &[(
    Application::Makehuman2,
    Level::Error,
    "refuses the mesh with a line in its log; the window opens without a base",
)];
const TORN: Case = &[(
    Application::Makehuman2,
    Level::Warning,
    "shows the mesh, but no slider and no pose moves that position: the surface tears there",
)];

/// A fault of a packed mesh, with what comes of it where that is not the usual. Nothing where another rule has the words.
pub(super) fn of_mesh(fault: &MeshFault) -> Option<(String, Case)> {
    Some(match fault {
        MeshFault::Archive(ArchiveFault::Empty) => return None,
        MeshFault::Archive(ArchiveFault::NotZip(reason)) => (format!("no zip archive: {reason}"), &[]),
        MeshFault::Oversized => ("unpacks to more than any mesh of its size".to_owned(), &[]),
        MeshFault::Missing(members) => (missing(members), REFUSED),
        MeshFault::Member(name, NpyFault::Shape) => (format!("member `{name}` has rows of another length"), &[]),
        MeshFault::Member(name, fault) => (format!("member `{name}` {}", of_member(fault)), &[]),
        MeshFault::Misfit(Misfit::Copy(position)) => (format!("position {position} is a copy of no vertex"), TORN),
        MeshFault::Misfit(misfit) => (misfit_words(misfit), &[]),
    })
}

/// What to do about a packed mesh.
pub(super) fn help_with_mesh(view: &View<'_>, file: &FileFacts) -> &'static str {
    let text = format!("{}/base.obj", parent(&file.rel));
    match view.layers().first_existing(&text) {
        Some(_) => "delete it: MakeHuman 2 then reads base.obj, which compile_meshes.py packs anew",
        None => "restore it, or pack base.obj anew with compile_meshes.py",
    }
}

fn missing(members: &[&str]) -> String {
    let names: Vec<String> = members.iter().map(|name| format!("`{name}`")).collect();
    match names.as_slice() {
        [only] => format!("member {only} is missing"),
        several => format!("{} members are missing: {}", several.len(), several.join(", ")),
    }
}

fn misfit_words(misfit: &Misfit) -> String {
    match misfit {
        Misfit::Header => "`header` states no number of vertices".to_owned(),
        Misfit::Short(part, there, needed) => short(*part, *there, *needed),
        Misfit::GroupName(name) => format!("the name of group `{name}` is not UTF-8"),
        Misfit::Faces => "groups with more faces, or faces with more corners, than there are".to_owned(),
        Misfit::SmallFace(corners) => format!("a face has {corners} corners"),
        Misfit::Overflow(position) => format!("`overflow` names position {position}, which does not exist"),
        Misfit::Copy(position) => format!("position {position} is a copy of no vertex"),
    }
}

fn short(part: Part, there: usize, needed: usize) -> String {
    match part {
        Part::Positions => format!("`header` states {needed} vertices, `coord` has {there} positions"),
        Part::Uvs => format!("`uvs` has {there} texture coordinates for {needed} positions"),
        Part::Triangles => format!("`header` states {there} triangles, the faces make {needed}"),
        Part::GroupNames => format!("`grpNames` has {there} names for {needed} groups"),
        Part::Groups => format!("`groupinfo` has {there} groups for {needed} names"),
    }
}

/// A fault of a member, behind its name.
pub(super) fn of_member(fault: &NpyFault) -> String {
    match fault {
        NpyFault::NotNpy => "is no NumPy array".to_owned(),
        NpyFault::Header => "has a header that NumPy refuses".to_owned(),
        NpyFault::Object => "holds Python objects, which are never unpickled".to_owned(),
        NpyFault::MissingField(name) => format!("has no field `{name}`"),
        NpyFault::WrongType("", kind) => format!("holds values of type `{kind}`, which are not what it is for"),
        NpyFault::WrongType(name, kind) => format!("has a field `{name}` of type `{kind}` that does not fit a target"),
        NpyFault::Shape => "is no plain list of rows".to_owned(),
        NpyFault::Truncated => "ends before its last row".to_owned(),
        NpyFault::Damaged(reason) => format!("cannot be unpacked: {reason}"),
    }
}
