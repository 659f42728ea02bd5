//! Faces must use what exists.

use super::super::{Check, Rule, RuleCx, counted};
use super::{ASSET_INDEX, ASSET_OVERFLOW, read};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2, Mpfb},
    Case, Finding, Level, Place, RuleInfo, Tally,
};
use mhlint_discover::Kind;
use mhlint_formats::obj::Mesh;
use mhlint_repo::{FileFacts, View};

pub(crate) static RULE: Rule = Check::File(run).rule(RuleInfo {
    breaks: &[
        (
            Makehuman2,
            "crashes with `IndexError` while loading the base mesh",
        ),
        (
            Makehuman1,
            "does not put the asset on: its mesh cannot be loaded",
        ),
        (Mpfb, "drops the face, without a message"),
    ],
    levels: &[(Mpfb, Level::Warning)],
    docs: include_str!("face_out_of_range.md").trim_ascii_end(),
    counts: "faces",
    ..RuleInfo::new(
        "mesh-face-out-of-range",
        Level::Error,
        "a face uses a vertex or texture coordinate that does not exist",
    )
});

const BELOW_ONE: Case = &[(
    Makehuman2,
    Level::Error,
    "crashes with `OverflowError` while loading the base mesh",
)];

fn run(view: &View<'_>, file: &FileFacts, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some(mesh) = read(view, file).filter(|mesh| mesh.asset.is_some() || !view.is_mpfb()) else {
        return;
    };
    let tally = &mesh.facts.face_out_of_range;
    let Some((line, number)) = tally.first.first() else {
        return;
    };
    // Blender counts negative numbers from the end, as the format has it
    // (`docs/loaders/mpfb/clothes.md#mesh-of-an-asset`).
    let from_end =
        usize::try_from(number.unsigned_abs()).is_ok_and(|back| back <= mesh.facts.vertices);
    if view.is_mpfb() && *number < 0 && from_end {
        return;
    }
    if let Some(packed_mesh) = file.mesh().filter(|_| file.kind == Kind::MeshArchive) {
        return out.push(packed(file, packed_mesh, tally, *number));
    }
    let (vertices, uvs) = (mesh.facts.vertices, mesh.uvs);
    let is_beyond = |count: usize| usize::try_from(*number).is_ok_and(|number| number > count);
    let message = match (is_beyond(vertices), is_beyond(uvs)) {
        (true, false) => format!(
            "{} {number}, but the mesh has {vertices}",
            uses(tally, "vertex")
        ),
        (false, true) => format!(
            "{} {number}, but the mesh has {uvs}",
            uses(tally, "texture coordinate")
        ),
        _ => {
            let uvs = counted(uvs, "texture coordinate");
            format!(
                "{} {number}, but the mesh has {vertices} vertices and {uvs}",
                uses(tally, "number")
            )
        }
    };
    let bad = usize::try_from(tally.count).unwrap_or(usize::MAX);
    let lines = tally.first.iter().map(|(line, _)| format!("line {line}"));
    let finding = RULE
        .at(file, Place::Line(*line), message)
        .help("count from 1, without negative numbers; export the mesh again if lines are missing")
        .evidence(tally.evidence(mesh.faces + bad).showing(lines));
    let finding = if *number < 1 {
        finding.case(BELOW_ONE)
    } else {
        finding
    };
    out.push(mesh.weigh(
        view,
        file,
        finding,
        if *number < 1 {
            ASSET_OVERFLOW
        } else {
            ASSET_INDEX
        },
    ));
}

/// Packed faces are numbered from 0, with the copies of vertices at seams behind the vertices.
fn packed(file: &FileFacts, mesh: &Mesh, tally: &Tally, number: i64) -> Finding {
    let positions = mesh.size().with_seams;
    let message = format!(
        "{} {number}, but the mesh has {positions} positions",
        uses(tally, "position")
    );
    RULE.at(file, Place::File, message)
        .help("rebuild base.mhbin from base.obj with compile_meshes.py")
        .evidence(tally.evidence(mesh.faces.len() + tally.first.len()))
}

/// The beginning of a message, before the first number.
fn uses(tally: &Tally, thing: &str) -> String {
    match tally.count {
        1 => format!("a face uses {thing}"),
        count if thing == "vertex" => format!("{count} faces use vertices such as"),
        count => format!("{count} faces use {thing}s such as"),
    }
}
