//! Faces that lose their area or turn over at some setting.

use super::super::{Check, Rule, RuleCx};
use super::{at_setting, percent, untold};
use crate::diag::{Application, Case, Confidence, Evidence, Finding, Level, RuleInfo};
use crate::eval::measures::{Measures, Seen};
use crate::repo::Body;

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        breaks: &[(Application::Makehuman2, "shows black or missing faces: without area a face has no normal")],
        docs: "At some setting of the sliders visible faces have (almost) no area, or a considerable part of the skin looks \
            inwards.\n\nA face has collapsed when its area falls to a ten-thousandth of what it is on the default character. \
            None of MakeHuman's own base does at any setting; two faces of its smallest babies come below a \
            thousandth.\n\nFaces that look the other way are normal in small numbers: lips, eyelids and sagging breasts turn \
            over at extremes, up to 2.6 % of the area. They are reported from 5 % of the visible area on.\n\nThe finding \
            stands at the target that moves the largest of these faces most.",
        ..RuleInfo::new(
            "numeric-collapsed-faces",
            Level::Warning,
            "faces that collapse or turn over at some slider setting",
        )
    },
    check: Check::Numeric(run),
};

const FLIPPED: Case = &[(
    Application::Makehuman2,
    Level::Warning,
    "shows the inside of the skin, or holes where back faces are not drawn",
)];

fn run(body: &Body<'_>, measures: &Measures, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some(space) = &measures.space else { return };
    if let Some(seen) = untold(body, space, space.collapsed.as_ref()) {
        let (faces, lose) = if seen.count == 1 { ("face", "loses its") } else { ("faces", "lose their") };
        let message = format!("{} {faces} of `{}` {lose} area", seen.count, seen.name);
        let evidence = Evidence { examples: vec![format!("face {}", seen.element)], ..Evidence::counted(seen.count) };
        out.push(finding(body, seen, &message, "collapsed").evidence(evidence));
    }
    if let Some(seen) = untold(body, space, space.flipped.as_ref()) {
        let share = percent(seen.value);
        let message =
            format!("{} faces of `{}`, {share} of the visible area, look the other way", seen.count, seen.name);
        out.push(
            finding(body, seen, &message, "flipped")
                .evidence(Evidence::counted(seen.count).with_worst(seen.value, format!("face {}", seen.element)))
                .case(FLIPPED),
        );
    }
}

fn finding(body: &Body<'_>, seen: &Seen, message: &str, key: &str) -> Finding {
    at_setting(&RULE, body, seen, message)
        .key(key)
        .parts(&seen.all)
        .confidence(Confidence::Medium)
        .help("look at the figure at this setting; the target overshoots, or several add up")
}
