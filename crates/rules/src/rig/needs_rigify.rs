//! Rigs that work without Rigify do not ask for it.

use super::super::{Check, Rule, RuleCx, such};
use super::subject;
use mhlint_diag::{Application::Mpfb, Case, Evidence, Finding, Level, Place, RuleInfo};
use mhlint_repo::mpfb::{RigPart, View};

pub(crate) static RULE: Rule = Check::Mpfb(run).rule(RuleInfo {
    breaks: &[(
        Mpfb,
        "fails with an exception when the rig is added, unless the Rigify add-on is enabled",
    )],
    docs: include_str!("needs_rigify.md").trim_ascii_end(),
    ..RuleInfo::new(
        "rig-needs-rigify",
        Level::Warning,
        "a rig that cannot be made while Rigify is off",
    )
});

const OF_ASSET: Case = &[(
    Mpfb,
    Level::Warning,
    "fails with an exception when the asset is added to any rig, unless the Rigify add-on is \
        enabled",
)];

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for (file, rig) in view
        .own_rigs()
        .filter(|(file, _)| file.part != RigPart::Rigify)
    {
        let needs = &rig.faults.needs_rigify;
        let Some(first) = needs.first() else { continue };
        let message = format!(
            "{} is for Rigify{}",
            subject(first),
            such(needs.len(), "keys")
        );
        let finding = RULE.at(file.file, Place::Pointer(first.clone()), message);
        let finding = finding.help("remove what is for Rigify, or say that the rig needs it");
        let finding = finding.evidence(Evidence::of_cases(needs));
        out.push(if file.part == RigPart::Asset {
            finding.case(OF_ASSET)
        } else {
            finding
        });
    }
}
