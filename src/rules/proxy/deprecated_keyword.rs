//! Bone weights have a file of their own.

use super::super::{Check, Rule, RuleCx};
use super::texts;
use crate::diag::{
    Application::{Makehuman1, Makehuman2},
    Finding, Level, Place, RuleInfo,
};
use crate::formats::mhclo::FaultKind;
use crate::repo::Body;

pub(in crate::rules) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[
        (Makehuman2, "refuses the asset with a message"),
        (Makehuman1, "reads the weights and does not use them"),
    ],
    levels: &[(Makehuman1, Level::Info)],
    docs: "The asset has a `weights` section, as very old versions of MakeHuman wrote it.\n\n\
        MakeHuman 2 refuses the whole asset; MakeHuman 1 reads the section and takes the weights from the body. Bone weights are in a file of their own, named with \
        `vertexboneweights_file`; without one they are taken from the body.\n\n\
        Remove all `weights` sections, or export the asset again.",
    ..RuleInfo::new("proxy-deprecated-keyword", Level::Error, "an asset with a section that is no longer read")
});

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for text in texts(body) {
        let old = text.clothes.faults.of(|kind| kind == FaultKind::OldFormat);
        let Some(first) = old.and_then(|(faults, _)| faults.first()) else { continue };
        let message = "`weights` belongs to an old format that is no longer read";
        let finding = RULE.at(text.file, Place::Span(first.span.clone()), message);
        out.push(finding.help("keep a copy; export the weights to a `.mhw` file for `vertexboneweights_file`, or remove the sections to use those of the body"));
    }
}
