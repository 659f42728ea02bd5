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
            "crashes at start with `ValueError` and leaves an empty compressedtargets.npz that crashes every later \
             start",
        ),
        (Makehuman1, "logs \"Unable to open\", and the whole target moves nothing"),
        (Mpfb, "fails when its slider moves first and does nothing afterwards; saved characters with it load only in part"),
    ],
    docs: "A field of a target row is not a number. A row is a vertex index and three decimal numbers with a \
        point.\n\n\
        MakeHuman 2 parses every target below the folder at start, used or not, with Python's `int()` and \
        `float()`. What they reject (words, `1.0` as an index, a decimal comma) crashes it. The empty archive that \
        stays behind must be deleted by hand, even after the target was fixed. While MakeHuman 2 uses a sound \
        archive in place of the text, the text is not parsed: a warning.\n\n\
        In MakeHuman 1 such a row makes the whole target inert, with an error in the log.\n\n\
        MPFB parses a target when its slider moves. It makes the shape key first, so that an empty one stays behind: the \
        slider fails once and does nothing from then on. It splits rows at single blanks and takes the first four fields; \
        what is wrong with other white space is `target-separator`. A `.ptarget` of a proxy or clothes, which is loaded by \
        hand, is read alike.\n\n\
        Write the field as a number, or remove the row. For a target that nothing uses see `target-breaks-start`.",
    counts: "rows",
    ..RuleInfo::new("target-syntax", Level::Error, "a field of a target row is not a number")
});

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    if body.is_mpfb() {
        out.extend(split_at_blanks(body).filter_map(|(file, facts, case)| Some(of_blanks(file, facts)?.case(case))));
        return;
    }
    for (target, file, facts) in targets(body).filter(|(target, ..)| !target.is_unused) {
        out.extend(finding(&RULE, file, facts).map(|finding| weigh(target, finding)));
    }
}

const ROW: &str =
    "write the row as `INDEX X Y Z`: an integer and three decimal numbers with a point; remarks begin with `#`";
const NO_MARK: &str = "save the text as UTF-8 without a byte order mark, and pack it again";

/// What a loader stops at that splits at single blanks.
fn of_blanks(file: &FileFacts, facts: &TargetFacts) -> Option<Finding> {
    let first = facts.blanks.as_ref()?.unreadable.as_ref()?;
    let lines = facts.blanks.as_ref().map_or(0, |blanks| blanks.unreadable_lines);
    let message = match lines {
        _ if first.field.starts_with('\u{feff}') => "the packed text begins with a byte order mark".to_owned(),
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
        _ if file.file_name().starts_with("._") => "delete it: macOS left it when it packed a folder",
        _ => ROW,
    };
    Some(RULE.at(file, place, message).help(help))
}
