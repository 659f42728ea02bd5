//! A parameter of a material is one that its shader has.

use super::super::{Check, Rule, RuleCx, shown};
use super::fault::{Fault, report};
use super::loader;
use mhlint_diag::{Application::Makehuman1, Finding, Level, RuleInfo};
use mhlint_formats::mhmat::Line;
use mhlint_formats::shader_source::ShaderSource;
use mhlint_repo::{Shader, Surface, View};

const EFFECT: &str = "ignores the values";

pub(crate) static RULE: Rule = Check::Repository(run).rule(RuleInfo {
    breaks: &[(Makehuman1, EFFECT)],
    docs: include_str!("unknown_uniform.md").trim_ascii_end(),
    ..RuleInfo::new(
        "material-unknown-uniform",
        Level::Info,
        "a parameter that the shader does not have",
    )
});

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for surface in view
        .surfaces()
        .iter()
        .filter(|surface| view.layers().is_checked(surface.file))
    {
        let Some(sources) = surface.shader.as_ref().and_then(Shader::sources) else {
            continue;
        };
        let last = loader::last_parameters(surface);
        let faults = last.filter_map(|line| fault(&sources, line)).collect();
        report(
            &RULE,
            surface,
            faults,
            "set parameters that the shader does not have",
            out,
        );
    }
}

fn fault(sources: &[&ShaderSource], line: &Line) -> Option<Fault> {
    let name = line.word(0);
    // A name that belongs to the program has another finding.
    if loader::PARAMETERS.contains(&name)
        || sources
            .iter()
            .any(|source| source.uniforms.contains_key(name))
    {
        return None;
    }
    let shown = shown(name);
    Some(Fault {
        place: Surface::place(line),
        level: Level::Info,
        message: format!("the shader has no parameter `{shown}`"),
        key: shown,
        effect: EFFECT.to_owned(),
        help: "correct the name, or remove the line".to_owned(),
    })
}
