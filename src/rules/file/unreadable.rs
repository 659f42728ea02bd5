//! What cannot be opened, listed or read, and folders in the place of files.

use super::super::cause::consequence::{Damage, consequence};
use super::super::{Check, Rule, RuleCx};
use crate::diag::{Application, Finding, Level, RuleInfo};
use crate::discover::Kind;
use crate::repo::View;
use crate::source::{ReadFault, WalkFaultKind};

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        breaks: &[(
            Application::Makehuman2,
            "cannot open it either: what is in it is missing, or the program stops at start",
        )],
        docs: "The file is there, but nobody can read it: the link points to nothing, the permissions forbid it, the disk reports \
            an error, or it is a folder, a pipe or a device. A file in the place of a folder is the same fault the other \
            way round.\n\nMakeHuman 2 treats an unreadable JSON as missing and stops at start when it cannot open a target or the \
            base mesh.\n\nMend the link or the permissions, or remove what stands in the place of the file.",
        ..RuleInfo::new("file-unreadable", Level::Error, "a file or folder that cannot be opened or read")
    },
    check: Check::Repository(run),
};

/// What is said of a file on which a reader of ours panicked.
const FAILED: &str = "cannot be read: mhlint itself failed on this file; please report it with the file";

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let layer = view.layers().checked;
    let finding = |rel: &str, message: String| {
        let finding = RULE.in_layer(layer, rel, message);
        consequence(view, rel, Damage::Closed).map(|loss| loss.of(view, finding))
    };
    for fault in &layer.walk_faults {
        if let WalkFaultKind::Unreadable { reason } = &fault.kind {
            out.extend(finding(&fault.path, format!("cannot be read: {reason}")));
        }
    }
    let all = || view.layers().strongest_first().flat_map(|layer| layer.files.values());
    let is_base = |name: &str| all().any(|file| file.base_in(view.application()) == Some(name));
    for file in view.files() {
        match &file.unreadable {
            Some(ReadFault::Unreadable(reason)) => {
                out.extend(finding(&file.rel, format!("cannot be read: {reason}")));
            }
            _ if file.failed => out.extend(finding(&file.rel, FAILED.to_owned())),
            _ if (view.layout().is_folder)(&file.rel, &is_base) => {
                let message = format!("`{}` is a file, but a folder belongs here", file.file_name());
                out.extend(finding(&file.rel, message).map(|it| it.help("remove the file or give it another name")));
            }
            _ => {}
        }
    }
    for folder in layer.folders.iter().filter(|folder| is_file(view.kind_at(folder))) {
        let name = folder.rsplit('/').next().unwrap_or(folder);
        let message = format!("`{name}` is a folder, but a file belongs here");
        let help = "put the file here, or give the folder another name";
        out.extend(finding(folder, message).map(|finding| finding.help(help)));
    }
}

/// Whether loaders open what is of this kind as a file.
fn is_file(kind: Kind) -> bool {
    kind.is_text() || kind == Kind::TargetArchive
}
