//! Which settings of the sliders are looked at: deliberate ones first, then a seeded sample.
//!
//! Every macro slider alone at every step, in the middle of every interval and on both sides of
//! every step; every detail slider alone at its ends; every corner of every macrodef; a fixed
//! pseudo-random sample of whole settings; on request every corner of the whole product.

use std::collections::BTreeSet;
use std::sync::Arc;

use super::macros::Macros;
use super::scene::{Scene, SceneSlider, Setting, SliderKind};
use super::steps::step;

/// How far beside a step the two sides of it are looked at: well inside every interval, outside the
/// 0.001 limits.
const BESIDE: f64 = 0.004;
/// Corners of a product beyond this are not visited; the caller says so.
pub const MOST_CORNERS: usize = 1 << 16;
/// Random settings when nobody asks for another number.
pub const DEFAULT_SAMPLES: usize = 64;
/// Detail sliders that a sampled setting moves: a person sets a few; all of them at once make no
/// figure.
const SAMPLED_DETAILS: usize = 3;
/// Numbers that all settings together may hold: hm08 has thirty thousand, and a stranger's sliders
/// times their defaults have no end.
const MOST_NUMBERS: usize = 1 << 21;
/// Steps that evaluating the macros at all settings may take. A character of a hundred macro
/// sliders comes to a tenth.
const MOST_STEPS: usize = 1 << 26;
/// Seed of the sample: any number, always the same.
const SEED: u64 = 0x6d68_6c69_6e74;

/// Sliders that are moved as one: the positions of one component of the macros.
#[derive(Debug, Clone, PartialEq)]
pub enum Dimension {
    /// A slider with its steps: place in the macro settings.
    Steps {
        /// Place in the macro settings.
        place: usize,
        /// Slider positions, ascending. Shared: a component may be named by any number of
        /// macrodefs.
        steps: Arc<[f64]>,
    },
    /// A barycentric set: places of its numbers.
    Corners(Vec<usize>),
}

/// The settings to look at, without repetition, in a fixed order, and whether some were left out
/// because they are too many.
pub fn plan(scene: &Scene, samples: usize, exhaustive: bool) -> (Vec<Setting>, bool) {
    let rest = scene.defaults();
    let cost = scene.macros.as_ref().map_or(1, Macros::cost).max(1);
    let mut plan = Plan {
        settings: vec![rest.clone()],
        rest,
        seen: BTreeSet::new(),
        room: MOST_NUMBERS,
        left: MOST_STEPS / cost,
        is_cut: false,
    };
    let dimensions = distinct(&scene.products);
    for dimension in &dimensions {
        plan.alone(dimension);
    }
    for product in &scene.products {
        plan.corners(product);
    }
    if exhaustive {
        plan.corners(&dimensions);
    }
    plan.details(scene);
    plan.sample(scene, &dimensions, samples);
    (plan.settings, plan.is_cut)
}

/// Number of corners of a product of dimensions.
pub fn corner_count(dimensions: &[Dimension]) -> usize {
    dimensions
        .iter()
        .map(Dimension::corners)
        .fold(1, usize::saturating_mul)
}

impl Dimension {
    pub(super) fn corners(&self) -> usize {
        match self {
            Self::Steps { steps, .. } => steps.len(),
            Self::Corners(places) => places.len(),
        }
    }

    /// Copies the positions of its sliders.
    pub(super) fn copy(&self, from: &[f64], to: &mut [f64]) {
        let one;
        let places: &[usize] = match self {
            Self::Steps { place, .. } => {
                one = [*place];
                &one
            }
            Self::Corners(places) => places,
        };
        for place in places {
            if let (Some(from), Some(to)) = (from.get(*place), to.get_mut(*place)) {
                *to = *from;
            }
        }
    }

    /// Puts a setting to a corner.
    fn put(&self, setting: &mut Setting, corner: usize) {
        match self {
            Self::Steps { place, steps } => {
                setting.put(*place, steps.get(corner).copied().unwrap_or(0.0));
            }
            Self::Corners(places) => {
                for (number, place) in places.iter().enumerate() {
                    setting.put(*place, if number == corner { 1.0 } else { 0.0 });
                }
            }
        }
    }
}

/// Each dimension once, in the order of the products.
fn distinct(products: &[Vec<Dimension>]) -> Vec<Dimension> {
    let mut seen: BTreeSet<(&[usize], Vec<u64>)> = BTreeSet::new();
    // What shares its steps with another one needs no look at them.
    let mut shared: BTreeSet<(usize, *const f64)> = BTreeSet::new();
    let mut all = Vec::new();
    for dimension in products.iter().flatten() {
        let is_new = match dimension {
            Dimension::Steps { place, steps } if !shared.insert((*place, steps.as_ptr())) => false,
            Dimension::Steps { place, steps } => {
                steps.iter().for_each(|_| step());
                seen.insert((
                    std::slice::from_ref(place),
                    steps.iter().map(|step| (step + 0.0).to_bits()).collect(),
                ))
            }
            Dimension::Corners(places) => seen.insert((places, vec![u64::MAX])),
        };
        if is_new {
            all.push(dimension.clone());
        }
    }
    all
}

struct Plan {
    /// All sliders as a reset leaves them.
    rest: Setting,
    settings: Vec<Setting>,
    seen: BTreeSet<Vec<u64>>,
    /// Numbers that there is room for.
    room: usize,
    /// Settings of macros that there is time for.
    left: usize,
    /// Whether there was no room for some settings.
    is_cut: bool,
}

impl Plan {
    /// The default setting, to be changed at so many sliders; nothing where there is no room for
    /// another one.
    fn another(&mut self, moved: usize) -> Option<Setting> {
        step();
        let left = self.room.checked_sub(1 + moved + self.rest.details.len());
        self.is_cut |= left.is_none();
        self.room = left.unwrap_or(0);
        left.is_some().then(|| self.rest.clone())
    }

    /// The same with macro settings of its own.
    fn another_of_macros(&mut self) -> Option<Setting> {
        self.left = self.left.checked_sub(1).or_else(|| {
            self.is_cut = true;
            None
        })?;
        self.another(2 * self.rest.macros.len())
    }

    /// Adds a setting of macro sliders unless it is there.
    fn add(&mut self, setting: Setting) {
        if self
            .seen
            .insert(setting.macros.iter().map(|value| value.to_bits()).collect())
        {
            self.settings.push(setting);
        }
    }

    fn alone(&mut self, dimension: &Dimension) {
        let Dimension::Steps { place, steps } = dimension else {
            return;
        };
        let middles = steps.windows(2).map(|pair| f64::midpoint(pair[0], pair[1]));
        let sides = steps.iter().flat_map(|step| [step - BESIDE, step + BESIDE]);
        let inside = sides.filter(|value| (0.0..=1.0).contains(value));
        for value in steps
            .iter()
            .copied()
            .chain([0.0, 1.0])
            .chain(middles)
            .chain(inside)
        {
            let Some(mut setting) = self.another_of_macros() else {
                return;
            };
            setting.put(*place, value);
            self.add(setting);
        }
    }

    fn corners(&mut self, dimensions: &[Dimension]) {
        let count = corner_count(dimensions);
        if count > MOST_CORNERS {
            return;
        }
        for number in 0..count {
            let Some(mut setting) = self.another_of_macros() else {
                return;
            };
            let mut rest = number;
            for dimension in dimensions {
                dimension.put(&mut setting, rest % dimension.corners());
                rest /= dimension.corners();
            }
            self.add(setting);
        }
    }

    fn details(&mut self, scene: &Scene) {
        for (number, slider) in scene.sliders.iter().enumerate() {
            let SliderKind::Detail {
                incr,
                decr,
                two_sided,
            } = slider.kind
            else {
                continue;
            };
            let ends = [(1.0, incr.is_some()), (-1.0, two_sided && decr.is_some())];
            for (value, _) in ends.into_iter().filter(|(_, has)| *has) {
                let Some(mut setting) = self.another(1) else {
                    return;
                };
                scene.set(&mut setting, number, value);
                self.settings.push(setting);
            }
        }
    }

    fn sample(&mut self, scene: &Scene, dimensions: &[Dimension], samples: usize) {
        let mut random = Random(SEED);
        let details = details_of(scene);
        for _ in 0..samples {
            let Some(mut setting) = self.another_of_macros() else {
                return;
            };
            for dimension in dimensions {
                random.macro_values(dimension, &mut setting);
            }
            for _ in 0..SAMPLED_DETAILS.min(details.len()) {
                let Some((number, two_sided)) = details.get(random.below(details.len())) else {
                    continue;
                };
                let value = random.next();
                scene.set(
                    &mut setting,
                    *number,
                    if *two_sided { 2.0 * value - 1.0 } else { value },
                );
            }
            self.settings.push(setting);
        }
    }
}

/// Numbers of the detail sliders and whether they have two sides.
fn details_of(scene: &Scene) -> Vec<(usize, bool)> {
    let detail = |(number, slider): (usize, &SceneSlider)| match slider.kind {
        SliderKind::Detail { two_sided, .. } => Some((number, two_sided)),
        SliderKind::Macro(_) => None,
    };
    scene
        .sliders
        .iter()
        .enumerate()
        .filter_map(detail)
        .collect()
}

/// `SplitMix64`: a few lines, the same numbers everywhere and for ever.
struct Random(u64);

impl Random {
    /// A number in 0..1.
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut bits = self.0;
        bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        (bits >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// A whole number below `count`.
    fn below(&mut self, count: usize) -> usize {
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "not negative and below `count`"
        )]
        {
            (self.next() * count as f64) as usize
        }
    }

    fn macro_values(&mut self, dimension: &Dimension, setting: &mut Setting) {
        match dimension {
            Dimension::Steps { place, .. } => {
                let value = self.next();
                setting.put(*place, value);
            }
            Dimension::Corners(places) => {
                let shares: Vec<f64> = places.iter().map(|_| self.next()).collect();
                let sum: f64 = shares.iter().sum();
                for (place, share) in places.iter().zip(shares) {
                    setting.put(*place, share / sum.max(f64::MIN_POSITIVE));
                }
            }
        }
    }
}

/// A slider by its name, and its value.
pub type SliderSetting = (String, f64);

/// The sliders that do not stand at their defaults, in the application's own names.
pub fn moved(scene: &Scene, setting: &Setting) -> Vec<SliderSetting> {
    let defaults = scene.defaults();
    let sliders = scene.sliders.iter().enumerate();
    let moved = sliders.filter_map(|(number, slider)| {
        let value = scene.value(setting, number)?;
        (Some(value) != scene.value(&defaults, number)).then(|| (slider.pattern.clone(), value))
    });
    moved.collect()
}

#[cfg(test)]
mod tests {
    use super::super::steps::steps_of;
    use super::*;

    fn scene() -> Scene {
        let slider = |pattern: &str, place| SceneSlider {
            pattern: pattern.to_owned(),
            kind: SliderKind::Macro(place),
            default: 0.5,
        };
        Scene {
            sliders: vec![
                slider("Age", 0),
                slider("Gender", 1),
                SceneSlider {
                    pattern: "nose".to_owned(),
                    kind: SliderKind::Detail {
                        incr: Some(0),
                        decr: None,
                        two_sided: false,
                    },
                    default: 0.0,
                },
            ],
            macro_defaults: vec![0.5, 0.5],
            products: vec![dimensions()],
            ..Scene::default()
        }
    }

    fn dimensions() -> Vec<Dimension> {
        vec![
            Dimension::Steps {
                place: 0,
                steps: [0.0, 0.25, 1.0].into(),
            },
            Dimension::Steps {
                place: 1,
                steps: [0.0, 1.0].into(),
            },
        ]
    }

    #[test]
    fn corners_middles_and_sides_are_there_once() {
        let scene = scene();
        let (plan, is_cut) = plan(&scene, 3, false);
        assert!(!is_cut);
        let has =
            |age: f64, gender: f64| plan.iter().filter(|s| *s.macros == [age, gender]).count();
        assert_eq!([has(0.0, 0.0), has(0.25, 1.0), has(1.0, 1.0)], [1, 1, 1]);
        assert_eq!(
            [
                has(0.625, 0.5),
                has(0.25 - BESIDE, 0.5),
                has(0.25 + BESIDE, 0.5)
            ],
            [1, 1, 1]
        );
        assert_eq!(
            plan.iter()
                .filter(|s| s.details == [(2, 1.0)].into() && *s.macros == [0.5, 0.5])
                .count(),
            1
        );
    }

    /// A scene of so many detail sliders, all of them set after a reset, and as many macro sliders.
    fn sliders(count: usize) -> Scene {
        let kind = SliderKind::Detail {
            incr: Some(0),
            decr: None,
            two_sided: false,
        };
        let details = (0..count).map(|_| SceneSlider {
            pattern: String::new(),
            kind,
            default: 0.5,
        });
        Scene {
            sliders: details.collect(),
            macro_defaults: vec![0.0; count],
            ..Scene::default()
        }
    }

    #[test]
    fn settings_that_have_no_room_are_left_out() {
        let count = 15_000;
        let mut scene = sliders(count);
        let mut found = (Vec::new(), false);
        let steps = steps_of(|| found = plan(&scene, 10, false));
        assert!(found.1 && steps < 3 * count as u64, "{steps}");
        assert!(
            found
                .0
                .iter()
                .map(|setting| setting.details.len())
                .sum::<usize>()
                <= MOST_NUMBERS + count
        );
        // Settings of one slider each share what they have in common.
        scene
            .sliders
            .iter_mut()
            .for_each(|slider| slider.default = 0.0);
        let (settings, is_cut) = plan(&scene, 10, false);
        assert_eq!((settings.len(), is_cut), (count + 11, false));
        let own: BTreeSet<_> = settings
            .iter()
            .map(|setting| Arc::as_ptr(&setting.macros))
            .collect();
        assert_eq!(own.len(), 1);
    }

    #[test]
    fn steps_that_are_named_again_and_again_are_looked_at_once() {
        let steps: Arc<[f64]> = (0..3000).map(f64::from).collect();
        let product = vec![Dimension::Steps { place: 0, steps }; 3000];
        let steps = steps_of(|| assert_eq!(distinct(&[product]).len(), 1));
        assert!(steps <= 3000, "{steps}");
    }

    #[test]
    fn the_sample_is_always_the_same() {
        let scene = scene();
        assert_eq!(plan(&scene, 5, false), plan(&scene, 5, false));
    }

    #[test]
    fn a_setting_is_told_by_what_differs() {
        let scene = scene();
        let mut setting = scene.defaults();
        assert_eq!(moved(&scene, &setting), []);
        scene.set(&mut setting, 0, 0.0);
        scene.set(&mut setting, 2, 1.0);
        assert_eq!(
            moved(&scene, &setting),
            [("Age".to_owned(), 0.0), ("nose".to_owned(), 1.0)]
        );
    }
}
