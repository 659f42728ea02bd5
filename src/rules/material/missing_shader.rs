//! The shader of a material must exist.

use super::super::{Check, Rule, RuleCx, did_you_mean};
use super::loader;
use crate::diag::{Application::Makehuman2, Finding, Level, RuleInfo};
use crate::repo::{Surface, View};

pub(in crate::rules) static RULE: Rule = Check::Repository(run).rule(RuleInfo {
    breaks: &[(Makehuman2, "silently draws the surface like phong, without its settings")],
    docs: "A material asks for a shader that MakeHuman 2 does not have for materials. It has `phong`, `litsphere`, `pbr` \
        and `toon`, in small letters; of a path such as `shaders/glsl/litsphere` it takes the last part.\n\n\
        With another name the surface is drawn like phong, but without the settings that phong gets. The name is kept \
        when the material is saved.\n\nWrite one of the four names.",
    ..RuleInfo::new("material-missing-shader", Level::Warning, "a material asks for a shader that does not exist")
});

fn run(view: &View<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for surface in view.surfaces().iter().filter(|surface| view.layers().is_checked(surface.file)) {
        let (name, line) = (loader::shader(surface), surface.material.last("shader"));
        let Some(line) = line.filter(|line| line.count > 0 && !loader::SHADERS.contains(&name)) else { continue };
        let shown: String = name.chars().take(40).collect();
        let finding = RULE.at(surface.file, Surface::place(line), format!("shader `{shown}` does not exist"));
        let near = cx.suggestions.nearest(name, loader::SHADERS);
        let help = did_you_mean(near, "write `phong`, `litsphere`, `pbr` or `toon`");
        out.push(finding.key(shown).help(help));
    }
}
