//! The shader of a material must exist.

use super::super::{Check, Rule, RuleCx, did_you_mean};
use super::loader;
use crate::diag::{
    Application::{Makehuman1, Makehuman2},
    Finding, Level, RuleInfo,
};
use crate::repo::{Shader, Surface, View};

pub(in crate::rules) static RULE: Rule = Check::Repository(run).rule(RuleInfo {
    breaks: &[(Makehuman2, "silently draws the surface like phong, without its settings"), (Makehuman1, "logs an error and draws the surface without a shader")],
    docs: "A material asks for a shader that MakeHuman 2 does not have for materials. It has `phong`, `litsphere`, `pbr` \
        and `toon`, in small letters; of a path such as `shaders/glsl/litsphere` it takes the last part.\n\n\
        With another name the surface is drawn like phong, but without the settings that phong gets. The name is kept \
        when the material is saved.\n\nA shader of MakeHuman 1 is a path without its ending, such as `shaders/glsl/litsphere`. Without one of its files the surface is drawn without a shader.\n\nWrite one of the four names for MakeHuman 2, and the whole path for MakeHuman 1.",
    ..RuleInfo::new("material-missing-shader", Level::Warning, "a material asks for a shader that does not exist")
});

fn run(view: &View<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    if loader::is_1(view.application()) {
        return of_files(view, out);
    }
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

/// A shader of MakeHuman 1 is a file. Without any shader there is one finding for all (`program-missing-file`).
fn of_files(view: &View<'_>, out: &mut Vec<Finding>) {
    let layers = view.layers();
    let has_shaders = layers.strongest_first().any(|layer| layer.below(FOLDER).next().is_some());
    for surface in view.surfaces().iter().filter(|surface| layers.is_checked(surface.file) && has_shaders) {
        let missing = |shader: &&Shader<'_>| shader.files.is_empty() && !shader.is_open;
        let Some(shader) = surface.shader.as_ref().filter(missing) else { continue };
        let name = shader.text.rsplit('/').next().unwrap_or_default();
        let shown: String = shader.text.chars().take(60).collect();
        let message = if shader.text.starts_with('/') || shader.text.get(1..2) == Some(":") {
            format!("shader `{shown}` is an absolute path: it exists on one computer at most")
        } else {
            format!("shader `{shown}` does not exist")
        };
        let finding = RULE.at(surface.file, shader.place.clone(), message);
        let is_there =
            layers.strongest_first().any(|layer| layer.file(&format!("{FOLDER}/{name}_fragment_shader.txt")).is_some());
        let help = if is_there {
            format!("write `{FOLDER}/{name}`")
        } else {
            format!("use a shader of `{FOLDER}`, without `_vertex_shader.txt`")
        };
        out.push(finding.key(shown).help(help));
    }
}

const FOLDER: &str = "shaders/glsl";
