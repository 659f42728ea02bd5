//! The size and the axes of the base mesh of MPFB (formats/mpfb-observed.md 2.4).

use super::super::Rule;
use crate::diag::{Application::Mpfb, Case, Finding, Level, Place};
use crate::formats::obj::Mesh;
use crate::repo::FileFacts;

/// Vertices of the one base mesh that there is. Of any other mesh nobody knows how large it should be.
const VERTICES: usize = 19_158;
/// Its height along y, in units of the file (dm).
const HEIGHT: f32 = 16.9;
/// A mesh this many times higher or lower has another unit. No edit of a figure comes near.
const OTHER_UNIT: f32 = 3.0;

const GIANT: Case = &[(
    Mpfb,
    Level::Warning,
    "makes a figure of another size; sliders move it as far as before, which is too much or too little",
)];
const LYING: Case = &[(Mpfb, Level::Warning, "makes a figure that does not stand, and moves it along other axes")];

/// What is wrong with the size of the mesh.
pub(super) fn fault(rule: &Rule, file: &FileFacts, mesh: &Mesh) -> Option<Finding> {
    if mesh.facts.vertices != VERTICES || mesh.facts.unreadable_lines > 0 {
        return None;
    }
    let [wide, high, deep] = extent(mesh)?;
    let tallest = wide.max(high).max(deep);
    if high < tallest {
        let axis = if wide < tallest { "z" } else { "x" };
        let message = format!("the mesh is largest along {axis}, not along y: it does not stand upright");
        let finding = rule.at(file, Place::File, message).key("axes").case(LYING);
        return Some(finding.help("export the mesh with y up, or restore it"));
    }
    let is_far = high > HEIGHT * OTHER_UNIT || high * OTHER_UNIT < HEIGHT;
    is_far.then(|| {
        let (metres, usual) = (high / 10.0, HEIGHT / 10.0);
        let message = format!("the mesh is {metres:.2} m ({high:.3}) high, expected about {usual:.1} m");
        let finding = rule.at(file, Place::File, message).key("size").case(GIANT);
        finding.help("export the mesh in decimetres, or restore it")
    })
}

/// How far the mesh reaches along each axis.
fn extent(mesh: &Mesh) -> Option<[f32; 3]> {
    let mut ends = [(f32::INFINITY, f32::NEG_INFINITY); 3];
    for position in &mesh.positions {
        for ((low, high), value) in ends.iter_mut().zip(position) {
            // NaN has a finding of its own, and is passed over here.
            *low = low.min(*value);
            *high = high.max(*value);
        }
    }
    let sizes = ends.map(|(low, high)| high - low);
    sizes.iter().all(|size| size.is_finite()).then_some(sizes)
}
