//! A bone that has no length at some setting.

use super::super::units::centimetres;
use super::super::{Check, Rule, RuleCx};
use super::{at_setting, untold};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2},
    Evidence, Finding, Grows, Level, MeasureKind, RuleInfo,
};
use mhlint_eval::measures::Measures;
use mhlint_eval::survey::Trouble;
use mhlint_repo::Body;

pub(crate) static RULE: Rule = Check::Numeric(run).rule(RuleInfo {
    breaks: &[
        (
            Makehuman2,
            "divides by zero: the rest matrix is not a number, and in pose mode the skin of the \
                bone disappears",
        ),
        (
            Makehuman1,
            "fails with `LinAlgError` when the pose changes, if a bone lies below this \
            one",
        ),
    ],
    docs: include_str!("zero_length_bone.md").trim_ascii_end(),
    grows: Grows::less(MeasureKind::Length),
    ..RuleInfo::new(
        "numeric-zero-length-bone",
        Level::Error,
        "a bone has no length at some \
        slider setting",
    )
});

fn run(body: &Body<'_>, measures: &Measures, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some(seen) = untold(body, measures, Trouble::ShortBone) else {
        return;
    };
    let length = 1.0 / seen.value;
    let cm = centimetres(length);
    // What is shown of a length that is not quite 0 has to differ from 0.
    let message = match format!("{cm:.5}").as_str() {
        "0.00000" => format!("bone `{}` has no length", seen.name),
        cm => format!("bone `{}` has no length: {cm} cm", seen.name),
    };
    out.push(
        at_setting(&RULE, body, seen, &message)
            .parts(&seen.all)
            .help("move the joint cubes at both ends together with the limb")
            .evidence(Evidence::counted(1).with_worst(length, &*seen.name)),
    );
}
