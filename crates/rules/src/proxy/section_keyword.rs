//! The two sections of an asset must be opened by their keywords.

use super::super::{Check, Rule, RuleCx};
use super::keywords;
use super::sections::{keyword_below_list, misspelt_list};
use super::{INDEX, Text, VALUE, blender, lines, more, texts};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2, Mpfb},
    Case, Finding, Level, Place, RuleInfo,
};
use mhlint_formats::mhclo::{Entry, FaultKind};
use mhlint_repo::Body;

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[
        (
            Makehuman2,
            "reads the numbers as something else and crashes when the asset is put on",
        ),
        (
            Makehuman1,
            "reads the numbers as something else and does not put the asset on",
        ),
        (Mpfb, "ignores the list: the body shows through the asset"),
    ],
    levels: &[(Mpfb, Level::Warning)],
    docs: include_str!("section_keyword.md").trim_ascii_end(),
    ..RuleInfo::new(
        "proxy-section-keyword",
        Level::Error,
        "a section keyword is misspelt, missing or misplaced",
    )
});

/// The rows go on, and the numbers of the list are rows as well.
const MORE_ROWS: Case = &[
    (
        Makehuman2,
        Level::Error,
        "reads the list as vertex rows and crashes when the asset is put on; models that wear it \
            load only in part",
    ),
    (
        Makehuman1,
        Level::Error,
        "does not put the asset on: it reads the keyword as a vertex row",
    ),
];

/// Below it are as many rows as the mesh has vertices.
const SURPLUS: Case = &[
    (Makehuman2, Level::Warning, "ignores the line"),
    (Makehuman1, Level::Warning, "ignores the line"),
];

/// Rows that nobody reads.
const ABOVE: Case = &[
    (
        Makehuman2,
        Level::Warning,
        "ignores the line: every vertex gets the row of a later one, and the last vertices have \
            none",
    ),
    (
        Makehuman1,
        Level::Error,
        "ignores the line and does not put the asset on, as rows and vertices differ in number",
    ),
];

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    if body.is_mpfb() {
        return blender::list::keywords(&RULE, body, out);
    }
    for text in texts(body) {
        out.extend(rows(&text));
        out.extend(above(&text));
        out.extend(list(&text).or_else(|| dash_among_rows(&text)));
        out.extend(keyword_in_list(&text));
    }
}

fn above(text: &Text<'_, '_>) -> Option<Finding> {
    let (faults, count) = text
        .reading
        .faults(|kind| kind == FaultKind::NumbersInHeader)?;
    // The numbers of an old section belong to it.
    let is_old = text
        .reading
        .faults(|kind| kind == FaultKind::OldFormat)
        .is_some();
    let first = faults
        .first()
        .filter(|_| text.reading.opens_rows() && !is_old)?;
    let message = format!("a line of numbers is above `verts`{}", more(count));
    let is_complete = text
        .worn
        .mesh()
        .is_some_and(|(_, mesh)| mesh.facts.vertices == text.clothes.rows.count);
    let (case, help) = match text.clothes.rows.count {
        0 => (INDEX, "move `verts` above all vertex rows"),
        // A misspelt list has a finding of its own.
        _ if is_complete && text.misspelt("delete_verts").is_some() => return None,
        _ if is_complete => (SURPLUS, "remove the line, or write `delete_verts` above it"),
        _ => (ABOVE, "move `verts` above all vertex rows"),
    };
    let finding = RULE
        .at(text.file, Place::Line(first.line), message)
        .key("above")
        .case(case);
    Some(finding.help(help).evidence(lines(&faults, count)))
}

fn rows(text: &Text<'_, '_>) -> Option<Finding> {
    if text.reading.opens_rows() || text.has_hidden("verts") {
        return None;
    }
    let numbers = text
        .reading
        .faults(|kind| kind == FaultKind::NumbersInHeader);
    if let Some(entry) = text.misspelt("verts") {
        let message = format!(
            "`{}` is not the keyword `verts`: the asset has no vertex rows",
            entry.written()
        );
        let help = format!("write `{}`", keywords::corrected(entry, "verts"));
        return Some(told(text, entry, message, INDEX).help(help));
    }
    let message = "the keyword `verts` is missing: the asset has no vertex rows";
    let place = numbers
        .as_ref()
        .and_then(|(faults, _)| faults.first())
        .map_or(Place::File, |fault| Place::Line(fault.line));
    let help = if numbers.is_some() {
        "add a line `verts` above the vertex rows"
    } else {
        "export the asset again"
    };
    Some(
        RULE.at(text.file, place, message)
            .key("verts")
            .case(INDEX)
            .help(help),
    )
}

fn list(text: &Text<'_, '_>) -> Option<Finding> {
    let entry = misspelt_list(text)?;
    let message = format!(
        "`{}` is not the keyword `delete_verts`: its numbers are read as vertex rows",
        entry.written()
    );
    let help = format!("write `{}`", keywords::corrected(entry, "delete_verts"));
    Some(told(text, entry, message, MORE_ROWS).help(help))
}

/// A range is no row.
fn dash_among_rows(text: &Text<'_, '_>) -> Option<Finding> {
    let (faults, _) = text.reading.faults(|kind| kind == FaultKind::RowWord)?;
    let first = faults.iter().find(|fault| &*fault.word == "-")?;
    let message =
        "a range of vertices is among the vertex rows: `delete_verts` is missing above it";
    let finding = RULE
        .at(text.file, Place::Line(first.line), message)
        .key("delete_verts")
        .case(VALUE);
    Some(finding.help("add a line `delete_verts` above the vertices to hide"))
}

/// A line of the head that stands in the list.
fn keyword_in_list(text: &Text<'_, '_>) -> Option<Finding> {
    let entry = keyword_below_list(text)?;
    let message = format!(
        "`{}` is below `delete_verts`, where it is not read as a keyword",
        entry.keyword
    );
    Some(told(text, entry, message, VALUE).help("move the line above `verts`, or remove it"))
}

fn told(text: &Text<'_, '_>, entry: &Entry, message: String, case: Case) -> Finding {
    RULE.at(text.file, Place::Span(entry.keyword_span.clone()), message)
        .key(&*entry.keyword)
        .case(case)
}
