//! A combination may be listed in a macro definition only once.

use super::super::{Check, Rule, RuleCx};
use super::titles;
use mhlint_diag::{
    Application::Makehuman2, Change, Finding, Fix, FixKind, Level, Place, RuleInfo, grouped,
};
use mhlint_repo::makehuman2::{Base, View};

pub(crate) static RULE: Rule = Check::Makehuman2(run).rule(RuleInfo {
    fix: FixKind::Unsafe,
    breaks: &[(
        Makehuman2,
        "uses the last entry; the target of an earlier one is never applied",
    )],
    docs: include_str!("duplicate_combination.md").trim_ascii_end(),
    ..RuleInfo::new(
        "macro-duplicate-combination",
        Level::Error,
        "a macrodef lists a combination more than once",
    )
});

fn run(_: &View<'_>, base: &Base<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some((file, macros)) = base.macro_file() else {
        return;
    };
    for macrodef in &macros.macrodefs {
        let mut by_name = grouped(macrodef.links.iter().map(|link| (link.name.as_str(), link)));
        // An empty name is never reached, however often it is listed; without components it is the
        // only one.
        by_name.retain(|name, _| !name.is_empty() || macrodef.components.is_empty());
        for (name, links) in by_name {
            let [first, .., last] = links.as_slice() else {
                continue;
            };
            let mut finding = RULE
                .at(
                    file,
                    Place::Pointer(macrodef.link_pointer(first, "name")),
                    format!(
                        "{} is listed {}",
                        titles::combination(name),
                        times(links.len())
                    ),
                )
                .key(name)
                .help("keep one entry with this name, and remove the others")
                .related(
                    &file.path,
                    Place::Pointer(macrodef.link_pointer(last, "name")),
                    "this entry is used",
                );
            if links.iter().all(|link| link.target == last.target) {
                let effect = "reads the same target twice, without effect: the entries are equal";
                let surplus = links.iter().skip(1);
                let fix = surplus.fold(
                    Fix::new(RULE.info.fix, "keep only the first entry"),
                    |fix, link| fix.step(&file.path, Change::Element(macrodef.entry_pointer(link))),
                );
                finding = finding.level(Level::Info).effect(effect).fix(fix);
            }
            out.push(finding);
        }
    }
}

fn times(count: usize) -> String {
    if count == 2 {
        "twice".to_owned()
    } else {
        format!("{count} times")
    }
}
