//! What cannot be opened, listed or read, and folders in the place of files.

use super::super::{Check, Rule, RuleCx};
use crate::diag::{Application, Finding, Level, RuleInfo};
use crate::discover::Kind;
use crate::repo::{Layer, View};
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

/// Folders below the data root that are sorted by base mesh.
const BY_BASE: [&str; 5] = ["base", "target", "contarget", "rigs", "models"];

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let layer = view.layers().checked;
    for fault in &layer.walk_faults {
        if let WalkFaultKind::Unreadable { reason } = &fault.kind {
            out.push(finding(layer, &fault.path, format!("cannot be read: {reason}")));
        }
    }
    for file in layer.files.values() {
        match &file.unreadable {
            Some(ReadFault::Unreadable(reason)) => {
                out.push(finding(layer, &file.rel, format!("cannot be read: {reason}")));
            }
            _ if is_folder_name(layer, &file.rel) => {
                let message = format!("`{}` is a file, but a folder belongs here", file.file_name());
                out.push(finding(layer, &file.rel, message).help("remove the file or give it another name"));
            }
            _ => {}
        }
    }
    for folder in layer.folders.iter().filter(|folder| is_file_name(layer, folder)) {
        let name = folder.rsplit('/').next().unwrap_or(folder);
        let message = format!("`{name}` is a folder, but a file belongs here");
        out.push(finding(layer, folder, message).help("put the file here, or give the folder another name"));
    }
}

fn finding(layer: &Layer, rel: &str, message: String) -> Finding {
    let kind = layer.kind_at(rel);
    let harmless = matches!(kind, Kind::Image | Kind::TargetIcon) && rel.contains('.');
    let level = if harmless { Level::Warning } else { Level::Error };
    RULE.in_layer(layer, rel, message).level(level)
}

/// Names that loaders open as files.
fn is_file_name(layer: &Layer, rel: &str) -> bool {
    let kind = layer.kind_at(rel);
    kind.is_text() || kind == Kind::TargetArchive
}

/// Names that loaders list as folders.
fn is_folder_name(layer: &Layer, rel: &str) -> bool {
    let is_base = |name: &str| layer.files.values().any(|file| file.base() == Some(name));
    match rel.split('/').collect::<Vec<_>>().as_slice() {
        [folder] => BY_BASE.contains(folder),
        [folder, base] => BY_BASE.contains(folder) && is_base(base),
        ["target" | "contarget", _, "icons"] => true,
        _ => false,
    }
}
