//! References must be relative.

use super::super::{Check, Rule, RuleCx};
use super::named::causes;
use crate::diag::{Application, Finding, Level, RuleInfo};
use crate::repo::{Resolution, View};

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        breaks: &[(Application::Makehuman2, "finds nothing there on any other computer")],
        docs: "The name begins with `/`, `\\` or a drive letter: it says where the file is on one computer. Names in assets are relative to a \
            folder of the data (targets and icons to the target folder, weights and skeletons to `rigs/<base>/`, models to \
            `base/<base>/`, textures to that of their material).\n\nOn every other computer the file is missing. Write the name relative to its folder.",
        ..RuleInfo::new("file-absolute-path", Level::Error, "a reference with an absolute path or a drive letter")
    },
    check: Check::Repository(run),
};

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let is_absolute = |resolution| matches!(resolution, Resolution::Absolute);
    for cause in causes(view, |reference| is_absolute(reference.resolution).then(String::new)) {
        let finding = cause.finding(&RULE, |text| match text {
            "" => "`folder` is empty, which makes an absolute path of every name behind it".to_owned(),
            text => format!("`{text}` is an absolute path"),
        });
        let finding = finding.map(|finding| cause.unfound(view, finding, "on other computers"));
        out.extend(finding.map(|finding| finding.help("write the name relative to its folder in the data")));
    }
}
