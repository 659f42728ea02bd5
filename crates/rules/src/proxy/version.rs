//! There is one version of what an asset's text says.

use super::super::{Check, Rule, RuleCx};
use super::texts;
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2},
    Finding, Level, Place, RuleInfo,
};
use mhlint_formats::python_int;
use mhlint_repo::Body;

const EFFECT: &str = "reads the rows as those of version 110";

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[(Makehuman2, EFFECT), (Makehuman1, EFFECT)],
    docs: include_str!("version.md").trim_ascii_end(),
    ..RuleInfo::new(
        "proxy-version",
        Level::Info,
        "an asset with a version that nothing reads",
    )
});

const KNOWN: i64 = 110;

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for text in texts(body) {
        // A word that is no number, and rows that cannot be read, have findings of their own.
        let Some(entry) = text
            .reading
            .last("version")
            .filter(|_| !text.reading.stops())
        else {
            continue;
        };
        let Some(number) = python_int(entry.word().as_bytes()).filter(|number| *number != KNOWN)
        else {
            continue;
        };
        let message =
            format!("`version {number}`, but the rows are read as those of version {KNOWN}");
        let finding = RULE.at(text.file, Place::Span(entry.word_span()), message);
        out.push(finding.help(format!("write `version {KNOWN}`, or remove the line")));
    }
}
