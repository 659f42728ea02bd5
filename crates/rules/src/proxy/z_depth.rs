//! What is drawn and hides above what.

use super::super::{Check, Rule, RuleCx};
use super::{OVERFLOW, Text, texts};
use mhlint_diag::{Application::Makehuman2, Case, Finding, Level, Place, RuleInfo};
use mhlint_formats::python_int;
use mhlint_repo::{Body, Worn};

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[(
        Makehuman2,
        "treats the asset as the topology in the glTF export and gives it the material of the skin",
    )],
    docs: include_str!("z_depth.md").trim_ascii_end(),
    ..RuleInfo::new(
        "proxy-z-depth",
        Level::Warning,
        "a z_depth that is out of range or changes",
    )
});

const CHANGES: Case = &[(
    Makehuman2,
    Level::Warning,
    "puts it above the hair at first, and below it from the second start on",
)];
const NO_VALUE: Case = &[(Makehuman2, Level::Warning, "uses 50 instead")];

/// What hair has when it is loaded from its archive.
const OF_PACKED_HAIR: i64 = 255;
const USUAL: i64 = 50;

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let has_topology = body.worn.iter().any(Worn::is_topology);
    let lowest_hair = texts(body)
        .filter(is_hair)
        .map(|text| depth(&text).unwrap_or(USUAL))
        .min();
    for text in texts(body).filter(|text| !text.reading.stops()) {
        out.extend(without_value(&text));
        let Some(depth) = depth(&text) else { continue };
        let Some(entry) = text.reading.last("z_depth") else {
            continue;
        };
        let told = |message: String| RULE.at(text.file, Place::Span(entry.word_span()), message);
        if i32::try_from(depth).is_err() {
            let finding = told(format!("`z_depth {}` is beyond 32 bits", entry.word()));
            out.push(
                finding
                    .key("size")
                    .case(OVERFLOW)
                    .help("write a number from 2 to 1000"),
            );
        } else if depth <= 0 && has_topology && !text.worn.is_topology() {
            let finding = told(format!(
                "`z_depth {depth}` is below that of a topology, which is 1"
            ));
            out.push(finding.help("write 2 or more"));
        } else if is_hat(&text, depth, lowest_hair) {
            let finding = told(format!(
                "`z_depth {depth}` is above the hair at first, and below it (255) from the second \
                    start on"
            ));
            out.push(
                finding
                    .key("hair")
                    .case(CHANGES)
                    .help("write a number from 256 to 1000 to stay above the hair"),
            );
        }
    }
}

/// Clothes that are meant to lie above all hair, by their number.
fn is_hat(text: &Text<'_, '_>, depth: i64, hair: Option<i64>) -> bool {
    let is_above = hair.is_some_and(|hair| depth > hair && (depth > FAR_ABOVE || hair > CLOTHES));
    is_above && depth <= OF_PACKED_HAIR && !is_hair(text) && !text.worn.is_topology()
}

/// The highest number that clothes have by custom: hair above it is meant to lie above them.
const CLOTHES: i64 = 69;

/// Numbers up to here are usual for clothes that nobody wants to lie above hair.
const FAR_ABOVE: i64 = 100;

fn is_hair(text: &Text<'_, '_>) -> bool {
    text.file.rel.starts_with("hair/")
}

fn depth(text: &Text<'_, '_>) -> Option<i64> {
    python_int(text.reading.last("z_depth")?.word().as_bytes())
}

fn without_value(text: &Text<'_, '_>) -> Option<Finding> {
    let entries = &text.clothes.entries;
    let empty = entries
        .iter()
        .find(|entry| &*entry.keyword == "z_depth" && entry.value.is_empty())?;
    if text.reading.last("z_depth").is_some() || text.worn.is_topology() {
        return None;
    }
    let finding = RULE.at(
        text.file,
        Place::Span(empty.keyword_span.clone()),
        "`z_depth` has no value",
    );
    Some(
        finding
            .key("value")
            .case(NO_VALUE)
            .help("write a number of 2 or more after it"),
    )
}
