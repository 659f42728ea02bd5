//! A parameter of a shader is of the kind that the shader has.

use super::super::{Check, Rule, RuleCx, counted};
use super::fault::{Fault, report};
use super::loader;
use mhlint_diag::{Application::Makehuman1, Finding, Level, RuleInfo};
use mhlint_formats::mhmat::Line;
use mhlint_formats::shader_source::Shape;
use mhlint_repo::{Surface, View};

pub(crate) static RULE: Rule = Check::Repository(run).rule(RuleInfo {
    breaks: &[(
        Makehuman1,
        "stops drawing each frame at this surface: everything after it is missing",
    )],
    docs: include_str!("uniform_type.md").trim_ascii_end(),
    ..RuleInfo::new(
        "material-uniform-type",
        Level::Error,
        "a parameter of a shader of another kind",
    )
});

/// Shader, parameter, and what it takes; of the shaders that come with the program
/// (`docs/loaders/makehuman1/shaders.md#shipped-shaders`), where their sources are not at hand.
const UNIFORMS: [(&str, &str, Shape); 8] = [
    ("litsphere", "AdditiveShading", Shape::Numbers(1)),
    ("litsphere", "litsphereTexture", Shape::Picture),
    ("xray", "edgefalloff", Shape::Numbers(1)),
    ("xray", "intensity", Shape::Numbers(1)),
    ("toon", "silhouetteThreshold", Shape::Numbers(1)),
    ("toon", "ambientIntensity", Shape::Numbers(1)),
    ("toon", "specularIntensity", Shape::Numbers(1)),
    ("toon", "diffuseIntensity", Shape::Numbers(1)),
];

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for surface in view
        .surfaces()
        .iter()
        .filter(|surface| view.layers().is_checked(surface.file))
    {
        let faults = loader::last_parameters(surface)
            .filter_map(|line| fault(surface, line))
            .collect();
        report(
            &RULE,
            surface,
            faults,
            "have values of another kind than the shader",
            out,
        );
    }
}

/// What a parameter of the shader takes, where it is sure to be in use: of the program's own
/// shaders that is known.
fn shape(surface: &Surface<'_>, name: &str) -> Option<Shape> {
    let own = loader::shader(surface);
    let known = UNIFORMS
        .iter()
        .find(|known| known.0 == own && known.1 == name)
        .map(|known| known.2);
    let Some(shader) = surface
        .shader
        .as_ref()
        .filter(|shader| !shader.files.is_empty())
    else {
        return known;
    };
    let declared = shader.uniform(name)?;
    if declared.is_certain {
        Some(declared.value)
    } else {
        known.filter(|known| *known == declared.value)
    }
}

fn fault(surface: &Surface<'_>, line: &Line) -> Option<Fault> {
    let name = line.word(0);
    let shape = shape(surface, name).filter(|_| !loader::PARAMETERS.contains(&name))?;
    // Several values that are not numbers stop the reader before that.
    let are_numbers = (1..line.count.min(line.words.len())).all(|at| line.number_at(at).is_some());
    let (what, help) = match (shape, line.count - 1) {
        (Shape::Picture, _) if are_numbers => (
            "a number, but the shader expects a picture".to_owned(),
            "write the name of a picture".to_owned(),
        ),
        (Shape::Numbers(count), 1) if !are_numbers => {
            let numbers = counted(count, "number");
            (
                format!("a word, but the shader expects {numbers}"),
                format!("write {numbers} with a decimal point"),
            )
        }
        (Shape::Numbers(count), given) if are_numbers && given != count => {
            let numbers = counted(count, "number");
            (
                format!(
                    "{}, but the shader expects {count}",
                    counted(given, "number")
                ),
                format!("write {numbers}"),
            )
        }
        _ => return None,
    };
    Some(Fault {
        key: name.to_owned(),
        place: Surface::place(line),
        level: Level::Error,
        message: format!("`{name}` has {what}"),
        effect: "stops drawing each frame at this surface: everything after it is missing"
            .to_owned(),
        help,
    })
}
