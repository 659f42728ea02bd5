//! Only one bone of a skeleton may be without parent.

use super::super::{Check, Rule, RuleCx};
use super::hierarchy::hierarchy;
use super::rigs;
use mhlint_diag::{Application::Makehuman2, Evidence, Finding, Level, Place, RuleInfo};
use mhlint_repo::Body;

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[(Makehuman2, "rejects the skeleton and logs a line")],
    docs: include_str!("multiple_roots.md").trim_ascii_end(),
    counts: "bones",
    ..RuleInfo::new(
        "skeleton-multiple-roots",
        Level::Error,
        "more than one bone of a skeleton has no parent",
    )
});

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for rig in rigs(body) {
        let roots = hierarchy(rig.skeleton).roots;
        let [first, second, ..] = roots.as_slice() else {
            continue;
        };
        let message = match roots.len() {
            2 => format!("2 bones have no parent: `{first}` and `{second}`"),
            count => {
                format!(
                    "{count} bones have no parent: `{first}`, `{second}` and {} more",
                    count.saturating_sub(2)
                )
            }
        };
        out.push(
            RULE.at(rig.file, Place::pointer(["bones", second]), message)
                .help("keep one root, and give every other bone a parent")
                .related(
                    rig.file.path.clone(),
                    Place::pointer(["bones", first]),
                    "the first root",
                )
                .evidence(Evidence::of_cases(&roots).out_of(rig.skeleton.bones.len())),
        );
    }
}
