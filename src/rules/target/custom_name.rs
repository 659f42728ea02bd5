//! Saved models find the user's own targets.

use super::super::{Check, Rule, RuleCx};
use crate::diag::{Application::Makehuman1, Finding, Level, Place, RuleInfo};
use crate::repo::makehuman1::View;

pub(in crate::rules) static RULE: Rule = Check::Makehuman1(run).rule(RuleInfo {
    breaks: &[(Makehuman1, "loses the value of the slider in saved models")],
    docs: "A target in `custom` of the user has a slider, and saved models name it by its path. A model separates words by \
        blanks: of `custom/grow tall` it reads `custom/grow`, and the value is lost with a warning in the log. Where that \
        target exists, too, the line fails.\n\nRename the file without blanks.",
    ..RuleInfo::new("target-custom-name", Level::Warning, "a blank in the name of a user's target")
});

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for one in view.targets.custom.iter().filter(|one| view.layers.is_checked(one.file)) {
        if !one.name.contains(char::is_whitespace) {
            continue;
        }
        let message = format!("`{}` has a blank in its name", one.name);
        out.push(
            RULE.at(one.file, Place::File, message).help(format!("rename it to `{}`", dashed(one.file.file_name()))),
        );
    }
}

fn dashed(name: &str) -> String {
    name.split_whitespace().collect::<Vec<_>>().join("-")
}
