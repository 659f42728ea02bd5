//! A target for the left is the mirror image of the one for the right.

use super::super::units::length;
use super::super::{Check, Rule, RuleCx, such};
use super::shown::with_setting;
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2, Mpfb},
    Case, Element, Evidence, Finding, Grows, Level, MeasureKind, Place, RuleInfo, grouped,
};
use mhlint_eval::measures::{Measures, PairMeasure};
use mhlint_repo::{Body, FileFacts};

pub(crate) static RULE: Rule = Check::Numeric(run).rule(RuleInfo {
    breaks: &[
        (
            Makehuman2,
            "gives left and right different shapes for the same slider values",
        ),
        (
            Makehuman1,
            "gives left and right different shapes for the same slider values",
        ),
        (
            Mpfb,
            "gives left and right different shapes for the same slider values",
        ),
    ],
    docs: include_str!("asymmetric_pair.md").trim_ascii_end(),
    counts: "vertices",
    grows: Grows::more(MeasureKind::Distance),
    ..RuleInfo::new(
        "target-asymmetric-pair",
        Level::Warning,
        "left and right targets are not mirror images",
    )
});

const EXCHANGED: Case = &[
    (
        Makehuman2,
        Level::Warning,
        "moves the left/right counterpart of what the slider says",
    ),
    (
        Makehuman1,
        Level::Warning,
        "moves the left/right counterpart of what the slider says",
    ),
    (
        Mpfb,
        Level::Warning,
        "moves the left/right counterpart of what the slider says",
    ),
];
const ON_HELPERS: Case = &[
    (
        Makehuman2,
        Level::Info,
        "fits clothes and hair asymmetrically at these helpers; the body is symmetric",
    ),
    (
        Makehuman1,
        Level::Info,
        "fits clothes and hair asymmetrically at these helpers; the body is symmetric",
    ),
    (
        Mpfb,
        Level::Info,
        "fits clothes and hair asymmetrically at these helpers; the body is symmetric",
    ),
];

fn run(body: &Body<'_>, measures: &Measures, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let (exchanged, others): (Vec<_>, Vec<_>) =
        measures.pairs.iter().partition(|pair| pair.is_exchanged);
    out.extend(others.into_iter().filter_map(|pair| finding(body, pair)));
    let files = exchanged.into_iter().filter_map(|pair| files(body, pair));
    let folder = |[left, _]: [&FileFacts; 2]| left.folder().to_owned();
    for pairs in grouped(files.map(|pair| (folder(pair), pair))).into_values() {
        out.extend(self::exchanged(body, &pairs));
    }
}

/// The two targets, if neither moves nothing at all: that is a finding of its own.
fn files<'b>(body: &'b Body<'_>, pair: &PairMeasure) -> Option<[&'b FileFacts; 2]> {
    let files = [
        body.target(&pair.left)?.file,
        body.target(&pair.right)?.file,
    ];
    let is_still = |file: &&FileFacts| file.target().is_some_and(|facts| facts.moving == 0);
    (!files.iter().any(is_still)).then_some(files)
}

/// Each moves the side that the other one is for: one finding for those of a folder.
fn exchanged(body: &Body<'_>, pairs: &[[&FileFacts; 2]]) -> Option<Finding> {
    let [left, right] = *pairs.first()?;
    let stem = right.stem().trim_end_matches(".target");
    let more = such(pairs.len(), "pairs");
    let message =
        format!("moves the right side of the body, and `{stem}` moves the left one{more}");
    let finding = RULE
        .at(left, Place::File, message)
        .key("exchanged")
        .case(EXCHANGED);
    let finding = finding.related(&right.path, Place::File, "its counterpart");
    let finding = finding.evidence(Evidence::of_cases(
        pairs.iter().map(|[left, _]| left.file_name()),
    ));
    let finding = finding.between(pairs.iter().flatten().map(|file| &file.path));
    Some(with_setting(
        finding.help("exchange the names of the two files"),
        body,
        left,
    ))
}

fn finding(body: &Body<'_>, pair: &PairMeasure) -> Option<Finding> {
    let [left, right] = files(body, pair)?;
    let on_body = !pair.body.different.is_empty();
    let difference = if on_body {
        &pair.body
    } else {
        &pair.difference
    };
    let different = difference.different.len();
    let (vertex, worst) = difference.worst.filter(|_| different > 0)?;
    let differing = match (different, on_body) {
        (1, _) => String::new(),
        (count, true) => format!("{count} body vertices differ, most "),
        (count, false) => format!("{count} helper vertices differ, most "),
    };
    let differs = if different == 1 { " differs" } else { "" };
    let message = format!(
        "not the mirror image of `{}`: {differing}{}{differs} by {}",
        right.stem().trim_end_matches(".target"),
        body.vertex(vertex),
        length(worst),
    );
    let place = Place::Element(Element {
        kind: "vertex",
        index: u64::from(vertex),
    });
    let evidence = Evidence::counted(different);
    let finding = RULE
        .at(left, place, message)
        .parts(&difference.different)
        .between([&left.path, &right.path])
        .related(&right.path, Place::File, "its counterpart")
        .help(
            "leave them if the difference is intended; otherwise mirror the better one, and \
            keep a copy of the other",
        )
        .evidence(
            evidence
                .out_of(difference.compared)
                .with_worst(worst, format!("vertex {vertex}")),
        );
    let finding = with_setting(finding, body, left);
    Some(if on_body {
        finding
    } else {
        finding.case(ON_HELPERS)
    })
}
