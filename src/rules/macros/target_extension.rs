//! `t` is written without suffix.

use super::super::{Check, Rule, RuleCx};
use super::links::{has_suffix, links};
use super::titles;
use crate::diag::{Application, Change, Evidence, Finding, Fix, FixKind, Level, Place, RuleInfo};
use crate::formats::macro_json::{Link, Macrodef};
use crate::repo::{Base, FileFacts, Repository};

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        fix: FixKind::Safe,
        breaks: &[(
            Application::Makehuman2,
            "looks for a file with a doubled suffix, does not find it, and stops as soon as the combination has weight",
        )],
        docs: "MakeHuman 2 puts `.target` behind every `t`, so `x.target` makes it look for `x.target.target`. \
            Packed targets (`.target.gz`) are never read. An empty text leads to a file called `.target`.\n\nThe \
            file is not found, and a file that is not found stops the program when its combination has \
            weight.\n\nRemove the suffix; write `null` instead of an empty text.",
        ..RuleInfo::new("macro-target-extension", Level::Error, "`t` ends in `.target` or `.gz`, or is empty")
    },
    check: Check::Base(run),
};

fn run(repository: &Repository<'_>, base: &Base<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some((file, macros)) = base.macro_file() else { return };
    let all = links(repository, base);
    for macrodef in &macros.macrodefs {
        let found = |index| {
            all.iter().any(|l| l.macrodef.index == macrodef.index && l.link.index == index && l.found().is_some())
        };
        let wrong =
            macrodef.links.iter().filter(|link| link.target.as_deref().is_some_and(has_suffix) && !found(link.index));
        let wrong: Vec<_> = wrong.collect();
        let Some(first) = wrong.first() else { continue };
        let text = first.target.as_deref().unwrap_or_default();
        let more = if wrong.len() > 1 { format!(" ({} entries like it)", wrong.len()) } else { String::new() };
        let (message, help) = if text.is_empty() {
            (
                format!("`t` of {} is empty{more}", titles::combination(&first.name)),
                "write `null` where nothing should change".to_owned(),
            )
        } else {
            let without = without_suffix(text);
            (format!("`{text}` ends in a suffix{more}"), format!("write `{without}`"))
        };
        let finding = RULE.at(file, Place::Pointer(macrodef.link_pointer(first, "t")), message).help(help);
        let evidence = Evidence::of_cases(wrong.iter().map(|link| &link.name)).out_of(macrodef.links.len());
        let fix = fix(base, file, macrodef, &wrong);
        out.push(finding.key(macrodef.components.join("-")).evidence(evidence).fix(fix));
    }
}

/// Takes the suffix off where that leads to a file, and writes `null` for an empty text.
fn fix(base: &Base<'_>, file: &FileFacts, macrodef: &Macrodef, wrong: &[&Link]) -> Fix {
    let exists = |name: &str| {
        let folder = macrodef.effective_folder.as_deref();
        let name = folder.map_or_else(|| name.to_owned(), |folder| format!("{folder}/{name}"));
        base.targets.is_some_and(|targets| targets.target(&name).is_some())
    };
    let mut fix = Fix::new(RULE.info.fix, "remove the suffix, or write `null` for an empty text");
    for link in wrong {
        let text = Some(without_suffix(link.target.as_deref().unwrap_or_default())).filter(|text| !text.is_empty());
        if text.is_none_or(exists) {
            let pointer = macrodef.link_pointer(link, "t");
            fix = fix.step(&file.path, Change::Value { pointer, text: text.map(str::to_owned) });
        }
    }
    fix
}

fn without_suffix(text: &str) -> &str {
    text.trim_end_matches(".gz").trim_end_matches(".target")
}
