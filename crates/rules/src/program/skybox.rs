//! A skybox has six sides (`docs/loaders/makehuman2/program.md#sky-boxes`).

use std::collections::BTreeMap;

use super::super::{Check, Rule, RuleCx, counted};
use super::sky_sides::{Shown, Sides, faults};
use mhlint_diag::{Application::Makehuman2, Evidence, Finding, Level, Place, RuleInfo};
use mhlint_discover::{Layout, SKY_SIDES, Single, extension};
use mhlint_formats::program::Shaders;
use mhlint_repo::makehuman2::View;
use mhlint_repo::{FileFacts, Layer};

pub(crate) static RULE: Rule = Check::Makehuman2Library(run).rule(RuleInfo {
    breaks: &[(Makehuman2, "leaves out the missing sides of the background")],
    docs: include_str!("skybox.md").trim_ascii_end(),
    ..RuleInfo::new(
        "program-skybox",
        Level::Warning,
        "a side of a skybox is missing or cannot be shown",
    )
});

const SHADERS: &str = "shaders/shader.json";
const FOLDER: &str = "shaders/skybox";

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let layers = view.layers;
    // A user's is never read.
    let file = layers.system.and_then(|system| system.file(SHADERS));
    let known = file.and_then(|file| Some((file, file.shaders()?)));
    let at_start = known.and_then(|(file, shaders)| Some((file, first(shaders)?)));
    let own = at_start.filter(|(file, _)| layers.is_checked(file));
    let is_absent = |name: &str| {
        layers
            .strongest_first()
            .all(|layer| boxes(layer, Some(name)).is_empty())
    };
    out.extend(
        own.filter(|(_, name)| is_absent(name))
            .map(|(file, name)| absent(file, name)),
    );
    let system = layers.system.filter(|_| !layers.checks_system());
    let shipped = system.map(|system| boxes(system, None));
    for (name, sides) in boxes(layers.checked, None) {
        let is_first = at_start.is_some_and(|(_, first)| first == name);
        let shown = match known {
            _ if is_first => Shown::AtStart,
            Some(_) => Shown::Chosen,
            None => Shown::Perhaps,
        };
        faults(&RULE, name, &sides, shown, out);
        let hides = shipped
            .as_ref()
            .is_some_and(|shipped| shipped.contains_key(name));
        let named_in = own.filter(|_| is_first).map(|(file, _)| file);
        out.extend(lacking(layers.checked, name, &sides, named_in, hides));
    }
}

/// The skybox that is shown at start.
fn first(shaders: &Shaders) -> Option<&str> {
    shaders.skybox.as_deref().filter(|_| shaders.has_skybox)
}

/// The skyboxes of a layer, or the one of a name: its sides by their names. Of two pictures of a
/// side the PNG is taken.
fn boxes<'l>(layer: &'l Layer, wanted: Option<&str>) -> BTreeMap<&'l str, Sides<'l>> {
    let mut found: BTreeMap<&str, Sides<'_>> = BTreeMap::new();
    for file in layer
        .below(FOLDER)
        .filter(|file| (Layout::of(Makehuman2).single)(&file.rel) == Some(Single::SkySide))
    {
        let mut parts = file.rel.split('/').skip(2);
        let (Some(name), Some((side, suffix))) = (
            parts.next(),
            parts.next().and_then(|last| last.rsplit_once('.')),
        ) else {
            continue;
        };
        let sides = found.entry(name).or_default();
        if suffix == "png" || !sides.contains_key(side) {
            sides.insert(side, file);
        }
    }
    found.retain(|name, _| wanted.is_none_or(|wanted| wanted == *name));
    found
}

fn absent(file: &FileFacts, name: &str) -> Finding {
    let finding = RULE
        .at(
            file,
            Place::pointer(["skyboxname"]),
            format!("skybox `{name}` does not exist"),
        )
        .key(name);
    let help =
        format!("add the pictures to `{FOLDER}/{name}`, or name another folder of `{FOLDER}`");
    finding
        .help(help)
        .evidence(Evidence::of_cases(SKY_SIDES).out_of(SKY_SIDES.len()))
}

fn lacking(
    layer: &Layer,
    name: &str,
    sides: &Sides<'_>,
    named_in: Option<&FileFacts>,
    hides: bool,
) -> Option<Finding> {
    let missing: Vec<&str> = SKY_SIDES
        .into_iter()
        .filter(|side| !sides.contains_key(side))
        .collect();
    let folder = format!("{FOLDER}/{name}");
    let (message, help) = match missing.as_slice() {
        [] => return None,
        [side] => {
            let suffix = sides
                .values()
                .next()
                .map_or("png", |other| extension(&other.rel));
            (
                format!("skybox `{name}` has no `{side}`"),
                format!("add `{side}.{suffix}` to `{folder}`"),
            )
        }
        [side, ..] => (
            format!(
                "skybox `{name}` lacks {}, first `{side}`",
                counted(missing.len(), "side")
            ),
            format!("add the pictures to `{folder}`: {}", SKY_SIDES.join(", ")),
        ),
    };
    let finding = match named_in {
        Some(file) => RULE.at(file, Place::pointer(["skyboxname"]), message),
        None => RULE.in_layer(layer, &folder, message),
    };
    let effect = "leaves out the missing sides of the background: the folder takes the place of \
        the program's as a whole";
    let finding = if hides {
        finding.effect(effect)
    } else {
        finding
    };
    Some(
        finding
            .key(name)
            .help(help)
            .evidence(Evidence::of_cases(missing).out_of(SKY_SIDES.len())),
    )
}
