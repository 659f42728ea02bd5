//! Faces that lose their area or turn over at some setting.

use super::super::{Check, Rule, RuleCx};
use super::{at_setting, percent, untold};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2, Mpfb},
    Case, Confidence, Evidence, Finding, Grows, Level, MeasureKind, RuleInfo,
};
use mhlint_eval::measures::{Measures, Seen};
use mhlint_eval::survey::Trouble;
use mhlint_repo::Body;

pub(crate) static RULE: Rule = Check::Numeric(run).rule(RuleInfo {
    breaks: &[
        (
            Makehuman2,
            "shows these faces black or not at all: a face without area has no normal",
        ),
        (
            Makehuman1,
            "shows these faces black or not at all: a face without area has no normal",
        ),
        (
            Mpfb,
            "shows these faces black or not at all: a face without area has no normal",
        ),
    ],
    docs: include_str!("collapsed_faces.md").trim_ascii_end(),
    counts: "faces",
    grows: Grows::more(MeasureKind::Share),
    ..RuleInfo::new(
        "numeric-collapsed-faces",
        Level::Warning,
        "faces collapse or turn inside out at some slider setting",
    )
});

const FLIPPED: Case = &[(
    Makehuman2,
    Level::Warning,
    "shows the inside of the skin, or holes where backfaces are not drawn",
)];

fn run(body: &Body<'_>, measures: &Measures, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    if let Some(seen) = untold(body, measures, Trouble::Collapsed) {
        let (faces, lose) = if seen.count == 1 {
            ("face", "loses its")
        } else {
            ("faces", "lose their")
        };
        let message = format!("{} {faces} of `{}` {lose} area", seen.count, seen.name);
        let evidence = Evidence {
            examples: vec![format!("face {}", seen.element)],
            ..Evidence::counted(seen.count)
        };
        out.push(finding(body, seen, &message, "collapsed").evidence(evidence));
    }
    if let Some(seen) = untold(body, measures, Trouble::Flipped) {
        let share = percent(seen.value);
        let (faces, turn) = if seen.count == 1 {
            ("face", "turns")
        } else {
            ("faces", "turn")
        };
        let message = format!(
            "{} {faces} of `{}` {turn} inside out, {share} of the visible area",
            seen.count, seen.name
        );
        out.push(
            finding(body, seen, &message, "flipped")
                .evidence(
                    Evidence::counted(seen.count)
                        .with_worst(seen.value, format!("face {}", seen.element)),
                )
                .case(FLIPPED),
        );
    }
}

fn finding(body: &Body<'_>, seen: &Seen, message: &str, key: &str) -> Finding {
    at_setting(&RULE, body, seen, message)
        .key(key)
        .parts(&seen.all)
        .confidence(Confidence::Medium)
        .help("reduce this target, or those that add up with it at this setting")
}
