//! What becomes of an asset on the base mesh that it is fitted to, against the mesh that its author
//! drew.
//!
//! Applications never look at where the vertices of an asset were drawn: every vertex goes where
//! its row puts it. The drawn mesh still tells what was meant. Up to an affine map the two have one
//! shape: of the assets of MakeHuman all agree within 7 % of their size, and their edges keep their
//! lengths in proportion within a tenth.

mod affine;
mod closest;
mod cover;
mod facing;
mod shape;
mod triangles;
mod triples;

pub use affine::median;
pub use cover::Uncovered;
pub use shape::{Disorder, Drift, Numbering, ShapeMeasure};
pub use triples::{TripleFault, Triples};

use super::faces::Faces;
use super::fit::{Reference, fit};
use super::vector::{Point, Vec3};

/// The mesh that assets are fitted to.
#[derive(Debug, Clone, Copy)]
pub struct Wearer<'a> {
    /// Its vertices.
    pub positions: &'a [Point],
    /// Its faces that are shown.
    pub skin: Faces<'a>,
    /// Its height, mesh units.
    pub height: f64,
}

/// An asset.
#[derive(Debug, Clone, Copy)]
pub struct Garment<'a> {
    /// A row for each vertex.
    pub references: &'a [Reference],
    /// What offsets are multiplied by; `None` for 1.
    pub scales: Option<Vec3>,
    /// Its vertices as drawn.
    pub drawn: &'a [Point],
    /// Its faces.
    pub faces: Faces<'a>,
    /// Which vertices of the wearer it hides; empty for none.
    pub deleted: &'a [bool],
}

/// What was measured of an asset.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct WornMeasure {
    /// Rows whose three vertices make no triangle.
    pub triples: Triples,
    /// Its shape against the one that was drawn; `None` where they cannot be compared.
    pub shape: ShapeMeasure,
    /// Whether its faces look inwards.
    pub is_inside_out: bool,
    /// Hidden faces of the wearer that nothing of it covers.
    pub uncovered: Option<Uncovered>,
}

/// Of so many rows one may have weights that do not sum to 1: where more have, nothing can be told
/// of the shape.
const MANY: usize = 10;

/// Measures an asset on a mesh. `None` if a row names a vertex that the mesh lacks.
pub fn measure(wearer: &Wearer<'_>, garment: &Garment<'_>) -> Option<WornMeasure> {
    let fitted = fit(wearer.positions, garment.references, garment.scales).ok()?;
    let triples = triples::measure(wearer.positions, garment.references);
    // Weights that do not sum to 1 bend the shape by themselves.
    let off = garment
        .references
        .iter()
        .filter(|row| shape::is_told_by_its_weights(row))
        .count();
    if off > garment.references.len() / MANY {
        return Some(WornMeasure {
            triples,
            ..WornMeasure::default()
        });
    }
    let is_inside_out = facing::is_inside_out(wearer, garment.faces, &fitted);
    let shape = shape::measure(wearer, garment, &fitted, &triples, is_inside_out);
    // Faces between rows of others look anywhere, and cover anything.
    let is_in_order = shape.disorder.is_none();
    Some(WornMeasure {
        triples,
        is_inside_out: is_in_order && is_inside_out,
        uncovered: if is_in_order {
            cover::uncovered(wearer, garment, &fitted)
        } else {
            None
        },
        shape,
    })
}
