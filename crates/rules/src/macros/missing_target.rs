//! A target that `macro.json` names must exist.

use super::super::{Check, Rule, RuleCx};
use super::links::{MacroLink, has_suffix, links, nearest_file};
use mhlint_diag::{Application::Makehuman2, Evidence, Finding, Level, RuleInfo, grouped};
use mhlint_repo::FileFacts;
use mhlint_repo::makehuman2::{Base, View};
use std::collections::{BTreeMap, BTreeSet};

pub(crate) static RULE: Rule = Check::Makehuman2(run).rule(RuleInfo {
    breaks: &[(
        Makehuman2,
        "logs a line and crashes with `AttributeError` as soon as the sliders reach the \
         combination, or at start if the default character uses it",
    )],
    docs: include_str!("missing_target.md").trim_ascii_end(),
    counts: "combinations",
    ..RuleInfo::new(
        "macro-missing-target",
        Level::Error,
        "a combination names a target that does \
        not exist",
    )
});

fn run(view: &View<'_>, base: &Base<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some((file, _)) = base.macro_file() else {
        return;
    };
    let all = links(view, base);
    let spoken_of: BTreeSet<usize> = all
        .chunk_by(|one, next| one.macrodef.index == next.macrodef.index)
        .filter_map(|own| own.first())
        .filter(|first| super::lost_folder::is_lost(base, first.macrodef, &all))
        .map(|first| first.macrodef.index)
        .collect();
    let missing = all
        .iter()
        .filter(|link| link.is_missing() && !has_suffix(link.reference.text));
    let missing = missing.filter(|link| !spoken_of.contains(&link.macrodef.index));
    let by_file = grouped(missing.map(|link| (link.reference.rel.as_str(), *link)));
    // A file that the combination of its own name uses is not meant.
    let own: BTreeSet<&str> = all
        .iter()
        .filter_map(own_file)
        .map(|file| file.path.as_str())
        .collect();
    let moved = Moved::of(base);
    for (rel, links) in by_file {
        let Some(first) = links.first() else { continue };
        let more = if links.len() > 1 {
            format!(" ({} combinations use it)", links.len())
        } else {
            String::new()
        };
        let help = help(view, base, first, (&own, &moved), cx);
        let finding = RULE
            .at(file, first.place(), format!("`{rel}` does not exist{more}"))
            .key(rel)
            .help(help);
        out.push(finding.evidence(Evidence::of_cases(links.iter().map(|link| &link.link.name))));
    }
}

fn help(
    view: &View<'_>,
    base: &Base<'_>,
    link: &MacroLink<'_>,
    (own, moved): (&BTreeSet<&str>, &Moved<'_>),
    cx: &RuleCx<'_>,
) -> String {
    let packed = format!("{}.gz", link.reference.rel);
    if let Some(packed) = view
        .layers
        .strongest_first()
        .find_map(|layer| layer.file(&packed))
    {
        return format!(
            "unpack `{}`; MakeHuman 2 does not read packed targets",
            packed.file_name()
        );
    }
    let near = nearest_file(base, link.reference, &cx.suggestions);
    match near.filter(|near| !own.contains(near.path.as_str())) {
        Some(near) => format!("did you mean `{}`?", near.stem()),
        None => moved.help(link).unwrap_or_else(|| {
            "correct the name, add the file, or write `null` where nothing should change".to_owned()
        }),
    }
}

/// Targets of the folder in use by their names; nothing for names that several have.
struct Moved<'s>(BTreeMap<&'s str, Option<&'s str>>);

impl<'s> Moved<'s> {
    fn of(base: &Base<'s>) -> Self {
        let mut files = BTreeMap::new();
        for file in base.targets.into_iter().flat_map(|folder| folder.targets()) {
            files
                .entry(file.stem())
                .and_modify(|only| *only = None)
                .or_insert(Some(file.rel.as_str()));
        }
        Self(files)
    }

    /// Where else the file of this name lies.
    fn help(&self, link: &MacroLink<'_>) -> Option<String> {
        let stem = link.reference.text.rsplit('/').next()?;
        let from = self.0.get(stem).copied().flatten()?;
        Some(format!(
            "move `{from}` to `{}`, or copy it if something else uses it",
            link.reference.rel
        ))
    }
}

/// The file of a combination that bears its name.
fn own_file<'s>(link: &MacroLink<'s>) -> Option<&'s FileFacts> {
    link.found().filter(|file| file.stem() == link.link.name)
}
