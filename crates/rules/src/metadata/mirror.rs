//! The mirror table of MPFB (`docs/loaders/mpfb/base-mesh.md#the-mirror-table`).

use std::collections::{BTreeMap, BTreeSet};

use super::super::{Rule, such};
use mhlint_diag::{Application::Mpfb, Case, Evidence, Finding, Level, Place};
use mhlint_formats::mesh_metadata::{LONG_SIDE, MirrorRow, MirrorTable};
use mhlint_formats::obj::Mesh;
use mhlint_repo::FileFacts;
use mhlint_repo::mpfb::View;
use mhlint_repo::mpfb::misplaced::is_across;

const STOPPED: Case = &[(
    Mpfb,
    Level::Error,
    "fails when a target is first made symmetric, and mirrors only the vertices above this row \
        from then on",
)];
const OUT_OF_RANGE: Case = &[(
    Mpfb,
    Level::Error,
    "fails with `IndexError` when a target is made symmetric",
)];
const PASSED_OVER: Case = &[(
    Mpfb,
    Level::Warning,
    "passes over these vertices when a target is made symmetric",
)];
const WRONG_HALF: Case = &[(
    Mpfb,
    Level::Warning,
    "mirrors the wrong half when a target is made symmetric",
)];
const APART: Case = &[(
    Mpfb,
    Level::Warning,
    "mirrors these vertices to others than their counterparts",
)];

/// The worst that is wrong with the table.
pub(super) fn fault(
    rule: &Rule,
    view: &View<'_>,
    file: &FileFacts,
    table: &MirrorTable,
) -> Option<Finding> {
    if let Some((line, count)) = table.unreadable {
        let message = format!(
            "the row is not `FROM TO SIDE` with one blank between the fields{}",
            such(count, "rows")
        );
        let finding = rule
            .at(file, Place::Line(line), message)
            .key("row")
            .case(STOPPED);
        return Some(
            finding
                .evidence(Evidence::counted(count))
                .help("write two numbers of vertices and `l`, `r` or `m`"),
        );
    }
    let (_, mesh) = view
        .mesh
        .filter(|(_, mesh)| mesh.facts.unreadable_lines == 0 && mesh.facts.vertices > 0)?;
    let x = |vertex: u32| mesh.positions.get(vertex as usize).map(|[x, ..]| *x);
    let of = |is_so: &dyn Fn(&MirrorRow) -> bool| -> Vec<&MirrorRow> {
        table.rows.iter().filter(|row| is_so(row)).collect()
    };
    let lost = of(&|row| x(row.from).is_none() || x(row.to).is_none());
    if let Some(first) = lost.first() {
        let vertex = if x(first.from).is_none() {
            first.from
        } else {
            first.to
        };
        let message = format!(
            "vertex {vertex} does not exist: the mesh has {} vertices",
            mesh.positions.len()
        );
        return Some(
            told(rule, file, &lost, message, OUT_OF_RANGE)?
                .help("make the table from this base mesh"),
        );
    }
    // Of a mesh that is not the one of the table that is the finding.
    if view.misplaced.is_some() {
        return None;
    }
    let other = of(&|row| is_across(row, mesh.positions.get(row.from as usize).copied()));
    if let Some(first) = other.first() {
        let side = if first.side == b'l' { "left" } else { "right" };
        let message = format!(
            "vertex {} does not lie on the {side}, as its row says",
            first.from
        );
        return Some(told(rule, file, &other, message, WRONG_HALF)?.help("exchange `l` and `r`"));
    }
    let unsided = of(&|row| !matches!(row.side, b'l' | b'r' | b'm'));
    if let Some(first) = unsided.first() {
        let message = match first.side {
            LONG_SIDE => "the side is a word, expected `l`, `r` or `m`".to_owned(),
            letter => format!(
                "`{}` is not a side, expected `l`, `r` or `m`",
                char::from(letter).escape_default()
            ),
        };
        return Some(
            told(rule, file, &unsided, message, PASSED_OVER)?
                .help("write `l`, `r` or `m` in small letters"),
        );
    }
    let counterpart: BTreeMap<u32, u32> = table.rows.iter().map(|row| (row.from, row.to)).collect();
    let apart = of(&|row| counterpart.get(&row.to) != Some(&row.from));
    if let Some(first) = apart.first() {
        let message = format!(
            "{} is the counterpart of {}, but not the other way round",
            first.to, first.from
        );
        return Some(
            told(rule, file, &apart, message, APART)?.help("let both rows name one another"),
        );
    }
    without_row(rule, file, mesh, &counterpart)
}

/// Vertices of the base mesh that no row begins with. Nobody sees those that are in no face.
fn without_row(
    rule: &Rule,
    file: &FileFacts,
    mesh: &Mesh,
    rows: &BTreeMap<u32, u32>,
) -> Option<Finding> {
    let vertices = mesh.positions.len();
    let lost: BTreeSet<u32> = mesh
        .corners
        .iter()
        .copied()
        .filter(|vertex| !rows.contains_key(vertex))
        .collect();
    let first = lost.first()?;
    let message = format!(
        "no row begins with vertex {first}{}",
        such(lost.len(), "vertices")
    );
    let finding = rule
        .at(file, Place::File, message)
        .key("rows")
        .case(PASSED_OVER);
    let finding =
        finding.evidence(Evidence::of_cases(lost.iter().map(ToString::to_string)).out_of(vertices));
    Some(finding.help("restore the table, or make it from this base mesh"))
}

/// A finding on rows, at the first of them.
fn told(
    rule: &Rule,
    file: &FileFacts,
    rows: &[&MirrorRow],
    message: String,
    case: Case,
) -> Option<Finding> {
    let message = format!("{message}{}", such(rows.len(), "rows"));
    let finding = rule
        .at(file, Place::Line(rows.first()?.line), message)
        .key("rows")
        .case(case);
    Some(finding.evidence(Evidence::of_cases(
        rows.iter().map(|row| row.from.to_string()),
    )))
}
