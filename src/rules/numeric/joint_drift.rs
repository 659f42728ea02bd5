//! A joint that leaves its limb at some setting.

use super::super::{Check, Rule, RuleCx};
use super::{at_setting, untold};
use crate::diag::{Application, Confidence, Evidence, Finding, Level, RuleInfo};
use crate::eval::measures::Measures;
use crate::repo::Body;

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        breaks: &[(
            Application::Makehuman2,
            "turns the limb around a point outside of it as soon as the figure is posed",
        )],
        docs: "At some setting of the sliders a joint is away from the skin that surrounds it.\n\nA joint is compared with \
            the sixteen vertices of visible skin nearest to it on the default character. Its distance from their middle \
            may grow by three times its stand there, the stand being that distance plus the radius of the skin. In \
            MakeHuman's own base toes and spine come to 2.2 at the corners of age and weight.\n\nMostly a target moves a \
            joint cube and not the skin, or the skin and not the cube. The finding stands at the target that moves the joint \
            most at that setting.",
        ..RuleInfo::new("numeric-joint-drift", Level::Warning, "a joint that leaves its limb at some slider setting")
    },
    check: Check::Numeric(run),
};

fn run(body: &Body<'_>, measures: &Measures, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some(space) = &measures.space else { return };
    let Some(seen) = untold(body, space, space.drifted.as_ref()) else { return };
    let message = format!(
        "joint `{}` leaves the skin around it: its distance grows by {:.1} times its stand on the default character",
        seen.name, seen.value
    );
    out.push(
        at_setting(&RULE, body, seen, &message)
            .parts(&seen.all)
            .confidence(Confidence::Medium)
            .help("move joint cube and skin together")
            .evidence(Evidence::counted(seen.count).with_worst(seen.value, &*seen.name)),
    );
}
