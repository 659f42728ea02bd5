//! What is meant to be transparent has to say so.

use super::super::{Check, Rule, RuleCx};
use mhlint_diag::{Application::Makehuman1, Case, Finding, Level, RuleInfo};
use mhlint_repo::{Surface, View};

pub(crate) static RULE: Rule = Check::Repository(run).rule(RuleInfo {
    breaks: &[(
        Makehuman1,
        "draws the surface without letting anything behind it show through",
    )],
    docs: include_str!("opacity.md").trim_ascii_end(),
    ..RuleInfo::new(
        "material-opacity",
        Level::Warning,
        "a material with an opacity below 1 that is not transparent",
    )
});

/// Old exporters wrote it, and their authors have always seen the surface.
const ZERO: Case = &[(
    Makehuman1,
    Level::Info,
    "draws the surface as if the line were not there",
)];

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    if !view.is_makehuman1() {
        return;
    }
    for surface in view
        .surfaces()
        .iter()
        .filter(|surface| view.layers().is_checked(surface.file))
    {
        let Some(line) = surface.material.last("opacity") else {
            continue;
        };
        // A value that is read as no has a finding of its own.
        let is_meant = surface
            .material
            .last("transparent")
            .is_some_and(|line| line.word(0).to_lowercase() != "false");
        let Some(opacity) = line.number_at(0).filter(|opacity| *opacity < 1.0) else {
            continue;
        };
        if !is_meant && !surface.is_true("transparent") {
            let message = format!("`opacity {}` without `transparent True`", line.word(0));
            let finding = RULE.at(surface.file, Surface::place(line), message);
            out.push(match opacity {
                ..=0.0 => finding
                    .case(ZERO)
                    .help("remove `opacity`: the surface stays as it looks"),
                _ => finding.help("write `transparent True`, or remove `opacity`"),
            });
        }
    }
}
