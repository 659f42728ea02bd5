//! What the loader makes a number of is one.

use super::super::{Check, Rule, RuleCx};
use super::rigs;
use mhlint_diag::{Application::Makehuman1, Finding, Level, Place, RuleInfo};
use mhlint_repo::Body;

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[(
        Makehuman1,
        "fails with `ValueError` when the skeleton is chosen",
    )],
    docs: include_str!("version.md").trim_ascii_end(),
    ..RuleInfo::new(
        "skeleton-version",
        Level::Error,
        "a text in place of a number",
    )
});

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    if !body.is_makehuman1() {
        return;
    }
    for rig in rigs(body) {
        for (key, text) in &rig.skeleton.texts_for_numbers {
            let message = format!("`{key}` is `{text}`, expected a whole number");
            out.push(
                RULE.at(rig.file, Place::pointer([*key]), message)
                    .key(*key)
                    .help("write a whole number"),
            );
        }
    }
}
