//! A bone that has no length at some setting.

use super::super::{Check, Rule, RuleCx};
use super::{at_setting, untold};
use crate::diag::{Application, Evidence, Finding, Level, RuleInfo};
use crate::eval::measures::Measures;
use crate::repo::Body;

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        breaks: &[(
            Application::Makehuman2,
            "divides by zero: the rest matrix is not a number, and in pose mode the skin of the bone vanishes",
        )],
        docs: "At some setting of the sliders the head and the tail of a bone come to lie on one point (closer than 0.0001 \
            decimetres; the shortest bone that MakeHuman's own base has at any setting is 0.026).\n\nJoints are the means of \
            their vertices on the morphed mesh, and MakeHuman 2 computes them anew after every change. A target that \
            moves one joint cube onto another removes the bone between them. The finding stands at that target; let it \
            move the joint cubes with the limb.\n\nA bone without length on the default character is \
            `skeleton-zero-length-bone`.",
        ..RuleInfo::new("numeric-zero-length-bone", Level::Error, "a bone that collapses at some slider setting")
    },
    check: Check::Numeric(run),
};

fn run(body: &Body<'_>, measures: &Measures, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some(space) = &measures.space else { return };
    let Some(seen) = untold(body, space, space.short_bone.as_ref()) else { return };
    let length = 1.0 / seen.value;
    let message = format!("bone `{}` has no length ({length:.6})", seen.name);
    out.push(
        at_setting(&RULE, body, seen, &message)
            .parts(&seen.all)
            .help("let the target move the joint cubes at both ends with the limb")
            .evidence(Evidence::counted(1).with_worst(length, &*seen.name)),
    );
}
