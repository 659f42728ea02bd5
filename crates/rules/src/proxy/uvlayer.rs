//! `uvLayer` leads nowhere.

use super::super::{Check, Rule, RuleCx};
use super::texts;
use mhlint_diag::{Application::Makehuman1, Finding, Level, Place, RuleInfo};
use mhlint_repo::Body;

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[(
        Makehuman1,
        "logs a `NameError` each time the asset is loaded from the data of a user, and never uses \
            the layer",
    )],
    docs: include_str!("uvlayer.md").trim_ascii_end(),
    ..RuleInfo::new(
        "proxy-uvlayer",
        Level::Warning,
        "an asset with a layer of texture coordinates",
    )
});

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    // Of the data of the program no archives are made.
    if body.layers.checks_system() {
        return;
    }
    for text in texts(body) {
        let Some(entry) = text.reading.last("uvLayer") else {
            continue;
        };
        let finding = RULE.at(
            text.file,
            Place::Span(entry.keyword_span.clone()),
            "`uvLayer` is never used",
        );
        out.push(finding.help("remove the line"));
    }
}
