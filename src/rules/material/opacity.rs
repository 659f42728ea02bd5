//! What is meant to be transparent has to say so.

use super::super::{Check, Rule, RuleCx};
use crate::diag::{Application::Makehuman1, Finding, Level, RuleInfo};
use crate::repo::{Surface, View};

pub(in crate::rules) static RULE: Rule = Check::Repository(run).rule(RuleInfo {
    breaks: &[(Makehuman1, "draws the surface without letting anything behind it show through")],
    docs: "A material has an `opacity` below 1 and is not `transparent`.\n\n\
        MakeHuman 1 draws it like any other surface: what is behind it is hidden, or shows only where it happened to be \
        drawn before.\n\n\
        Write `transparent True`, or remove `opacity`.",
    ..RuleInfo::new("material-opacity", Level::Warning, "a material with an opacity below 1 that is not transparent")
});

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    if !view.is_makehuman1() {
        return;
    }
    for surface in view.surfaces().iter().filter(|surface| view.layers().is_checked(surface.file)) {
        let Some(line) = surface.material.last("opacity") else { continue };
        // A value that is read as no has a finding of its own.
        let is_meant = surface.material.last("transparent").is_some_and(|line| line.word(0).to_lowercase() != "false");
        let is_below = line.number_at(0).is_some_and(|opacity| opacity < 1.0);
        if is_below && !is_meant && !surface.is_true("transparent") {
            let message = format!("`opacity {}` without `transparent True`", line.word(0));
            let finding = RULE.at(surface.file, Surface::place(line), message);
            out.push(finding.help("write `transparent True`, or remove `opacity`"));
        }
    }
}
