//! Every bone must be reachable from the root.

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
        docs: "A bone that is correct itself is lost when its parents lead into a circle (see `skeleton-cycle`, \
            which names the circle): MakeHuman 2 builds the skeleton from the root downwards and never comes \
            there.\n\nIf the weights mention a lost bone, entering pose mode stops with a KeyError; otherwise \
            (`warning`) the bones are just not there.\n\nMend the circle, or hang these bones somewhere else.",
        ..RuleInfo::new(
            "skeleton-unreachable-bone",
            Level::Error,
            "bones hang below a circle of parents, cut off from the root",
        )
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
            let (Some(first), Some(origin)) = (ring.below.first(), ring.bones.iter().min()) else { continue };
            let message = match ring.below.len() {
                1 => {
                    format!("bone `{first}` cannot be reached from the root: the parents of `{origin}` run in a circle")
                }
                count => {
                    format!("{count} bones cannot be reached from the root: the parents of `{origin}` run in a circle")
                }
            };
            let mut finding = RULE
                .at(rig.file, Place::pointer(["bones", first, "parent"]), message)
                .key(*origin)
                .help("mend the circle, or hang the bones on one that leads to the root")
                .related(rig.file.path.clone(), Place::pointer(["bones", origin, "parent"]), "part of the circle")
                .evidence(Evidence::of_cases(&ring.below).out_of(rig.skeleton.bones.len()));
            if !ring.below.iter().any(|bone| weighted.contains(bone)) {
                finding =
                    finding.level(Level::Warning).breaks(Application::Makehuman2, "drops these bones without a word");
            }
            out.push(finding);
        }
    }
}
