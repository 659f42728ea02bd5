//! A skeleton has another name than the base skeleton.

use super::super::{Check, Rule, RuleCx};
use super::rigs;
use mhlint_diag::{Application::Makehuman1, Finding, Level, Place, RuleInfo};
use mhlint_repo::Body;

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[(
        Makehuman1,
        "takes it for the base skeleton: its references are ignored, and exports have the weights \
            of that",
    )],
    docs: include_str!("base_name.md").trim_ascii_end(),
    of_whole: true,
    ..RuleInfo::new(
        "skeleton-base-name",
        Level::Warning,
        "a skeleton with the name of the base \
        skeleton",
    )
});

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let base = body
        .default_rig()
        .and_then(|rig| rig.skeleton()?.name.as_deref());
    let Some(base) = base.filter(|_| body.is_makehuman1()) else {
        return;
    };
    for rig in
        rigs(body).filter(|rig| !rig.own.is_default && rig.skeleton.name.as_deref() == Some(base))
    {
        let finding = RULE.at(
            rig.file,
            Place::pointer(["name"]),
            format!("`{base}` is the name of the base skeleton"),
        );
        out.push(finding.help("give the skeleton a name of its own"));
    }
}
