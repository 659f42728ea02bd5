//! Texture coordinates must be complete in a group.

use super::super::{Check, Rule, RuleCx};
use super::{ASSET_INDEX, read};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2},
    Evidence, Finding, Level, Place, RuleInfo,
};
use mhlint_repo::{FileFacts, View};

pub(crate) static RULE: Rule = Check::File(run).rule(RuleInfo {
    breaks: &[
        (
            Makehuman2,
            "crashes with `IndexError` while loading the base mesh",
        ),
        (
            Makehuman1,
            "shows one colour of each texture on these faces",
        ),
    ],
    levels: &[(Makehuman1, Level::Warning)],
    docs: include_str!("partial_uv.md").trim_ascii_end(),
    counts: "faces",
    ..RuleInfo::new(
        "mesh-partial-uv",
        Level::Error,
        "a group has faces with and without texture coordinates",
    )
});

fn run(view: &View<'_>, file: &FileFacts, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some(mesh) = read(view, file) else { return };
    for group in &mesh.facts.partial_uv {
        let message = format!(
            "group `{}` has no texture coordinates on {} of {} faces",
            group.name, group.without, group.faces
        );
        let evidence = Evidence::counted(group.without);
        let finding = RULE
            .at(file, Place::Line(group.line), message)
            .key(&group.name)
            .help(
                "unwrap only these faces and keep the other texture coordinates; do not reorder \
                the faces",
            )
            .evidence(evidence.out_of(group.faces));
        out.push(mesh.weigh(view, file, finding, ASSET_INDEX));
    }
}
