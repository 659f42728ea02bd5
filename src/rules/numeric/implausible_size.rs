//! A body is as large as something that walks on two legs.

use super::super::units::centimetres;
use super::super::{Check, Rule, RuleCx};
use crate::diag::{Application::Makehuman2, Confidence, Evidence, Finding, Level, Place, RuleInfo};
use crate::formats::obj::{Mesh, joined};
use crate::repo::{Body, Rig};

pub(in crate::rules) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[(Makehuman2, "shows a body of this size without a message; targets, clothes and poses do not fit it")],
    docs: "The body is implausibly small or large: the visible groups of a mesh with a pose skeleton are at most \
        20 cm, or at least 6 m, in their largest dimension. Everything in between is taken as intended.\n\n\
        Numbers in `base.obj` are decimetres: a figure of 1.70 m is 17 high. Programs that count in metres or \
        centimetres write a mesh that is ten times too small or too large, and existing targets move its vertices \
        ten times too far, or hardly at all.\n\n\
        Export the mesh in decimetres (scale 0.1 or 10).",
    ..RuleInfo::new("numeric-implausible-size", Level::Warning, "a body measures a few centimetres or many metres")
});

/// Decimetres. A tenth of an adult is 17 cm, ten times a small figure 10 m; the smallest known base has 32 cm.
const SMALLEST: f32 = 2.0;
const LARGEST: f32 = 60.0;

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some((file, mesh)) = body.mesh.filter(|(_, mesh)| mesh.facts.non_finite.count == 0) else { return };
    let has_rig = body.default_rig().and_then(Rig::skeleton).is_some_and(|skeleton| !skeleton.bones.is_empty());
    let Some(extent) = extent(body, mesh).filter(|_| has_rig) else { return };
    if extent > SMALLEST && extent < LARGEST {
        return;
    }
    let (length, help) = (centimetres(extent), if extent < LARGEST { "10" } else { "0.1" });
    let message = format!("the visible mesh measures {length:.1} cm ({extent:.3}) in its largest dimension");
    out.push(
        RULE.at(file, Place::File, message)
            .confidence(Confidence::Medium)
            .help(format!("export the mesh in decimetres, probably with scale {help}, in the same vertex order"))
            .evidence(Evidence::of_unnamed([format!("{length:.1} cm")])),
    );
}

/// The largest extent of the shown groups along an axis.
fn extent(body: &Body<'_>, mesh: &Mesh) -> Option<f32> {
    let groups = mesh.groups.iter().zip(&mesh.facts.bounds);
    let shown = groups.filter(|(group, _)| body.shows(&group.name)).filter_map(|(_, bounds)| *bounds);
    let bounds = shown.reduce(|one, other| joined(&one, &other))?;
    Some(bounds.iter().fold(0.0, |most: f32, (lowest, highest)| most.max(highest - lowest)))
}
