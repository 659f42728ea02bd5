//! `uvLayer` leads nowhere.

use super::super::{Check, Rule, RuleCx};
use super::texts;
use mhlint_diag::{Application::Makehuman1, Finding, Level, Place, RuleInfo};
use mhlint_repo::Body;

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[(Makehuman1, "logs a `NameError` each time the asset is loaded from the data of a user, and never uses the layer")],
    docs: "An asset names a map of texture coordinates with `uvLayer`.\n\n\
        MakeHuman 1 keeps the name and never uses it. In the data of a user it compiles an asset when it is put on; with \
        this line that fails each time, so that the asset is loaded from its text each time.\n\n\
        Remove the line; name a map in `uvMap` of the material if it is needed.",
    ..RuleInfo::new("proxy-uvlayer", Level::Warning, "an asset with a layer of texture coordinates")
});

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    // Of the data of the program no archives are made.
    if body.layers.checks_system() {
        return;
    }
    for text in texts(body) {
        let Some(entry) = text.last("uvLayer") else { continue };
        let finding = RULE.at(text.file, Place::Span(entry.keyword_span.clone()), "`uvLayer` is never used");
        out.push(finding.help("remove the line"));
    }
}
