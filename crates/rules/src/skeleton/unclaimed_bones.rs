//! Another skeleton takes over all weights of the default one.

use std::collections::BTreeSet;

use super::super::{Check, Rule, RuleCx, bones_in_words};
use super::measured::{Measured, measured};
use mhlint_diag::{Application::Makehuman2, Evidence, Finding, Level, Place, RuleInfo};
use mhlint_eval::measures::Measures;
use mhlint_repo::{Body, Rig};

pub(crate) static RULE: Rule = Check::Numeric(run).rule(RuleInfo {
    breaks: &[(
        Makehuman2,
        "exports these vertices without a bone: they do not move in any pose",
    )],
    docs: include_str!("unclaimed_bones.md").trim_ascii_end(),
    counts: "vertices",
    ..RuleInfo::new(
        "skeleton-unclaimed-bones",
        Level::Warning,
        "vertices lose their weights because no bone of a skeleton claims them",
    )
});

fn run(body: &Body<'_>, measures: &Measures, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some(default) = body.default_rig().and_then(Rig::skeleton) else {
        return;
    };
    let vertices = body.mesh.map_or(0, |(_, mesh)| mesh.positions.len());
    let rigs = measured(body, measures);
    let defaults: BTreeSet<&String> = default.bones.iter().map(|bone| &bone.name).collect();
    out.extend(
        rigs.iter()
            .filter(|rig| knows_its_references(rig, &defaults))
            .filter_map(|rig| finding(rig, vertices)),
    );
}

/// A name that does not exist may be that of the lost bone.
fn knows_its_references(rig: &Measured<'_>, defaults: &BTreeSet<&String>) -> bool {
    let bones = rig.skeleton.bones.iter();
    let mut names = bones.flat_map(|bone| {
        bone.reference
            .iter()
            .chain(&bone.weights_reference)
            .flatten()
    });
    names.all(|name| defaults.contains(name))
}

fn finding(rig: &Measured<'_>, vertices: usize) -> Option<Finding> {
    let received = &rig.measure.received;
    let bones: Vec<&str> = received.lost_bones.iter().map(String::as_str).collect();
    let lost = received.lost_vertices;
    if bones.is_empty() || lost == 0 {
        return None;
    }
    let get = if lost == 1 { "gets" } else { "get" };
    let message = format!(
        "{lost} of {vertices} vertices {get} no weights: no bone of this skeleton takes the \
            weights of {}",
        bones_in_words(&bones)
    );
    Some(
        RULE.at(rig.file, Place::pointer(["bones"]), message)
            .parts(&bones)
            .help("list the lost default bones in `reference` of the bones that replace them")
            .evidence(Evidence::counted(lost).out_of(vertices)),
    )
}
