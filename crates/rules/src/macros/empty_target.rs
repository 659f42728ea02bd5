//! A macro target that moves nothing.

use super::super::{Check, Rule, RuleCx};
use super::links::{MacroLink, links};
use mhlint_diag::{
    Application::Makehuman2, Change, Evidence, Finding, Fix, FixKind, Level, Place, RuleInfo,
    grouped,
};
use mhlint_formats::macro_json::without_suffix;
use mhlint_formats::target::TargetFacts;
use mhlint_repo::makehuman2::{Base, View};
use mhlint_repo::{FileFacts, Reference, ReferenceKind};
use std::collections::BTreeMap;

pub(crate) static RULE: Rule = Check::Makehuman2(run).rule(RuleInfo {
    fix: FixKind::Unsafe,
    breaks: &[(Makehuman2, "loads and applies a target that moves nothing")],
    docs: include_str!("empty_target.md").trim_ascii_end(),
    counts: "combinations",
    ..RuleInfo::new(
        "macro-empty-target",
        Level::Info,
        "a combination uses a target that moves nothing",
    )
});

fn run(view: &View<'_>, base: &Base<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some((file, _)) = base.macro_file() else {
        return;
    };
    let all = links(view, base);
    let by_file = grouped(all.iter().filter_map(|link| {
        let target = link
            .reference
            .meant()
            .filter(|target| moves_nothing(target))?;
        Some((target.rel.as_str(), *link))
    }));
    let unmet = if by_file.is_empty() {
        BTreeMap::new()
    } else {
        unmet(view)
    };
    for (rel, links) in by_file {
        let Some((first, target)) = links
            .first()
            .and_then(|link| Some((link, link.reference.meant()?)))
        else {
            continue;
        };
        let more = if links.len() > 1 {
            format!(" ({} combinations use it)", links.len())
        } else {
            String::new()
        };
        let what = if target.size == 0 {
            "is an empty file and moves nothing"
        } else {
            "moves nothing"
        };
        let text = &first.reference.text;
        let finding = match slider_of(view, target) {
            Some(slider) => RULE
                .at(
                    file,
                    first.place(),
                    format!(
                        "`{text}` {what}{more}; slider `{}` also uses it",
                        slider.owner
                    ),
                )
                .level(Level::Warning)
                .effect("loads the target, but the slider moves nothing")
                .help("save the intended shape in the file; the macro could use `null`, but the \
                    slider needs the file")
                .related(&slider.from.path, slider.place.clone(), "also uses it"),
            None => RULE.at(file, first.place(), format!("`{text}` {what}{more}")).help(
                "export the shape again; if the combination should change nothing, write `null` \
                    and remove the file",
            ),
        };
        out.push(
            finding
                .key(rel)
                .fix(fix(view, base, file, &links, target, &unmet))
                .related(&target.path, Place::File, "moves nothing")
                .evidence(Evidence::of_cases(links.iter().map(|link| &link.link.name))),
        );
    }
}

/// What uses the file besides the macros.
fn slider_of<'s>(view: &'s View<'_>, target: &FileFacts) -> Option<&'s Reference<'s>> {
    let is_slider = |reference: &&Reference<'_>| {
        reference.kind.is_target()
            && reference.kind != ReferenceKind::MacroTarget
            && reference.found().is_some()
    };
    view.references.to_file(target).find(is_slider)
}

/// Writes `null` and removes the file, which would only be left lying around. Not where something
/// else names it, or a binary archive holds it.
fn fix(
    view: &View<'_>,
    base: &Base<'_>,
    file: &FileFacts,
    links: &[MacroLink<'_>],
    target: &FileFacts,
    unmet: &BTreeMap<&str, usize>,
) -> Fix {
    // Also names that are not quite right: they may be fixed next.
    let users = view.references.to_file(target).count()
        + unmet.get(stem(&target.rel)).copied().unwrap_or_default();
    let archived = base
        .targets
        .is_some_and(|folder| folder.archive().is_some());
    let fix = Fix::new(RULE.info.fix, "write `null` and remove the file");
    // One of 0 bytes is mostly what is left of an export that failed.
    let is_lost = target.size == 0;
    if users != links.len() || archived || is_lost || !view.layers.is_checked(target) {
        return fix;
    }
    let nulls = links.iter().filter_map(|link| {
        if let Place::Pointer(pointer) = link.place() {
            Some(pointer)
        } else {
            None
        }
    });
    let fix = nulls.fold(fix, |fix, pointer| {
        fix.step(
            &file.path,
            Change::Value {
                pointer,
                text: None,
            },
        )
    });
    fix.step(&target.path, Change::Remove)
}

/// How many references that lead nowhere write each name.
fn unmet<'s>(view: &'s View<'_>) -> BTreeMap<&'s str, usize> {
    let mut unmet = BTreeMap::new();
    for reference in view
        .references
        .iter()
        .filter(|reference| reference.meant().is_none())
    {
        *unmet.entry(stem(&reference.rel)).or_default() += 1;
    }
    unmet
}

fn stem(rel: &str) -> &str {
    rel.strip_suffix(".target").map_or("", without_suffix)
}

fn moves_nothing(file: &FileFacts) -> bool {
    let is_checked = |facts: &TargetFacts| {
        // Lines that are no rows are lost, which is a finding of its own.
        let damaged = facts.unreadable_rows + facts.non_finite.count + facts.field_count.count;
        facts.moving == 0 && damaged == 0
    };
    file.target().is_some_and(is_checked)
}
