//! Who made an asset belongs into comments.

use super::super::{Check, Rule, RuleCx, such};
use super::{keywords, texts};
use mhlint_diag::{Application::Makehuman1, Evidence, Finding, Level, Place, RuleInfo};
use mhlint_formats::mhclo::Entry;
use mhlint_repo::Body;

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[(
        Makehuman1,
        "does not put the asset on: `AttributeError` when it reads such a line",
    )],
    docs: include_str!("licence_keyword.md").trim_ascii_end(),
    ..RuleInfo::new(
        "proxy-licence-keyword",
        Level::Error,
        "author or licence of an asset outside of a comment",
    )
});

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for text in texts(body) {
        let found: Vec<&Entry> = text
            .clothes
            .entries
            .iter()
            .filter(|entry| keywords::is_licence(entry))
            .collect();
        let Some(first) = found.first() else { continue };
        let more = such(found.len(), "lines");
        let message = format!("`{}` is outside of a comment{more}", first.keyword);
        let finding = RULE.at(text.file, Place::Span(first.keyword_span.clone()), message);
        let evidence = Evidence::of_cases(found.iter().map(|entry| entry.keyword.to_string()));
        out.push(
            finding
                .evidence(evidence)
                .help(format!("write `# {} …`", first.keyword)),
        );
    }
}
