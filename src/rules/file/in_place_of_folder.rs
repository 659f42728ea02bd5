//! Files in the place of folders, and folders in the place of files.

use super::super::cause::consequence::{Damage, consequence};
use super::super::{Check, Rule, RuleCx};
use crate::diag::{Application, Finding, Level, RuleInfo};
use crate::discover::Kind;
use crate::repo::View;

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        breaks: &[(
            Application::Makehuman2,
            "cannot open or list it: what belongs in it is missing, or the program stops at start",
        )],
        docs: "A file has the name of a folder that an application looks into, or a folder the name of a file that it opens.\n\n\
            MakeHuman 2 stops at start where it lists or fills such a folder, treats a JSON that is a folder as missing, and \
            refuses the base mesh if `target/<base>` of the user is a file (\"File exists instead of folder\").\n\nRemove what \
            stands there, or give it another name.",
        ..RuleInfo::new(
            "file-in-place-of-folder",
            Level::Error,
            "a file where an application expects a folder, or the reverse",
        )
    },
    check: Check::Repository(run),
};

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let layer = view.layers().checked;
    let finding = |rel: &str, stands: &str, belongs: &str, help: &str| {
        let name = rel.rsplit('/').next().unwrap_or(rel);
        let message = format!("`{name}` is a {stands}, but a {belongs} belongs here");
        let finding = RULE.in_layer(layer, rel, message).help(help);
        consequence(view, rel, Damage::Closed).map(|loss| loss.of(view, finding))
    };
    let all = || view.layers().strongest_first().flat_map(|layer| layer.files.values());
    let is_base = |name: &str| all().any(|file| file.base_in(view.application()) == Some(name));
    for file in view.files().filter(|file| file.unreadable.is_none() && !file.failed) {
        if (view.layout().is_folder)(&file.rel, &is_base) {
            out.extend(finding(&file.rel, "file", "folder", "remove the file or give it another name"));
        }
    }
    for folder in layer.folders.iter().filter(|folder| is_file(view.kind_at(folder))) {
        out.extend(finding(folder, "folder", "file", "put the file here, or give the folder another name"));
    }
}

/// Whether loaders open what is of this kind as a file.
fn is_file(kind: Kind) -> bool {
    kind.is_text() || kind == Kind::TargetArchive
}
