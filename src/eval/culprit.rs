//! Which target moves something most at a setting: where the author of a fault has to look.

use super::macro_eval::MacroResult;
use super::scene::{Scene, Setting};

/// The target, by place, that moves the given vertices most compared with the default character: displacement times
/// what its factor is more or less than there. Suspects are left out. `None` if nothing moves them.
pub fn most_moving(scene: &Scene, setting: &Setting, vertices: &[u32]) -> Option<usize> {
    let factors = scene.factors(setting, &mut MacroResult::default()).ok()?;
    let rest = scene.factors(&scene.defaults(), &mut MacroResult::default()).ok()?;
    let at_rest =
        |place: usize| rest.iter().filter(|(other, _)| *other == place).map(|(_, factor)| factor).sum::<f64>();
    let moved = factors.into_iter().filter_map(|(place, factor)| {
        let target = scene.targets.get(place).filter(|target| !target.suspect)?;
        let rows = target.rows.as_deref()?.iter().filter(|(vertex, _)| vertices.contains(vertex));
        // Infinite displacements count as the largest.
        let longest = rows.map(|(_, delta)| delta.iter().map(|part| f64::from(part.abs())).fold(0.0, f64::max));
        let by = longest.fold(0.0, f64::max) * (factor - at_rest(place)).abs();
        (by > 0.0).then_some((place, by))
    });
    moved.max_by(|a, b| a.1.total_cmp(&b.1)).map(|(place, _)| place)
}

#[cfg(test)]
mod tests {
    use super::super::scene::{MorphTarget, SceneSlider, SliderKind};
    use super::*;

    #[test]
    fn the_target_with_the_largest_share_is_named() {
        let target = |rows: Vec<(u32, [f32; 3])>| MorphTarget { rows: Some(rows), ..MorphTarget::default() };
        let slider = |incr| SceneSlider {
            pattern: String::new(),
            kind: SliderKind::Detail { incr: Some(incr), decr: None, two_sided: false },
            default: 0.0,
        };
        let scene = Scene {
            positions: vec![[0.0; 3]; 2],
            targets: vec![target(vec![(0, [1.0, 0.0, 0.0])]), target(vec![(0, [0.0, -3.0, 0.0]), (1, [9.0; 3])])],
            sliders: vec![slider(0), slider(1)],
            ..Scene::default()
        };
        let setting = |a, b| Setting { macros: Vec::new(), details: vec![a, b] };
        assert_eq!(most_moving(&scene, &setting(1.0, 0.5), &[0]), Some(1));
        assert_eq!(most_moving(&scene, &setting(1.0, 0.1), &[0]), Some(0));
        assert_eq!(most_moving(&scene, &setting(1.0, 0.0), &[1]), None);
    }
}
