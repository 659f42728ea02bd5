//! One bone of a skeleton must be its root.

use super::super::{Check, Rule, RuleCx};
use super::hierarchy::hierarchy;
use super::rigs;
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2},
    Evidence, Finding, Level, Place, RuleInfo,
};
use mhlint_formats::mhskel::Section;
use mhlint_repo::Body;

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[
        (Makehuman2, "rejects the skeleton and logs a line"),
        (
            Makehuman1,
            "fails with `IndexError` when the skeleton is chosen",
        ),
    ],
    docs: include_str!("no_root.md").trim_ascii_end(),
    counts: "bones",
    ..RuleInfo::new(
        "skeleton-no-root",
        Level::Error,
        "no bone of a skeleton is the root",
    )
});

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for rig in rigs(body) {
        let hierarchy = hierarchy(rig.skeleton);
        if rig.skeleton.bones_section != Section::Present
            || rig.file.json.falsy
            || !hierarchy.lacks_root()
        {
            continue;
        }
        let place = Place::pointer(["bones"]);
        let Some(ring) = hierarchy.rings.first() else {
            out.push(
                RULE.at(rig.file, place, "the skeleton has no bones")
                    .help("add at least the root bone"),
            );
            continue;
        };
        let bones = rig.skeleton.bones.len();
        let message = format!(
            "none of the {bones} bones is the root: the parents of `{}` form a cycle",
            ring.bones.first().unwrap_or(&"")
        );
        out.push(
            RULE.at(rig.file, place, message)
                .help("set `parent` of the bone that carries all others to null")
                .evidence(Evidence::of_cases(&ring.bones).out_of(bones)),
        );
    }
}
