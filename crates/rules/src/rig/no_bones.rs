//! A rig has bones.

use super::super::{Check, Rule, RuleCx};
use mhlint_diag::{Application::Mpfb, Finding, Level, Place, RuleInfo};
use mhlint_repo::mpfb::View;

pub(crate) static RULE: Rule = Check::Mpfb(run).rule(RuleInfo {
    breaks: &[(Mpfb, "silently makes an empty armature")],
    docs: include_str!("no_bones.md").trim_ascii_end(),
    ..RuleInfo::new("rig-no-bones", Level::Warning, "a rig has no bone")
});

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let is_empty = |faults: &mhlint_formats::rig::RigFaults| {
        faults.layout.is_empty() && !faults.keys.all().iter().any(|one| one.pointer == "/bones")
    };
    for (file, _) in view
        .own_rigs()
        .filter(|(_, rig)| rig.bones.is_empty() && is_empty(&rig.faults))
    {
        out.push(
            RULE.at(file.file, Place::File, "the rig has no bone")
                .help("export the rig again from MPFB"),
        );
    }
}
