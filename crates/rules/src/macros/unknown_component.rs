//! `comp` must name components that are defined.

use super::super::{Check, Rule, RuleCx, did_you_mean};
use mhlint_diag::{Application::Makehuman2, EXAMPLES, Finding, Level, Place, RuleInfo, grouped};
use mhlint_formats::macro_json::{MacroFile, Macrodef};
use mhlint_json::UnknownKey;
use mhlint_repo::FileFacts;
use mhlint_repo::makehuman2::{Base, View};
use std::collections::BTreeSet;

pub(crate) static RULE: Rule = Check::Makehuman2(run).rule(RuleInfo {
    breaks: &[(
        Makehuman2,
        "skips the component; the names of the macrodef are then too short, and none of its \
            targets is applied",
    )],
    docs: include_str!("unknown_component.md").trim_ascii_end(),
    ..RuleInfo::new(
        "macro-unknown-component",
        Level::Error,
        "`comp` names a component that is \
        not defined",
    )
});

fn run(_: &View<'_>, base: &Base<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some((file, macros)) = base.macro_file() else {
        return;
    };
    // Without any component `components` is no object, or missing, and the schema says so.
    if macros.components.is_empty() && !file.schema.faults.is_empty() {
        return;
    }
    if macros.components.is_empty() {
        out.extend(without_components(file, macros));
        return;
    }
    let known: BTreeSet<&str> = macros
        .components
        .iter()
        .map(|component| component.name.as_str())
        .collect();
    let unknown = grouped(macros.macrodefs.iter().flat_map(|macrodef| {
        let strangers = macrodef
            .components
            .iter()
            .enumerate()
            .filter(|(_, name)| !known.contains(name.as_str()));
        strangers.map(|(at, name)| (name.as_str(), place(macrodef, at)))
    }));
    let unused = known.iter().filter(|name| !macros.used.contains(**name));
    let unused: BTreeSet<&str> = unused.copied().collect();
    let inner = file.schema.unknown.iter().filter(|key| key.is_object);
    let inner = grouped(inner.map(|key| (key.key.as_str(), key)));
    for (name, places) in unknown {
        let candidates = if places.len() == 1 { &known } else { &unused };
        let help = did_you_mean(
            cx.suggestions.nearest(name, candidates.iter().copied()),
            "define the component, or remove it from `comp` and from the names",
        );
        let more = if places.len() > 1 {
            format!(" ({} macrodefs name it)", places.len())
        } else {
            String::new()
        };
        let Some((first, others)) = places.split_first() else {
            continue;
        };
        let mut finding = RULE.at(
            file,
            first.clone(),
            format!("component `{name}` is not defined{more}"),
        );
        for other in others.iter().take(EXAMPLES - 1) {
            finding = finding.related(&file.path, other.clone(), "also named here");
        }
        let inside = inner.get(name).and_then(|keys| keys.first());
        out.push(
            finding
                .key(name)
                .help(inside.map_or(help, |key| moved_out(key))),
        );
    }
}

/// The component is there, inside another one.
fn moved_out(inside: &UnknownKey) -> String {
    let outer = inside.pointer.split('/').rev().nth(1).unwrap_or_default();
    format!("move `{}` one level up, out of `{outer}`", inside.key)
}

fn place(macrodef: &Macrodef, at: usize) -> Place {
    Place::pointer([
        "macrodef",
        &macrodef.index.to_string(),
        "comp",
        &at.to_string(),
    ])
}

/// With no component at all every name is unknown, for one reason.
fn without_components(file: &FileFacts, macros: &MacroFile) -> Option<Finding> {
    let first = macros.used.first()?;
    let more = if macros.used.len() > 1 {
        format!(" and {} more", macros.used.len() - 1)
    } else {
        String::new()
    };
    let message = format!("no component is defined, but the macrodefs name `{first}`{more}");
    let finding = RULE
        .at(file, Place::pointer(["components"]), message)
        .key("none");
    Some(finding.help("define the components that the macrodefs name in `comp`"))
}
