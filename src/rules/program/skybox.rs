//! A skybox has six sides.

use super::super::{Check, Rule, RuleCx, counted};
use crate::diag::{Application::Makehuman2, Evidence, Finding, Level, Place, RuleInfo};
use crate::repo::{FileFacts, View};

pub(in crate::rules) static RULE: Rule = Check::File(run).rule(RuleInfo {
    breaks: &[(Makehuman2, "leaves out the missing sides of the background")],
    docs: "`skyboxname` in `shaders/shader.json` names a folder in `shaders/skybox/` with six pictures: `posx`, `negx`, \
        `posy`, `negy`, `posz` and `negz`, as `.png` or `.jpg`. The user's folder is used before the system's, as a \
        whole.\n\n\
        MakeHuman 2 leaves out the sides that are missing.\n\n\
        Add the pictures, or name another folder.",
    ..RuleInfo::new("program-skybox", Level::Warning, "a side of the skybox does not exist")
});

const SIDES: [&str; 6] = ["posx", "negx", "posy", "negy", "posz", "negz"];

fn run(view: &View<'_>, file: &FileFacts, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some(shaders) = file.shaders().filter(|shaders| shaders.has_skybox) else { return };
    let Some(name) = shaders.skybox.as_deref() else { return };
    let folder = format!("shaders/skybox/{name}");
    let layers = view.layers();
    let holder = layers.strongest_first().find(|layer| layer.below(&folder).next().is_some());
    let exists = |side: &str| {
        let is_there = |suffix| holder.is_some_and(|layer| layer.file(&format!("{folder}/{side}.{suffix}")).is_some());
        ["png", "jpg"].into_iter().any(is_there)
    };
    let missing: Vec<&str> = SIDES.into_iter().filter(|side| !exists(side)).collect();
    let (message, help) = match missing.as_slice() {
        [] => return,
        _ if holder.is_none() => (
            format!("skybox `{name}` does not exist"),
            format!("add the pictures to `{folder}`, or name another folder of `shaders/skybox`"),
        ),
        [side] => (format!("skybox `{name}` has no `{side}`"), format!("add `{side}.png` to `{folder}`")),
        [side, ..] => (
            format!("skybox `{name}` lacks {}, first `{side}`", counted(missing.len(), "side")),
            format!("add the pictures to `{folder}`: {}", SIDES.join(", ")),
        ),
    };
    let finding = RULE.at(file, Place::pointer(["skyboxname"]), message).key(name).help(help);
    out.push(finding.evidence(Evidence::of_cases(missing).out_of(SIDES.len())));
}
