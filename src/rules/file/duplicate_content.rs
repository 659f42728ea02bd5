//! The same content under several names.

use std::collections::BTreeMap;

use super::super::{Check, Rule, RuleCx};
use crate::diag::{Application, Evidence, Finding, Level, Place, RuleInfo};
use crate::discover::Kind;
use crate::repo::{FileFacts, ReferenceKind, View};

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        breaks: &[(Application::Makehuman2, "loads and keeps the same content more than once")],
        docs: "Several targets with the same displacements, or pictures or meshes with the same bytes. It does no harm, but costs space, and whoever \
            changes one forgets the other.\n\nTargets are compared by their numbers, whatever their comments; targets that move nothing and \
            files below 200 bytes are left out. Only files of the same base mesh and category are compared, because others cannot be \
            shared.\n\nLet all references name one of the files and remove the rest.",
        ..RuleInfo::new("file-duplicate-content", Level::Info, "several files with the same content")
    },
    check: Check::Repository(run),
};

/// Smaller files (a dot of an icon, a target of a few rows) are equal by chance.
const SMALLEST: u64 = 200;

/// What equal files have in common: where they lie, what they are, and their content.
type Class<'f> = ((&'f str, &'f str), &'static str, u64);

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let layer = view.layers().checked;
    let mut twins: BTreeMap<Class<'_>, Vec<&FileFacts>> = BTreeMap::new();
    // Through a link it is the same file, not another one.
    let is_link = |file: &FileFacts| file.link_to.as_deref().is_some_and(|real| layer.file(real).is_some());
    for file in view.files().filter(|file| !is_link(file)) {
        if let (Some(class), Some(hash)) = (class(file), file.content_hash) {
            twins.entry((category(file), class, hash)).or_default().push(file);
        }
    }
    for ((_, class, _), files) in twins {
        let [first, others @ ..] = files.as_slice() else { continue };
        if others.is_empty() {
            continue;
        }
        let message = if let [other] = others {
            format!("the same {class} as `{}`", other.shown())
        } else {
            let names: Vec<String> = files.iter().map(|file| format!("`{}`", file.shown())).collect();
            format!("the same {class} in {} files: {}", files.len(), names.join(", "))
        };
        let mut finding = RULE.at(first, Place::File, message).help(advice(view, first, others));
        for other in others {
            finding = finding.related(other.path.clone(), Place::File, "the same content");
        }
        let finding = finding.parts_in(files.iter().map(|file| (file.shown(), &file.path)));
        let finding = finding.between(files.iter().map(|file| &file.path));
        out.push(finding.evidence(Evidence::of_cases(files.iter().map(|file| file.shown()))));
    }
}

/// What a file is compared with, if it is.
fn class(file: &FileFacts) -> Option<&'static str> {
    let extension = file.rel.rsplit('.').next().unwrap_or_default();
    match file.kind {
        _ if file.size < SMALLEST || file.encoding.lfs_pointer => None,
        Kind::Target => file.target().filter(|facts| facts.moving > 0).map(|_| "displacement"),
        Kind::BaseMesh | Kind::AssetMesh => Some("mesh"),
        // Every asset has its own thumb, named after it.
        Kind::Image if extension == "thumb" => None,
        Kind::Image | Kind::TargetIcon => Some("picture"),
        _ => None,
    }
}

/// Folder and base mesh: within it one file can stand for another.
fn category(file: &FileFacts) -> (&str, &str) {
    let (folder, _) = file.rel.split_once('/').unwrap_or_default();
    file.base().map_or((file.rel.as_str(), ""), |base| (folder, base))
}

fn advice(view: &View<'_>, first: &FileFacts, others: &[&FileFacts]) -> String {
    let mut references = others.iter().flat_map(|other| view.references().to_file(other));
    match references.find(|reference| reference.found().is_some()) {
        // With another target the slider would have another name in saved models.
        Some(reference) if matches!(reference.kind, ReferenceKind::Incr | ReferenceKind::Decr) => format!(
            "if `{}` in {} is meant to move the same, leave both files: saved models know the slider by the name of its \
             target; otherwise give it a shape of its own",
            reference.owner,
            reference.from.file_name()
        ),
        Some(reference) => format!(
            "let `{}` in {} name the file `{}`, and remove the other",
            reference.owner,
            reference.from.file_name(),
            first.file_name()
        ),
        None => "let everything that uses them name one file, and remove the others".to_owned(),
    }
}
