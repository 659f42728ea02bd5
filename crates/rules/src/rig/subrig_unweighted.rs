//! A sub-rig moves at least a part of its asset.

use super::super::{Check, Rule, RuleCx};
use super::has_asset;
use mhlint_diag::{Application::Mpfb, Case, Finding, Level, Place, RuleInfo};
use mhlint_repo::FileFacts;
use mhlint_repo::mpfb::{RigPart, View};
use mhlint_source::parent;

pub(crate) static RULE: Rule = Check::Mpfb(run).rule(RuleInfo {
    breaks: &[(Mpfb, "adds the sub-rig, which moves nothing")],
    docs: include_str!("subrig_unweighted.md").trim_ascii_end(),
    ..RuleInfo::new(
        "rig-subrig-unweighted",
        Level::Warning,
        "a sub-rig whose asset has no weights for it",
    )
});

const NEVER_READ: Case = &[(Mpfb, Level::Warning, "never reads the sub-rig")];

const MASK: &str = "mhmask-subrig";

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for (file, rig) in view
        .own_rigs()
        .filter(|(file, _)| file.part == RigPart::Asset)
    {
        let prefix = format!("{}/{}.", parent(&file.file.rel), file.file.stem());
        let stem = file.file.stem();
        if !has_asset(file) {
            let message = format!("there is no asset `{stem}.mhclo` beside the sub-rig");
            let finding = RULE
                .at(file.file, Place::File, message)
                .key("asset")
                .case(NEVER_READ);
            out.push(finding.help("give the sub-rig the name of its asset"));
            continue;
        }
        let weights: Vec<&FileFacts> = file
            .layer
            .beginning_with(prefix)
            .filter(|other| other.file_name().ends_with(".mhw"))
            .collect();
        // Weights that cannot be read are reported by another rule.
        let is_unread = weights.iter().any(|weights| weights.weights().is_none());
        let has_mask = |weights: &&FileFacts| {
            let bones = weights
                .weights()
                .map(|weights| weights.bones.as_slice())
                .unwrap_or_default();
            bones
                .iter()
                .any(|bone| bone.name == MASK && bone.listed > 0)
        };
        if is_unread || rig.bones.is_empty() || weights.iter().any(has_mask) {
            continue;
        }
        let message = match weights.first() {
            None => format!(
                "the asset has no weights with the group `{MASK}`: there is no `{}.mhw`",
                file.file.stem()
            ),
            Some(weights) => format!(
                "`{}` has no weights in the group `{MASK}`",
                weights.file_name()
            ),
        };
        out.push(RULE.at(file.file, Place::File, message).help(format!(
            "add `{MASK}` to `{}.mhw`, with the vertices that the sub-rig moves",
            file.file.stem()
        )));
    }
}
