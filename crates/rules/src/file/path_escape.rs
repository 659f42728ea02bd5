//! Nothing may lead out of the data root.

use super::super::{Check, Rule, RuleCx};
use super::named::causes;
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2},
    Finding, Level, RuleInfo,
};
use mhlint_repo::{Resolution, View};
use mhlint_source::WalkFaultKind;

pub(crate) static RULE: Rule = Check::Repository(run).rule(RuleInfo {
    cannot_be_ignored: true,
    breaks: &[
        (
            Makehuman2,
            "opens a file outside the data folder, or finds none on another computer",
        ),
        (
            Makehuman1,
            "opens a file outside the data folder, or finds none on another computer",
        ),
    ],
    docs: include_str!("path_escape.md").trim_ascii_end(),
    counts: "references",
    ..RuleInfo::new(
        "file-path-escape",
        Level::Error,
        "a reference or link that leaves the data root",
    )
});

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let leaves = |resolution| matches!(resolution, Resolution::Escapes);
    for cause in causes(view, |reference| {
        leaves(reference.resolution).then(String::new)
    }) {
        let finding = cause.finding(&RULE, |text| {
            format!("`{text}` leads outside the data folder")
        });
        out.extend(finding.map(|finding| {
            finding.help("copy the file into the data folder, and write the path of the copy")
        }));
    }
    let layer = view.layers().checked;
    for fault in layer
        .walk_faults
        .iter()
        .filter(|fault| fault.kind == WalkFaultKind::LinkLeavesRoot)
    {
        let finding = RULE.in_layer(
            layer,
            &fault.path,
            "the link leads outside the data folder and was not followed",
        );
        out.push(
            finding
                .key("link")
                .help("copy what it points to into the data folder"),
        );
    }
}
