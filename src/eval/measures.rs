//! What evaluation measures on a scene, in plain data that outlives the scene. Rules judge it.

use super::scene::Scene;

/// Measures of one base mesh.
#[derive(Debug, Clone, Default)]
pub struct Measures {
    /// Vertices of the base mesh.
    pub vertices: usize,
}

impl Measures {
    /// Measures a scene.
    pub fn of(scene: &Scene) -> Self {
        Self { vertices: scene.positions.len() }
    }
}
