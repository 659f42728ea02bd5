//! An override that the application ignores.

use super::super::cause::consequence::ignored_override;
use super::super::cause::is_ignored_override;
use super::super::{Check, Rule, RuleCx};
use super::overrides;
use mhlint_diag::{
    Application::Makehuman2, Change, Finding, Fix, FixKind, Level, Place, Rewrite, RuleInfo,
};
use mhlint_discover::Kind;
use mhlint_formats::Content;
use mhlint_formats::json_file::JsonFault;
use mhlint_repo::FileFacts;
use mhlint_repo::makehuman2::{Base, View};

pub(crate) static RULE: Rule = Check::Makehuman2(run).rule(RuleInfo {
    fix: FixKind::Safe,
    breaks: &[(
        Makehuman2,
        "ignores the override with only a log line, and uses the file of the system data",
    )],
    docs: include_str!("broken_override.md").trim_ascii_end(),
    ..RuleInfo::new(
        "overlay-broken-override",
        Level::Error,
        "an override in contarget that MakeHuman 2 ignores",
    )
});

fn run(view: &View<'_>, base: &Base<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for each in overrides(base) {
        let Some(file) = each.file.filter(|file| is_ignored_override(file)) else {
            continue;
        };
        let (place, fault, help) = fault(file);
        let message = format!("the override `{}` is ignored: {fault}", file.rel);
        let finding = RULE.at(file, place, message).key(each.name).help(help);
        let finding = finding.effect(ignored_override(
            view,
            base,
            each.name,
            each.system.is_some(),
        ));
        let finding = match &*file.content {
            Content::Broken(JsonFault::ByteOrderMark) => {
                let change = Change::Rewrite(Rewrite::DropByteOrderMark);
                finding.fix(
                    Fix::new(RULE.info.fix, "remove the byte order mark").step(&file.path, change),
                )
            }
            _ => finding,
        };
        out.push(match each.system {
            Some(system) => finding.related(
                system.path.clone(),
                Place::File,
                "this file is used instead",
            ),
            None => finding,
        });
    }
}

fn fault(file: &FileFacts) -> (Place, String, &'static str) {
    match &*file.content {
        Content::Broken(JsonFault::ByteOrderMark) => (
            Place::Span(0..3),
            "it begins with a byte order mark".to_owned(),
            "save the file as UTF-8 without a byte order mark",
        ),
        Content::Broken(JsonFault::Syntax(fault)) => (
            Place::Span(fault.span.clone()),
            fault.to_string(),
            "fix the JSON at this place, or remove the file",
        ),
        Content::Broken(_) => (
            Place::File,
            "it is empty".to_owned(),
            "write its content, or remove the file",
        ),
        _ if file.kind != Kind::MacroJson => (
            Place::Pointer(String::new()),
            "an empty value counts as a missing file".to_owned(),
            "write its content, or remove the file",
        ),
        _ => (
            Place::Pointer(String::new()),
            "an empty value counts as a missing file".to_owned(),
            "write its content, or remove the file; for a base without macros, write \
             `{\"components\": {}, \"macrodef\": []}`",
        ),
    }
}
