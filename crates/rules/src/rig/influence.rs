//! The influence of a constraint is a share.

use super::super::{Check, Rule, RuleCx, such};
use super::at_bones;
use mhlint_diag::{Application::Mpfb, Finding, Level, Place, RuleInfo};
use mhlint_repo::mpfb::View;

pub(crate) static RULE: Rule = Check::Mpfb(run).rule(RuleInfo {
    breaks: &[(Mpfb, "silently takes the nearest of 0 and 1")],
    docs: include_str!("influence.md").trim_ascii_end(),
    counts: "bones",
    ..RuleInfo::new(
        "rig-influence",
        Level::Warning,
        "the influence of a constraint is not between 0 and 1",
    )
});

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for (file, rig) in view.own_rigs() {
        let bound = rig
            .bones
            .iter()
            .flat_map(|bone| bone.constraints.iter().map(move |one| (bone, one)));
        let given = bound.filter_map(|(bone, one)| Some((bone, one, one.influence?)));
        let beyond: Vec<_> = given
            .filter(|(_, _, influence)| !(0.0..=1.0).contains(influence))
            .collect();
        let Some((bone, one, influence)) = beyond.first() else {
            continue;
        };
        let more = such(beyond.len(), "constraints");
        let message = format!(
            "{} of bone `{}` has the influence {influence}, outside 0 to 1{more}",
            one.kind, bone.name
        );
        let bones: Vec<&str> = beyond.iter().map(|(bone, ..)| bone.name.as_str()).collect();
        let finding = at_bones(&RULE, file, rig, &bones, "constraints", message);
        out.extend(finding.map(|finding| {
            let finding = finding.help("write a number from 0 to 1");
            match beyond.get(1) {
                Some((_, other, _)) => finding.related(
                    file.file.path.clone(),
                    Place::Pointer(other.pointer.clone()),
                    "so has this one",
                ),
                None => finding,
            }
        }));
    }
}
