//! Bone weights have a file of their own.

use super::super::{Check, Rule, RuleCx, such};
use super::{Text, texts};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2},
    Case, Evidence, Finding, Level, Place, RuleInfo,
};
use mhlint_formats::mhclo::{Entry, FaultKind};
use mhlint_repo::Body;

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[
        (Makehuman2, "refuses the asset with a message"),
        (Makehuman1, "reads the weights and does not use them"),
    ],
    levels: &[(Makehuman1, Level::Info)],
    docs: include_str!("deprecated_keyword.md").trim_ascii_end(),
    ..RuleInfo::new(
        "proxy-deprecated-keyword",
        Level::Error,
        "an asset with a section that is no longer read",
    )
});

const PASSED_OVER: Case = &[(
    Makehuman1,
    Level::Info,
    "logs a warning and ignores the line",
)];

/// The first line with a keyword of old.
fn passed_over(text: &Text<'_, '_>) -> Option<Finding> {
    let is_old = |entry: &&Entry| !entry.is_comment && text.reading.passes_over(entry);
    let found: Vec<&Entry> = text.clothes.entries.iter().filter(is_old).collect();
    let first = found.first()?;
    let message = format!(
        "`{}` is a keyword that is no longer used{}",
        first.keyword,
        such(found.len(), "lines")
    );
    let finding = RULE
        .at(text.file, Place::Span(first.keyword_span.clone()), message)
        .key("old")
        .case(PASSED_OVER);
    let evidence = Evidence::of_cases(found.iter().map(|entry| entry.keyword.to_string()));
    Some(
        finding
            .evidence(evidence)
            .help("remove the line, or leave it: nothing is lost"),
    )
}

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for text in texts(body) {
        out.extend(passed_over(&text));
        let old = text.clothes.faults.of(|kind| kind == FaultKind::OldFormat);
        let Some(first) = old.and_then(|(faults, _)| faults.first()) else {
            continue;
        };
        let message = "`weights` belongs to an old format that is no longer read";
        let finding = RULE.at(text.file, Place::Span(first.span.clone()), message);
        out.push(finding.help(
            "keep a copy; export the weights to a `.mhw` file for \
            `vertexboneweights_file`, or remove the section to use the weights of the body",
        ));
    }
}
