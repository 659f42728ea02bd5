//! Every joint of a motion has a name of its own.

use std::collections::BTreeMap;

use super::super::{Check, Rule, RuleCx};
use super::imported;
use mhlint_diag::{
    Application::{Makehuman2, Mpfb},
    Evidence, Finding, Level, Place, RuleInfo,
};
use mhlint_formats::bvh::Joint;
use mhlint_repo::Body;

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[
        (
            Makehuman2,
            "uses only the angles of the last joint of that name",
        ),
        (Mpfb, "uses only the angles of the last joint of that name"),
    ],
    docs: include_str!("duplicate_joint.md").trim_ascii_end(),
    ..RuleInfo::new(
        "bvh-duplicate-joint",
        Level::Warning,
        "two joints of a BVH file have the same name",
    )
});

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    imported::repeated_joints(&RULE, body, out);
    for (file, motion) in &body.motions {
        let mut first: BTreeMap<&str, &Joint> = BTreeMap::new();
        let mut again: Vec<(&Joint, &Joint)> = Vec::new();
        for joint in &motion.joints {
            match first.get(&*joint.name) {
                Some(before) => again.push((before, joint)),
                None => drop(first.insert(&joint.name, joint)),
            }
        }
        let Some((before, joint)) = again.first() else {
            continue;
        };
        let message = match again.len() {
            1 => format!("joint `{}` appears twice", joint.name),
            count => format!(
                "{count} joints have the name of an earlier one, first `{}`",
                joint.name
            ),
        };
        let evidence = Evidence::of_cases(again.iter().map(|(_, joint)| joint.name.to_string()));
        let finding = RULE.at(file, Place::Span(joint.span.clone()), message);
        let finding = finding.related(
            file.path.clone(),
            Place::Span(before.span.clone()),
            "the first joint of that name",
        );
        let help = "give every joint the name of its bone";
        out.push(
            finding
                .help(help)
                .evidence(evidence.out_of(motion.joints.len())),
        );
    }
}
