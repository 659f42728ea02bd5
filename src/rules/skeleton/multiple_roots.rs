//! Only one bone of a skeleton may be without parent.

use super::super::{Check, Rule, RuleCx};
use super::hierarchy::hierarchy;
use super::rigs;
use crate::diag::{Application, Evidence, Finding, Level, Place, RuleInfo};
use crate::repo::Body;

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        breaks: &[(Application::Makehuman2, "refuses the skeleton with a line in its log")],
        docs: "A skeleton of MakeHuman 2 has exactly one bone without parent. A second one, even if it is a \
            forgotten `parent`, makes it refuse the whole skeleton. (MakeHuman 1 takes several roots.)\n\nGive \
            every bone but one a parent; an unattached bone can hang on the root.",
        ..RuleInfo::new("skeleton-multiple-roots", Level::Error, "more than one bone of a skeleton has no parent")
    },
    check: Check::Body(run),
};

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for rig in rigs(body) {
        let roots = hierarchy(rig.skeleton).roots;
        let [first, second, ..] = roots.as_slice() else { continue };
        let message = format!(
            "{} bones have no parent: `{first}`, `{second}`{}",
            roots.len(),
            if roots.len() > 2 { " …" } else { "" }
        );
        out.push(
            RULE.at(rig.file, Place::pointer(["bones", second]), message)
                .help("name a parent for every bone but one")
                .related(rig.file.path.clone(), Place::pointer(["bones", first]), "the first root")
                .evidence(Evidence::of_cases(&roots).out_of(rig.skeleton.bones.len())),
        );
    }
}
