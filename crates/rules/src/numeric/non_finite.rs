//! A setting at which something is no number although every file holds numbers.

use super::super::{Check, Rule, RuleCx};
use super::{at_setting, untold};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2},
    Evidence, Finding, Grows, Level, MeasureKind, RuleInfo,
};
use mhlint_eval::measures::Measures;
use mhlint_eval::skeleton::PARALLEL_SINE;
use mhlint_eval::survey::Trouble;
use mhlint_repo::Body;

pub(crate) static RULE: Rule = Check::Numeric(run).rule(RuleInfo {
    breaks: &[
        (Makehuman2, "in pose mode all skin of the bone disappears"),
        (Makehuman1, "draws a torn mesh at this setting"),
    ],
    docs: include_str!("non_finite.md").trim_ascii_end(),
    grows: Grows::less(MeasureKind::Sine),
    ..RuleInfo::new(
        "numeric-non-finite",
        Level::Error,
        "a vertex or matrix is NaN or infinite at some slider setting",
    )
});

fn run(body: &Body<'_>, measures: &Measures, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    if let Some(seen) = untold(body, measures, Trouble::NonFinite) {
        let vertex = body.vertex(seen.element);
        let message = match seen.count {
            1 => format!("the position of {vertex} is NaN or infinite"),
            count => {
                format!("the positions of {count} vertices are NaN or infinite, first {vertex}")
            }
        };
        out.push(
            at_setting(&RULE, body, seen, &message)
                .key("vertices")
                .parts(seen.elements.iter().copied())
                .help("reduce the displacements that add up here: the sum exceeds a 32-bit float")
                .evidence(Evidence::counted(seen.count)),
        );
    }
    // What MakeHuman 1 makes of such a plane is not known.
    let flat = untold(body, measures, Trouble::FlatPlane).filter(|_| !body.is_makehuman1());
    if let Some(seen) = flat.filter(|seen| !is_flat_at_rest(measures, &seen.name)) {
        let message = format!(
            "the rotation plane of bone `{}` has no normal: its three joints are on one straight \
                line",
            seen.name
        );
        out.push(
            at_setting(&RULE, body, seen, &message)
                .key("planes")
                .parts(&seen.all)
                .help(
                    "move the joint cubes together with the limb, so that the three joints keep \
                    an angle",
                )
                .evidence(Evidence::counted(1).with_worst(1.0 / seen.value, "sine of the angle")),
        );
    }
}

/// A plane that has no normal at rest is reported with its skeleton.
fn is_flat_at_rest(measures: &Measures, bone: &str) -> bool {
    let bones = measures
        .skeletons
        .iter()
        .flat_map(|skeleton| &skeleton.bones);
    bones
        .filter(|known| known.name == bone)
        .any(|known| known.plane_sine.is_some_and(|sine| !(sine > PARALLEL_SINE)))
}
