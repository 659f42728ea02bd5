//! The list of vertices to hide consists of numbers and ranges.

use super::super::{Check, Rule, RuleCx};
use super::{STOPS_WITH_VALUE, Text, VALUE, blender, lines, more, sections, texts};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2, Mpfb},
    Case, Finding, Level, Place, RuleInfo, Tally,
};
use mhlint_formats::mhclo::{Entry, FaultKind};
use mhlint_repo::Body;

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[
        (Makehuman2, STOPS_WITH_VALUE),
        (
            Makehuman1,
            "does not put the asset on: `ValueError` when it reads the file",
        ),
        (Mpfb, "fails with `ValueError` when the asset is loaded"),
    ],
    docs: include_str!("delete_range.md").trim_ascii_end(),
    ..RuleInfo::new(
        "proxy-delete-range",
        Level::Error,
        "a list of vertices to hide that cannot be read",
    )
});

const LEADING: Case = &[
    (
        Makehuman2,
        Level::Error,
        "crashes with `UnboundLocalError` when the asset is put on; models that wear it load only \
            in part",
    ),
    (
        Makehuman1,
        Level::Error,
        "does not put the asset on: `UnboundLocalError` when it reads the file",
    ),
];
const CUT: Case = &[
    (
        Makehuman2,
        Level::Warning,
        "ignores the dash and hides only both ends of the range",
    ),
    (
        Makehuman1,
        Level::Warning,
        "ignores the dash and hides only both ends of the range",
    ),
];
const OPEN: Case = &[
    (
        Makehuman2,
        Level::Warning,
        "hides only the first vertex of the range",
    ),
    (
        Makehuman1,
        Level::Warning,
        "hides only the first vertex of the range",
    ),
];
const REVERSED: Case = &[
    (
        Makehuman2,
        Level::Warning,
        "hides only the first vertex of the range",
    ),
    (
        Makehuman1,
        Level::Warning,
        "hides only the first vertex of the range",
    ),
];

const BESIDE: Case = &[
    (
        Makehuman2,
        Level::Warning,
        "ignores the numbers: these vertices stay visible",
    ),
    (
        Makehuman1,
        Level::Warning,
        "ignores the numbers: these vertices stay visible",
    ),
];

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    if body.is_mpfb() {
        return blender::list::ranges(&RULE, body, out);
    }
    for text in texts(body) {
        out.extend(word(&text));
        out.extend(leading_dash(&text));
        out.extend(beside_keyword(&text));
        let deletes = &text.clothes.deletes;
        // With no number behind it, it has no other end.
        let is_last = |at: i64| text.clothes.deleted.last() == Some(&(at, at));
        let is_open = deletes.cut_ranges.count == 1
            && deletes
                .cut_ranges
                .first
                .first()
                .is_some_and(|(_, at)| is_last(*at));
        let cut = if is_open { OPEN } else { CUT };
        out.extend(range(&text, &deletes.cut_ranges, cut, "cut", |at| {
            format!("the range from {at} has no end on its line")
        }));
        out.extend(range(
            &text,
            &deletes.reversed,
            REVERSED,
            "reversed",
            |at| format!("the range from {at} goes down to a lower number"),
        ));
    }
}

fn word(text: &Text<'_, '_>) -> Option<Finding> {
    // A keyword there has a finding of its own, and ends what can be read.
    if sections::keyword_below_list(text).is_some() {
        return None;
    }
    let (faults, count) = text.reading.faults(|kind| kind == FaultKind::DeleteWord)?;
    let first = faults.first()?;
    let message = format!(
        "`{}` among the vertices to hide is not a whole number{}",
        first.word,
        more(count)
    );
    let help = match &*first.word {
        word if word.starts_with('#') => "move the comment to a line of its own",
        word if word.contains(',') => "separate numbers with spaces only",
        word if word.contains('-') => "put spaces around the dash",
        _ => "write whole numbers, and ranges with spaces around the dash",
    };
    let finding = RULE
        .at(text.file, Place::Span(first.span.clone()), message)
        .case(VALUE)
        .help(help);
    Some(finding.evidence(lines(&faults, count)))
}

/// Numbers in the line of the keyword.
fn beside_keyword(text: &Text<'_, '_>) -> Option<Finding> {
    let has_number = |entry: &&Entry| {
        entry
            .word()
            .starts_with(|first: char| first.is_ascii_digit())
    };
    let entry = text.clothes.all("delete_verts").find(has_number)?;
    let message = format!(
        "`{}` is on the line of `delete_verts` and is ignored",
        entry.value
    );
    let finding = RULE
        .at(text.file, Place::Span(entry.span.clone()), message)
        .key("beside")
        .case(BESIDE);
    Some(finding.help("write the numbers below the keyword"))
}

fn leading_dash(text: &Text<'_, '_>) -> Option<Finding> {
    let (faults, _) = text.reading.faults(|kind| kind == FaultKind::OpenRange)?;
    let first = faults.first()?;
    let message = "the list of vertices to hide begins with a dash";
    let finding = RULE
        .at(text.file, Place::Span(first.span.clone()), message)
        .key("-")
        .case(LEADING);
    Some(finding.help("write the first vertex of the range before the dash"))
}

fn range(
    text: &Text<'_, '_>,
    tally: &Tally,
    case: Case,
    key: &str,
    what: fn(i64) -> String,
) -> Option<Finding> {
    let (line, vertex) = tally.first.first()?;
    let message = format!("{}{}", what(*vertex), more(tally.count));
    let finding = RULE
        .at(text.file, Place::Line(*line), message)
        .key(key)
        .case(case);
    let finding = finding.evidence(tally.evidence(text.clothes.deleted.len()));
    Some(finding.help("write the range in one line, the lower number first"))
}
