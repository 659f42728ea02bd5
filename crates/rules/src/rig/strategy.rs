//! The ends of a bone have a strategy by which their places can be found.

use super::super::unfit::findings_in;
use super::super::{Check, Rule, RuleCx, did_you_mean};
use super::ends::{AT_DEFAULT, ends, has_place};
use super::{IN_BONES, STOPS, at_bones, stops};
use mhlint_diag::{Application::Mpfb, Finding, Level, RuleInfo};
use mhlint_formats::rig::{End, Rig, RigBone, Strategy};
use mhlint_repo::mpfb::{RigFile, View};

pub(crate) static RULE: Rule = Check::Mpfb(run).rule(RuleInfo {
    breaks: &[(Mpfb, STOPS)],
    docs: include_str!("strategy.md").trim_ascii_end(),
    counts: "bones",
    ..RuleInfo::new(
        "rig-strategy",
        Level::Error,
        "an end of a bone has a strategy that gives no place",
    )
});

const STRATEGIES: [&str; 4] = ["CUBE", "VERTEX", "MEAN", "XYZ"];

fn run(view: &View<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for (file, rig) in view.own_rigs() {
        let found = findings_in(IN_BONES, &RULE, file.file, &rig.faults.ends, cx);
        out.extend(found.map(|(_, finding)| stops(file, finding)));
        for (is_so, key) in SORTS {
            for has_default in [false, true] {
                out.extend(finding(file, rig, is_so, key, has_default, cx));
            }
        }
    }
}

type IsSo = fn(&Strategy) -> bool;

/// Strategies that find no place on any mesh.
const SORTS: [(IsSo, &str); 3] = [
    (
        |strategy| matches!(strategy, Strategy::Unknown(_)),
        "unknown",
    ),
    (
        |strategy| matches!(strategy, Strategy::Mean(vertices) if vertices.is_empty()),
        "empty",
    ),
    (
        |strategy| matches!(strategy, Strategy::Xyz(vertices) if vertices.len() < 3),
        "three",
    ),
];

fn finding(
    file: &RigFile<'_>,
    rig: &Rig,
    is_so: IsSo,
    key: &'static str,
    has_default: bool,
    cx: &RuleCx<'_>,
) -> Option<Finding> {
    let is_meant = |end: &End| is_so(&end.strategy) && has_place(end) == has_default;
    let found = ends(rig).filter(|(.., end)| is_meant(end));
    let found: Vec<(&RigBone, &'static str, &End)> = found.collect();
    let (bone, which, end) = found.first()?;
    let subject = format!("`{which}` of bone `{}`", bone.name);
    let (message, help) = match &end.strategy {
        Strategy::Unknown(name) => {
            let near = STRATEGIES
                .into_iter()
                .find(|known| known.eq_ignore_ascii_case(name));
            let near = near.or_else(|| cx.suggestions.nearest(name, STRATEGIES));
            let help = did_you_mean(near, "write CUBE, VERTEX, MEAN or XYZ");
            (format!("{subject} has the unknown strategy `{name}`"), help)
        }
        Strategy::Xyz(vertices) => {
            let help = "name three vertices: for x, for y and for z".to_owned();
            (
                format!(
                    "{subject} has {} vertices for XYZ, expected 3",
                    vertices.len()
                ),
                help,
            )
        }
        _ => (
            format!("{subject} has no vertex for MEAN"),
            "name the vertices whose mean it is".to_owned(),
        ),
    };
    let message = format!("{message}{}", super::super::such(found.len(), "ends"));
    let bones: Vec<&str> = found.iter().map(|(bone, ..)| bone.name.as_str()).collect();
    let finding = at_bones(&RULE, file, rig, &bones, which, message)?.help(help);
    let finding = finding.key(if has_default {
        key.to_owned()
    } else {
        format!("{key} without default")
    });
    Some(if has_default {
        finding.case(AT_DEFAULT)
    } else {
        stops(file, finding)
    })
}
