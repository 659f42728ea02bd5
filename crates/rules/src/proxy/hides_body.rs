//! Something of the body must be left to see.

use std::ops::Range;

use super::super::{Check, Rule, RuleCx};
use super::{lone_archives, texts};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2, Mpfb},
    Case, Evidence, Finding, Level, Place, RuleInfo,
};
use mhlint_formats::obj::Mesh;
use mhlint_repo::{Body, FileFacts};

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[
        (
            Makehuman2,
            "hides the whole body; the exports to glTF and OBJ crash with `ValueError`",
        ),
        (Makehuman1, "shows nothing of the body under the asset"),
        (
            Mpfb,
            "shows nothing of the body under the asset, if the delete groups are imported",
        ),
    ],
    levels: &[(Makehuman1, Level::Info), (Mpfb, Level::Info)],
    docs: include_str!("hides_body.md").trim_ascii_end(),
    ..RuleInfo::new(
        "proxy-hides-body",
        Level::Error,
        "an asset hides the whole body",
    )
});

const ALMOST: Case = &[
    (
        Makehuman2,
        Level::Info,
        "shows little of the body under the asset",
    ),
    (
        Makehuman1,
        Level::Info,
        "shows little of the body under the asset",
    ),
    (
        Mpfb,
        Level::Info,
        "shows little of the body under the asset, if the delete groups are imported",
    ),
];

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some(mesh) = body.whole_mesh() else {
        return;
    };
    for text in texts(body).filter(|text| !text.worn.is_topology() && !text.reading.stops()) {
        if text.clothes.deleted.is_empty() || text.size_of_base(body).is_none() {
            continue;
        }
        let hidden = hidden(
            body,
            mesh,
            &text.clothes.merged_deletes(mesh.positions.len()),
        );
        let list = text
            .clothes
            .entries
            .iter()
            .find(|entry| &*entry.keyword == "delete_verts");
        let place = list.map_or(Place::File, |entry| Place::Line(entry.line));
        out.extend(finding(text.file, place, "`delete_verts`", hidden));
    }
    for archive in lone_archives(body).filter(|archive| !archive.worn.is_topology()) {
        let mask = archive
            .mask
            .filter(|mask| mask.length == mesh.positions.len());
        let Some(mask) = mask else { continue };
        out.extend(finding(
            archive.file,
            Place::File,
            "the mask",
            hidden(body, mesh, &mask.runs),
        ));
    }
}

fn finding(
    file: &FileFacts,
    place: Place,
    what: &str,
    (shown, hidden): (usize, usize),
) -> Option<Finding> {
    let is_almost_all = shown > 0 && hidden.saturating_mul(20) > shown.saturating_mul(19);
    let all = if hidden == shown { "all" } else { "almost all" };
    is_almost_all.then(|| {
        let finding = RULE.at(file, place, format!("{what} hides {all} faces of the body"));
        let finding = finding.evidence(Evidence::counted(hidden).out_of(shown));
        let finding = finding.help("list only vertices that lie under the asset");
        if hidden == shown {
            finding
        } else {
            finding.case(ALMOST)
        }
    })
}

/// How many faces are shown without the asset, and how many of them it hides.
fn hidden(body: &Body<'_>, mesh: &Mesh, runs: &[Range<usize>]) -> (usize, usize) {
    let mut is_deleted = vec![false; mesh.positions.len()];
    for vertex in runs.iter().cloned().flatten() {
        if let Some(deleted) = is_deleted.get_mut(vertex) {
            *deleted = true;
        }
    }
    let is_shown: Vec<bool> = mesh
        .groups
        .iter()
        .map(|group| body.shows(&group.name))
        .collect();
    let (mut shown, mut hidden) = (0, 0);
    for face in mesh
        .faces
        .iter()
        .filter(|face| is_shown.get(face.group as usize) == Some(&true))
    {
        shown += 1;
        hidden += usize::from(
            face.of(&mesh.corners)
                .iter()
                .all(|corner| is_deleted.get(*corner as usize) == Some(&true)),
        );
    }
    (shown, hidden)
}
