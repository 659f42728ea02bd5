//! An override that the application ignores.

use super::super::cause::consequence::ignored_override;
use super::super::cause::is_ignored_override;
use super::super::{Check, Rule, RuleCx};
use super::overrides;
use crate::diag::{Application, Change, Finding, Fix, FixKind, Level, Place, Rewrite, RuleInfo};
use crate::formats::Content;
use crate::formats::json_file::JsonFault;
use crate::repo::FileFacts;
use crate::repo::makehuman2::{Base, View};

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        fix: FixKind::Safe,
        breaks: &[(
            Application::Makehuman2,
            "ignores the override but for a line in the log, and takes the system's file",
        )],
        docs: "macro.json, modelling.json and target_cat.json in `contarget/<base>/` replace those of the system. MakeHuman 2 \
            takes the first of the two that it can read and that is not empty, each file for itself. A syntax error, a byte \
            order mark or an empty object is only a line in the log: the system's file is used as if there were no \
            override.\n\nThe target files do not fall back with it. If macro.json is the one that is refused, all targets \
            are searched in the system's folder again, where those of the override are not; and a base that lives in user \
            space alone stops the program at start, because there is no such folder.\n\nMend the file at the place that is \
            shown, or remove it. (Bytes that are no UTF-8 are worse: MakeHuman 2 stops; see `file-not-utf8`.)",
        ..RuleInfo::new("overlay-broken-override", Level::Error, "a contarget file that MakeHuman 2 silently ignores")
    },
    check: Check::Makehuman2(run),
};

fn run(view: &View<'_>, base: &Base<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for each in overrides(base) {
        let Some(file) = each.file.filter(|file| is_ignored_override(file)) else { continue };
        let (place, fault, help) = fault(file);
        let message = format!("the override `{}` is ignored: {fault}", file.rel);
        let finding = RULE.at(file, place, message).key(each.name).help(help);
        let finding = finding.effect(ignored_override(view, base, each.name, each.system.is_some()));
        let finding = match &*file.content {
            Content::Broken(JsonFault::ByteOrderMark) => {
                let change = Change::Rewrite(Rewrite::DropByteOrderMark);
                finding.fix(Fix::new(RULE.info.fix, "remove the mark").step(&file.path, change))
            }
            _ => finding,
        };
        out.push(match each.system {
            Some(system) => finding.related(system.path.clone(), Place::File, "this file is used instead"),
            None => finding,
        });
    }
}

fn fault(file: &FileFacts) -> (Place, String, &'static str) {
    match &*file.content {
        Content::Broken(JsonFault::ByteOrderMark) => (
            Place::Span(0..3),
            "it starts with a byte order mark, which Python refuses".to_owned(),
            "save it as UTF-8 without byte order mark",
        ),
        Content::Broken(JsonFault::Syntax(fault)) => {
            (Place::Span(fault.span.clone()), fault.to_string(), "mend the JSON at this place, or remove the file")
        }
        Content::Broken(_) => (Place::File, "it is empty".to_owned(), "fill it, or remove it"),
        _ => (
            Place::Pointer(String::new()),
            "there is nothing in it, and an empty value counts as no file".to_owned(),
            "fill it, or remove it; a base without macros writes `{\"components\": {}, \"macrodef\": []}`",
        ),
    }
}
