//! The vertices of a measuring line must exist, and a line around something must close.

use super::super::{Check, Rule, RuleCx};
use crate::diag::{Application, Evidence, Finding, Level, Place, RuleInfo};
use crate::eval::measure::{chain_length, closing_gap};
use crate::repo::makehuman2::{Base, BoundSlider, View};

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        breaks: &[(Application::Makehuman2, "stops with an IndexError when the length is shown")],
        docs: "`measure` lists vertices of the base mesh, counted from 0; the length of the line through them is shown beside the slider.\n\n\
            A vertex that the mesh does not have raises an exception whenever the length is computed. A negative number is taken \
            from the end of the mesh: no exception, but a wrong length (a warning).\n\nThe line is not closed by the program. One that is \
            called a circumference (`circ` or `girth` in the name of the slider) and ends away from where it began leaves a \
            piece out, so the length shown is too small (a warning with the gap on the unmorphed mesh).\n\nWrite vertices of \
            the base mesh, and the first one again at the end of a circumference.",
        ..RuleInfo::new("modelling-measure", Level::Error, "`measure` does not fit the base mesh")
    },
    check: Check::Makehuman2(run),
};

/// Two vertices (of a seam, say) this close are one place, mesh units: meshes are written with four decimals.
const SAME_PLACE: f64 = 2e-4;

fn run(_: &View<'_>, base: &Base<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
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
            out.push(
                finding(bound, &message, "").evidence(Evidence::of_cases(beyond.iter().copied()).out_of(line.len())),
            );
        } else if let Some(first) = negative.first() {
            let message = format!("measures vertex {first}, which is counted from the end of the mesh");
            let effect = "takes a vertex counted from the end of the mesh and shows a wrong length";
            out.push(
                finding(bound, &message, effect)
                    .level(Level::Warning)
                    .evidence(Evidence::of_cases(negative.iter().copied()).out_of(line.len())),
            );
        } else if is_circumference(bound) {
            out.extend(open_line(bound, line, &mesh.positions));
        }
    }
}

/// Whether the name says that the line goes around something.
fn is_circumference(bound: &BoundSlider<'_>) -> bool {
    let key = bound.slider.key.to_lowercase();
    let target = bound.slider.incr.as_deref().unwrap_or_default().to_lowercase();
    ["circ", "girth"].iter().any(|word| key.contains(word) || target.contains(word))
}

/// The gap of a line that should close, on the unmorphed mesh.
fn open_line(bound: &BoundSlider<'_>, line: &[i64], positions: &[[f32; 3]]) -> Option<Finding> {
    let line: Vec<u32> = line.iter().map(|vertex| u32::try_from(*vertex).ok()).collect::<Option<_>>()?;
    let (length, gap) = (chain_length(positions, &line).ok()?, closing_gap(positions, &line).ok()?);
    let (first, last) = (line.first()?, line.last()?);
    if gap <= SAME_PLACE || !length.is_finite() {
        return None;
    }
    let message = format!("does not close: its ends are {gap:.3} apart, its length is {length:.3}");
    let effect = "shows a length without the missing piece";
    let help = format!("write vertex {first} again behind {last}, with those between them if there are any");
    let evidence = Evidence::counted(1).with_worst(gap, format!("vertices {first} and {last}"));
    // Another fault than a vertex that does not exist: it must not be taken for the same.
    let key = format!("{} gap", bound.slider.key);
    Some(finding(bound, &message, effect).key(key).level(Level::Warning).help(help).evidence(evidence))
}

fn finding(bound: &BoundSlider<'_>, message: &str, effect: &str) -> Finding {
    let key = bound.slider.key.as_str();
    let finding = RULE
        .at(bound.file, Place::pointer([key, "measure"]), format!("`{key}` {message}"))
        .key(key)
        .help("vertices are counted from 0; was the line made for another mesh?");
    if effect.is_empty() { finding } else { finding.effect(effect) }
}
