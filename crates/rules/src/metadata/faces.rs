//! The packed tables of faces and vertices of MPFB's base mesh
//! (`docs/loaders/mpfb/base-mesh.md#metadata`, `docs/loaders/mpfb/clothes.md#delete-group`).

use super::super::{Rule, counted, such};
use mhlint_diag::{Application::Mpfb, Case, Evidence, Finding, Level, Place};
use mhlint_discover::Kind;
use mhlint_formats::index_table::{IndexTable, inverse, sorted};
use mhlint_formats::obj::Mesh;
use mhlint_repo::FileFacts;
use mhlint_repo::mpfb::View;

const NOT_WORN: Case = &[(
    Mpfb,
    Level::Error,
    "fails with an exception when an asset that hides vertices of the body is put on",
)];
const OTHER_FACES: Case = &[(
    Mpfb,
    Level::Warning,
    "hides other faces of the body than assets ask for",
)];
const UNUSED: Case = &[(
    Mpfb,
    Level::Info,
    "has no effect in MPFB, which never asks for these rows",
)];
const OTHER_NUMBERS: Case = &[(
    Mpfb,
    Level::Warning,
    "takes other vertices for joints, targets and groups, or hides other faces",
)];

const HELP: &str =
    "make the table from this base mesh, or restore it from the download of the add-on";

/// A table, and how large it should be.
struct Table<'v> {
    file: &'v FileFacts,
    rows: &'v IndexTable,
}

fn table<'v>(view: &View<'v>, kind: Kind) -> Option<Table<'v>> {
    let file = view
        .layers
        .system?
        .files
        .values()
        .find(|file| file.kind == kind)?;
    Some(Table {
        file,
        rows: file.index_table()?,
    })
}

/// The mesh, if all of its faces are as they are written.
fn sound<'v>(view: &View<'v>) -> Option<&'v Mesh> {
    let (_, mesh) = view.mesh?;
    let facts = &mesh.facts;
    let is_whole = facts.unreadable_lines == 0
        && facts.short_faces.is_empty()
        && facts.face_out_of_range.count == 0;
    (is_whole && !mesh.faces.is_empty()).then_some(mesh)
}

/// Findings on both tables.
pub(super) fn faults(rule: &Rule, view: &View<'_>, out: &mut Vec<Finding>) {
    let is_checked = |table: &Table<'_>| view.layers.is_checked(table.file);
    let (faces, vertices) = (table(view, Kind::FaceTable), table(view, Kind::VertexTable));
    let both = faces.iter().chain(&vertices);
    out.extend(
        both.filter(|one| is_checked(one))
            .filter_map(|one| unread(rule, one)),
    );
    let of_faces = faces.filter(|one| one.rows.is_sound());
    let of_vertices = vertices.filter(|one| one.rows.is_sound());
    let Some(mesh) = sound(view) else {
        out.extend(
            of_faces
                .zip(of_vertices)
                .and_then(|(faces, vertices)| unknown_face(rule, &faces, &vertices)),
        );
        return;
    };
    // Tables that agree with one another are for another mesh than the one that is there.
    if of_faces
        .as_ref()
        .zip(of_vertices.as_ref())
        .is_some_and(|(faces, vertices)| vertices.rows.is_inverse_of(faces.rows))
    {
        return;
    }
    let corners: Vec<Vec<u32>> = mesh
        .faces
        .iter()
        .map(|face| sorted(face.of(&mesh.corners)))
        .collect();
    if let Some(table) = of_faces.filter(is_checked) {
        out.extend(differing(rule, &table, &corners, "face", "faces"));
    }
    if let Some(table) = of_vertices.filter(is_checked) {
        out.extend(differing(
            rule,
            &table,
            &inverse(&corners, mesh.facts.vertices),
            "vertex",
            "vertices",
        ));
    }
}

/// A finding on a mesh that both tables are not for, though they agree with one another.
pub(super) fn of_mesh(
    rule: &Rule,
    view: &View<'_>,
    file: &FileFacts,
    mesh: &Mesh,
) -> Option<Finding> {
    let (faces, vertices) = table(view, Kind::FaceTable).zip(table(view, Kind::VertexTable))?;
    let are_sound = faces.rows.is_sound()
        && vertices.rows.is_sound()
        && vertices.rows.is_inverse_of(faces.rows);
    if !are_sound || sound(view).is_none() {
        return None;
    }
    let (own, known) = (mesh.faces.len(), faces.rows.rows());
    let message = if own == known {
        let is_other = |(at, face): &(usize, &mhlint_formats::obj::Face)| {
            sorted(face.of(&mesh.corners)) != sorted(faces.rows.row(*at))
        };
        let others: Vec<usize> = mesh
            .faces
            .iter()
            .enumerate()
            .filter(is_other)
            .map(|(at, _)| at)
            .collect();
        let first = others.first()?;
        format!(
            "face {first} has other vertices than its tables say{}",
            such(others.len(), "faces")
        )
    } else {
        format!("the mesh has {own} faces, and its tables are for {known}")
    };
    let finding = rule
        .at(file, Place::File, message)
        .key("faces")
        .case(OTHER_NUMBERS);
    Some(
        finding
            .related(
                faces.file.path.clone(),
                Place::File,
                "the vertices of each face",
            )
            .help("restore the base mesh"),
    )
}

/// A finding on a table that is no list of lists.
fn unread(rule: &Rule, table: &Table<'_>) -> Option<Finding> {
    let rows = table.rows;
    let (message, key) = if rows.fault.is_some() {
        ("what is packed in it is not valid JSON".to_owned(), "json")
    } else if !rows.is_list {
        ("what is packed in it is not a list".to_owned(), "list")
    } else {
        let (first, count) = rows.misshapen?;
        (
            format!(
                "row {first} is not a list of whole numbers{}",
                such(count, "rows")
            ),
            "row",
        )
    };
    Some(
        rule.at(table.file, Place::File, message)
            .key(key)
            .case(NOT_WORN)
            .help(HELP),
    )
}

/// A face that the table of faces does not have.
fn unknown_face(rule: &Rule, faces: &Table<'_>, vertices: &Table<'_>) -> Option<Finding> {
    let (largest, known) = (vertices.rows.largest()?, faces.rows.rows());
    if (largest as usize) < known {
        return None;
    }
    let message = format!("the table has {known} faces, and face {largest} is asked for");
    let finding = rule
        .at(faces.file, Place::File, message)
        .key("rows")
        .case(NOT_WORN);
    Some(
        finding
            .related(
                vertices.file.path.clone(),
                Place::File,
                "the faces of each vertex",
            )
            .help(HELP),
    )
}

/// A finding on a table that is too short, has other rows than the mesh, or more of them.
fn differing(
    rule: &Rule,
    table: &Table<'_>,
    wanted: &[Vec<u32>],
    what: &str,
    things: &str,
) -> Option<Finding> {
    let rows = table.rows.rows();
    let finding = |message: String, key: &str, case: Case| {
        rule.at(table.file, Place::File, message)
            .key(key)
            .case(case)
            .help(HELP)
    };
    if rows < wanted.len() {
        let message = format!(
            "the table has {}, and the mesh has {} {things}",
            counted(rows, "row"),
            wanted.len()
        );
        return Some(finding(message, "rows", NOT_WORN));
    }
    let is_other = |at: &usize| {
        wanted
            .get(*at)
            .is_some_and(|own| sorted(table.rows.row(*at)) != *own)
    };
    let others: Vec<usize> = (0..wanted.len()).filter(is_other).collect();
    if let Some(first) = others.first() {
        let message = format!(
            "the row of {what} {first} is not that of the mesh{}",
            such(others.len(), "rows")
        );
        let evidence = Evidence::of_cases(others.iter().map(usize::to_string));
        return Some(
            finding(message, "other", OTHER_FACES).evidence(evidence.out_of(wanted.len())),
        );
    }
    let message = format!(
        "the table has {rows} rows, and the mesh has {} {things}",
        wanted.len()
    );
    (rows > wanted.len()).then(|| finding(message, "more", UNUSED))
}
