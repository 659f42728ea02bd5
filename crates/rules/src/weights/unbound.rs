//! Weights should be used by a skeleton.

use super::super::{Check, Rule, RuleCx};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2, Mpfb},
    Finding, Level, Place, RuleInfo,
};
use mhlint_repo::{Body, BodyWeights, WeightsUse};

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[
        (Makehuman2, "never reads the file"),
        (Makehuman1, "never reads the file"),
        (Mpfb, "never reads the file"),
    ],
    docs: include_str!("unbound.md").trim_ascii_end(),
    ..RuleInfo::new(
        "weights-unbound",
        Level::Warning,
        "no skeleton uses a weights file",
    )
});

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    // What lies in no data folder may still get its skeleton.
    let unbound = body
        .own_weights()
        .filter(|own| own.used == WeightsUse::Unread && !own.file.is_loose);
    for BodyWeights { file, name, .. } in unbound {
        let message = format!("no skeleton of base `{}` uses these weights", body.name);
        let name = name.unwrap_or_default();
        let (message, help) = if body.is_mpfb() {
            (
                format!("no rig uses `{name}`"),
                "rename it after its rig, or keep it outside of the data".to_owned(),
            )
        } else {
            (
                message,
                format!(
                    "name `{name}` as `weights_file` of a skeleton, or keep the file outside of \
                        the data"
                ),
            )
        };
        out.push(RULE.at(file, Place::File, message).help(help));
    }
}
