//! What a slider asks of the program exists.

use super::super::{Check, Rule, RuleCx, did_you_mean};
use super::LOST_TABS;
use mhlint_diag::{Application::Makehuman1, Case, Finding, Level, Place, RuleInfo};
use mhlint_formats::unfit::NamedAt;
use mhlint_repo::FileFacts;
use mhlint_repo::makehuman1::View;

pub(crate) static RULE: Rule = Check::Makehuman1(run).rule(RuleInfo {
    breaks: &[(Makehuman1, LOST_TABS)],
    docs: include_str!("unknown_view.md").trim_ascii_end(),
    ..RuleInfo::new(
        "modifiers-unknown-view",
        Level::Error,
        "a camera or condition that the program does not have",
    )
});

const CONDITION: Case = &[(
    Makehuman1,
    Level::Error,
    "fails at start and at each change of the human; sliders behind this one are not brought up \
        to date",
)];

/// What the program has, in its short form (`docs/loaders/makehuman1/modifiers.md#sliders`).
const CAMERAS: [&str; 24] = [
    "frontView",
    "backView",
    "leftView",
    "rightView",
    "topView",
    "bottomView",
    "globalCamera",
    "faceCamera",
    "leftHandFrontCamera",
    "rightHandFrontCamera",
    "leftHandTopCamera",
    "rightHandTopCamera",
    "leftFootFrontCamera",
    "leftFootLeftCamera",
    "rightFootFrontCamera",
    "rightFootRightCamera",
    "leftArmFrontCamera",
    "rightArmFrontCamera",
    "leftArmTopCamera",
    "rightArmTopCamera",
    "leftLegFrontCamera",
    "leftLegLeftCamera",
    "rightLegFrontCamera",
    "rightLegRightCamera",
];
/// What the human can be asked for.
const CONDITIONS: [&str; 1] = ["hasGenitals"];

fn run(view: &View<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    if !view.layers.checks_system() {
        return;
    }
    for (file, sliders) in view.modifiers.sets.iter().filter_map(|set| set.sliders) {
        for slider in sliders.sliders() {
            if let Some(camera) = slider
                .camera
                .as_ref()
                .filter(|camera| !is_camera(&camera.name))
            {
                out.push(finding(file, camera, "camera", &CAMERAS, cx));
            }
            if let Some(own) = slider
                .condition
                .as_ref()
                .filter(|own| !CONDITIONS.contains(&own.name.as_str()))
            {
                out.push(finding(file, own, "condition", &CONDITIONS, cx).case(CONDITION));
            }
        }
    }
}

/// `frontView`, or the whole name of what does it, `setFrontView`; the cameras have no other.
fn is_camera(name: &str) -> bool {
    let short = |long: &str| {
        let mut letters = long.chars();
        letters
            .next()
            .map(|first| first.to_lowercase().chain(letters).collect::<String>())
            .unwrap_or_default()
    };
    CAMERAS.contains(&name)
        || name
            .strip_prefix("set")
            .is_some_and(|long| CAMERAS.contains(&short(long).as_str()))
}

fn finding(
    file: &FileFacts,
    named: &NamedAt,
    what: &str,
    known: &[&'static str],
    cx: &RuleCx<'_>,
) -> Finding {
    let in_capitals = known
        .iter()
        .find(|own| own.eq_ignore_ascii_case(&named.name))
        .copied();
    let near = in_capitals.or_else(|| cx.suggestions.nearest(&named.name, known.iter().copied()));
    let message = format!("the program has no {what} `{}`", named.name);
    let finding = RULE
        .at(file, Place::Pointer(named.pointer.clone()), message)
        .key(&named.pointer);
    finding.help(did_you_mean(
        near,
        "name one that exists, or remove the key",
    ))
}
