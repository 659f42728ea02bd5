//! The numbers of a pose must be finite.

use super::super::{Check, Rule, RuleCx, counted};
use crate::diag::{Application::Makehuman2, Finding, Level, Place, RuleInfo};
use crate::repo::Body;

pub(in crate::rules) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[(Makehuman2, "shows a torn mesh in this pose; the glTF export with animation crashes with `ValueError`")],
    docs: "A frame of a BVH file has NaN or infinity as a number.\n\n\
        MakeHuman 2 reads it as an angle. The bone and all below it lose their places, and with them the vertices that \
        they move. The glTF export with animation crashes.\n\n\
        Export the motion again, or replace the number.",
    ..RuleInfo::new("pose-non-finite", Level::Error, "a pose has NaN or infinity")
});

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for (file, motion) in &body.motions {
        let Some(line) = motion.non_finite.first.first() else { continue };
        let message = match motion.non_finite.count {
            1 => "a frame has NaN or infinity".to_owned(),
            count => format!("{} have NaN or infinity", counted(count, "frame")),
        };
        let evidence = motion.non_finite.evidence();
        let finding = RULE.at(file, Place::Line(*line), message).evidence(evidence);
        out.push(finding.help("export the motion again, or replace the number"));
    }
}
