//! A body is as large as something that walks on two legs.

use super::super::units::centimetres;
use super::super::{Check, Rule, RuleCx};
use crate::diag::{
    Application::{Makehuman1, Makehuman2},
    Confidence, Evidence, Finding, Level, Place, RuleInfo,
};
use crate::repo::extent::{LARGEST, extent, is_plausible};
use crate::repo::{Body, Rig};

pub(in crate::rules) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[
        (Makehuman2, "shows a body of this size without a message; targets, clothes and poses do not fit it"),
        (Makehuman1, "shows a body of this size without a message; targets, clothes and poses do not fit it"),
    ],
    docs: "The body is implausibly small or large: the visible groups of a mesh with a pose skeleton are at most \
        20 cm, or at least 6 m, in their largest dimension. Everything in between is taken as intended.\n\n\
        Numbers in `base.obj` are decimetres: a figure of 1.70 m is 17 high. Programs that count in metres or \
        centimetres write a mesh that is ten times too small or too large, and existing targets move its vertices \
        ten times too far, or hardly at all.\n\n\
        Export the mesh in decimetres (scale 0.1 or 10).",
    ..RuleInfo::new("numeric-implausible-size", Level::Warning, "a body measures a few centimetres or many metres")
});

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some((file, mesh)) = body.mesh.filter(|(_, mesh)| mesh.facts.non_finite.count == 0) else { return };
    let has_rig = body.default_rig().and_then(Rig::skeleton).is_some_and(|skeleton| !skeleton.bones.is_empty());
    let shown = extent(mesh, |group| body.shows(group));
    let Some(extent) = shown.filter(|_| has_rig) else { return };
    if is_plausible(extent) {
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
