//! A joint needs vertices.

use super::super::{Check, Rule, RuleCx};
use super::rigs;
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2},
    Case, Finding, Level, Place, RuleInfo,
};
use mhlint_repo::Body;

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[
        (
            Makehuman2,
            "drops the joint, then crashes with `KeyError` at the first bone that needs it",
        ),
        (Makehuman1, AT_ORIGIN),
    ],
    levels: &[(Makehuman1, Level::Warning)],
    docs: include_str!("empty_joint.md").trim_ascii_end(),
    ..RuleInfo::new(
        "skeleton-empty-joint",
        Level::Error,
        "a joint lists no vertices",
    )
});

const AT_ORIGIN: &str = "puts the end of the bone at the origin, with a line in the log";
const UNNEEDED: &str = "silently drops the joint; no bone needs it";
const NOT_NEEDED: Case = &[
    (Makehuman2, Level::Info, UNNEEDED),
    (Makehuman1, Level::Info, UNNEEDED),
];

const STOPS: Case = &[(
    Makehuman2,
    Level::Error,
    "crashes with `KeyError` at the first bone that needs the joint,",
)];

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for rig in rigs(body) {
        let asked = rig.asked_joints();
        for joint in rig.skeleton.joints.iter().filter(|joint| joint.listed == 0) {
            let what = if joint.vertices.is_some() {
                "lists no vertices"
            } else {
                "is not a list of vertices"
            };
            let place = Place::pointer(["joints", &joint.name]);
            let finding = RULE
                .at(rig.file, place, format!("joint `{}` {what}", joint.name))
                .key(&joint.name)
                .help("list the base-mesh vertices whose mean is the joint, or remove the joint");
            out.push(if asked.contains(joint.name.as_str()) {
                rig.stops_with(STOPS, finding)
            } else {
                finding.case(NOT_NEEDED)
            });
        }
    }
}
