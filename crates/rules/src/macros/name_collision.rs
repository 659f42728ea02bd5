//! No two macro definitions may share the name of a combination.

use super::super::{Check, Rule, RuleCx, counted};
use super::sound::clear_space;
use super::space::Space;
use super::titles;
use mhlint_diag::{Application::Makehuman2, Evidence, Finding, Level, Place, RuleInfo};
use mhlint_formats::macro_json::{Link, Macrodef};
use mhlint_repo::FileFacts;
use mhlint_repo::makehuman2::{Base, View};
use std::collections::BTreeMap;

pub(crate) static RULE: Rule = Check::Makehuman2(run).rule(RuleInfo {
    breaks: &[(
        Makehuman2,
        "uses the file of the last macrodef for both, and applies it twice",
    )],
    docs: include_str!("name_collision.md").trim_ascii_end(),
    counts: "names",
    ..RuleInfo::new(
        "macro-name-collision",
        Level::Error,
        "two macrodefs list or generate the same name",
    )
});

/// A definition with what it lists (last entry wins) and generates.
struct Table<'a> {
    macrodef: &'a Macrodef,
    space: Space<'a>,
    links: BTreeMap<&'a str, &'a Link>,
}

/// Pairs that are told one by one; what more there are is counted. Nobody has that many, and
/// corrects them one by one.
const MOST_PAIRS: usize = 1000;

fn run(_: &View<'_>, base: &Base<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some((file, macros)) = base.macro_file() else {
        return;
    };
    let table = |macrodef| {
        Some(Table {
            macrodef,
            space: clear_space(file, macros, macrodef)?,
            links: links(macrodef),
        })
    };
    let tables: Vec<Table<'_>> = macros.macrodefs.iter().filter_map(table).collect();
    let (start, mut more) = (out.len(), 0);
    for (at, a) in tables.iter().enumerate() {
        for b in tables.iter().skip(at + 1).filter(|b| may_share(a, b)) {
            if out.len() - start >= MOST_PAIRS {
                more += usize::from(do_share(a, b));
                continue;
            }
            let both: Vec<&Link> = a
                .links
                .keys()
                .filter_map(|name| b.links.get(name).copied())
                .collect();
            let differ = both.iter().any(|link| {
                path(a, a.links.get(link.name.as_str()).copied()) != path(b, Some(link))
            });
            // One finding for the two of them, on the worst that they share.
            let (of_a, of_b) = (generated(a, b), generated(b, a));
            if !both.is_empty() {
                let also = [of_a, of_b].concat();
                report(
                    file,
                    (a, b),
                    (&both, &also),
                    if differ { Level::Error } else { Level::Warning },
                    out,
                );
            } else if of_a.is_empty() {
                report(file, (a, b), (&of_b, &[]), Level::Warning, out);
            } else {
                report(file, (b, a), (&of_a, &of_b), Level::Warning, out);
            }
        }
    }
    if more > 0 {
        let message = format!(
            "{} of macrodefs with shared names, not listed",
            counted(more, "more pair")
        );
        out.push(
            RULE.at(file, Place::File, message)
                .key("more")
                .evidence(Evidence::counted(more)),
        );
    }
}

/// Whether two definitions list a name together, or one of them generates what the other lists.
fn do_share(a: &Table<'_>, b: &Table<'_>) -> bool {
    a.links.keys().any(|name| b.links.contains_key(name))
        || !generated(a, b).is_empty()
        || !generated(b, a).is_empty()
}

fn links(macrodef: &Macrodef) -> BTreeMap<&str, &Link> {
    macrodef
        .links
        .iter()
        .map(|link| (link.name.as_str(), link))
        .collect()
}

/// Definitions whose names cannot be equal need no comparison of every name.
fn may_share(a: &Table<'_>, b: &Table<'_>) -> bool {
    let dashes = |table: &Table<'_>| {
        table
            .space
            .axes
            .iter()
            .any(|axis| axis.values.iter().any(|value| value.contains('-')))
    };
    dashes(a) || dashes(b) || a.space.axes.len() == b.space.axes.len()
}

/// Names with a file that `a` lists and generates, and `b` generates without listing them.
fn generated<'a>(a: &Table<'a>, b: &Table<'a>) -> Vec<&'a Link> {
    let links = a
        .links
        .values()
        .copied()
        .filter(|link| link.target.is_some() && !b.links.contains_key(link.name.as_str()));
    links
        .filter(|link| a.space.parse(&link.name).is_some() && b.space.parse(&link.name).is_some())
        .collect()
}

fn path<'a>(table: &Table<'a>, link: Option<&'a Link>) -> Option<(Option<&'a str>, &'a str)> {
    Some((
        table.macrodef.effective_folder.as_deref(),
        link?.target.as_deref()?,
    ))
}

/// `links` stand in the second definition; the first one shares their names, and `also` of either
/// are shared too.
fn report(
    file: &FileFacts,
    (other, own): (&Table<'_>, &Table<'_>),
    (links, also): (&[&Link], &[&Link]),
    level: Level,
    out: &mut Vec<Finding>,
) {
    let Some(first) = links.first() else { return };
    let title = |table: &Table<'_>| table.macrodef.components.join("-");
    let lists = other.links.contains_key(first.name.as_str());
    let verb = if lists { "listed" } else { "generated" };
    let shared = links.len() + also.len();
    let more = if shared > 1 {
        format!(" ({shared} names are shared)")
    } else {
        String::new()
    };
    let (whose, name) = (
        titles::macrodef(other.macrodef),
        titles::combination(&first.name),
    );
    let message = format!("{name} is also {verb} by macrodef {whose}{more}");
    let place = Place::Pointer(own.macrodef.link_pointer(first, "name"));
    let mut finding = RULE
        .at(file, place, message)
        .key(format!("{}/{}", title(own), title(other)))
        .help("rename a value in one of the components so that the names differ")
        .level(level)
        .evidence(Evidence::of_cases(
            links.iter().chain(also).map(|link| &link.name),
        ));
    if let Some(twin) = other.links.get(first.name.as_str()) {
        let twin = Place::Pointer(other.macrodef.link_pointer(twin, "name"));
        finding = finding.related(&file.path, twin, "the same name");
    }
    if level == Level::Warning {
        finding =
            finding.effect("applies the target once for each macrodef, so the shape is doubled");
    }
    out.push(finding);
}
