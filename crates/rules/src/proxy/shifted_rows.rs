//! No vertex row may be taken for something else.

use super::super::{Check, Rule, RuleCx, counted};
use super::{INDEX, blender, lines, more, texts};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2, Mpfb},
    Finding, Level, Place, RuleInfo,
};
use mhlint_formats::mhclo::{Fault, FaultKind};
use mhlint_repo::Body;

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[
        (
            Makehuman2,
            "drops such rows, and ties every later vertex to the row of another one",
        ),
        (
            Makehuman1,
            "does not put the asset on: the first word of the row is not a vertex",
        ),
        (
            Mpfb,
            "takes the row for the end of the list, and fails with `KeyError` when it fits the \
            asset",
        ),
    ],
    levels: &[(Makehuman1, Level::Error), (Mpfb, Level::Error)],
    docs: include_str!("shifted_rows.md").trim_ascii_end(),
    ..RuleInfo::new(
        "proxy-shifted-rows",
        Level::Warning,
        "a vertex row is taken for something \
        else",
    )
});

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    if body.is_mpfb() {
        return blender::rows::signs(&RULE, body, out);
    }
    for text in texts(body) {
        let dropped = text.reading.faults(|kind| kind == FaultKind::DroppedRow);
        let Some((faults, count)) = dropped.filter(|(faults, _)| !faults.is_empty()) else {
            continue;
        };
        let Some(first) = faults.first() else {
            continue;
        };
        let message = match count {
            1 => format!(
                "the vertex row `{} …` is dropped: its first word is not a plain number",
                first.word
            ),
            count => {
                let rows = counted(count, "vertex row");
                format!(
                    "{rows} are dropped, first `{} …`: the first word is not a plain number",
                    first.word
                )
            }
        };
        let message = if text.is_makehuman1() {
            row(first, count)
        } else {
            message
        };
        let finding = RULE.at(text.file, Place::Span(first.span.clone()), message);
        let finding = finding.help(
            "export the asset again; by hand, begin the row with the number of a base \
                vertex, in digits only",
        );
        let finding = finding.evidence(lines(&faults, count));
        out.push(if text.clothes.rows.count == 0 {
            finding.case(INDEX)
        } else {
            finding
        });
    }
}

/// MakeHuman 1 drops no row.
fn row(first: &Fault, count: u64) -> String {
    format!(
        "`{}` at the beginning of a vertex row is not the number of a vertex{}",
        first.word,
        more(count)
    )
}
