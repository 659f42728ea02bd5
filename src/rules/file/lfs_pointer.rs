//! Git LFS stand-ins where the content should be.

use std::collections::BTreeMap;

use super::super::cause::consequence::{Damage, consequence};
use super::super::{Check, Rule, RuleCx};
use crate::diag::{Application, Evidence, Finding, Level, RuleInfo};
use crate::repo::{FileFacts, View};

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        breaks: &[(
            Application::Makehuman2,
            "reads the text of the pointer: JSON is refused, a target moves nothing, a picture cannot be shown",
        )],
        docs: "Git LFS keeps large files elsewhere and leaves a small text in their place until the content is fetched. Without it \
            the asset is not there, although a file of its name is.\n\nThe finding counts the stand-ins of a folder. It is an error \
            where the content must be parsed (JSON, targets, meshes, weights, skeletons), a warning for pictures and the rest. \
            Nothing else is said about these files.\n\nRun `git lfs pull`, or in a CI job check out with LFS switched on.",
        ..RuleInfo::new("file-lfs-pointer", Level::Warning, "a Git LFS pointer stands where the content should be")
    },
    check: Check::Repository(run),
};

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let layer = view.layers().checked;
    let mut folders: BTreeMap<(&str, bool), Vec<&FileFacts>> = BTreeMap::new();
    for file in view.files().filter(|file| file.encoding.lfs_pointer) {
        let folder = file.rel.rsplit_once('/').map_or("", |(folder, _)| folder);
        folders.entry((folder, file.kind.is_text())).or_default().push(file);
    }
    for ((folder, parsed), files) in folders {
        let losses = files.iter().filter_map(|file| consequence(view, &file.rel, Damage::Pointer));
        let Some(loss) = losses.max_by_key(|loss| loss.level) else { continue };
        let finding = match files.as_slice() {
            [file] => RULE.in_layer(layer, &file.rel, format!("`{}` is a Git LFS pointer", file.file_name())),
            several => {
                let what = if parsed { "files of this folder that must be parsed" } else { "files of this folder" };
                let message = format!("{} {what} are Git LFS pointers", several.len());
                RULE.in_layer(layer, folder, message)
            }
        };
        let evidence = Evidence::of_cases(files.iter().map(|file| file.file_name()));
        out.push(
            loss.of(view, finding)
                .asset(layer.display(folder))
                .key(if parsed { "parsed" } else { "" })
                .parts_in(files.iter().map(|file| (file.file_name(), &file.path)))
                .evidence(evidence)
                .help("run `git lfs pull`"),
        );
    }
}
