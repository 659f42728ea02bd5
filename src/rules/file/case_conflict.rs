//! Names in one folder that differ in nothing but case.

use super::super::{Check, Rule, RuleCx};
use crate::diag::{Application::Makehuman2, Finding, Level, Place, RuleInfo, grouped};
use crate::repo::View;

pub(in crate::rules) static RULE: Rule = Check::Repository(run).rule(RuleInfo {
    breaks: &[(Makehuman2, "finds only one of them on Windows and macOS, where they cannot coexist")],
    docs: "Linux keeps `Nose.target` and `nose.target` apart; Windows and macOS do not. If the repository is \
        checked out or unpacked there, the later file replaces the earlier one, and what refers to the earlier \
        one gets the wrong content.\n\nOnly names in the same folder are compared. Rename one of them, and \
        update the references to it.",
    ..RuleInfo::new("file-case-conflict", Level::Warning, "two names in one folder that differ only in case")
});

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let layer = view.layers().checked;
    let siblings = grouped(layer.files.keys().chain(&layer.folders).map(|path| {
        let (folder, name) = path.rsplit_once('/').unwrap_or(("", path));
        ((folder, name.to_lowercase()), path.as_str())
    }));
    for ((folder, folded), mut paths) in siblings {
        paths.sort_unstable();
        let [first, others @ ..] = paths.as_slice() else { continue };
        let Some(last) = others.last() else { continue };
        let name = |path: &str| path.rsplit('/').next().unwrap_or_default().to_owned();
        let before: Vec<String> =
            paths.iter().filter(|path| *path != last).map(|path| format!("`{}`", name(path))).collect();
        let message = format!("{} and `{}` differ only in case", before.join(", "), name(last));
        let is_folder = paths.iter().any(|path| layer.has_folder(path));
        let help = if is_folder {
            "move all files into one of the folders, and remove the others"
        } else {
            "keep the file that is in use, and rename or remove the others"
        };
        let finding = RULE.in_layer(layer, last, message).key(folded).help(help);
        let finding = finding.asset(layer.display(folder)).parts(&paths);
        out.push(finding.related(layer.display(first), Place::File, "the other name"));
    }
}
