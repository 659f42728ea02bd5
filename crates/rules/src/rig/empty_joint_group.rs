//! Each joint of the base mesh has vertices.

use super::super::{Check, Rule, RuleCx, such};
use mhlint_diag::{Application::Mpfb, Evidence, Finding, Level, Place, RuleInfo};
use mhlint_discover::Kind;
use mhlint_repo::mpfb::View;

pub(crate) static RULE: Rule = Check::Mpfb(run).rule(RuleInfo {
    breaks: &[(
        Mpfb,
        "fails with an exception when any rig is added, whether it uses the joint or not",
    )],
    docs: include_str!("empty_joint_group.md").trim_ascii_end(),
    counts: "groups",
    ..RuleInfo::new(
        "rig-empty-joint-group",
        Level::Error,
        "a joint of the base mesh has no vertex",
    )
});

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let sound = view
        .mesh
        .filter(|(_, mesh)| mesh.facts.unreadable_lines == 0 && mesh.facts.vertices > 0);
    let vertices = sound.and_then(|(_, mesh)| i64::try_from(mesh.facts.vertices).ok());
    for file in view.own(Kind::VertexGroups) {
        let Some(groups) = file
            .vertex_groups()
            .filter(|groups| groups.stops.all().is_empty())
        else {
            continue;
        };
        let joints = groups
            .groups
            .iter()
            .filter(|group| group.name.contains("joint"));
        let empty: Vec<&str> = joints
            .filter(|joint| joint.is_empty(vertices))
            .map(|joint| joint.name.as_str())
            .collect();
        let Some(first) = empty.first() else { continue };
        let message = format!(
            "joint `{first}` has no vertex{}",
            such(empty.len(), "joints")
        );
        let finding = RULE
            .at(file, Place::pointer([first]), message)
            .help("write the vertices of its cube");
        out.push(finding.evidence(Evidence::of_cases(&empty)));
    }
}
