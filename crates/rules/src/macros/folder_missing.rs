//! The folder of a macro definition must be given and exist.

use std::cell::LazyCell;

use super::super::cause::schema::is_sound;
use super::super::{Check, Rule, RuleCx, did_you_mean};
use super::links::{MacroLink, links, own_links};
use super::lost_folder::{holds_files, is_lost};
use mhlint_diag::{Application::Makehuman2, Finding, Grouped, Level, Place, RuleInfo, grouped};
use mhlint_repo::makehuman2::{Base, View};

pub(crate) static RULE: Rule = Check::Makehuman2(run).rule(RuleInfo {
    breaks: &[(
        Makehuman2,
        "uses the folder of the previous macrodef, or crashes at start in the first one; a missing \
         target crashes it with `AttributeError` as soon as the sliders reach its combination",
    )],
    docs: include_str!("folder_missing.md").trim_ascii_end(),
    ..RuleInfo::new(
        "macro-folder-missing",
        Level::Error,
        "`folder` of a macrodef is missing, or \
        does not exist",
    )
});

fn run(view: &View<'_>, base: &Base<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some((file, macros)) = base.macro_file() else {
        return;
    };
    let all = links(view, base);
    let folders = LazyCell::new(|| folders_by_name(base));
    for macrodef in &macros.macrodefs {
        let own = own_links(&all, macrodef);
        let index = macrodef.index.to_string();
        if own.is_empty() || !is_sound(file, &format!("/macrodef/{index}/folder")) {
            continue;
        }
        let finding = match (&macrodef.folder, &macrodef.effective_folder) {
            (Some(folder), _) if is_lost(base, macrodef, &all) => {
                let place = Place::pointer(["macrodef", &index, "folder"]);
                let message = match base.targets {
                    Some(targets) if holds_files(targets, folder) => {
                        let count = own.len();
                        format!(
                            "folder `{folder}` has none of the targets of this macrodef ({count} \
                                combinations)"
                        )
                    }
                    _ => format!("folder `{folder}` is missing or empty"),
                };
                RULE.at(file, place, message)
                    .effect(
                        "finds no target and crashes with `AttributeError` as soon as the sliders \
                            reach a combination",
                    )
                    .help(
                        folder_of_files(base, &folders, own)
                            .unwrap_or_else(|| nearest_folder(base, folder, cx)),
                    )
            }
            (Some(_), _) => continue,
            (None, Some(folder)) => {
                let message = format!(
                    "the macrodef has no `folder`, so `{folder}` of the previous one is used"
                );
                let effect = "looks for the targets there and crashes with `AttributeError` as \
                    soon as the sliders reach a missing one";
                let finding = RULE
                    .at(file, Place::pointer(["macrodef", &index]), message)
                    .effect(effect);
                if own.iter().all(|link| link.found().is_some()) {
                    let effect = "finds the targets, because they are in the folder of the \
                        previous macrodef";
                    finding.level(Level::Info).effect(effect)
                } else {
                    finding
                }
            }
            (None, None) => RULE
                .at(
                    file,
                    Place::pointer(["macrodef", &index]),
                    "the first macrodef has no `folder`",
                )
                .effect("crashes at start with `UnboundLocalError`"),
        };
        let help = finding
            .help
            .clone()
            .unwrap_or_else(|| "add `folder` with the folder of its targets".to_owned());
        let folder = macrodef.folder.as_deref().unwrap_or("none");
        out.push(
            finding
                .help(help)
                .key(format!("{} {folder}", macrodef.components.join("-"))),
        );
    }
}

/// The folders of the targets of each name.
fn folders_by_name<'a>(base: &Base<'a>) -> Grouped<&'a str, &'a str> {
    let files = base
        .targets
        .into_iter()
        .flat_map(|targets| targets.targets().map(move |file| (targets, file)));
    grouped(files.filter_map(|(targets, file)| {
        let (folder, _) = targets.name_of(file)?.rsplit_once('/')?;
        Some((file.stem(), folder))
    }))
}

/// The folder that holds all files of a definition, as help.
fn folder_of_files(
    base: &Base<'_>,
    folders: &Grouped<&str, &str>,
    own: &[MacroLink<'_>],
) -> Option<String> {
    let targets = base.targets?;
    let holds_all = |folder: &&&str| {
        own.iter().all(|link| {
            targets
                .target(&format!("{folder}/{}", link.reference.text))
                .is_some()
        })
    };
    let mut folders = folders.get(own.first()?.reference.text)?.iter();
    folders
        .find(holds_all)
        .map(|folder| format!("write `{folder}`: its targets are there"))
}

fn nearest_folder(base: &Base<'_>, folder: &str, cx: &RuleCx<'_>) -> String {
    let rel = base
        .targets
        .map(|targets| format!("{}/", targets.rel()))
        .unwrap_or_default();
    let folders = base
        .targets
        .map(|targets| targets.layer.folders.as_slice())
        .unwrap_or_default();
    let start = folders.partition_point(|other| *other < rel);
    let folders = folders.iter().skip(start);
    did_you_mean(
        cx.suggestions
            .nearest(folder, folders.map_while(|other| other.strip_prefix(&rel))),
        format!("create `{rel}{folder}` with the targets, or correct the name"),
    )
}
