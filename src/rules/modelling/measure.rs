//! The vertices of a measuring line must exist, and a line around something must close.

use super::super::cause::schema::is_sound;
use super::super::{Check, Rule, RuleCx};
use crate::diag::{Application, Evidence, Finding, Level, Place, RuleInfo, pointer};
use crate::eval::measure::{chain_length, closing_gap};
use crate::repo::makehuman2::{Base, BoundSlider, View};

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        breaks: &[(Application::Makehuman2, "stops with an IndexError when the length is shown")],
        docs: "`measure` lists vertices of the base mesh, counted from 0; the length of the line through them is shown beside the slider.\n\n\
            A vertex that the mesh does not have raises an exception whenever the length is computed. A negative number is taken \
            from the end of the mesh: no exception, but a wrong length (a warning). So is a number just beyond the vertices of the file, which means a \
            copy that MakeHuman 2 makes at a texture seam. A number with a point, as `100.0`, raises the same exception. A line with less than two \
            vertices is shown as `0 cm` (a warning).\n\nThe line is not closed by the program. One that is \
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
    out.extend(base.sliders.iter().filter_map(whatever_the_mesh));
    let Some((_, mesh)) = base.mesh.filter(|(_, mesh)| mesh.facts.unreadable_lines == 0) else { return };
    let vertices = i64::try_from(mesh.facts.vertices).unwrap_or(i64::MAX);
    // Behind the real vertices come the duplicates of seams.
    let end = i64::try_from(mesh.facts.vertices + mesh.facts.seam_duplicates).unwrap_or(i64::MAX);
    for bound in &base.sliders {
        // The rest of a line with a float says nothing about where it was meant to run.
        let sound = bound.slider.measure_floats.is_empty();
        let Some(line) = bound.slider.measure.as_ref().filter(|_| sound) else { continue };
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
        } else if let Some(first) = line.iter().find(|vertex| **vertex >= vertices) {
            let message = format!("measures vertex {first}, a copy at a seam: the mesh has {vertices}");
            let effect = "measures to a copy of a vertex at a texture seam and shows a wrong length";
            out.push(finding(bound, &message, effect).level(Level::Warning));
        } else if is_circumference(bound) {
            out.extend(open_line(bound, line, &mesh.positions));
        }
    }
}

/// What is wrong with a line on any mesh.
fn whatever_the_mesh(bound: &BoundSlider<'_>) -> Option<Finding> {
    let slider = bound.slider;
    let line = slider.measure.as_ref()?;
    if let Some(first) = slider.measure_floats.first() {
        let message = format!("measures vertex {first:.1}, a number with a point");
        return Some(finding(bound, &message, "").help("write the numbers of vertices without a point"));
    }
    let is_short = line.len() < 2 && is_sound(bound.file, &pointer(&[&slider.key, "measure"]));
    let what = if line.is_empty() { "measures no vertex" } else { "measures a single vertex" };
    let help = "list the vertices along the line, or remove the key";
    is_short.then(|| finding(bound, what, "shows a length of `0 cm`").level(Level::Warning).help(help))
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
