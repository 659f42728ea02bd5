//! Which target moves something most at a setting: where the author of a fault has to look.

use std::collections::BTreeMap;

use super::macros::MacroWork;
use super::scene::{Scene, Setting};
use super::steps::step;
use super::vector::{Point, Vec3, add, scale, sub, widen};

/// The target, by place, that moves the given vertices most compared with the default character:
/// displacement times what its factor is more or less than there. What moves several vertices alike
/// does no harm to the face or bone between them, so only differences count then. Suspects are left
/// out. `None` if nothing moves them.
pub fn most_moving(scene: &Scene, setting: &Setting, vertices: &[u32]) -> Option<usize> {
    let factors = scene.factors(setting, &mut MacroWork::default()).ok()?;
    let rest = scene
        .factors(&scene.defaults(), &mut MacroWork::default())
        .ok()?;
    let mut at_rest: BTreeMap<usize, f64> = BTreeMap::new();
    for (place, factor) in rest {
        *at_rest.entry(place).or_default() += factor;
    }
    let moved = factors.into_iter().filter_map(|(place, factor)| {
        let target = scene.targets.get(place).filter(|target| !target.suspect)?;
        let by = largest(target.rows.as_deref()?, vertices)
            * (factor - at_rest.get(&place).copied().unwrap_or(0.0)).abs();
        (by > 0.0).then_some((place, by))
    });
    moved
        .max_by(|a, b| a.1.total_cmp(&b.1))
        .map(|(place, _)| place)
}

/// The largest displacement of a vertex; of several vertices the largest difference from their
/// mean.
fn largest(rows: &[(u32, Point)], vertices: &[u32]) -> f64 {
    // Of several rows for a vertex the last counts.
    let mut moved: BTreeMap<u32, Point> =
        vertices.iter().map(|vertex| (*vertex, [0.0; 3])).collect();
    for (vertex, delta) in rows {
        step();
        if let Some(moved) = moved.get_mut(vertex) {
            *moved = *delta;
        }
    }
    let delta = |vertex: &u32| moved.get(vertex).copied().unwrap_or_default();
    let deltas: Vec<Vec3> = vertices.iter().map(delta).map(widen).collect();
    let mean = match deltas.as_slice() {
        [_] => [0.0; 3],
        several => scale(
            several.iter().copied().fold([0.0; 3], add),
            1.0 / several.len().max(1) as f64,
        ),
    };
    // Infinite displacements count as the largest.
    let parts = deltas
        .iter()
        .flat_map(|delta| sub(*delta, mean))
        .map(f64::abs);
    parts
        .map(|part| if part.is_nan() { f64::INFINITY } else { part })
        .fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::super::scene::{MorphTarget, SceneSlider, SliderKind};
    use super::super::steps::steps_of;
    use super::*;

    /// Two vertices, two targets with these rows, a slider for each.
    fn scene(rows: [&[(u32, [f32; 3])]; 2]) -> Scene {
        let target = |rows: &[(u32, [f32; 3])]| MorphTarget {
            rows: Some(Arc::new(rows.to_vec())),
            ..MorphTarget::default()
        };
        let slider = |incr| SceneSlider {
            pattern: String::new(),
            kind: SliderKind::Detail {
                incr: Some(incr),
                decr: None,
                two_sided: false,
            },
            default: 0.0,
        };
        Scene {
            positions: vec![[0.0; 3]; 2],
            targets: rows.map(target).to_vec(),
            sliders: vec![slider(0), slider(1)],
            ..Scene::default()
        }
    }

    fn setting(a: f64, b: f64) -> Setting {
        Setting {
            macros: Vec::new().into(),
            details: [(0, a), (1, b)].into(),
        }
    }

    #[test]
    fn the_target_with_the_largest_share_is_named() {
        let scene = scene([
            &[(0, [1.0, 0.0, 0.0])],
            &[(0, [0.0, -3.0, 0.0]), (1, [9.0; 3])],
        ]);
        assert_eq!(most_moving(&scene, &setting(1.0, 0.5), &[0]), Some(1));
        assert_eq!(most_moving(&scene, &setting(1.0, 0.1), &[0]), Some(0));
        assert_eq!(most_moving(&scene, &setting(1.0, 0.0), &[1]), None);
    }

    #[test]
    fn rows_are_walked_once_for_all_vertices() {
        let vertices: Vec<u32> = (0..1000).collect();
        let rows: Vec<(u32, Point)> = vertices
            .iter()
            .map(|vertex| (*vertex, [0.0, 1.0, 0.0]))
            .collect();
        let again = [
            (7, [0.0, 2.0, 0.0]),
            (9, [0.0, 5.0, 0.0]),
            (7, [0.0, 1.0, 0.0]),
            (9, [0.0, 1.0, 0.0]),
        ];
        let rows = [rows.as_slice(), &again].concat();
        let steps = steps_of(|| assert!(largest(&rows, &vertices) < 1e-9));
        assert!(steps <= 2000, "{steps}");
    }

    #[test]
    fn what_moves_all_vertices_alike_is_not_blamed() {
        let scene = scene([
            &[(0, [0.0, -9.0, 0.0]), (1, [0.0, -9.0, 0.0])],
            &[(1, [0.5, 0.0, 0.0])],
        ]);
        assert_eq!(most_moving(&scene, &setting(1.0, 1.0), &[0, 1]), Some(1));
        assert_eq!(most_moving(&scene, &setting(1.0, 1.0), &[0]), Some(0));
    }
}
