//! References must be relative.

use super::super::{Check, Rule, RuleCx};
use super::named::causes;
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2, Mpfb},
    Finding, Level, RuleInfo,
};
use mhlint_repo::{Resolution, View};

pub(crate) static RULE: Rule = Check::Repository(run).rule(RuleInfo {
    breaks: &[
        (Makehuman2, "does not find the file on other computers"),
        (Makehuman1, "does not find the file on other computers"),
        (Mpfb, "does not find the file on other computers"),
    ],
    docs: include_str!("absolute_path.md").trim_ascii_end(),
    counts: "references",
    ..RuleInfo::new(
        "file-absolute-path",
        Level::Error,
        "a reference with an absolute path or a drive letter",
    )
});

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let is_absolute = |resolution| matches!(resolution, Resolution::Absolute);
    for cause in causes(view, |reference| {
        is_absolute(reference.resolution).then(String::new)
    }) {
        let finding = cause.finding(&RULE, |text| match text {
            "" => "`folder` is empty, which makes every name in it an absolute path".to_owned(),
            text => format!("`{text}` is an absolute path"),
        });
        let finding = finding.map(|finding| cause.unfound(view, finding, "on other computers"));
        out.extend(finding.map(|finding| {
            finding.help(
                "copy the file into the data unless it is in it, and write its path \
                relative to its folder",
            )
        }));
    }
}
