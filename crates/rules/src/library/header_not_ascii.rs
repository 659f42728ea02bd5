//! What an asset says of itself must fit into the binary that is made of it.

use super::super::{Check, Rule, RuleCx, plain_letters, such};
use mhlint_diag::{Application::Makehuman2, Evidence, Finding, Level, Place, RuleInfo};
use mhlint_discover::Kind;
use mhlint_formats::mhclo::{Clothes, Entry};
use mhlint_repo::{FileFacts, View};

pub(crate) static RULE: Rule = Check::File(run).rule(RuleInfo {
    breaks: &[(
        Makehuman2,
        "crashes with `UnicodeEncodeError` each time the asset is put on",
    )],
    docs: include_str!("header_not_ascii.md").trim_ascii_end(),
    ..RuleInfo::new(
        "library-header-not-ascii",
        Level::Error,
        "a value of an asset that is not ASCII",
    )
});

/// What is written into the binary, beside the tags.
const WRITTEN: [&str; 7] = [
    "name",
    "uuid",
    "author",
    "description",
    "license",
    "material",
    "vertexboneweights_file",
];

fn run(view: &View<'_>, file: &FileFacts, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let is_listed = file.kind == Kind::Clothes && (view.layout().scans)(&file.rel);
    // Bytes that are no text are dropped; without them the asset cannot be listed.
    let is_text = file.encoding.invalid_utf8_at.is_none();
    let Some(clothes) = file.clothes().filter(|_| is_listed && is_text) else {
        return;
    };
    let foreign: Vec<&Entry> = WRITTEN
        .iter()
        .filter_map(|keyword| last(clothes, keyword))
        .collect();
    let foreign: Vec<&Entry> = foreign
        .into_iter()
        .filter(|entry| !written(entry).is_ascii())
        .collect();
    let Some(first) = foreign.first() else {
        return out.extend(other_author(file, clothes));
    };
    let letter = written(first)
        .chars()
        .find(|letter| !letter.is_ascii())
        .unwrap_or_default();
    let more = such(foreign.len(), "values");
    let message = format!(
        "`{}` has the letter `{letter}`, which is not ASCII{more}",
        first.keyword
    );
    let finding = RULE.at(file, Place::Span(first.span.clone()), message);
    let evidence = Evidence::of_cases(foreign.iter().map(|entry| entry.keyword.to_string()));
    out.push(finding.evidence(evidence).help(plain_letters(letter)));
}

/// A comment with another word that begins with `author`, such as `# authors`: it counts as well.
fn other_author(file: &FileFacts, clothes: &Clothes) -> Option<Finding> {
    let author = clothes.scanned.author.as_ref()?;
    let letter = author.text.chars().find(|letter| !letter.is_ascii())?;
    let message =
        format!("the comment on the author has the letter `{letter}`, which is not ASCII");
    let finding = RULE
        .at(file, Place::Span(author.span.clone()), message)
        .key("author");
    Some(finding.help(plain_letters(letter)))
}

/// What of a line is written: of the names of files the first word.
fn written(entry: &Entry) -> &str {
    match &*entry.keyword {
        "material" | "vertexboneweights_file" => entry.word(),
        _ => &entry.value,
    }
}

/// The last line that sets a value; an author may stand in a comment.
fn last<'c>(clothes: &'c Clothes, keyword: &str) -> Option<&'c Entry> {
    let sets = |entry: &&Entry| {
        &*entry.keyword == keyword
            && !entry.value.is_empty()
            && (!entry.is_comment || keyword == "author")
    };
    clothes.entries.iter().rev().find(sets)
}
