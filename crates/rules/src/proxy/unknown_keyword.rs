//! Misspelt keywords.

use super::super::{Check, Rule, RuleCx};
use super::{keywords, sections, texts};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2},
    Case, Finding, Level, Place, RuleInfo,
};
use mhlint_repo::Body;

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[
        (Makehuman2, "ignores the line"),
        (Makehuman1, "ignores the line"),
    ],
    docs: include_str!("unknown_keyword.md").trim_ascii_end(),
    ..RuleInfo::new(
        "proxy-unknown-keyword",
        Level::Warning,
        "a misspelt keyword",
    )
});

const HARMLESS: Case = &[
    (
        Makehuman2,
        Level::Info,
        "ignores the line, which is only for readers",
    ),
    (
        Makehuman1,
        Level::Info,
        "ignores the line, which is only for readers",
    ),
];

/// Those of which the loss has a rule of its own.
const TOLD: [&str; 6] = ["name", "uuid", "obj_file", "verts", "delete_verts", "tag"];

const LOST: [&str; 4] = ["name", "uuid", "obj_file", "verts"];

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for text in texts(body) {
        for entry in &text.clothes.entries {
            // Below `verts` the line is a row to MakeHuman 1, and has a finding of its own.
            let is_row = || sections::is_among_rows(&text, entry) || keywords::is_licence(entry);
            let is_told = |meant: &&str| {
                if text.is_makehuman1() {
                    LOST.contains(meant) || is_row()
                } else {
                    TOLD.contains(meant)
                }
            };
            let Some(meant) =
                keywords::meant_in(text.application, entry).filter(|meant| !is_told(meant))
            else {
                continue;
            };
            // With a line of the right keyword nothing is missing.
            // Each tag counts.
            let is_there = text.reading.last(meant).is_some() && meant != "tag";
            let message = format!("unknown keyword `{}`", entry.written());
            let finding = RULE
                .at(text.file, Place::Span(entry.keyword_span.clone()), message)
                .key(&*entry.keyword);
            let finding = if is_there || keywords::is_harmless(meant) {
                finding.case(HARMLESS)
            } else {
                finding
            };
            let is_spelt = *meant == *entry.keyword;
            let without_colon = || match &*meant {
                // Without a colon it stops the loader.
                "homepage" => "write `# homepage`: it is read in comments alone".to_owned(),
                meant => format!("write `{meant}` without the colon"),
            };
            out.push(finding.help(if is_spelt {
                without_colon()
            } else {
                format!("did you mean `{}`?", keywords::corrected(entry, meant))
            }));
        }
    }
}
