//! The vertices of a measuring line must exist, and a line around something must close.

use std::cell::LazyCell;

use super::super::cause::schema::is_sound;
use super::super::units::length;
use super::super::{Check, Rule, RuleCx};
use mhlint_diag::{
    Application::Makehuman2, Evidence, Finding, Grows, Level, MeasureKind, Place, RuleInfo, pointer,
};
use mhlint_eval::measure::{chain_length, closing_gap};
use mhlint_repo::Landmarks;
use mhlint_repo::makehuman2::{Base, BoundSlider, View};

pub(crate) static RULE: Rule = Check::Makehuman2(run).rule(RuleInfo {
    breaks: &[(
        Makehuman2,
        "crashes with `IndexError` when it shows the length",
    )],
    docs: include_str!("measure.md").trim_ascii_end(),
    counts: "entries",
    grows: Grows::more(MeasureKind::Gap),
    ..RuleInfo::new(
        "modelling-measure",
        Level::Error,
        "`measure` does not fit the base mesh",
    )
});

/// Two vertices (of a seam, say) this close are one place, mesh units: meshes are written with four
/// decimals.
const SAME_PLACE: f64 = 2e-4;

fn run(_: &View<'_>, base: &Base<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    out.extend(base.sliders.iter().filter_map(whatever_the_mesh));
    let Some((_, mesh)) = base
        .mesh
        .filter(|(_, mesh)| mesh.facts.unreadable_lines == 0)
    else {
        return;
    };
    let vertices = i64::try_from(mesh.facts.vertices).unwrap_or(i64::MAX);
    // Behind the real vertices come the duplicates of seams.
    let end = i64::try_from(mesh.facts.vertices + mesh.facts.seam_duplicates).unwrap_or(i64::MAX);
    // Made when a place is asked for, and once.
    let landmarks = LazyCell::new(|| base.landmarks());
    for bound in &base.sliders {
        // The rest of a line with a float says nothing about where it was meant to run.
        let sound = bound.slider.measure_floats.is_empty();
        let Some(line) = bound.slider.measure.as_ref().filter(|_| sound) else {
            continue;
        };
        let outside = |vertex: &&i64| **vertex >= end || **vertex < -end;
        let beyond: Vec<&i64> = line.iter().filter(outside).collect();
        let negative: Vec<&i64> = line
            .iter()
            .filter(|vertex| **vertex < 0 && !outside(vertex))
            .collect();
        if let Some(first) = beyond.first() {
            let message = format!(
                "measures vertex {first}, but the mesh has {} vertices",
                mesh.facts.vertices
            );
            out.push(
                finding(bound, &message, "")
                    .evidence(Evidence::of_cases(beyond.iter().copied()).out_of(line.len())),
            );
        } else if let Some(first) = negative.first() {
            let message =
                format!("measures vertex {first}, which is counted from the end of the mesh");
            let effect = "counts the vertex from the end of the mesh and shows a wrong length";
            out.push(
                finding(bound, &message, effect)
                    .level(Level::Warning)
                    .evidence(Evidence::of_cases(negative.iter().copied()).out_of(line.len())),
            );
        } else if let Some(first) = line.iter().find(|vertex| **vertex >= vertices) {
            let message = format!(
                "measures vertex {first}, a UV-seam duplicate: the mesh has {vertices} vertices"
            );
            let effect = "measures to the copy of another vertex, which it adds where the UV map \
                is cut: the length is wrong";
            out.push(finding(bound, &message, effect).level(Level::Warning));
        } else if is_circumference(bound) {
            out.extend(open_line(bound, line, &mesh.positions, &landmarks));
        }
    }
}

/// What is wrong with a line on any mesh.
fn whatever_the_mesh(bound: &BoundSlider<'_>) -> Option<Finding> {
    let slider = bound.slider;
    let line = slider.measure.as_ref()?;
    if let Some(first) = slider.measure_floats.first() {
        let message = format!("measures vertex {first:.1}, which has a decimal point");
        return Some(
            finding(bound, &message, "").help("write vertex numbers without a decimal point"),
        );
    }
    let is_short = line.len() < 2 && is_sound(bound.file, &pointer(&[&slider.key, "measure"]));
    let what = if line.is_empty() {
        "measures no vertices"
    } else {
        "measures only one vertex"
    };
    let help = "list the vertices along the line, or remove `measure`";
    is_short.then(|| {
        finding(bound, what, "shows a length of `0 cm`")
            .level(Level::Warning)
            .help(help)
    })
}

/// Whether the name says that the line goes around something.
fn is_circumference(bound: &BoundSlider<'_>) -> bool {
    let key = bound.slider.key.to_lowercase();
    let target = bound
        .slider
        .incr
        .as_deref()
        .unwrap_or_default()
        .to_lowercase();
    ["circ", "girth"]
        .iter()
        .any(|word| key.contains(word) || target.contains(word))
}

/// The gap of a line that should close, on the unmorphed mesh.
fn open_line(
    bound: &BoundSlider<'_>,
    line: &[i64],
    positions: &[[f32; 3]],
    landmarks: &Option<Landmarks<'_>>,
) -> Option<Finding> {
    let line: Vec<u32> = line
        .iter()
        .map(|vertex| u32::try_from(*vertex).ok())
        .collect::<Option<_>>()?;
    let (whole, gap) = (
        chain_length(positions, &line).ok()?,
        closing_gap(positions, &line).ok()?,
    );
    let (first, last) = (line.first()?, line.last()?);
    if gap <= SAME_PLACE || !whole.is_finite() {
        return None;
    }
    // The message names the place of the evidence, whose number has no unit.
    let ends = format!("vertices {first} and {last}");
    let place = landmarks
        .as_ref()
        .and_then(|body| body.place(*first))
        .map(|place| format!(" ({place})"));
    let message = format!(
        "does not close: {ends}{} are {} apart",
        place.unwrap_or_default(),
        length(gap)
    );
    let effect = format!(
        "shows a length without the missing piece: {} on the base mesh",
        length(whole)
    );
    let help = format!(
        "add vertex {first} again after {last}, with the vertices between them if there are any"
    );
    let evidence = Evidence::counted(1).with_worst(gap, ends);
    // Another fault than a vertex that does not exist: it must not be taken for the same.
    let key = format!("{} gap", bound.slider.key);
    Some(
        finding(bound, &message, &effect)
            .key(key)
            .level(Level::Warning)
            .help(help)
            .evidence(evidence),
    )
}

fn finding(bound: &BoundSlider<'_>, message: &str, effect: &str) -> Finding {
    let key = bound.slider.key.as_str();
    let finding = RULE
        .at(
            bound.file,
            Place::pointer([key, "measure"]),
            format!("`{key}` {message}"),
        )
        .key(key)
        .help(
            "correct the vertex numbers, which start at 0; the measuring line may be from \
            another mesh",
        );
    if effect.is_empty() {
        finding
    } else {
        finding.effect(effect)
    }
}
