//! A litsphere needs its picture.

use super::super::{Check, Rule, RuleCx};
use super::loader;
use super::path_quote::is_quoted;
use crate::diag::{Application::Makehuman2, Case, Finding, Level, RuleInfo};
use crate::repo::{Surface, View};

pub(in crate::rules) static RULE: Rule = Check::Repository(run).rule(RuleInfo {
    breaks: &[(Makehuman2, "silently draws the surface with phong")],
    docs: "A material asks for the shader `litsphere`, but has no picture for it: `shaderParam litsphereTexture` is missing, \
        or the picture that it names does not exist.\n\n\
        MakeHuman 2 looks for the name without its folders in `shaders/litspheres/` of the user and of the system. \
        Without a picture it draws the surface with phong. If the picture does not exist and the material has no \
        `name`, it crashes with `TypeError` instead (error).\n\n\
        Name a picture of that folder, or put it there.",
    ..RuleInfo::new("material-missing-litsphere", Level::Warning, "a litsphere without its picture")
});

const STOPS: Case = &[(
    Makehuman2,
    Level::Error,
    "crashes with `TypeError` when the material is used: without a `name` it cannot log the fault",
)];

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let own = view.surfaces().iter().filter(|surface| view.layers().is_checked(surface.file));
    for surface in own.filter(|surface| loader::shader(surface) == "litsphere") {
        let Some(line) = surface.material.last("shader") else { continue };
        let Some(picture) = &surface.litsphere else {
            // A parameter without a value stops the loader before that.
            let is_cut = surface.material.lines_of("shaderParam").any(|line| line.count < 2);
            if !is_cut {
                let message = "shader `litsphere` has no `shaderParam litsphereTexture`";
                let finding = RULE.at(surface.file, Surface::place(line), message).key("litsphereTexture");
                out.push(finding.help("add a line `shaderParam litsphereTexture` with the name of the picture"));
            }
            continue;
        };
        if picture.file.is_some() || picture.is_open || is_quoted(picture.text) {
            continue;
        }
        let text: String = picture.text.chars().take(60).collect();
        let message = format!("litsphere `{text}` does not exist");
        let finding = RULE.at(surface.file, picture.place.clone(), message).key("litsphereTexture");
        let finding = finding.help("name a picture of `shaders/litspheres/`, or put it there");
        let has_name = surface.material.last("name").is_some();
        out.push(if has_name { finding } else { finding.case(STOPS) });
    }
}
