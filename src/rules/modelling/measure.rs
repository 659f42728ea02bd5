//! The vertices of a measuring line must exist.

use super::super::{Check, Rule, RuleCx};
use crate::diag::{Application, Evidence, Finding, Level, Place, RuleInfo};
use crate::repo::{Base, BoundSlider, Repository};

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        breaks: &[(Application::Makehuman2, "stops with an IndexError when the length is shown")],
        docs: "`measure` lists vertices of the base mesh, counted from 0; the length of the line through them is shown beside the slider.\n\n\
            A vertex that the mesh does not have raises an exception whenever the length is computed. A negative number is taken \
            from the end of the mesh: no exception, but a wrong length (a warning).\n\nWrite vertices of the base mesh.",
        ..RuleInfo::new("modelling-measure", Level::Error, "`measure` names a vertex outside the base mesh")
    },
    check: Check::Base(run),
};

fn run(_: &Repository<'_>, base: &Base<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some((_, mesh)) = base.mesh.filter(|(_, mesh)| mesh.facts.unreadable_lines == 0) else { return };
    // Behind the real vertices come the duplicates of seams: they exist, and have a rule of their own.
    let end = i64::try_from(mesh.facts.vertices + mesh.facts.seam_duplicates).unwrap_or(i64::MAX);
    for bound in &base.sliders {
        let Some(line) = &bound.slider.measure else { continue };
        let outside = |vertex: &&i64| **vertex >= end || **vertex < -end;
        let beyond: Vec<&i64> = line.iter().filter(outside).collect();
        let negative: Vec<&i64> = line.iter().filter(|vertex| **vertex < 0 && !outside(vertex)).collect();
        if let Some(first) = beyond.first() {
            let message = format!("measures vertex {first}, but the mesh has {}", mesh.facts.vertices);
            out.push(finding(bound, &message, "").evidence(Evidence::of_cases(&beyond).out_of(line.len())));
        } else if let Some(first) = negative.first() {
            let message = format!("measures vertex {first}, which is counted from the end of the mesh");
            let effect = "takes a vertex counted from the end of the mesh and shows a wrong length";
            out.push(
                finding(bound, &message, effect)
                    .level(Level::Warning)
                    .evidence(Evidence::of_cases(&negative).out_of(line.len())),
            );
        }
    }
}

fn finding(bound: &BoundSlider<'_>, message: &str, effect: &str) -> Finding {
    let key = bound.slider.key.as_str();
    let finding = RULE
        .at(bound.file, Place::pointer([key, "measure"]), format!("`{key}` {message}"))
        .key(key)
        .help("vertices are counted from 0; was the line made for another mesh?");
    if effect.is_empty() { finding } else { finding.breaks(Application::Makehuman2, effect) }
}
