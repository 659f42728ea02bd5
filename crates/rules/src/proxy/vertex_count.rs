//! An asset has a row for each vertex of its mesh.

use super::super::{Check, Rule, RuleCx, counted};
use super::{Lone, STOPS_WITH_INDEX, Text, blender, lone_archives, sections, texts};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2, Mpfb},
    Case, Evidence, Finding, Level, Place, RuleInfo,
};
use mhlint_formats::mhclo::FaultKind;
use mhlint_repo::Body;

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[
        (Makehuman2, STOPS_WITH_INDEX),
        (
            Makehuman1,
            "does not put the asset on: rows and vertices differ in number",
        ),
        (Mpfb, "fails with `KeyError` when it fits the asset"),
    ],
    docs: include_str!("vertex_count.md").trim_ascii_end(),
    ..RuleInfo::new(
        "proxy-vertex-count",
        Level::Error,
        "rows and vertices of an asset differ in number",
    )
});

const FEWER: Case = &[(
    Makehuman2,
    Level::Warning,
    "leaves the last vertices where the OBJ has them: they follow no slider and hang on the root \
        bone",
)];

const SINGLE: Case = &[(
    Makehuman1,
    Level::Warning,
    "puts all vertices of the asset at one point",
)];

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    if body.is_mpfb() {
        return blender::rows::count(&RULE, body, out);
    }
    for text in texts(body).filter(|text| !text.reading.stops()) {
        out.extend(finding(body, &text));
    }
    out.extend(
        lone_archives(body)
            .filter(|_| body.is_makehuman1())
            .filter_map(|archive| of_archive(body, &archive)),
    );
}

/// An archive of MakeHuman 1 that is all there is of an asset.
fn of_archive(body: &Body<'_>, archive: &Lone<'_, '_>) -> Option<Finding> {
    let (file, mesh) = archive.worn.mesh().filter(|(_, mesh)| body.opens(mesh))?;
    let (rows, vertices) = (archive.rows.count, mesh.facts.vertices);
    // Loose vertices keep it from loading an OBJ at all (`mesh-unused-vertex`).
    let is_loose = archive.worn.packed_mesh.is_none() && mesh.facts.unused.count > 0;
    if rows == vertices || is_loose {
        return None;
    }
    let message = format!(
        "{} for {} of `{}`",
        counted(rows, "packed row"),
        vertices_of(vertices),
        file.file_name()
    );
    let finding = RULE.at(archive.file, Place::File, message).related(
        file.path.clone(),
        Place::File,
        "the mesh",
    );
    let finding = finding.evidence(Evidence::counted(rows.abs_diff(vertices)));
    let finding = finding.help("restore the mesh that it was packed with, or pack both again");
    Some(if rows == 1 {
        finding.case(SINGLE)
    } else {
        finding
    })
}

fn finding(body: &Body<'_>, text: &Text<'_, '_>) -> Option<Finding> {
    let rows = text.clothes.rows.count;
    // To MakeHuman 1 some of them are rows.
    let dropped = text
        .clothes
        .faults
        .of(|kind| kind == FaultKind::DroppedRow)
        .map_or(0, |(_, count)| count);
    let help = "export the asset again from this mesh, or restore the mesh that it was made from";
    let verts = text
        .clothes
        .entries
        .iter()
        .find(|entry| &*entry.keyword == "verts");
    let place = verts.map_or(Place::File, |entry| Place::Line(entry.line));
    if rows == 0 {
        // Without the keyword, or with each row dropped, the cause is told.
        let is_told = dropped > 0 || sections::has_no_rows(text) || sections::rows_above(text) > 0;
        let message = "there are no vertex rows below `verts`";
        return (!is_told).then(|| RULE.at(text.file, place, message).key("none").help(help));
    }
    // The numbers of a list that is taken for rows are told.
    if sections::misspelt_list(text).is_some() {
        return None;
    }
    let (file, mesh) = text.worn.mesh().filter(|(_, mesh)| body.opens(mesh))?;
    let vertices = mesh.facts.vertices;
    let unread = dropped + sections::rows_above(text);
    if rows == vertices || rows as u64 + unread == vertices as u64 {
        return None;
    }
    let is_makehuman1 = text.is_makehuman1();
    // Loose vertices keep it from loading the mesh at all (`mesh-unused-vertex`).
    if is_makehuman1 && mesh.facts.unused.count > 0 {
        return None;
    }
    let message = format!(
        "{} for {} of `{}`",
        counted(rows, "vertex row"),
        vertices_of(vertices),
        file.file_name()
    );
    let evidence = Evidence::counted(rows.abs_diff(vertices));
    let finding =
        RULE.at(text.file, place, message)
            .related(file.path.clone(), Place::File, "the mesh");
    let finding = finding.evidence(evidence).help(help);
    let finding = if is_makehuman1 && rows == 1 {
        finding.case(SINGLE)
    } else {
        finding
    };
    Some(if rows < vertices {
        finding.case(FEWER)
    } else {
        finding
    })
}

fn vertices_of(count: usize) -> String {
    if count == 1 {
        "1 vertex".to_owned()
    } else {
        format!("{count} vertices")
    }
}
