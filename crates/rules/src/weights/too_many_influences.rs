//! No vertex hangs on more bones than engines take.

use super::super::{Check, Rule, RuleCx, percent};
use super::places::{self, Worst};
use mhlint_diag::{Application::Makehuman2, Element, Evidence, Finding, Level, Place, RuleInfo};
use mhlint_eval::measures::Measures;
use mhlint_eval::rig_measure::ENGINE_INFLUENCES;
use mhlint_repo::Body;

pub(crate) static RULE: Rule = Check::Numeric(run).rule(RuleInfo {
    breaks: &[(
        Makehuman2,
        "uses all bones, but its glTF export keeps only the four largest weights: the exported \
         surface bends differently",
    )],
    docs: include_str!("too_many_influences.md").trim_ascii_end(),
    counts: "vertices",
    ..RuleInfo::new(
        "weights-too-many-influences",
        Level::Info,
        "a vertex has weights of more \
        than four bones",
    )
});

fn run(body: &Body<'_>, measures: &Measures, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some((weights, file)) = measures.weights.as_ref().zip(body.default_weights()) else {
        return;
    };
    let Some(Worst {
        vertex,
        value: share,
        places,
    }) = places::worst(body, &weights.over, |share| share)
    else {
        return;
    };
    let vertices = body.mesh.map_or(0, |(_, mesh)| mesh.positions.len());
    let (over, most, lost) = (weights.over.len(), weights.most, percent(f64::from(share)));
    let message = match (over, places) {
        (1, _) => format!("{} has weights of {most} bones", body.vertex(vertex)),
        (_, Some(places)) => {
            format!(
                "{over} vertices ({places}) have weights of more than {ENGINE_INFLUENCES} bones, \
                    up to {most}"
            )
        }
        (_, None) => format!(
            "{over} vertices have weights of more than {ENGINE_INFLUENCES} bones, up to {most}"
        ),
    };
    let most_lost = match over {
        1 => format!(
            "vertex {vertex} loses {lost} of its weight if only {ENGINE_INFLUENCES} bones are kept"
        ),
        _ => format!(
            "{} loses most if only {ENGINE_INFLUENCES} bones are kept: {lost}",
            body.vertex(vertex)
        ),
    };
    let place = Place::Element(Element {
        kind: "vertex",
        index: u64::from(vertex),
    });
    let evidence = Evidence::counted(weights.over.len()).out_of(vertices);
    out.push(
        RULE.at(file, place, message)
            .parts(weights.over.iter().map(|(vertex, _)| vertex))
            .related(&file.path, Place::File, most_lost)
            .help(
                "for export, use fewer bones for the vertices that lose much; MakeHuman itself \
                has no limit",
            )
            .evidence(evidence.with_worst(f64::from(share), format!("vertex {vertex}"))),
    );
}
