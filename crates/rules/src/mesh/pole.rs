//! A vertex belongs to a few faces.

use super::super::{Check, Rule, RuleCx};
use mhlint_diag::{
    Application::{self, Makehuman1},
    Finding, Level, Place, RuleInfo,
};
use mhlint_formats::asset_mesh::AssetMesh;
use mhlint_formats::mhclo::Entry;
use mhlint_formats::python_int;
use mhlint_repo::{Body, Worn, worn_reader};

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[(
        Makehuman1,
        "does not put the asset on: its mesh cannot be loaded",
    )],
    docs: include_str!("pole.md").trim_ascii_end(),
    ..RuleInfo::new(
        "mesh-pole",
        Level::Error,
        "a vertex with more faces than are kept",
    )
});

/// Half of what is kept where the asset does not say.
const USUAL: i64 = 8;

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let own = body
        .worn
        .iter()
        .filter(|worn| body.layers.is_checked(worn.file));
    out.extend(
        own.clone()
            .filter_map(|worn| finding(body.application(), worn)),
    );
    out.extend(own.filter_map(of_archive));
}

/// An asset that is nothing but its archive, which says how many are kept.
fn of_archive(worn: &Worn<'_>) -> Option<Finding> {
    // The archive of a mesh says it itself.
    let proxy = worn.packed_proxy().filter(|_| worn.packed_mesh.is_none())?;
    let (file, mesh) = worn.mesh().filter(|(_, mesh)| mesh.is_sound())?;
    let (vertex, most, what) =
        most(mesh).filter(|(_, most, _)| u64::from(*most) > proxy.max_pole)?;
    let message = format!(
        "{} of `{}` has {most} {what}, but the archive allows {}",
        mesh.named(vertex),
        file.file_name(),
        proxy.max_pole
    );
    let finding = RULE.at(worn.file, Place::File, message).related(
        file.path.clone(),
        Place::File,
        "the mesh",
    );
    Some(finding.help(format!(
        "pack it again from a text with `max_pole {}`",
        most.div_ceil(2)
    )))
}

/// The vertex with most faces, or most neighbours.
fn most(mesh: &AssetMesh) -> Option<(u32, u32, &'static str)> {
    let (vertex, faces) = mesh.pole?;
    let beside = mesh.neighbours.filter(|(_, count)| *count > faces);
    Some(beside.map_or((vertex, faces, "faces"), |(vertex, count)| {
        (vertex, count, "neighbours")
    }))
}

fn finding(application: Application, worn: &Worn<'_>) -> Option<Finding> {
    let entry = worn_reader(application)
        .of(worn.clothes()?)
        .last("max_pole");
    let (file, mesh) = worn.mesh().filter(|(_, mesh)| mesh.is_sound())?;
    let (vertex, most, what) = most(mesh)?;
    // A word that is no number has a finding of its own.
    let half = entry.map_or(Some(USUAL), |entry| python_int(entry.word().as_bytes()))?;
    let kept = half.saturating_mul(2);
    if i64::from(most) <= kept {
        return None;
    }
    let place = entry.map_or(Place::File, |entry: &Entry| Place::Span(entry.word_span()));
    let allows = entry.map_or("MakeHuman 1 keeps".to_owned(), |entry| {
        format!("`max_pole {}` allows", entry.word())
    });
    let message = format!(
        "{} of `{}` has {most} {what}, but {allows} {}",
        mesh.named(vertex),
        file.file_name(),
        kept.max(0)
    );
    let finding =
        RULE.at(worn.file, place, message)
            .related(file.path.clone(), Place::File, "the mesh");
    Some(finding.help(format!(
        "write `max_pole {}`: MakeHuman 1 allows twice that number",
        most.div_ceil(2)
    )))
}
