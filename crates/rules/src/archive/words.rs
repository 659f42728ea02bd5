//! What is wrong with an archive, in words.

use super::super::counted;
use super::super::unpacking::plain;
use super::Sort;
use mhlint_diag::{Application::Makehuman2, Case, Level};
use mhlint_formats::mhbin::{MeshFault, Misfit, Part};
use mhlint_formats::npz::{ArchiveFault, NpyFault};
use mhlint_repo::{FileFacts, View};
use mhlint_source::parent;

const REFUSED: Case = &[(
    Makehuman2,
    Level::Error,
    "rejects the mesh with only a log line; the window opens without a base",
)];
const TORN: Case = &[(
    Makehuman2,
    Level::Warning,
    "shows the mesh, but no slider or pose moves that position: the surface tears there",
)];

/// A fault of a packed mesh, with what comes of it where that is not the usual. Nothing where
/// another rule has the words.
pub(super) fn of_mesh(fault: &MeshFault) -> Option<(Sort, String, Case)> {
    let (message, case): (String, Case) = match fault {
        MeshFault::Archive(ArchiveFault::Empty) => return None,
        MeshFault::Archive(ArchiveFault::NotZip(reason)) => (not_zip(reason), &[]),
        MeshFault::Oversized => (
            "unpacks to more data than any mesh of its size".to_owned(),
            &[],
        ),
        MeshFault::Missing(members) => (missing(members), REFUSED),
        MeshFault::Member(name, NpyFault::Shape) => {
            (format!("member `{name}` has rows of the wrong length"), &[])
        }
        MeshFault::Member(name, fault) => (format!("member `{name}` {}", of_member(fault)), &[]),
        MeshFault::Misfit(misfit @ Misfit::Copy(_)) => (misfit_words(misfit), TORN),
        MeshFault::Misfit(misfit) => (misfit_words(misfit), &[]),
    };
    let sort = match fault {
        MeshFault::Missing(_) => Sort::MissingMember,
        MeshFault::Member(_, fault) => Sort::of(fault),
        _ => Sort::Malformed,
    };
    Some((sort, message, case))
}

/// What to do about a packed mesh.
pub(super) fn help_with_mesh(view: &View<'_>, file: &FileFacts) -> &'static str {
    let text = format!("{}/base.obj", parent(&file.rel));
    match view.layers().first_existing(&text) {
        Some(_) => {
            "delete the archive, so that MakeHuman 2 reads base.obj, or rebuild it with \
                compile_meshes.py"
        }
        None => "restore it, or rebuild it from base.obj with compile_meshes.py",
    }
}

/// A file that no reader of archives takes. What the library says of it is for those who know zip.
pub(super) fn not_zip(reason: &str) -> String {
    // The directory of a zip is at its end.
    if reason.contains("EOCD") || reason.contains("end of central directory") {
        return "not a zip archive, or its end is missing".to_owned();
    }
    format!("not a readable zip archive ({reason})")
}

pub(super) fn missing(members: &[&str]) -> String {
    let names: Vec<String> = members.iter().map(|name| format!("`{name}`")).collect();
    match names.as_slice() {
        [only] => format!("member {only} is missing"),
        several => format!(
            "{} members are missing: {}",
            several.len(),
            several.join(", ")
        ),
    }
}

fn misfit_words(misfit: &Misfit) -> String {
    match misfit {
        Misfit::Header => "`header` has no number of vertices".to_owned(),
        Misfit::Short(part, there, needed) => short(*part, *there, *needed),
        Misfit::GroupName(name) => format!("the name of group `{name}` is not UTF-8"),
        Misfit::Faces => {
            "groups list more faces, or faces more corners, than the archive contains".to_owned()
        }
        Misfit::SmallFace(corners) => format!(
            "a face has {}, expected at least 3",
            counted(corners, "corner")
        ),
        Misfit::Overflow(position) => {
            format!("`overflow` names position {position}, which does not exist")
        }
        Misfit::Copy(position) => format!("position {position} is not a copy of any vertex"),
    }
}

fn short(part: Part, there: usize, needed: usize) -> String {
    match part {
        Part::Positions => {
            format!("`coord` has {there} positions, but `header` says {needed} vertices")
        }
        Part::Uvs => {
            format!("`uvs` has {there} texture coordinates, but the mesh has {needed} positions")
        }
        Part::Triangles => format!("`header` says {there} triangles, but the faces have {needed}"),
        Part::GroupNames => {
            format!("`grpNames` has {there} names, but the mesh has {needed} groups")
        }
        Part::Groups => {
            format!("`groupinfo` has {there} groups, but `grpNames` has {needed} names")
        }
    }
}

/// A fault of a member, behind its name.
pub(super) fn of_member(fault: &NpyFault) -> String {
    match fault {
        NpyFault::NotNpy => "is not a NumPy array".to_owned(),
        NpyFault::Header => {
            "has a header that NumPy, the array library of MakeHuman, rejects".to_owned()
        }
        NpyFault::Object => "contains Python objects, which are never loaded".to_owned(),
        NpyFault::MissingField(name) => format!("has no field `{name}`"),
        NpyFault::WrongType("", kind) => format!("has values of the wrong type `{kind}`"),
        NpyFault::WrongType(name, kind) => {
            format!("has a field `{name}` of the wrong type `{kind}`")
        }
        NpyFault::Shape => "is not a plain list of rows".to_owned(),
        NpyFault::NotUtf8 => "is not UTF-8".to_owned(),
        NpyFault::Truncated => "ends before its last row".to_owned(),
        NpyFault::Damaged(reason) => format!("cannot be unpacked: {}", plain(reason)),
    }
}
