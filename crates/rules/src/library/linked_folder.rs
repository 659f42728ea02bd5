//! Folders behind links are not searched.

use super::super::{Check, Rule, RuleCx, are, counted};
use mhlint_diag::{
    Application::{Makehuman1, Mpfb},
    Evidence, Finding, Level, RuleInfo,
};
use mhlint_repo::View;

pub(crate) static RULE: Rule = Check::Repository(run).rule(RuleInfo {
    breaks: &[
        (
            Makehuman1,
            "does not search the folder: its assets are not listed",
        ),
        (
            Mpfb,
            "does not search the folder: its assets are not listed",
        ),
    ],
    docs: include_str!("linked_folder.md").trim_ascii_end(),
    of_library: true,
    ..RuleInfo::new(
        "library-linked-folder",
        Level::Error,
        "a folder of assets that is a link",
    )
});

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let layer = view.layers().checked;
    for folder in &layer.linked_folders {
        let assets: Vec<&str> = layer
            .below(folder)
            .filter(|file| view.lists(file))
            .map(|file| file.rel.as_str())
            .collect();
        if assets.is_empty() {
            continue;
        }
        let count = assets.len();
        let (listed, are) = (counted(count, "asset"), are(count));
        let message = format!("the folder is a link: {listed} in it {are} not listed");
        let finding = RULE
            .in_layer(layer, folder, message)
            .evidence(Evidence::of_cases(assets));
        out.push(finding.help("copy the folder here, or make links to its files"));
    }
}
