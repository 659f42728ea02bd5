//! What is wrong with the packed assets of MakeHuman 1: `.mhpxy` of what is worn, `.npz` of meshes
//! (`docs/loaders/makehuman1/compiled-clothes.md#faults-of-compiled-clothes`,
//! `docs/loaders/makehuman1/base-mesh.md#packed-meshes`).

use super::super::Rule;
use super::{Sort, words};
use mhlint_diag::{Application::Makehuman1, Case, Finding, Level, Place};
use mhlint_discover::archive_library_of;
use mhlint_formats::mhbin::MeshFault;
use mhlint_formats::npz::{ArchiveFault, NpyFault};
use mhlint_formats::packed::asset::Packed;
use mhlint_repo::makehuman1::View;
use mhlint_repo::{FileFacts, Reference, ReferenceKind};

const TEXT: Case = &[(
    Makehuman1,
    Level::Info,
    "reads the text beside it, with a warning in the log",
)];
const NOT_WORN: Case = &[(Makehuman1, Level::Error, "does not put the asset on")];

/// What is wrong of this sort.
pub(super) fn report(
    rule: &Rule,
    sort: Sort,
    view: &View<'_>,
    file: &FileFacts,
    out: &mut Vec<Finding>,
) {
    let text = view.layers.checked.text_of_archive(&file.rel);
    // Beside a text an empty file, or a pointer, has a finding of its own, and that is all.
    let is_blank = file.size == 0 || file.encoding.lfs_pointer;
    let blank = || {
        (
            Sort::Malformed,
            "the archive has nothing in it, and there is no text beside it".to_owned(),
        )
    };
    let found = fault(file)
        .or_else(|| of_numbers(file))
        .or_else(|| (is_blank && text.is_none()).then(blank));
    let Some((_, message)) = found.filter(|(own, _)| *own == sort) else {
        return;
    };
    let is_base = file.rel == BASE;
    if !is_base && !is_opened(view, file, text.is_some()) {
        return;
    }
    // What can be read is not read anew.
    let is_read = is_read(file);
    let (case, help) = match text {
        Some(_) if !is_read => (TEXT, "delete it: the text is read instead"),
        Some(_) => (
            if is_base { STOPS } else { NOT_WORN },
            "delete it: the text is read instead",
        ),
        None => (
            if is_base { STOPS } else { NOT_WORN },
            "restore it, or the text that it was made from",
        ),
    };
    let case = if sort == Sort::ObjectArray { &[] } else { case };
    out.push(rule.at(file, Place::File, message).case(case).help(help));
}

/// Whether an asset leads to it. Outside of the libraries that list it nothing puts on what is in
/// an archive, and a zip of something else beside an asset is nobody's.
fn is_opened(view: &View<'_>, file: &FileFacts, has_text: bool) -> bool {
    if file.rel.ends_with(".mhpxy") {
        return archive_library_of(&file.rel).is_some();
    }
    let is_mesh = |one: &Reference<'_>| {
        let found = one.found().is_some_and(|mesh| std::ptr::eq(mesh, file));
        found && one.kind == ReferenceKind::AssetMesh
    };
    has_text || file.rel.ends_with(".npz") && view.references.to_file(file).any(is_mesh)
}

/// The archive of the base mesh.
const BASE: &str = "3dobjs/base.npz";
const STOPS: Case = &[(
    Makehuman1,
    Level::Error,
    "stops at start: only the splash picture stays on the screen",
)];

/// Whether the program takes it in place of the text, and fails with it later.
fn is_read(file: &FileFacts) -> bool {
    match file.packed() {
        Some(Packed::Proxy(proxy)) => proxy.fault.as_ref().is_none_or(|(member, fault)| {
            let is_kept = matches!(fault, Some(NpyFault::WrongType(..) | NpyFault::Shape));
            is_kept && FITTED.contains(member)
        }),
        Some(Packed::Mesh(mesh)) => mesh.is_ok(),
        _ => false,
    }
}

/// Members that are taken as they are, and looked at when the asset is fitted.
const FITTED: [&str; 4] = ["ref_vIdxs", "weights", "offsets", "deleteVerts"];

/// Vertices that the base mesh does not have, or a face of those that the mesh does not have.
fn of_numbers(file: &FileFacts) -> Option<(Sort, String)> {
    let message = match file.packed()? {
        Packed::Proxy(proxy) if proxy.fault.is_none() => {
            let (_, vertex) = proxy.rows.out_of_range.first.first()?;
            format!("a row names vertex {vertex}, which the base mesh does not have")
        }
        Packed::Mesh(Ok(mesh)) if !mesh.is_sound() => {
            "has no vertex, or a face of one that does not exist".to_owned()
        }
        _ => return None,
    };
    Some((Sort::Malformed, message))
}

fn fault(file: &FileFacts) -> Option<(Sort, String)> {
    match file.packed()? {
        Packed::Unopened(ArchiveFault::Empty) => None,
        Packed::Unopened(ArchiveFault::NotZip(reason)) => {
            Some((Sort::Malformed, words::not_zip(reason)))
        }
        Packed::Other | Packed::Asset(_) => Some((
            Sort::Malformed,
            "has neither the members of something worn nor those of a mesh".to_owned(),
        )),
        Packed::Proxy(proxy) => proxy.fault.as_ref().map(|(member, fault)| match fault {
            Some(fault) => (
                Sort::of(fault),
                format!("member `{member}` {}", words::of_member(fault)),
            ),
            None => (Sort::MissingMember, words::missing(&[member])),
        }),
        Packed::Mesh(Err(MeshFault::Missing(members))) => {
            Some((Sort::MissingMember, words::missing(members)))
        }
        Packed::Mesh(Err(fault)) => words::of_mesh(fault).map(|(sort, message, _)| (sort, message)),
        Packed::Mesh(Ok(_)) => None,
    }
}
