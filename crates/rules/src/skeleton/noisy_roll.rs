//! A bone stands across the normal that gives its roll.

use super::super::{Check, Rule, RuleCx};
use super::measured::{Measured, NO_LENGTH, measured, plane_of};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2},
    Evidence, Finding, Grows, Level, MeasureKind, OptionInfo, Place, RuleInfo,
};
use mhlint_eval::measures::Measures;
use mhlint_repo::Body;

pub(crate) static RULE: Rule = Check::Numeric(run).rule(RuleInfo {
    breaks: &[
        (
            Makehuman2,
            "turns the bone around its own axis by a value that may change with every \
            slider",
        ),
        (
            Makehuman1,
            "turns the bone around its own axis by a value that may change with every \
            slider",
        ),
    ],
    docs: include_str!("noisy_roll.md").trim_ascii_end(),
    options: &[OptionInfo {
        name: "cosine",
        default: 0.999,
        docs: "cosine of the angle between bone and normal above which the roll counts as noise \
            (0.999 is 2.6°)",
    }],
    counts: "bones",
    grows: Grows::less(MeasureKind::Sine),
    ..RuleInfo::new(
        "skeleton-noisy-roll",
        Level::Info,
        "bones are almost parallel to the normal that determines their roll",
    )
});

const WITHOUT: &str =
    "give these bones a `rotation_plane` through three joints that are not on one line";
const WITH: &str = "choose three other joints for the `rotation_plane` of these bones";

fn run(body: &Body<'_>, measures: &Measures, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let cosine = cx.option(&RULE, "cosine");
    let sine = (1.0 - cosine * cosine).max(0.0).sqrt();
    // Other skeletons of MakeHuman 1 copy their axes from the one that it poses.
    let is_posed = |rig: &Measured<'_>| {
        body.default_rig()
            .is_some_and(|posed| posed.file.path == rig.file.path)
    };
    let all = measured(body, measures).into_iter();
    for rig in all.filter(|rig| !body.is_makehuman1() || is_posed(rig)) {
        let noisy = |measure: f64, length: f64| measure < sine && length >= NO_LENGTH;
        let bones: Vec<_> = rig
            .bones()
            .filter(|(_, bone)| noisy(bone.roll_sine, bone.length))
            .collect();
        // Exactly parallel has a rule of its own in the application and does not jitter while it
        // lasts.
        let nearest = |a: f64| if a == 0.0 { f64::INFINITY } else { a };
        let worst = bones
            .iter()
            .min_by(|a, b| nearest(a.1.roll_sine).total_cmp(&nearest(b.1.roll_sine)));
        let Some((bone, measure)) = worst else {
            continue;
        };
        let without = bones
            .iter()
            .filter(|(bone, _)| plane_of(bone).is_none())
            .count();
        let what = if plane_of(bone).is_none() {
            "the vertical"
        } else {
            "the normal of its plane"
        };
        let name = &bone.name;
        let why = match format!("{:.2}", measure.roll_sine.asin().to_degrees()).as_str() {
            "0.00" => format!("it is parallel to {what}"),
            angle => format!("it is only {angle}° off {what}"),
        };
        let message = match bones.len() {
            1 => format!("the roll of bone `{name}` is unstable: {why}"),
            count => format!("the roll of {count} bones is unstable, most that of `{name}`: {why}"),
        };
        let evidence = Evidence::of_cases(bones.iter().map(|(bone, _)| &bone.name))
            .out_of(rig.skeleton.bones.len());
        out.push(
            RULE.at(rig.file, Place::key(["bones", &bone.name]), message)
                .help(if without > 0 { WITHOUT } else { WITH })
                .evidence(evidence.with_worst(measure.roll_sine, &bone.name)),
        );
    }
}
