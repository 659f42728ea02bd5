//! Numbers of vertex rows must be finite.

use super::super::{Check, Rule, RuleCx};
use super::{blender, lone_archives, texts};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2, Mpfb},
    Finding, Level, Place, RuleInfo,
};
use mhlint_formats::mhclo::RowFacts;
use mhlint_repo::{Body, FileFacts};

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[
        (
            Makehuman2,
            "loses the vertex; the glTF export of the whole figure crashes with `ValueError`",
        ),
        (Makehuman1, "loses the vertex: it is nowhere"),
        (Mpfb, "loses the vertex: it is nowhere"),
    ],
    levels: &[(Makehuman1, Level::Warning), (Mpfb, Level::Warning)],
    docs: include_str!("non_finite.md").trim_ascii_end(),
    ..RuleInfo::new(
        "proxy-non-finite",
        Level::Error,
        "a number of a vertex row is NaN or infinite",
    )
});

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    if body.is_mpfb() {
        return blender::rows::not_finite(&RULE, body, out);
    }
    for text in texts(body).filter(|text| !text.reading.stops()) {
        let rows = &text.clothes.rows;
        let line = rows
            .non_finite
            .first
            .first()
            .map_or(Place::File, |(line, _)| Place::Line(*line));
        let help = "give the row finite numbers, or export the asset again";
        out.extend(finding(
            text.file,
            rows,
            line,
            |vertex| text.vertex(vertex),
            help,
        ));
    }
    let archives = lone_archives(body).filter_map(|archive| {
        finding(
            archive.file,
            archive.rows,
            Place::File,
            |vertex| format!("vertex {vertex}"),
            "export the asset again",
        )
    });
    out.extend(archives);
}

fn finding(
    file: &FileFacts,
    rows: &RowFacts,
    place: Place,
    vertex: impl Fn(i64) -> String,
    help: &str,
) -> Option<Finding> {
    let vertex = vertex(rows.non_finite.first.first()?.1);
    let message = match rows.non_finite.count {
        1 => format!("a number in the row of {vertex} is NaN or infinite"),
        count => {
            format!("numbers in the rows of {count} vertices are NaN or infinite, first {vertex}")
        }
    };
    Some(
        RULE.at(file, place, message)
            .evidence(rows.non_finite.evidence(rows.count))
            .help(help),
    )
}
