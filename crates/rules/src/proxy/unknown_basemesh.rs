//! The base mesh that an asset names is the one that it lies with.

use super::super::{Check, Rule, RuleCx, shown};
use super::texts;
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2},
    Finding, Level, Place, RuleInfo,
};
use mhlint_repo::Body;

const EFFECT: &str = "ignores the line and puts the asset on";

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[(Makehuman2, EFFECT), (Makehuman1, EFFECT)],
    docs: include_str!("unknown_basemesh.md").trim_ascii_end(),
    ..RuleInfo::new(
        "proxy-unknown-basemesh",
        Level::Info,
        "an asset that names another base mesh",
    )
});

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    // In a folder that is none of a base mesh that is told.
    if body.mesh.is_none() {
        return;
    }
    for text in texts(body) {
        // What then does not fit is the finding.
        if text.other_base().is_none() || text.is_foreign(body) || text.is_foreign_by_scale(body) {
            continue;
        }
        let base = text.worn.base;
        let Some(entry) = text.reading.last("basemesh") else {
            continue;
        };
        let named = shown(entry.word());
        let message = format!("`basemesh {named}`, but the asset is one of `{base}`");
        let finding = RULE
            .at(text.file, Place::Span(entry.word_span()), message)
            .key(named);
        out.push(finding.help(format!(
            "if it fits, write `basemesh {base}`; otherwise export it again for `{base}`"
        )));
    }
}
