//! Some names of shaders belong to the program.

use super::super::{Check, Rule, RuleCx};
use super::fault::{Fault, report};
use super::loader;
use mhlint_diag::{Application::Makehuman1, Finding, Level, RuleInfo};
use mhlint_formats::mhmat::Line;
use mhlint_repo::{Surface, View};

pub(crate) static RULE: Rule = Check::Repository(run).rule(RuleInfo {
    breaks: &[(Makehuman1, "does not put the asset on, or show the skin")],
    docs: include_str!("protected_name.md").trim_ascii_end(),
    ..RuleInfo::new(
        "material-protected-name",
        Level::Error,
        "a name of a shader that the program keeps for itself",
    )
});

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for surface in view
        .surfaces()
        .iter()
        .filter(|surface| view.layers().is_checked(surface.file))
    {
        let faults = surface
            .material
            .lines
            .iter()
            .filter_map(|line| fault(surface, line))
            .collect();
        report(&RULE, surface, faults, "have reserved names", out);
    }
}

fn fault(surface: &Surface<'_>, line: &Line) -> Option<Fault> {
    let keyword = line.keyword.name;
    let name = match keyword {
        // Without a value it has another finding.
        "shaderParam" if line.count > 1 => loader::PARAMETERS
            .into_iter()
            .find(|own| *own == line.word(0))?,
        "shaderDefine" => loader::DEFINES
            .into_iter()
            .find(|own| *own == line.word(0))?,
        _ => return None,
    };
    Some(Fault {
        key: name.to_owned(),
        place: Surface::place(line),
        level: Level::Error,
        message: format!("`{keyword} {name}` is a reserved name"),
        effect: loader::crash(surface, "RuntimeError"),
        help: "use the keyword of the material for it, or remove the line".to_owned(),
    })
}
