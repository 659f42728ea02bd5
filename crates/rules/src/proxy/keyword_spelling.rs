//! What one reader of an asset finds and the other does not.

use super::super::{Check, Rule, RuleCx};
use super::{Text, texts};
use mhlint_diag::{Application::Makehuman2, Case, Finding, Level, Place, RuleInfo};
use mhlint_formats::mhclo::Entry;
use mhlint_repo::Body;

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[(
        Makehuman2,
        "reads the line in one place and ignores it in another",
    )],
    docs: include_str!("keyword_spelling.md").trim_ascii_end(),
    ..RuleInfo::new(
        "proxy-keyword-spelling",
        Level::Warning,
        "a line that only one reader of an asset understands",
    )
});

const COLON: Case = &[(
    Makehuman2,
    Level::Warning,
    "does not read it for the library until the asset has been put on once; models saved before \
        do not find the asset again",
)];
const TAG: Case = &[(
    Makehuman2,
    Level::Warning,
    "reads the line as a tag until the asset has been put on once",
)];
const AUTHOR: Case = &[(Makehuman2, Level::Warning, "shows the author as unknown")];
const UNSEEN_AUTHOR: Case = &[(
    Makehuman2,
    Level::Info,
    "shows the author as unknown until the asset has been put on once",
)];
const NO_AUTHOR: Case = &[(
    Makehuman2,
    Level::Warning,
    "reads the words after `author` as the author",
)];

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for text in texts(body) {
        for keyword in ["name", "uuid"] {
            out.extend(colon(&text, keyword));
        }
        out.extend(
            text.clothes
                .entries
                .iter()
                .filter_map(|entry| stray_tag(&text, entry)),
        );
        out.extend(
            text.clothes
                .entries
                .iter()
                .find_map(|entry| stray_author(&text, entry)),
        );
        out.extend(hidden_author(&text));
    }
}

fn colon(text: &Text<'_, '_>, keyword: &str) -> Option<Finding> {
    let scanned = &text.clothes.scanned;
    let is_seen = if keyword == "name" {
        scanned.name.is_some()
    } else {
        scanned.uuid.is_some()
    };
    let entry = text
        .reading
        .last(keyword)
        .filter(|entry| entry.has_colon && !is_seen)?;
    Some(
        told(text, entry, format!("`{keyword}:` has a colon"), COLON)
            .help(format!("write `{keyword}` without a colon")),
    )
}

/// A line of the head that the library counts as a tag, and nothing else does.
fn stray_tag(text: &Text<'_, '_>, entry: &Entry) -> Option<Finding> {
    let is_scanned = text
        .clothes
        .scanned
        .tags
        .iter()
        .any(|tag| tag.line == entry.line);
    if !is_scanned || entry.is_comment || &*entry.keyword == "tag" {
        return None;
    }
    let message = format!(
        "the library reads the line `{} …` as a tag because it contains `tag`",
        entry.keyword
    );
    let help = if entry.keyword.to_lowercase().starts_with("tag") {
        "write a line `tag` for each tag".to_owned()
    } else {
        "use other words, or move the text into a comment above".to_owned()
    };
    Some(told(text, entry, message, TAG).help(help))
}

fn stray_author(text: &Text<'_, '_>, entry: &Entry) -> Option<Finding> {
    let author = text
        .clothes
        .scanned
        .author
        .as_ref()
        .filter(|author| author.line == entry.line)?;
    if entry.is_comment {
        return None;
    }
    let message = format!("the library reads `{}` as the author", author.text);
    Some(told(text, entry, message, NO_AUTHOR).help("begin the text with another word"))
}

/// A comment that is meant to name the author.
fn hidden_author(text: &Text<'_, '_>) -> Option<Finding> {
    if text.clothes.scanned.author.is_some() {
        return None;
    }
    if let Some(entry) = text.clothes.last("author") {
        let message = "the library looks for the author in a comment only";
        let finding = told(text, entry, message.to_owned(), UNSEEN_AUTHOR);
        return Some(finding.help(format!("write `# author {}` as well", entry.value)));
    }
    let glued = text.clothes.scanned.glued_author.as_ref()?;
    let message = format!("`{}` is not read as the author", glued.text);
    let finding = RULE
        .at(text.file, Place::Span(glued.span.clone()), message)
        .key("author")
        .case(AUTHOR);
    Some(finding.help("put a space after the `#`: `# author …`"))
}

fn told(text: &Text<'_, '_>, entry: &Entry, message: String, case: Case) -> Finding {
    RULE.at(text.file, Place::Span(entry.keyword_span.clone()), message)
        .key(&*entry.keyword)
        .case(case)
}
