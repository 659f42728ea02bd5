//! The fields of a row are separated by single blanks.

use super::super::{Check, Rule, RuleCx, such};
use super::split_at_blanks;
use mhlint_diag::{Application::Mpfb, Evidence, Finding, Level, Place, RuleInfo};
use mhlint_repo::Body;

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[(
        Mpfb,
        "fails when its slider moves first and does nothing afterwards; saved characters with it \
            load only in part",
    )],
    docs: include_str!("separator.md").trim_ascii_end(),
    counts: "rows",
    ..RuleInfo::new(
        "target-separator",
        Level::Error,
        "fields of a target that are not separated \
        by one blank",
    )
});

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for (file, facts, case) in split_at_blanks(body) {
        let Some(blanks) = &facts.blanks else {
            continue;
        };
        let tally = &blanks.separators;
        let Some((line, _)) = tally.first.first() else {
            continue;
        };
        let what = if blanks.has_tab {
            "separated by a tab"
        } else {
            "not separated by one blank"
        };
        let message = format!(
            "the fields of the row are {what}{}",
            such(tally.count, "rows")
        );
        let mut evidence =
            Evidence::of_unnamed(tally.first.iter().map(|(line, _)| format!("line {line}")));
        evidence.count = tally.count;
        let finding = RULE
            .at(file, Place::Line(*line), message)
            .help("write one blank between the fields");
        out.push(finding.evidence(evidence.out_of(facts.rows)).case(case));
    }
}
