//! The list of vertices to hide (`docs/loaders/mpfb/clothes.md#delete-list`,
//! `docs/loaders/mpfb/clothes.md#delete-group`).

use super::super::texts;
use super::{at, is_list, is_number, whole};
use crate::Rule;
use mhlint_diag::{Application::Mpfb, Case, Finding, Level};
use mhlint_formats::mhclo::{Gap, Part, StopCause};
use mhlint_repo::Body;

const REVERSED: Case = &[(
    Mpfb,
    Level::Warning,
    "hides only the first vertex of the range",
)];
const CUT: Case = &[(
    Mpfb,
    Level::Warning,
    "ignores the dash and hides only both ends of the range",
)];
const NEGATIVE: Case = &[(
    Mpfb,
    Level::Warning,
    "counts the number from the end and hides another part of the body",
)];
const BESIDE: Case = &[(
    Mpfb,
    Level::Warning,
    "ignores the numbers: these vertices stay visible",
)];

/// Numbers and ranges that are not read as they are meant.
pub(in crate::proxy) fn ranges(rule: &Rule, body: &Body<'_>, out: &mut Vec<Finding>) {
    for text in texts(body) {
        let flow = &text.clothes.flow;
        if let Some(stop) = flow
            .stop
            .as_ref()
            .filter(|stop| stop.cause == StopCause::ListWord)
        {
            let help = match &*stop.word {
                word if word.contains('-') => "put spaces around the dash",
                word if word.contains(',') => "separate numbers with spaces only",
                word if word.starts_with('#') => "move the comment to a line of its own",
                _ => "write whole numbers, and ranges with spaces around a dash: `5 - 7`",
            };
            let message = format!(
                "`{}` among the vertices to hide is not a whole number",
                stop.word
            );
            out.push(rule.at(text.file, at(stop.line), message).help(help));
        }
        let told = |line: Option<u32>, message: &str, key: &str, case: Case, help: &str| {
            line.map(|line| {
                rule.at(text.file, at(line), message)
                    .key(key)
                    .case(case)
                    .help(help)
            })
        };
        let order = "write the range in one line, the lower number first";
        out.extend(told(
            flow.cut.first().copied(),
            "a range has no end on its line",
            "cut",
            CUT,
            order,
        ));
        let reversed = flow.reversed.first().copied();
        out.extend(told(
            reversed,
            "a range goes down to a lower number",
            "reversed",
            REVERSED,
            order,
        ));
        let negative = flow.negative.first().copied();
        out.extend(told(
            negative,
            "a vertex to hide has a negative number",
            "negative",
            NEGATIVE,
            "write its number",
        ));
        let beside = "numbers are on the line of `delete_verts` and are ignored";
        out.extend(told(
            flow.beside,
            beside,
            "beside",
            BESIDE,
            "write the numbers below the keyword",
        ));
    }
}

/// A list that the reader does not see, or leaves too early.
pub(in crate::proxy) fn lost(rule: &Rule, body: &Body<'_>, out: &mut Vec<Finding>) {
    for text in whole(body) {
        let behind_rows =
            |gap: &Gap| gap.ended == Some(Part::Rows) && is_list(&gap.word) && gap.lines > 0;
        let behind_list = |gap: &Gap| gap.ended == Some(Part::List) && gap.lines > 0;
        let ended = |gap: &Gap| {
            gap.ended == Some(Part::List) && (is_number(&gap.word) || gap.word.starts_with('-'))
        };
        let gaps = &text.clothes.flow.gaps;
        let Some(gap) = gaps
            .iter()
            .find(|gap| behind_rows(gap) || behind_list(gap) || ended(gap))
        else {
            continue;
        };
        let (message, help) = match (gap.ended, &*gap.word) {
            (Some(Part::Rows), word) => (
                format!("`{word}` is directly behind the vertex rows, which swallow it"),
                "put an empty line above it; a comment does not help",
            ),
            (_, "") if gap.taken == 0 => (
                "an empty line is directly below `delete_verts` and ends the list".to_owned(),
                "remove the empty line",
            ),
            (_, "") => (
                "an empty line ends the list of vertices to hide".to_owned(),
                "remove the empty line",
            ),
            (_, word) => (
                format!("`{word}` at the beginning of a line ends the list of vertices to hide"),
                "begin each line with a number, and put spaces around dashes: `5 - 7`",
            ),
        };
        out.push(rule.at(text.file, at(gap.line), message).help(help));
    }
}

/// Ranges in front of the rows.
pub(in crate::proxy) fn before_rows(rule: &Rule, body: &Body<'_>, out: &mut Vec<Finding>) {
    for text in whole(body).filter(|text| text.clothes.flow.rows > 0) {
        let Some(line) = text.clothes.flow.early_range else {
            continue;
        };
        let message = "a range of vertices to hide stands above `verts`";
        out.push(
            rule.at(text.file, at(line), message)
                .help("move `delete_verts` with its list below the vertex rows"),
        );
    }
}

const NO_ROWS: Case = &[(
    Mpfb,
    Level::Error,
    "takes no vertex row, and fails with `ValueError` when the asset is loaded",
)];

/// Keywords of sections that are mistyped.
pub(in crate::proxy) fn keywords(rule: &Rule, body: &Body<'_>, out: &mut Vec<Finding>) {
    for text in whole(body) {
        for gap in text
            .clothes
            .flow
            .gaps
            .iter()
            .filter(|gap| gap.ended.is_none() && gap.lines > 0)
        {
            let told = |message: String| rule.at(text.file, at(gap.line), message).key(&*gap.word);
            if is_verts(&gap.word) {
                let message = match &*gap.word {
                    "verts" => "`verts` has no number behind it".to_owned(),
                    word => format!("`{word}` is not the keyword `verts`"),
                };
                out.push(told(message).case(NO_ROWS).help("write `verts 0`"));
            } else if is_list(&gap.word) {
                let message = format!("`{}` is not the keyword `delete_verts`", gap.word);
                out.push(told(message).help("write `delete_verts`"));
            }
        }
    }
}

/// Whether a word is meant to open the rows.
pub(super) fn is_verts(word: &str) -> bool {
    let bare = word.strip_suffix(':').unwrap_or(word);
    bare.eq_ignore_ascii_case("verts") || matches!(bare, "vert" | "vertices" | "vertexs" | "vers")
}
