//! The text of a JSON must be JSON.

use super::super::cause::consequence::{Damage, consequence, of_special};
use super::super::cause::is_ignored_override;
use super::super::{Check, Rule, RuleCx};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2, Mpfb},
    Evidence, Finding, Level, Place, RuleInfo,
};
use mhlint_discover::Kind;
use mhlint_formats::Content;
use mhlint_formats::json_file::JsonFault;
use mhlint_json::{SyntaxFault, SyntaxKind};
use mhlint_repo::{FileFacts, View};

pub(crate) static RULE: Rule = Check::File(run).rule(RuleInfo {
    breaks: &[
        (
            Makehuman2,
            "treats the file as missing, or crashes at start if it is an asset",
        ),
        (
            Makehuman1,
            "does not put on the asset that uses these weights",
        ),
        (Mpfb, "fails with an exception where it reads the file"),
    ],
    docs: include_str!("syntax.md").trim_ascii_end(),
    ..RuleInfo::new("json-syntax", Level::Error, "a file that is not valid JSON")
});

fn run(view: &View<'_>, file: &FileFacts, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    if is_ignored_override(file) {
        return;
    }
    match &*file.content {
        Content::Broken(JsonFault::Syntax(fault))
            if fault.kind != SyntaxKind::TooDeep && !is_stray(view, file) =>
        {
            let finding = RULE
                .at(
                    file,
                    Place::Span(fault.span.clone()),
                    format!("not valid JSON: {fault}"),
                )
                .parts([format!("{} {}", sort(&fault.kind), fault.within)])
                .help(help(fault));
            out.extend(
                consequence(view, &file.rel, Damage::Syntax).map(|loss| loss.of(view, finding)),
            );
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

/// Whether no loader looks for a JSON of this name where it lies: `file-unreferenced` speaks, or
/// `file-case-mismatch`.
fn is_stray(view: &View<'_>, file: &FileFacts) -> bool {
    matches!(file.kind, Kind::Json | Kind::ConfigJson | Kind::Pose)
        && !(view.layout().opens)(&file.rel)
}

/// Quotes that word processors and chat programs make of straight ones.
const TYPOGRAPHIC: [char; 10] = [
    '\u{201c}', '\u{201d}', '\u{201e}', '\u{201f}', '\u{2018}', '\u{2019}', '\u{201a}', '\u{ab}',
    '\u{bb}', '\u{2033}',
];

fn help(fault: &SyntaxFault) -> &'static str {
    match &fault.kind {
        SyntaxKind::TrailingComma => "remove the comma",
        SyntaxKind::Comment => "remove the comment; notes can go under a key `comment`",
        SyntaxKind::Conflict => {
            "keep one version or combine both, and remove the lines `<<<<<<<`, `=======` and \
                `>>>>>>>`"
        }
        SyntaxKind::CutText => {
            "restore the file, which seems to be cut off, or close the string and all brackets"
        }
        SyntaxKind::BadString("does not end on its line") => {
            "close the string with `\"`; write a line break in it as `\\n`"
        }
        SyntaxKind::BadString(_) => {
            "write control characters and backslashes as escapes: `\\n`, `\\t`, `\\\\`"
        }
        SyntaxKind::UnexpectedEnd(_) => {
            "restore the file if it is cut off, or close the open bracket"
        }
        SyntaxKind::TrailingText => "remove what follows, or the bracket that closes too early",
        SyntaxKind::Expected { found, .. } if fault.span.start == 0 && found.starts_with('<') => {
            "download the file itself: this is a web page"
        }
        SyntaxKind::Expected { .. } if fault.span.start == 0 => {
            "replace it with the JSON file: this is another kind of file"
        }
        SyntaxKind::Expected { .. } if fault.invisible().is_some() => {
            "remove all such characters: outside strings, JSON allows only spaces, tabs and line \
                breaks"
        }
        SyntaxKind::Expected { found, .. } if found.starts_with('\'') => "use double quotes",
        SyntaxKind::Expected { found, .. } if found.starts_with(TYPOGRAPHIC) => {
            "replace the curly quotes with straight ones (`\"`)"
        }
        SyntaxKind::Expected { .. } | SyntaxKind::TooDeep => {
            "add the missing comma, quote or bracket; it may belong just before this place"
        }
    }
}

fn special_numbers(view: &View<'_>, file: &FileFacts) -> Option<Finding> {
    let specials = &file.json.specials;
    let first = specials.first()?;
    let consequence = of_special(view, file)?;
    let message = match specials.len() {
        1 => "a number is `NaN` or `Infinity`, which JSON does not allow".to_owned(),
        count => format!("{count} numbers are `NaN` or `Infinity`, which JSON does not allow"),
    };
    let evidence = Evidence::of_unnamed(specials.iter().map(|span| format!("byte {}", span.start)));
    let finding = RULE
        .at(file, Place::Span(first.clone()), message)
        .key("special numbers")
        .help("write a finite number")
        .evidence(evidence);
    Some(consequence.of(view, finding))
}
