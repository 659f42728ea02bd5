//! A listed combination must be one that its macro definition generates.

use super::super::{Check, Rule, RuleCx, such};
use super::holders::Holders;
use super::homes::Homes;
use super::lacking_component;
use super::listing::Listing;
use super::misspelt_value::{MisspeltValue, Tokens, misspelt_values, other_component};
use super::sound::sound_space;
use super::space::Space;
use super::titles;
use mhlint_diag::{
    Application::Makehuman2, EXAMPLES, Evidence, Finding, Level, Place, RuleInfo, grouped,
};
use mhlint_formats::macro_json::Macrodef;
use mhlint_repo::FileFacts;
use mhlint_repo::makehuman2::{Base, View};
use std::collections::BTreeSet;

pub(crate) static RULE: Rule = Check::Makehuman2(run).rule(RuleInfo {
    breaks: &[(
        Makehuman2,
        "never uses such entries: their targets are loaded and never applied, and the intended \
            combinations have none",
    )],
    docs: include_str!("unexpected_combination.md").trim_ascii_end(),
    counts: "names",
    ..RuleInfo::new(
        "macro-unexpected-combination",
        Level::Error,
        "a macrodef lists a name that its components cannot generate",
    )
});

fn run(_: &View<'_>, base: &Base<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some((file, macros)) = base.macro_file() else {
        return;
    };
    let homes = Homes::of(macros);
    let misspelt = misspelt_values(file, macros, &cx.suggestions);
    out.extend(misspelt.iter().map(|value| finding_on_value(file, value)));
    let (explained, holders) = (Tokens::of(&misspelt), Holders::of(macros));
    for macrodef in &macros.macrodefs {
        if macrodef.components.is_empty() {
            out.extend(without_components(file, macrodef));
        }
        let Some(space) = sound_space(file, macros, macrodef) else {
            continue;
        };
        let listing = Listing::of(&space, macrodef, &cx.suggestions);
        let finding = || finding_on_comp(file, &holders, macrodef, (&space, &listing));
        if let Some(finding) =
            lacking_component::finding(&RULE, file, &holders, macrodef, &listing).or_else(finding)
        {
            out.push(finding);
            continue;
        }
        let unexplained = listing
            .strangers
            .iter()
            .filter(|stranger| !explained.contain(&space, &stranger.slip));
        let groups = grouped(unexplained.map(|stranger| {
            let home = homes.of_name(&stranger.link.name, macrodef);
            (
                (home.map(|home| home.index), stranger.slip.clone()),
                stranger,
            )
        }));
        for ((home, slip), strangers) in groups {
            let Some(first) = strangers.first() else {
                continue;
            };
            let more = such(strangers.len(), "names");
            let reason = match home.and_then(|home| macros.macrodefs.get(home)) {
                Some(home) => format!("is a combination of macrodef {}", titles::macrodef(home)),
                None => slip.reason(&space),
            };
            let message = format!("{} {reason}{more}", titles::combination(&first.link.name));
            let place = Place::Pointer(macrodef.link_pointer(first.link, "name"));
            let mut finding = RULE.at(file, place, message).key(format!(
                "{}/{}",
                macrodef.components.join("-"),
                slip.word()
            ));
            finding = finding.help(match &first.intended {
                Some(intended) => format!("did you mean `{}`?", space.name(intended)),
                None => format!(
                    "write one value of each component: `{}`",
                    macrodef.components.join("-")
                ),
            });
            if home.is_some() {
                let effect = "uses the entry for that macrodef, with the folder of this one";
                finding.help = Some(
                    "move the entry to that macrodef, and check the folder of its target"
                        .to_owned(),
                );
                finding = finding.level(Level::Info).effect(effect);
            }
            let names = strangers.iter().map(|stranger| &stranger.link.name);
            out.push(finding.evidence(Evidence::of_cases(names).out_of(macrodef.links.len())));
        }
    }
}

/// A value that no name has: the fault is in the component, not in the names.
fn finding_on_value(file: &FileFacts, value: &MisspeltValue<'_>) -> Finding {
    let (written, token, component) = (value.written(), &value.token, &value.component.name);
    let count = value.names.len();
    let message = format!(
        "no name has the value `{written}` of `{component}`, but {count} names have `{token}`"
    );
    let place = Place::pointer(["components", component, "values", &value.value.to_string()]);
    let mut finding = RULE
        .at(file, place, message)
        .key(format!("{component}/{written}"));
    finding = finding.help(format!("did you mean `{token}`?"));
    let mut seen = BTreeSet::new();
    for (macrodef, link) in value
        .names
        .iter()
        .filter(|(macrodef, _)| seen.insert(macrodef.index))
        .take(EXAMPLES)
    {
        let place = Place::Pointer(macrodef.link_pointer(link, "name"));
        finding = finding.related(
            &file.path,
            place,
            format!("macrodef {}", titles::macrodef(macrodef)),
        );
    }
    finding.evidence(Evidence::of_cases(
        value.names.iter().map(|(_, link)| &link.name),
    ))
}

/// If no name is right because all have values of another component in one place, `comp` is wrong
/// there.
fn finding_on_comp(
    file: &FileFacts,
    holders: &Holders<'_>,
    macrodef: &Macrodef,
    (space, listing): (&Space<'_>, &Listing<'_>),
) -> Option<Finding> {
    let (axis, meant) = other_component(holders, listing)?;
    let message = format!(
        "`comp` has `{}` where the names have values of `{}`",
        space.axes.get(axis)?.name,
        meant.name
    );
    let place = Place::pointer([
        "macrodef",
        &macrodef.index.to_string(),
        "comp",
        &axis.to_string(),
    ]);
    let names = listing.strangers.iter().map(|stranger| &stranger.link.name);
    let finding = RULE
        .at(file, place, message)
        .key(format!("{}/comp", macrodef.components.join("-")));
    let evidence = Evidence::of_cases(names).out_of(macrodef.links.len());
    Some(
        finding
            .help(format!("did you mean `{}`?", meant.name))
            .evidence(evidence),
    )
}

/// Without components a definition generates the empty name alone.
fn without_components(file: &FileFacts, macrodef: &Macrodef) -> Option<Finding> {
    let names = || {
        macrodef
            .links
            .iter()
            .map(|link| &link.name)
            .filter(|name| !name.is_empty())
    };
    let first = names().next().filter(|_| file.schema.faults.is_empty())?;
    let place = Place::pointer(["macrodef", &macrodef.index.to_string()]);
    let message = match names().count() {
        1 => format!("`comp` is empty, so `{first}` is never used"),
        count => format!("`comp` is empty, so `{first}` is never used ({count} such names)"),
    };
    let finding = RULE
        .at(file, place, message)
        .key(macrodef.effective_folder.as_deref().unwrap_or_default());
    Some(
        finding
            .help("list the components of the names in `comp`")
            .evidence(Evidence::of_cases(names())),
    )
}
