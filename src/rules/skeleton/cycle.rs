//! Parents must lead to the root, not in a circle.

use super::super::{Check, Rule, RuleCx};
use super::hierarchy::hierarchy;
use super::rigs;
use crate::diag::{Application, Evidence, Finding, Level, Place, RuleInfo};
use crate::repo::{Base, Repository};

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        breaks: &[(
            Application::Makehuman2,
            "drops these bones without a word; entering pose mode then stops with a KeyError, because the weights \
            mention them",
        )],
        docs: "MakeHuman 2 builds a skeleton from its root downwards. Bones that are each other's parents are never \
            reached: they are missing in the skeleton, without a message. If the weights mention one, entering \
            pose mode stops with a KeyError; otherwise (`warning`) the bones are just not there.\n\nGive one \
            bone of the circle a parent outside of it. Bones that hang below a circle are reported as \
            `skeleton-unreachable-bone`; a skeleton in which nothing but circles exists as `skeleton-no-root`.",
        ..RuleInfo::new("skeleton-cycle", Level::Error, "the parents of some bones run in a circle")
    },
    check: Check::Base(run),
};

fn run(repository: &Repository<'_>, base: &Base<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for rig in rigs(repository, base) {
        let hierarchy = hierarchy(rig.skeleton);
        if hierarchy.lacks_root() {
            continue;
        }
        let weighted = rig.weighted_bones();
        for ring in &hierarchy.rings {
            let Some(first) = ring.bones.first() else { continue };
            let message = match ring.bones.as_slice() {
                [only] => format!("bone `{only}` is its own parent"),
                bones => format!("the parents of `{first}` run in a circle of {} bones", bones.len()),
            };
            let finding = RULE
                .at(rig.file, Place::pointer(["bones", first, "parent"]), message)
                .key(*ring.bones.iter().min().unwrap_or(first))
                .help("give one bone of the circle a parent outside of it")
                .evidence(Evidence::of_cases(&ring.bones).out_of(rig.skeleton.bones.len()));
            out.push(if ring.bones.iter().any(|bone| weighted.contains(bone)) {
                finding
            } else {
                dropped_silently(finding)
            });
        }
    }
}

fn dropped_silently(finding: Finding) -> Finding {
    finding.level(Level::Warning).breaks(Application::Makehuman2, "drops these bones without a word")
}
