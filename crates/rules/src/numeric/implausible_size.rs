//! A body is as large as something that walks on two legs.

use super::super::units::centimetres;
use super::super::{Check, Rule, RuleCx};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2},
    Confidence, Evidence, Finding, Grows, Level, MeasureKind, Place, RuleInfo,
};
use mhlint_repo::Body;
use mhlint_repo::extent::{LARGEST, SMALLEST, implausible};

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[
        (
            Makehuman2,
            "shows a body of this size without a message; targets, clothes and poses do not fit it",
        ),
        (
            Makehuman1,
            "shows a body of this size without a message; targets, clothes and poses do not fit it",
        ),
    ],
    docs: include_str!("implausible_size.md").trim_ascii_end(),
    grows: Grows::more(MeasureKind::Factor),
    ..RuleInfo::new(
        "numeric-implausible-size",
        Level::Warning,
        "a body measures a few centimetres or many metres",
    )
});

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some(((file, _), extent)) = body.mesh.zip(implausible(body)) else {
        return;
    };
    let is_small = extent < LARGEST;
    let (length, help) = (centimetres(extent), if is_small { "10" } else { "0.1" });
    let times = if is_small {
        SMALLEST / extent
    } else {
        extent / LARGEST
    };
    let message =
        format!("the visible mesh measures {length:.1} cm ({extent:.3}) in its largest dimension");
    out.push(
        RULE.at(file, Place::File, message)
            .confidence(Confidence::Medium)
            .help(format!(
                "export the mesh in decimetres, probably with scale {help}, in the same \
                vertex order; until then nothing is measured on it"
            ))
            .evidence(
                Evidence::of_unnamed([format!("{length:.1} cm")])
                    .with_worst(times.into(), "visible groups"),
            ),
    );
}
