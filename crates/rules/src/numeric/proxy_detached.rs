//! An asset that leaves the body at some setting.

use std::collections::BTreeMap;

use super::super::units::length;
use super::super::{Check, Rule, RuleCx};
use super::{all_untold, to_see};
use mhlint_diag::{
    Application::Makehuman2, Confidence, Evidence, Finding, Grows, Level, MeasureKind, Place,
    RuleInfo,
};
use mhlint_eval::measures::{Measures, Seen};
use mhlint_eval::survey::Trouble;
use mhlint_repo::{Body, Worn};

pub(crate) static RULE: Rule = Check::Numeric(run).rule(RuleInfo {
    breaks: &[(
        Makehuman2,
        "draws a part of the asset away from the body, or inside it, at such settings",
    )],
    docs: include_str!("proxy_detached.md").trim_ascii_end(),
    counts: "vertices",
    grows: Grows::more(MeasureKind::Distance),
    ..RuleInfo::new(
        "numeric-proxy-detached",
        Level::Warning,
        "an asset leaves the body at some slider setting",
    )
});

fn run(body: &Body<'_>, measures: &Measures, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let worn = body.worn.iter().rev();
    let worn: BTreeMap<&str, &Worn<'_>> =
        worn.map(|worn| (worn.file.path.as_str(), worn)).collect();
    for (trouble, seen) in all_untold(body, measures) {
        if !matches!(trouble, Trouble::Detached(_)) {
            continue;
        }
        let own = worn.get(seen.name.as_str());
        // A vertex that leaves its neighbours already on the mesh as it is has a finding of its
        // own.
        let is_told = measures.worn.get(&seen.name).is_some_and(|measure| {
            measure.shape.disorder.is_some()
                || measure
                    .shape
                    .drifts
                    .iter()
                    .any(|drift| drift.vertex == seen.element)
        });
        out.extend(
            own.filter(|_| !is_told)
                .and_then(|worn| finding(body, worn, seen)),
        );
    }
}

fn finding(body: &Body<'_>, worn: &Worn<'_>, seen: &Seen) -> Option<Finding> {
    let reference = worn.clothes()?.kept.get(seen.element)?;
    let vertex = match worn.mesh() {
        Some((_, mesh)) => mesh.named(seen.element),
        None => format!("vertex {}", seen.element),
    };
    let away = seen
        .length
        .map(|away| format!(" {}", length(away)))
        .unwrap_or_default();
    let message = format!(
        "{vertex} of the asset, tied to {} of the body, moves{away} away from the skin around it",
        body.vertex(reference.vertices[0])
    );
    let finding = RULE
        .at(worn.file, Place::Line(reference.line), message)
        .confidence(Confidence::Medium);
    let finding = finding.evidence(
        Evidence::of_unnamed(seen.all.iter())
            .with_worst(seen.value, format!("vertex {}", seen.element)),
    );
    let finding = finding.help("tie the vertices to the skin that they lie on");
    Some(match &seen.target {
        Some(target) => finding.related(target.clone(), Place::File, to_see(&seen.setting)),
        None => finding.related(worn.file.path.clone(), Place::File, to_see(&seen.setting)),
    })
}
