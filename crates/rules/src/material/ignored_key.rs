//! Settings that an application never reads.

use super::super::{Check, Rule, RuleCx, counted};
use super::loader;
use mhlint_diag::{Application::Makehuman2, Evidence, Finding, Level, RuleInfo};
use mhlint_formats::mhmat::{Line, Value};
use mhlint_repo::{Surface, View};

pub(crate) static RULE: Rule = Check::Repository(run).rule(RuleInfo {
    breaks: &[(Makehuman2, "ignores the line")],
    docs: include_str!("ignored_key.md").trim_ascii_end(),
    ..RuleInfo::new(
        "material-ignored-key",
        Level::Info,
        "settings of a material that are never read",
    )
});

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for surface in view
        .surfaces()
        .iter()
        .filter(|surface| view.layers().is_checked(surface.file))
    {
        let ignored: Vec<&Line> = surface
            .material
            .lines
            .iter()
            .filter(|line| is_ignored(surface, line))
            .collect();
        let Some(first) = ignored.first() else {
            continue;
        };
        let keyword = first.keyword.name;
        let message = match ignored.len() {
            1 => format!("`{keyword}` is a setting of other applications"),
            count => format!(
                "{} of other applications, first `{keyword}`",
                counted(count, "setting")
            ),
        };
        let names = ignored.iter().map(|line| line.keyword.name);
        let finding = RULE
            .at(surface.file, Surface::place(first), message)
            .evidence(Evidence::of_cases(names));
        out.push(finding.help(
            "leave them if the material is for other applications too; otherwise remove them",
        ));
    }
}

fn is_ignored(surface: &Surface<'_>, line: &Line) -> bool {
    let keyword = line.keyword.name;
    let is_true = || matches!(&*line.word(0).to_lowercase(), "true" | "yes" | "enabled");
    match (keyword, line.keyword.value) {
        _ if loader::reads(surface.application, keyword) => false,
        ("opacity", _) => line.number_at(0).is_some_and(|share| share < 1.0),
        ("translucency", _) => line.number_at(0).is_some_and(|share| share > 0.0),
        ("shadeless" | "wireframe" | "depthless" | "autoBlendSkin", _) => is_true(),
        (
            "specularmapTexture"
            | "displacementmapTexture"
            | "transparencymapTexture"
            | "opacitymapTexture"
            | "transmissionmapTexture"
            | "subsurfaceColorMapTexture"
            | "subsurfaceStrengthMapTexture",
            Value::Picture,
        ) => line.count > 0,
        (_, Value::Picture) => line
            .keyword
            .alias_of
            .is_some_and(|of| matches!(of, "opacitymapTexture" | "subsurfaceColorMapTexture")),
        _ => false,
    }
}
