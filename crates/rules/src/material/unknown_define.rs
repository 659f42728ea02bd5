//! A define of a material is one that its shader asks for.

use super::super::{Check, Rule, RuleCx, shown};
use super::fault::{Fault, report};
use super::loader;
use mhlint_diag::{Application::Makehuman1, Finding, Level, RuleInfo};
use mhlint_formats::mhmat::Line;
use mhlint_formats::shader_source::ShaderSource;
use mhlint_repo::{Shader, Surface, View};

const EFFECT: &str = "defines the names without effect";

pub(crate) static RULE: Rule = Check::Repository(run).rule(RuleInfo {
    breaks: &[(Makehuman1, EFFECT)],
    docs: include_str!("unknown_define.md").trim_ascii_end(),
    ..RuleInfo::new(
        "material-unknown-define",
        Level::Info,
        "a define that the shader does not use",
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
        let own = surface
            .material
            .lines_of("shaderDefine")
            .filter(|line| line.count > 0);
        let faults = own.filter_map(|line| fault(&sources, line)).collect();
        report(
            &RULE,
            surface,
            faults,
            "define names that the shader does not use",
            out,
        );
    }
}

fn fault(sources: &[&ShaderSource], line: &Line) -> Option<Fault> {
    let name = line.word(0);
    // A name that belongs to the program has another finding.
    if loader::DEFINES.contains(&name) || sources.iter().any(|source| source.defines.contains(name))
    {
        return None;
    }
    let shown = shown(name);
    Some(Fault {
        place: Surface::place(line),
        level: Level::Info,
        message: format!("the shader does not use `{shown}`"),
        key: shown,
        effect: EFFECT.to_owned(),
        help: "correct the name, or remove the line".to_owned(),
    })
}
