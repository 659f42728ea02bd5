//! A model has lines of models.

use super::super::{Check, Rule, RuleCx};
use super::own;
use crate::diag::{Application::Makehuman2, Finding, Level, Place, RuleInfo};
use crate::repo::makehuman2::{Base, View};

pub(in crate::rules) static RULE: Rule = Check::Makehuman2(run).rule(RuleInfo {
    breaks: &[(Makehuman2, "loads it as the naked default figure, without a message")],
    docs: "No line of a model (`.mhm`) begins with a keyword of models, such as `name`, `modifier`, `clothes` or \
        `skinMaterial`. The file is something else, such as a web page that was saved in place of a download, or a \
        character of another program.\n\n\
        MakeHuman 2 passes over all its lines and shows the default figure without clothes.\n\n\
        Restore the model, or remove the file.",
    ..RuleInfo::new("model-syntax", Level::Error, "a model without any line of models")
});

fn run(view: &View<'_>, base: &Base<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    // One without content, or in another encoding, has a finding of its own.
    let has_text = |encoding: &crate::source::Encoding| {
        !encoding.blank && !encoding.only_comments && !encoding.lfs_pointer && encoding.invalid_utf8_at.is_none()
    };
    for saved in own(view, base).filter(|saved| has_text(&saved.file.encoding) && !saved.model.has_keyword) {
        let finding = RULE.at(saved.file, Place::File, "no line begins with a keyword of models");
        out.push(finding.help("restore the model: this file is something else, such as a web page"));
    }
}
