//! `t` is written without suffix.

use std::cell::OnceCell;
use std::collections::BTreeSet;

use super::super::{Check, Rule, RuleCx, such};
use super::fit::{Spellings, values_of};
use super::links::{has_suffix, is_in_folder, links};
use super::titles;
use mhlint_diag::{
    Application::Makehuman2, Change, Evidence, Finding, Fix, FixKind, Level, Place, RuleInfo,
};
use mhlint_formats::macro_json::{Link, Macrodef, without_suffix};
use mhlint_repo::FileFacts;
use mhlint_repo::makehuman2::{Base, TargetFolder, View};

pub(crate) static RULE: Rule = Check::Makehuman2(run).rule(RuleInfo {
    fix: FixKind::Safe,
    breaks: &[(
        Makehuman2,
        "adds `.target`, does not find the file and crashes with `AttributeError` as soon as the \
         sliders reach the combination",
    )],
    docs: include_str!("target_extension.md").trim_ascii_end(),
    counts: "entries",
    ..RuleInfo::new(
        "macro-target-extension",
        Level::Error,
        "`t` ends in `.target` or `.gz`, or \
        is empty",
    )
});

const SUFFIXED: &str = "looks for `{}.target`, does not find it and crashes with `AttributeError` \
    as soon as the sliders reach the combination";
const NAMELESS: &str = "looks for a file named `{}.target`, does not find it and crashes with \
    `AttributeError` as soon as the sliders reach the combination";

fn run(view: &View<'_>, base: &Base<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some((file, macros)) = base.macro_file() else {
        return;
    };
    let all = links(view, base)
        .into_iter()
        .filter(|link| link.found().is_some());
    let found: BTreeSet<(usize, usize)> = all
        .map(|link| (link.macrodef.index, link.link.index))
        .collect();
    for macrodef in &macros.macrodefs {
        let found = |index| found.contains(&(macrodef.index, index));
        let wrong = macrodef
            .links
            .iter()
            .filter(|link| link.target.as_deref().is_some_and(has_suffix) && !found(link.index));
        let wrong: Vec<_> = wrong.collect();
        let Some(first) = wrong.first() else { continue };
        let text = first.target.as_deref().unwrap_or_default();
        let own = own_target(base, macrodef, first);
        let more = such(wrong.len(), "entries");
        let (message, help, effect) = if without_suffix(text).is_empty() {
            let what = if text.is_empty() {
                "is empty".to_owned()
            } else {
                format!("is only `{text}`")
            };
            let help = match own {
                Some(own) => format!("write `{own}`; a target with this name exists"),
                None => "write `null`, or the name of the file".to_owned(),
            };
            (
                format!("`t` of {} {what}{more}", titles::combination(&first.name)),
                help,
                NAMELESS.replace("{}", text),
            )
        } else {
            let (without, file) = (
                without_suffix(text),
                text.rsplit(['/', '\\']).next().unwrap_or(text),
            );
            let message = format!("`{text}` has a suffix, but `t` must not have one{more}");
            let plain = without.replace('\\', "/");
            (
                message,
                format!("write `{}`", plain.trim_start_matches("./")),
                SUFFIXED.replace("{}", file),
            )
        };
        let finding = RULE.at(
            file,
            Place::Pointer(macrodef.link_pointer(first, "t")),
            message,
        );
        let finding = finding.help(help).effect(effect);
        let evidence =
            Evidence::of_cases(wrong.iter().map(|link| &link.name)).out_of(macrodef.links.len());
        let fix = fix(view, base, file, macrodef, &wrong);
        out.push(
            finding
                .key(macrodef.components.join("-"))
                .evidence(evidence)
                .fix(fix),
        );
    }
}

/// Takes the suffix off where that leads to a file. For an empty text writes the combination's own
/// name if there is such a file, else `null`, unless an unused file may be the one that was meant.
fn fix(
    view: &View<'_>,
    base: &Base<'_>,
    file: &FileFacts,
    macrodef: &Macrodef,
    wrong: &[&Link],
) -> Fix {
    let unused = OnceCell::new();
    // Whether the folder has a target for the combination that nothing uses.
    let has_candidate = |macrodef: &Macrodef, link: &Link| {
        let fitting = unused
            .get_or_init(|| unused_targets(view, base))
            .fitting(&values_of(&link.name));
        fitting
            .into_iter()
            .any(|(_, file)| is_in_folder(base, macrodef, file))
    };
    let is_nameless =
        |link: &&Link| without_suffix(link.target.as_deref().unwrap_or_default()).is_empty();
    let title = match wrong.iter().filter(|link| is_nameless(link)).count() {
        0 => "remove the suffix",
        count if count == wrong.len() => {
            "write the name of the target, or `null` if no target has it"
        }
        _ => "remove the suffix; replace an empty `t` with the name of its target, or `null`",
    };
    let mut fix = Fix::new(RULE.info.fix, title);
    for link in wrong {
        let text = match without_suffix(link.target.as_deref().unwrap_or_default()) {
            "" => own_target(base, macrodef, link),
            text if exists(base, macrodef, text) => Some(text),
            _ => continue,
        };
        if text.is_none() && has_candidate(macrodef, link) {
            continue;
        }
        let pointer = macrodef.link_pointer(link, "t");
        fix = fix.step(
            &file.path,
            Change::Value {
                pointer,
                text: text.map(str::to_owned),
            },
        );
    }
    fix
}

fn exists(base: &Base<'_>, macrodef: &Macrodef, name: &str) -> bool {
    let folder = macrodef.effective_folder.as_deref();
    let name = folder.map_or_else(|| name.to_owned(), |folder| format!("{folder}/{name}"));
    // Other faults of the name have findings of their own, and are fixed afterwards.
    base.target_named(&name).meant().is_some()
}

/// The name of the combination, if the folder has a target of that name.
fn own_target<'a>(base: &Base<'_>, macrodef: &Macrodef, link: &'a Link) -> Option<&'a str> {
    Some(link.name.as_str()).filter(|name| !name.is_empty() && exists(base, macrodef, name))
}

/// Targets that nothing uses, by what their names spell.
fn unused_targets<'s>(view: &View<'_>, base: &Base<'s>) -> Spellings<'s, &'s FileFacts> {
    let all = base.targets.iter().flat_map(TargetFolder::targets);
    let unused = all.filter(|file| view.references.to_file(file).next().is_none());
    Spellings::of(unused.map(|file| (file.stem(), file)))
}
