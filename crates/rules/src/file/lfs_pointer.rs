//! Git LFS stand-ins where the content should be.

use std::collections::BTreeMap;

use super::super::cause::consequence::{Damage, consequence};
use super::super::{Check, Rule, RuleCx};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2, Mpfb},
    Evidence, Finding, Level, Place, RuleInfo,
};
use mhlint_discover::Kind;
use mhlint_formats::Format;
use mhlint_repo::{FileFacts, View};
use mhlint_source::{is_below, parent};

pub(crate) static RULE: Rule = Check::Repository(run).rule(RuleInfo {
    breaks: &[
        (
            Makehuman2,
            "reads the pointer instead of the content: JSON is rejected, targets move nothing, \
                pictures are not shown",
        ),
        (Makehuman1, "reads the pointer instead of the content"),
        (Mpfb, "reads the pointer instead of the content"),
    ],
    docs: include_str!("lfs_pointer.md").trim_ascii_end(),
    counts: "files",
    ..RuleInfo::new(
        "file-lfs-pointer",
        Level::Warning,
        "a Git LFS pointer instead of the content",
    )
});

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let layer = view.layers().checked;
    let loss = |file: &FileFacts| consequence(view, &file.rel, Damage::Pointer);
    let with_loss = |file: &FileFacts| loss(file).map(|loss| loss.level);
    let files: Vec<&FileFacts> = view
        .files()
        .filter(|file| file.encoding.lfs_pointer)
        .collect();
    let files: Vec<&FileFacts> = files
        .into_iter()
        .filter(|file| with_loss(file).is_some())
        .collect();
    let (Some(first), Some(worst)) = (
        files.first(),
        files.iter().filter_map(|file| with_loss(file)).max(),
    ) else {
        return;
    };
    let mut folders: BTreeMap<&str, usize> = BTreeMap::new();
    files
        .iter()
        .for_each(|file| *folders.entry(parent(&file.rel)).or_default() += 1);
    let above = common(folders.keys().copied());
    let finding = match files.as_slice() {
        [file] => RULE.in_layer(
            layer,
            &file.rel,
            format!("`{}` is a Git LFS pointer", file.file_name()),
        ),
        _ if above.is_empty() => RULE.at(first, Place::File, message(&files, &folders)),
        _ => RULE.in_layer(layer, above, message(&files, &folders)),
    };
    // One file alone, or those of the worst kind, may have more to say.
    let mut worst_files = files.iter().filter(|file| with_loss(file) == Some(worst));
    let own = worst_files.find_map(|file| loss(file)?.effect);
    let counts = folders
        .iter()
        .map(|(folder, count)| format!("{}: {count}", layer.shown(folder)));
    let mut evidence = Evidence::of_unnamed(counts);
    evidence.count = files.len() as u64;
    out.push(
        finding
            .level_in(view.application(), worst)
            .effect_in(
                view.application(),
                own.map_or_else(|| effect(&files), str::to_owned),
            )
            .asset(layer.display(parent(&first.rel)))
            .parts_in(files.iter().map(|file| (file.file_name(), &file.path)))
            .evidence(evidence)
            .help(
                "run `git lfs pull`; a ZIP of the repository has only pointers, so clone it, or \
                download these files one by one",
            ),
    );
}

fn message(files: &[&FileFacts], folders: &BTreeMap<&str, usize>) -> String {
    let count = files.len();
    match folders.len() {
        1 => format!("{count} files in this folder are Git LFS pointers"),
        several => format!("{count} files in {several} folders are Git LFS pointers"),
    }
}

/// The deepest folder that holds all of these.
fn common<'f>(mut folders: impl Iterator<Item = &'f str>) -> &'f str {
    let first = folders.next().unwrap_or_default();
    folders.fold(first, |common, folder| {
        let mut common = common;
        while !is_below(folder, common) {
            common = parent(common);
        }
        common
    })
}

/// What the application makes of the text of a pointer, for what is concerned.
fn effect(files: &[&FileFacts]) -> String {
    let has = |of: &dyn Fn(Kind) -> bool| files.iter().any(|file| of(file.kind));
    let concerned = [
        (has(&|kind| kind == Kind::Target), "targets move nothing"),
        (has(&|kind| Format::of(kind).is_json()), "JSON is rejected"),
        (
            has(&|kind| matches!(kind, Kind::BaseMesh | Kind::AssetMesh)),
            "meshes have no vertices",
        ),
        (
            has(&|kind| matches!(kind, Kind::Image | Kind::TargetIcon)),
            "pictures are not shown",
        ),
    ];
    let seen: Vec<&str> = concerned
        .iter()
        .filter(|(is_here, _)| *is_here)
        .map(|(_, what)| *what)
        .collect();
    match seen.as_slice() {
        [] => "reads the pointer instead of the content".to_owned(),
        seen => format!(
            "reads the pointer instead of the content: {}",
            seen.join(", ")
        ),
    }
}
