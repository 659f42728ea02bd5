//! A skybox has six sides.

use super::super::{Check, Rule, RuleCx, counted};
use crate::diag::{Application::Makehuman2, Case, Evidence, Finding, Level, Place, RuleInfo};
use crate::repo::{FileFacts, View};

pub(in crate::rules) static RULE: Rule = Check::File(run).rule(RuleInfo {
    breaks: &[(Makehuman2, "leaves out the missing sides of the background")],
    docs: "`skyboxname` in `shaders/shader.json` names a folder in `shaders/skybox/` with six pictures: `posx`, `negx`, \
        `posy`, `negy`, `posz` and `negz`, as `.png` or `.jpg`. The user's folder is used before the system's, as a \
        whole.\n\n\
        MakeHuman 2 leaves out the sides that are missing, and takes all of them to be 2048 pixels wide and high.\n\n\
        Add the pictures in this size, or name another folder.",
    ..RuleInfo::new("program-skybox", Level::Warning, "a side of the skybox does not exist")
});

const OTHER_SIZE: Case = &[(Makehuman2, Level::Warning, "shows the side cut off or with a border of noise")];

/// What every side is taken to have, in pixels.
const SIZE: (u64, u64) = (2048, 2048);
const SIDES: [&str; 6] = ["posx", "negx", "posy", "negy", "posz", "negz"];

fn run(view: &View<'_>, file: &FileFacts, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some(shaders) = file.shaders().filter(|shaders| shaders.has_skybox) else { return };
    let Some(name) = shaders.skybox.as_deref() else { return };
    let folder = format!("shaders/skybox/{name}");
    let layers = view.layers();
    let holder = layers.strongest_first().find(|layer| layer.below(&folder).next().is_some());
    let picture =
        |side: &str| ["png", "jpg"].iter().find_map(|suffix| holder?.file(&format!("{folder}/{side}.{suffix}")));
    let missing: Vec<&str> = SIDES.into_iter().filter(|side| picture(side).is_none()).collect();
    let odd = SIDES.into_iter().filter_map(picture).filter_map(|file| Some((file, file.picture()?.size?)));
    out.extend(of_another_size(&odd.filter(|(_, size)| *size != SIZE).collect::<Vec<_>>()));
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

fn of_another_size(sides: &[(&FileFacts, (u64, u64))]) -> Option<Finding> {
    let (first, (width, height)) = sides.first()?;
    let more = if sides.len() > 1 { format!(" ({} sides)", sides.len()) } else { String::new() };
    let message = format!("`{}` has {width} × {height} pixels, expected 2048 × 2048{more}", first.file_name());
    let names = sides.iter().map(|(file, _)| file.file_name());
    let finding = RULE.at(first, Place::File, message).key("size").case(OTHER_SIZE).evidence(Evidence::of_cases(names));
    let parts = sides.iter().map(|(file, _)| (file.file_name(), &file.path));
    Some(finding.parts_in(parts).help("save all six pictures with 2048 by 2048 pixels"))
}
