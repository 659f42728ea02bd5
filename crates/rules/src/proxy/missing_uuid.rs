//! An asset has an identity.

use super::super::cause::library::empty_uuid;
use super::super::{Check, Rule, RuleCx};
use super::{Text, blender, missing::missing, texts};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2, Mpfb},
    Case, Finding, Level, RuleInfo,
};
use mhlint_repo::Body;

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[
        (
            Makehuman2,
            "crashes with `IndexError` when a model saved with the asset is loaded",
        ),
        (
            Makehuman1,
            "fails with `TypeError` when the asset is put on beside another one, and \
            saved models lose it",
        ),
        (
            Mpfb,
            "does not save which material the asset has; models that know it by its uuid lose \
            it",
        ),
    ],
    levels: &[(Mpfb, Level::Warning)],
    docs: include_str!("missing_uuid.md").trim_ascii_end(),
    ..RuleInfo::new("proxy-missing-uuid", Level::Error, "an asset has no uuid")
});

const TOPOLOGY: Case = &[(Makehuman1, Level::Info, "puts the topology on all the same")];
const SINGLE: Case = &[(
    Makehuman1,
    Level::Error,
    "does not put on a second asset without a uuid, and saved models lose both",
)];

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    if body.is_mpfb() {
        return blender::names::known_by(&RULE, body, "uuid", out);
    }
    for text in texts(body) {
        // An empty line is worse in MakeHuman 1, and has a finding of its own.
        let is_lost = || text.reading.last("uuid").is_none() && empty_uuid(text.clothes).is_none();
        let is_missing = if text.is_makehuman1() {
            is_lost()
        } else {
            text.clothes.scanned.uuid.is_none()
        };
        if is_missing {
            let told = missing(
                &text,
                "uuid",
                "uuid: that of earlier versions, or a new one from a generator",
            );
            let told =
                told.map(|(place, message, help)| RULE.at(text.file, place, message).help(help));
            out.extend(told.map(|finding| match known_by(&text) {
                Some(case) => finding.case(case),
                None => finding,
            }));
        }
    }
}

/// What else becomes of an asset of which one alone is worn.
fn known_by(text: &Text<'_, '_>) -> Option<Case> {
    if text.worn.is_topology() {
        return Some(TOPOLOGY);
    }
    (!text.file.rel.starts_with("clothes/")).then_some(SINGLE)
}
