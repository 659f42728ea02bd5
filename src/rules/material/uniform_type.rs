//! A parameter of a shader is of the kind that the shader has.

use super::super::{Check, Rule, RuleCx};
use super::fault::{Fault, report};
use super::loader;
use crate::diag::{Application::Makehuman1, Finding, Level, RuleInfo};
use crate::formats::mhmat::Line;
use crate::repo::{Surface, View};

pub(in crate::rules) static RULE: Rule = Check::Repository(run).rule(RuleInfo {
    breaks: &[(Makehuman1, "ends each frame at this surface: what would be drawn after it is not drawn")],
    docs: "A `shaderParam` has a value that its shader cannot take: several numbers or a word for a single number, such as \
        `AdditiveShading` of `litsphere`, or a number for a picture, such as `litsphereTexture`.\n\n\
        MakeHuman 1 puts the asset on, and then raises an exception in each frame as soon as it comes to this surface. \
        What would be drawn after it is missing for as long as the asset is worn.\n\n\
        The shaders that come with the program are checked. Write one number, or the name of a picture.",
    ..RuleInfo::new("material-uniform-type", Level::Error, "a parameter of a shader of another kind")
});

/// Shader, parameter, and whether that is a picture; of the shaders that come with the program (formats/makehuman1.md §13).
const UNIFORMS: [(&str, &str, bool); 8] = [
    ("litsphere", "AdditiveShading", false),
    ("litsphere", "litsphereTexture", true),
    ("xray", "edgefalloff", false),
    ("xray", "intensity", false),
    ("toon", "silhouetteThreshold", false),
    ("toon", "ambientIntensity", false),
    ("toon", "specularIntensity", false),
    ("toon", "diffuseIntensity", false),
];

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for surface in view.surfaces().iter().filter(|surface| view.layers().is_checked(surface.file)) {
        let shader = loader::shader(surface);
        let own = surface.material.lines.iter().filter(|line| line.keyword.name == "shaderParam" && line.count > 1);
        let is_last =
            |line: &&Line| surface.material.parameter(line.word(0)).is_some_and(|last| std::ptr::eq(last, *line));
        let faults = own.filter(is_last).filter_map(|line| fault(shader, line)).collect();
        report(&RULE, surface, faults, "have values of another kind than the shader", out);
    }
}

fn fault(shader: &str, line: &Line) -> Option<Fault> {
    let (_, name, is_picture) = UNIFORMS.iter().find(|own| own.0 == shader && own.1 == line.word(0))?;
    // Several values that are not numbers stop the reader before that.
    let are_numbers = (1..line.count.min(line.words.len())).all(|at| line.number_at(at).is_some());
    let (what, help) = match (is_picture, line.count) {
        (true, _) if are_numbers => ("a number, but the shader expects a picture", "write the name of a picture"),
        (false, 2) if !are_numbers => {
            ("a word, but the shader expects a number", "write a number with a decimal point")
        }
        (false, 3..) if are_numbers => ("several numbers, but the shader expects one", "write one number"),
        _ => return None,
    };
    Some(Fault {
        key: (*name).to_owned(),
        place: Surface::place(line),
        level: Level::Error,
        message: format!("`{name}` has {what}"),
        effect: "ends each frame at this surface: what would be drawn after it is not drawn".to_owned(),
        help: help.to_owned(),
    })
}
