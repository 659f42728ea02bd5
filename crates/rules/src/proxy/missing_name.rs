//! An asset has a name.

use super::super::{Check, Rule, RuleCx};
use super::{blender, missing::missing, texts};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2, Mpfb},
    Finding, Level, RuleInfo,
};
use mhlint_repo::Body;

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[
        (
            Makehuman2,
            "lists the asset without a name, and models lose it",
        ),
        (Makehuman1, "lists the asset under the name of its file"),
        (Mpfb, "lists the asset under the name of its file"),
    ],
    levels: &[(Makehuman1, Level::Info), (Mpfb, Level::Info)],
    docs: include_str!("missing_name.md").trim_ascii_end(),
    ..RuleInfo::new("proxy-missing-name", Level::Error, "an asset has no name")
});

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    if body.is_mpfb() {
        return blender::names::known_by(&RULE, body, "name", out);
    }
    for text in texts(body) {
        let is_missing = if text.is_makehuman1() {
            text.reading.last("name").is_none()
        } else {
            text.clothes.scanned.name.is_none()
        };
        if is_missing {
            out.extend(
                missing(&text, "name", "name")
                    .map(|(place, message, help)| RULE.at(text.file, place, message).help(help)),
            );
        }
    }
}
