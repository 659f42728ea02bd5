//! Files without anything in them where content is needed.

use super::super::cause::consequence::{Damage, consequence};
use super::super::cause::schema::is_of_wrong_type;
use super::super::cause::{self, is_override, is_unmet};
use super::super::{Check, Rule, RuleCx};
use crate::diag::{Application, Finding, Level, Place, RuleInfo};
use crate::discover::Kind;
use crate::repo::{FileFacts, Reference, ReferenceKind, View};

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        breaks: &[(Application::Makehuman2, "loads nothing, or stops")],
        docs: "The file has no bytes, or nothing but blanks and comments. Often a download or an export was interrupted.\n\nHow bad that is \
            depends on the file. An empty `.mhskel`, `.mhpose` or `.mhbin` stops MakeHuman 2 while it scans the assets, an empty `base.mhbin` when it loads the base, an empty \
            `compressedtargets.npz` stops every start until it is deleted, and an empty JSON, also one that is no more than `{}`, `[]`, `\"\"`, `0`, `false` or `null`, counts as missing (an override in `contarget/` is the business of `overlay-broken-override`). A target \
            without a row loads and moves nothing; where a macro names it, `macro-empty-target` speaks instead.\n\nRestore the \
            content, or remove the file and what refers to it.",
        ..RuleInfo::new("file-empty", Level::Warning, "an empty file where content is needed")
    },
    check: Check::File(run),
};

fn run(view: &View<'_>, file: &FileFacts, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some(what) = emptiness(file).or_else(|| counts_as_missing(view, file)) else { return };
    if is_override(file) || is_target_of_macros(view, file) || is_unmet(view, file) {
        return;
    }
    let damage = match file.kind {
        _ if view.does_without(file) => Damage::Needless,
        kind if kind.is_json() => Damage::Refused,
        _ => Damage::Empty,
    };
    let Some(loss) = consequence(view, &file.rel, damage) else { return };
    let message = format!("`{}` is empty{what}", file.file_name());
    let help = match file.kind {
        Kind::TargetArchive => "delete it: MakeHuman 2 makes a new one from the targets",
        _ => "restore the content, or remove the file and what refers to it",
    };
    out.push(loss.of(view, RULE.at(file, Place::File, message)).help(help));
}

/// An empty value counts as no file, too. In a generated modelling.json it is usual.
fn counts_as_missing(view: &View<'_>, file: &FileFacts) -> Option<&'static str> {
    let usual = file.kind == Kind::ModellingJson && view.is_generated(&file.rel);
    let what = if is_of_wrong_type(file) {
        " (null, 0, false and empty values count as no file)"
    } else {
        " (`{}` counts as no file)"
    };
    (cause::counts_as_missing(file) && !usual).then_some(what)
}

/// `macro-empty-target` knows these better.
fn is_target_of_macros(view: &View<'_>, file: &FileFacts) -> bool {
    let is_macro = |reference: &Reference<'_>| reference.kind == ReferenceKind::MacroTarget;
    view.references().to_file(file).any(|reference| is_macro(reference) && reference.found().is_some())
}

fn emptiness(file: &FileFacts) -> Option<&'static str> {
    let encoding = &file.encoding;
    match file.kind {
        _ if file.size == 0 => Some(" (0 bytes)"),
        kind if !kind.is_text() => None,
        _ if encoding.blank && encoding.byte_order_mark => Some(" (nothing but a byte order mark)"),
        _ if encoding.blank => Some(" (nothing but blanks)"),
        // A comment is no JSON: that is a matter of syntax.
        kind if !kind.is_json() && encoding.only_comments => Some(" (nothing but comments)"),
        _ => None,
    }
}
