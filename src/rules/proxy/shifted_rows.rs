//! No vertex row may be taken for something else.

use super::super::{Check, Rule, RuleCx, counted};
use super::{INDEX, lines, texts};
use crate::diag::{Application::Makehuman2, Finding, Level, Place, RuleInfo};
use crate::formats::mhclo::FaultKind;
use crate::repo::Body;

pub(in crate::rules) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[(Makehuman2, "drops the row and ties every later vertex to the row of the next one")],
    docs: "A vertex row does not begin with a plain number. MakeHuman 2 accepts only digits there: no sign, no \
        decimal point, no underscore, no letter.\n\n\
        It takes such a line for an unknown keyword and drops it without a message. Every later row then belongs to \
        the vertex before, and the shape of the asset is scrambled. If no row is left, it crashes with `IndexError` when the \
        asset is put on (an error).\n\n\
        Write the number of the base vertex in digits only.",
    ..RuleInfo::new("proxy-shifted-rows", Level::Warning, "a vertex row is taken for something else")
});

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for text in texts(body) {
        let dropped = text.clothes.faults.of(|kind| kind == FaultKind::DroppedRow);
        let Some((faults, count)) = dropped.filter(|(faults, _)| !faults.is_empty()) else { continue };
        let Some(first) = faults.first() else { continue };
        let message = match count {
            1 => format!("the vertex row `{} …` is dropped: its first word is not a plain number", first.word),
            count => {
                let rows = counted(count, "vertex row");
                format!("{rows} are dropped, first `{} …`: the first word is not a plain number", first.word)
            }
        };
        let finding = RULE.at(text.file, Place::Span(first.span.clone()), message);
        let finding = finding.help("begin the row with the number of a base vertex, in digits only");
        let finding = finding.evidence(lines(faults, count));
        out.push(if text.clothes.rows.count == 0 { finding.case(INDEX) } else { finding });
    }
}
