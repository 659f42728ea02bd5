//! Names in one folder that differ in nothing but case.

use std::collections::BTreeSet;

use super::super::{Check, Rule, RuleCx};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2, Mpfb},
    Finding, Level, Place, RuleInfo, grouped,
};
use mhlint_discover::extension;
use mhlint_repo::View;
use mhlint_source::{file_name, folder_and_name};

const ONE: &str = "finds only one of them on Windows and macOS, where they cannot coexist";

pub(crate) static RULE: Rule = Check::Repository(run).rule(RuleInfo {
    breaks: &[(Makehuman2, ONE), (Makehuman1, ONE), (Mpfb, ONE)],
    docs: include_str!("case_conflict.md").trim_ascii_end(),
    ..RuleInfo::new(
        "file-case-conflict",
        Level::Warning,
        "two names in one folder that differ only in case",
    )
});

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let layer = view.layers().checked;
    let siblings = grouped(layer.files.keys().chain(&layer.folders).map(|path| {
        let (folder, name) = folder_and_name(path);
        ((folder, name.to_lowercase()), path.as_str())
    }));
    let misnamed: BTreeSet<String> = view
        .misnamed_folders()
        .into_iter()
        .map(|folder| folder.rel)
        .collect();
    for ((folder, folded), mut paths) in siblings {
        paths.sort_unstable();
        let [first, others @ ..] = paths.as_slice() else {
            continue;
        };
        let Some(last) = others
            .last()
            .filter(|_| !paths.iter().any(|path| is_told(view, &misnamed, path)))
        else {
            continue;
        };
        let name = |path: &str| file_name(path).to_owned();
        let before: Vec<String> = paths
            .iter()
            .filter(|path| *path != last)
            .take(SHOWN)
            .map(|path| format!("`{}`", name(path)))
            .collect();
        let more = paths.len() - 1 - before.len();
        let more = if more > 0 {
            format!(", {more} more")
        } else {
            String::new()
        };
        let message = format!(
            "{}{more} and `{}` differ only in case",
            before.join(", "),
            name(last)
        );
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

/// Names that the message has before the last one.
const SHOWN: usize = 5;

/// Whether the application looks for another name, which has a finding of its own: with that the
/// conflict goes.
fn is_told(view: &View<'_>, misnamed: &BTreeSet<String>, path: &str) -> bool {
    let is_worn = |extension: &str| matches!(extension.to_lowercase().as_str(), "mhclo" | "proxy");
    let has_capitals =
        |extension: &str| is_worn(extension) && extension.chars().any(char::is_uppercase);
    // Of the data of MPFB all folders are looked for by their names, and what lies in no library of
    // MakeHuman 1 is told.
    let is_looked_for = view.is_mpfb() && view.layers().checks_system() || view.is_makehuman1();
    is_looked_for && view.layout().folder_in_other_case(path).is_some()
        || misnamed.contains(path)
        || has_capitals(extension(path))
}
