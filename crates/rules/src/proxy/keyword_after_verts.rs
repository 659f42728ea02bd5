//! Below the vertex rows only some lines are found.

use super::super::{Check, Rule, RuleCx, such};
use super::keywords::known_to_makehuman1;
use super::{Text, blender, sections, texts};
use mhlint_diag::{
    Application::{Makehuman1, Mpfb},
    Case, Evidence, Finding, Level, Place, RuleInfo,
};
use mhlint_formats::mhclo::{Entry, Section};
use mhlint_repo::Body;

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[
        (
            Makehuman1,
            "does not put the asset on: it reads the line as a vertex row",
        ),
        (
            Mpfb,
            "takes the line for the end of the rows, and fails with `KeyError` when it fits \
            the asset",
        ),
    ],
    docs: include_str!("keyword_after_verts.md").trim_ascii_end(),
    ..RuleInfo::new(
        "proxy-keyword-after-verts",
        Level::Error,
        "a line below the vertex rows that does not belong there",
    )
});

const TAG: Case = &[(
    Makehuman1,
    Level::Warning,
    "does not show the tag in the library: it looks no further than `verts`",
)];
const UUID: Case = &[(
    Makehuman1,
    Level::Warning,
    "does not find the asset for saved models: the library looks no further than `verts`",
)];

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    if body.is_mpfb() {
        return blender::rows::lost(&RULE, body, out);
    }
    for text in texts(body) {
        out.extend(unknown(&text));
        out.extend(unseen(&text, "tag", TAG));
        // From the data of a user an archive is made, in which it is found.
        if body.layers.checks_system() {
            out.extend(unseen(&text, "uuid", UUID));
        }
    }
}

/// Below the list of vertices to hide any such word is told as one that is not a number.
fn unknown(text: &Text<'_, '_>) -> Option<Finding> {
    if !text.reading.opens_rows() {
        return None;
    }
    let list = sections::misspelt_list(text).map(|entry| entry.line);
    let is_unknown = |entry: &&Entry| {
        let is_known = known_to_makehuman1(&entry.keyword) && !entry.has_colon
            || super::keywords::is_licence(entry);
        entry.section == Section::Vertices
            && !entry.is_comment
            && !is_known
            && Some(entry.line) != list
    };
    let found: Vec<&Entry> = text.clothes.entries.iter().filter(is_unknown).collect();
    let first = found.first()?;
    let more = such(found.len(), "lines");
    let message = format!("`{}` below `verts` is not a keyword{more}", first.written());
    let finding = RULE.at(text.file, Place::Span(first.keyword_span.clone()), message);
    let evidence = Evidence::of_cases(found.iter().map(|entry| entry.keyword.to_string()));
    Some(
        finding
            .evidence(evidence)
            .help("correct the keyword, or remove the line"),
    )
}

/// A line that only who reads all of the file finds.
fn unseen(text: &Text<'_, '_>, keyword: &str, case: Case) -> Option<Finding> {
    let is_below = |entry: &&Entry| entry.section != Section::Header && !entry.has_colon;
    let entry = text.clothes.all(keyword).find(is_below)?;
    let is_told = keyword == "uuid"
        && text
            .clothes
            .all(keyword)
            .any(|entry| entry.section == Section::Header);
    let message = format!("`{keyword}` is below `verts`");
    let finding = RULE
        .at(text.file, Place::Span(entry.keyword_span.clone()), message)
        .key(keyword)
        .case(case);
    (!is_told).then(|| finding.help("move the line above `verts`"))
}
