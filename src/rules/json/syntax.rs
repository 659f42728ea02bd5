//! The text of a JSON must be JSON.

use super::super::cause::consequence::{Damage, consequence, of_special};
use super::super::cause::is_ignored_override;
use super::super::{Check, Rule, RuleCx};
use crate::diag::{Application, Evidence, Finding, Level, Place, RuleInfo};
use crate::discover::Kind;
use crate::formats::Content;
use crate::formats::json_file::JsonFault;
use crate::json::{SyntaxFault, SyntaxKind};
use crate::repo::{FileFacts, View};

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        breaks: &[(Application::Makehuman2, "treats the file as absent, or stops at start if it is an asset")],
        docs: "JSON is strict: keys and texts in double quotes, a comma between two members and none after the last, no \
            comments, no text after the end.\n\nPython, which all applications are written in, is as strict, with one \
            exception: it reads `NaN`, `Infinity` and `-Infinity` as numbers, which JSON does not have and other tools \
            refuse. Such a file loads, so that is a warning.\n\nWhat a fault costs depends on the file. MakeHuman 2 takes a \
            broken macro.json, modelling.json or target_cat.json for absent, with no more than a line in its log; it does not load \
            a base whose base.json is broken; and a broken skeleton or pose stops it at start, because it reads all \
            assets then. A broken override in `contarget/` is the business of `overlay-broken-override`.\n\nMend the text \
            at the place that is shown; the cause may stand just before it.",
        ..RuleInfo::new("json-syntax", Level::Error, "a file is no JSON")
    },
    check: Check::File(run),
};

fn run(view: &View<'_>, file: &FileFacts, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    if is_ignored_override(file) {
        return;
    }
    match &*file.content {
        Content::Broken(JsonFault::Syntax(fault)) if fault.kind != SyntaxKind::TooDeep && !is_stray(view, file) => {
            let finding = RULE
                .at(file, Place::Span(fault.span.clone()), format!("no JSON: {fault}"))
                .parts([format!("{} {}", sort(&fault.kind), fault.within)])
                .help(help(fault));
            out.extend(consequence(view, &file.rel, Damage::Syntax).map(|loss| loss.of(view, finding)));
        }
        _ if !is_stray(view, file) => out.extend(special_numbers(view, file)),
        _ => {}
    }
}

/// What a fault is called among those of the same place.
fn sort(kind: &SyntaxKind) -> &'static str {
    match kind {
        SyntaxKind::Expected { .. } => "other",
        SyntaxKind::TrailingComma => "comma",
        SyntaxKind::Comment => "comment",
        SyntaxKind::Conflict => "conflict",
        SyntaxKind::CutText | SyntaxKind::BadString(_) => "text",
        SyntaxKind::UnexpectedEnd(_) => "end",
        SyntaxKind::TrailingText => "rest",
        SyntaxKind::TooDeep => "depth",
    }
}

/// Whether no loader looks for a JSON of this name where it lies: `file-unreferenced` speaks, or `file-case-mismatch`.
fn is_stray(view: &View<'_>, file: &FileFacts) -> bool {
    matches!(file.kind, Kind::Json | Kind::Pose) && !(view.layout().opens)(&file.rel)
}

/// Quotes that word processors and chat programs make of straight ones.
const TYPOGRAPHIC: [char; 10] = [
    '\u{201c}', '\u{201d}', '\u{201e}', '\u{201f}', '\u{2018}', '\u{2019}', '\u{201a}', '\u{ab}', '\u{bb}', '\u{2033}',
];

fn help(fault: &SyntaxFault) -> &'static str {
    match &fault.kind {
        SyntaxKind::TrailingComma => "remove the comma; Python refuses it, too",
        SyntaxKind::Comment => "remove the comment (a key `comment` is a place for it); Python refuses it, too",
        SyntaxKind::Conflict => {
            "keep one side, or what is needed of both, and remove the lines `<<<<<<<`, `=======` and `>>>>>>>`"
        }
        SyntaxKind::CutText => "the file seems to be cut off: restore it, or close the text and all brackets",
        SyntaxKind::BadString("does not end on its line") => {
            "close the text with `\"`; a line break in it is written `\\n`"
        }
        SyntaxKind::BadString(_) => "write control characters and backslashes as escapes: `\\n`, `\\t`, `\\\\`",
        SyntaxKind::UnexpectedEnd(_) => "the file is cut off (restore it), or a bracket is not closed",
        SyntaxKind::TrailingText => "remove what follows, or a bracket was closed too early",
        SyntaxKind::Expected { found, .. } if fault.span.start == 0 && found.starts_with('<') => {
            "this is a web page in place of the file: download the file itself"
        }
        SyntaxKind::Expected { .. } if fault.span.start == 0 => {
            "this is another kind of file: put the JSON in its place"
        }
        SyntaxKind::Expected { .. } if fault.invisible().is_some() => {
            "remove it, and others like it: outside of texts JSON has blanks, tabs and line ends only"
        }
        SyntaxKind::Expected { found, .. } if found.starts_with('\'') => {
            "use double quotes; Python refuses others, too"
        }
        SyntaxKind::Expected { found, .. } if found.starts_with(TYPOGRAPHIC) => {
            "write straight quotes (`\"`): a word processor has bent these, and Python refuses them, too"
        }
        SyntaxKind::Expected { .. } | SyntaxKind::TooDeep => "look for a missing comma, quote or bracket just before",
    }
}

fn special_numbers(view: &View<'_>, file: &FileFacts) -> Option<Finding> {
    let specials = &file.json.specials;
    let first = specials.first()?;
    let consequence = of_special(view, file)?;
    let message = match specials.len() {
        1 => "a number that JSON does not have (`NaN` or `Infinity`)".to_owned(),
        count => format!("{count} numbers that JSON does not have (`NaN` or `Infinity`)"),
    };
    let evidence = Evidence::of_unnamed(specials.iter().map(|span| format!("byte {}", span.start)));
    let finding = RULE
        .at(file, Place::Span(first.clone()), message)
        .key("special numbers")
        .help("write a finite number; Python accepts this one, JSON does not")
        .evidence(evidence);
    Some(consequence.of(view, finding))
}
