//! Every field of a target row must be a number.

use super::super::cause::archived::weigh;
use super::super::{Check, Rule, RuleCx};
use super::unreadable_fields::finding;
use super::{split_at_blanks, targets};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2, Mpfb},
    Finding, Level, Place, RuleInfo,
};
use mhlint_discover::Kind;
use mhlint_formats::target::TargetFacts;
use mhlint_repo::{Body, FileFacts};

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[
        (
            Makehuman2,
            "crashes at start with `ValueError` and leaves an empty compressedtargets.npz that \
             crashes every later start",
        ),
        (
            Makehuman1,
            "logs \"Unable to open\", and the whole target moves nothing",
        ),
        (
            Mpfb,
            "fails when its slider moves first and does nothing afterwards; saved characters with \
                it load only in part",
        ),
    ],
    docs: include_str!("syntax.md").trim_ascii_end(),
    counts: "rows",
    ..RuleInfo::new(
        "target-syntax",
        Level::Error,
        "a field of a target row is not a number",
    )
});

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    if body.is_mpfb() {
        out.extend(
            split_at_blanks(body)
                .filter_map(|(file, facts, case)| Some(of_blanks(file, facts)?.case(case))),
        );
        return;
    }
    for (target, file, facts) in targets(body).filter(|(target, ..)| !target.is_unused) {
        out.extend(finding(&RULE, file, facts).map(|finding| weigh(target, finding)));
    }
}

const ROW: &str = "write the row as `INDEX X Y Z`: an integer and three decimal numbers with a \
    point; remarks begin with `#`";
const NO_MARK: &str = "save the text as UTF-8 without a byte order mark, and pack it again";

/// What a loader stops at that splits at single blanks.
fn of_blanks(file: &FileFacts, facts: &TargetFacts) -> Option<Finding> {
    let first = facts.blanks.as_ref()?.unreadable.as_ref()?;
    let lines = facts
        .blanks
        .as_ref()
        .map_or(0, |blanks| blanks.unreadable_lines);
    let message = match lines {
        _ if first.field.starts_with('\u{feff}') => {
            "the packed text begins with a byte order mark".to_owned()
        }
        1 => format!("`{}` is not a number", first.field),
        count => format!("`{}` is not a number ({count} such lines)", first.field),
    };
    // The bytes of packed text have no place in the file.
    let place = match file.kind {
        Kind::PackedTarget | Kind::PackedPartTarget => Place::Line(first.line),
        _ => Place::Span(first.start..first.start + first.field.len()),
    };
    let help = match first.field.as_str() {
        field if field.starts_with('\u{feff}') => NO_MARK,
        field if field.starts_with('<') => "download the file again: this is a web page",
        _ if file.file_name().starts_with("._") => {
            "delete it: macOS left it when it packed a folder"
        }
        _ => ROW,
    };
    Some(RULE.at(file, place, message).help(help))
}
