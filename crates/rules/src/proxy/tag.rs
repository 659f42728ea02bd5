//! Tags must come out as they were written.

use super::super::{Check, Rule, RuleCx};
use super::texts;
use mhlint_diag::{Application::Makehuman2, Finding, Level, Place, RuleInfo};
use mhlint_repo::Body;

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[(
        Makehuman2,
        "shows other tags than written, so that filters miss the asset",
    )],
    docs: include_str!("tag.md").trim_ascii_end(),
    ..RuleInfo::new(
        "proxy-tag",
        Level::Warning,
        "a tag that is not kept as it is written",
    )
});

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for text in texts(body) {
        for entry in text.clothes.all("tag") {
            let Some((message, help)) = fault(&entry.value) else {
                continue;
            };
            let finding = RULE
                .at(text.file, Place::Span(entry.span.clone()), message)
                .key(&*entry.value);
            out.push(finding.help(help));
        }
    }
}

/// What becomes of a tag, and what to do.
fn fault(tag: &str) -> Option<(String, &'static str)> {
    let kept: String = tag.chars().filter(char::is_ascii).collect();
    let lost = tag
        .chars()
        .any(|letter| !letter.is_ascii() && letter.is_alphanumeric());
    if tag.contains('|') {
        Some((
            format!("the tag `{tag}` is split at `|`"),
            "write a line `tag` for each tag",
        ))
    } else if tag.contains(';') {
        Some((
            format!("`{tag}` is one tag: `;` does not separate tags"),
            "write a line `tag` for each tag",
        ))
    } else if lost {
        Some((
            format!("the tag `{tag}` becomes `{}`", kept.to_lowercase()),
            "write the tag with letters a to z",
        ))
    } else {
        None
    }
}
