//! A joint that leaves its limb at some setting.

use super::super::units::length;
use super::super::{Check, Rule, RuleCx};
use super::{at_setting, untold};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2},
    Confidence, Evidence, Finding, Grows, Level, MeasureKind, RuleInfo,
};
use mhlint_eval::measures::Measures;
use mhlint_eval::survey::Trouble;
use mhlint_repo::Body;

pub(crate) static RULE: Rule = Check::Numeric(run).rule(RuleInfo {
    breaks: &[
        (
            Makehuman2,
            "rotates the limb around a point outside it as soon as the figure is posed",
        ),
        (
            Makehuman1,
            "rotates the limb around a point outside it as soon as the figure is posed",
        ),
    ],
    docs: include_str!("joint_drift.md").trim_ascii_end(),
    counts: "joints",
    grows: Grows::more(MeasureKind::Distance),
    ..RuleInfo::new(
        "numeric-joint-drift",
        Level::Warning,
        "a joint leaves its limb at some slider setting",
    )
});

fn run(body: &Body<'_>, measures: &Measures, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some(seen) = untold(body, measures, Trouble::Drifted) else {
        return;
    };
    let away = seen
        .length
        .map(|away| format!(" {}", length(away)))
        .unwrap_or_default();
    let message = format!(
        "joint `{}` moves{away} away from the skin around it, {:.1} times its reach",
        seen.name, seen.value
    );
    out.push(
        at_setting(&RULE, body, seen, &message)
            .parts(&seen.all)
            .confidence(Confidence::Medium)
            .help("move the joint cube and the skin together")
            .evidence(Evidence::counted(seen.count).with_worst(seen.value, &*seen.name)),
    );
}
