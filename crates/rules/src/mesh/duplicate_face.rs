//! A face stands once in a mesh.

use super::super::{Check, Rule, RuleCx, counted};
use super::of_asset;
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2},
    Evidence, Finding, Level, Place, RuleInfo,
};
use mhlint_repo::{FileFacts, View};

pub(crate) static RULE: Rule = Check::File(run).rule(RuleInfo {
    breaks: &[
        (
            Makehuman2,
            "draws the face twice, in the same place, and exports both",
        ),
        (
            Makehuman1,
            "draws the face twice, in the same place, and exports both",
        ),
    ],
    docs: include_str!("duplicate_face.md").trim_ascii_end(),
    counts: "faces",
    ..RuleInfo::new(
        "mesh-duplicate-face",
        Level::Warning,
        "two faces with the same vertices",
    )
});

fn run(view: &View<'_>, file: &FileFacts, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some(mesh) = of_asset(view, file).filter(|mesh| mesh.repeated > 0 && mesh.is_sound())
    else {
        return;
    };
    let faces = counted(mesh.repeated, "face");
    let have = if mesh.repeated == 1 { "has" } else { "have" };
    let message = format!(
        "{faces} of {} {have} the vertices of an earlier one",
        mesh.faces
    );
    let finding = RULE
        .at(file, Place::File, message)
        .evidence(Evidence::counted(mesh.repeated).out_of(mesh.faces));
    out.push(finding.help("remove one of each two equal faces, and keep all vertices"));
}
