//! Sliders as saved characters name them: lines of `.mhm`, and targets by their names
//! (`docs/loaders/mpfb/models.md#lines-of-a-model`,
//! `docs/loaders/mpfb/models.md#saved-characters`).

use mhlint_eval::scene::{Scene, SliderKind};
use mhlint_formats::mhm::columns::setting_of;

/// The place of the slider that a name means, and the sign of its value: the target of the negative
/// end lowers it.
pub(crate) fn slider(scene: &Scene, name: &str) -> Option<(usize, f64)> {
    if let Some(setting) = setting_of(name) {
        return scene.slider(setting).map(|place| (place, 1.0));
    }
    let last = name
        .split_once('/')
        .map_or(name, |(_, last)| last)
        .replace('|', "-");
    let is_named = |known: &str| known.rsplit('/').next() == Some(&*last);
    let by_name = scene
        .sliders
        .iter()
        .position(|slider| is_named(&slider.pattern))
        .map(|place| (place, 1.0));
    let is_target = |target: Option<usize>| {
        target
            .and_then(|at| scene.targets.get(at))
            .is_some_and(|one| is_named(&one.name))
    };
    let end = |(place, kind): (usize, SliderKind)| match kind {
        SliderKind::Detail { incr, .. } if is_target(incr) => Some((place, 1.0)),
        SliderKind::Detail { decr, .. } if is_target(decr) => Some((place, -1.0)),
        _ => None,
    };
    by_name.or_else(|| {
        scene
            .sliders
            .iter()
            .map(|slider| slider.kind)
            .enumerate()
            .find_map(end)
    })
}
