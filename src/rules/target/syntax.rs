//! Every field of a target row must be a number.

use super::super::{Check, Rule, RuleCx};
use crate::diag::{Application, Evidence, Finding, Level, Place, RuleInfo};
use crate::repo::Layer;

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        breaks: &[(
            Application::Makehuman2,
            "stops at start with a ValueError and leaves an empty compressedtargets.npz behind, which stops every later start",
        )],
        docs: "A row of a target is a vertex index and three decimal numbers with a point.\n\nMakeHuman 2 reads every target below \
            the folder at start, used or not, and hands the fields to Python's `int()` and `float()`. What they refuse \
            (words, `1.0` as an index, a decimal comma) ends the program. The empty archive that stays behind must be \
            deleted by hand, even after the target was mended.\n\nWrite the field as a number or remove the row.",
        ..RuleInfo::new("target-syntax", Level::Error, "a field of a target row is no number")
    },
    check: Check::Layer(run),
};

fn run(layer: &Layer, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for file in layer.files.values() {
        let Some(facts) = file.target() else { continue };
        let Some(first) = facts.unreadable.first() else { continue };
        let rows = facts.unreadable_rows;
        let message = if rows == 1 {
            format!("`{}` is no number", first.field)
        } else {
            format!("`{}` is no number ({rows} rows like it)", first.field)
        };
        let place = Place::Span(first.start..first.start + first.field.len());
        let mut evidence = Evidence::of_cases(facts.unreadable.iter().map(|field| format!("line {}", field.line)));
        evidence.count = rows;
        out.push(
            RULE.at(file, place, message)
                .help("a row is `INDEX X Y Z`: an integer and three decimals with a point")
                .evidence(evidence.out_of(facts.rows)),
        );
    }
}
