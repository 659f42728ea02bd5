//! Macro sliders to the variables that weight targets.
//!
//! Gets values of sliders, returns a value for each word that a target can have. Source:
//! `docs/loaders/makehuman1/macros.md#values-of-words`.

/// The sliders in the order in which they are numbered here; the last three are the races.
pub const SLIDERS: [&str; 11] = [
    "gender",
    "age",
    "muscle",
    "weight",
    "height",
    "breastSize",
    "breastFirmness",
    "bodyProportions",
    "african",
    "asian",
    "caucasian",
];
/// The number of the first race.
pub const FIRST_RACE: usize = 8;
/// How many races there are.
const RACES: usize = SLIDERS.len() - FIRST_RACE;
/// What every slider has at first; races a third each.
const MIDDLE: f64 = 0.5;
/// Slope of the age up to a child. Not 16/3: the sums come to 1 all the same.
const CHILD_SLOPE: f64 = 5.333;
/// Where a baby has become a child.
const CHILD: f64 = 0.1875;
/// Slope of the age from there to a young adult.
const YOUNG_SLOPE: f64 = 3.2;
/// A race this near to 1 is 1.
const WHOLE: f64 = 0.001;

/// The words that a target can have, in the order of their values.
pub const VARIABLES: [&str; 27] = [
    "male",
    "female",
    "baby",
    "child",
    "young",
    "old",
    "maxmuscle",
    "averagemuscle",
    "minmuscle",
    "maxweight",
    "averageweight",
    "minweight",
    "maxheight",
    "averageheight",
    "minheight",
    "maxcup",
    "averagecup",
    "mincup",
    "maxfirmness",
    "averagefirmness",
    "minfirmness",
    "idealproportions",
    "regularproportions",
    "uncommonproportions",
    "african",
    "asian",
    "caucasian",
];

/// Positions of the macro sliders, each from 0 to 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Human {
    values: [f64; SLIDERS.len()],
}

impl Default for Human {
    fn default() -> Self {
        let mut values = [MIDDLE; SLIDERS.len()];
        values
            .iter_mut()
            .skip(FIRST_RACE)
            .for_each(|race| *race = 1.0 / 3.0);
        Self { values }
    }
}

impl Human {
    /// The sliders at these values; what is not given stands at its default. NaN is the highest
    /// value, as `min(1, max(0, NaN))` is in Python. Races are set as they are and then brought to
    /// a sum of 1.
    pub fn of_file(values: &[f64]) -> Self {
        let mut human = Self::default();
        for (slot, value) in human.values.iter_mut().zip(values) {
            *slot = clamped(*value);
        }
        human.share(None);
        human
    }

    /// Value of a slider.
    pub fn value(&self, slider: usize) -> f64 {
        self.values.get(slider).copied().unwrap_or(f64::NAN)
    }

    /// Sets a slider. The other races take what a race leaves of 1, in their proportion.
    pub fn set(&mut self, slider: usize, value: f64) {
        if let Some(slot) = self.values.get_mut(slider) {
            *slot = clamped(value);
        }
        if slider >= FIRST_RACE {
            self.share(Some(slider));
        }
    }

    /// Brings the races, but for `kept`, to what is left of 1.
    fn share(&mut self, kept: Option<usize>) {
        let kept = kept.and_then(|slider| slider.checked_sub(FIRST_RACE));
        let races = &mut self.values[FIRST_RACE..];
        let left = 1.0
            - kept
                .and_then(|kept| races.get(kept))
                .copied()
                .unwrap_or(0.0);
        let is_other = |place: usize| Some(place) != kept;
        let sum: f64 = races
            .iter()
            .enumerate()
            .filter(|(place, _)| is_other(*place))
            .map(|(_, race)| race)
            .sum();
        if sum != 0.0 {
            let others = races
                .iter_mut()
                .enumerate()
                .filter(|(place, _)| is_other(*place));
            others.for_each(|(_, race)| *race = left * (*race / sum));
        } else if kept.is_none() || left >= 1.0 {
            races.fill(1.0 / 3.0);
        } else if left.abs() <= WHOLE {
            races
                .iter_mut()
                .enumerate()
                .for_each(|(place, race)| *race = if is_other(place) { 0.0 } else { 1.0 });
        } else {
            let others = f64::from(u8::try_from(RACES - 1).unwrap_or(1));
            races
                .iter_mut()
                .enumerate()
                .filter(|(place, _)| is_other(*place))
                .for_each(|(_, race)| {
                    *race = left / others;
                });
        }
    }

    /// The values of [`VARIABLES`].
    pub fn variables(&self) -> [f64; VARIABLES.len()] {
        let value = |slider: usize| self.values.get(slider).copied().unwrap_or(f64::NAN);
        let gender = value(0);
        let parts = [
            [gender, 1.0 - gender].as_slice(),
            &ages(value(1)),
            &of_sum(value(2)),
            &of_sum(value(3)),
            &of_larger(value(4)),
            &of_larger(value(5)),
            &of_larger(value(6)),
            &of_larger(value(7)),
            &self.values[FIRST_RACE..],
        ]
        .concat();
        let mut variables = [0.0; VARIABLES.len()];
        variables
            .iter_mut()
            .zip(parts)
            .for_each(|(slot, value)| *slot = value);
        variables
    }
}

/// To 0..1; NaN becomes 1.
fn clamped(value: f64) -> f64 {
    if value.is_nan() {
        1.0
    } else {
        value.clamp(0.0, 1.0)
    }
}

/// Baby, child, young, old.
fn ages(age: f64) -> [f64; 4] {
    if age < MIDDLE {
        let young = ((age - CHILD) * YOUNG_SLOPE).max(0.0);
        let child = (CHILD_SLOPE * age).min(1.0) - young;
        [
            (1.0 - age * CHILD_SLOPE).max(0.0),
            child.max(0.0),
            young,
            0.0,
        ]
    } else {
        let old = (2.0 * age - 1.0).max(0.0);
        [0.0, 0.0, 1.0 - old, old]
    }
}

/// Largest, average, least, which come to 1.
fn of_sum(value: f64) -> [f64; 3] {
    let (max, min) = ends(value);
    [max, 1.0 - max - min, min]
}

/// Largest, average, least; the average is what the larger of the others leaves.
fn of_larger(value: f64) -> [f64; 3] {
    let (max, min) = ends(value);
    [max, 1.0 - max.max(min), min]
}

fn ends(value: f64) -> (f64, f64) {
    ((2.0 * value - 1.0).max(0.0), (1.0 - 2.0 * value).max(0.0))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn near(one: f64, other: f64) -> bool {
        (one - other).abs() < 1e-6
    }

    fn variable(human: &Human, name: &str) -> f64 {
        human.variables()[VARIABLES.iter().position(|own| *own == name).unwrap()]
    }

    #[test]
    fn an_age_between_baby_and_child_has_a_rest_of_the_baby() {
        let mut human = Human::default();
        human.set(1, 0.1875);
        assert!((variable(&human, "baby") - 6.25e-5).abs() < 1e-12);
        assert!((variable(&human, "child") - 0.999_937_5).abs() < 1e-12);
        human.set(1, 0.0);
        assert_eq!(
            ["baby", "child", "young", "old"].map(|age| variable(&human, age)),
            [1.0, 0.0, 0.0, 0.0]
        );
        human.set(1, 0.5);
        assert_eq!(
            ["young", "old"].map(|age| variable(&human, age)),
            [1.0, 0.0]
        );
        human.set(1, 0.75);
        assert_eq!(
            ["child", "young", "old"].map(|age| variable(&human, age)),
            [0.0, 0.5, 0.5]
        );
    }

    #[test]
    fn what_lies_outside_is_clamped_and_nan_is_the_highest() {
        let human = Human::of_file(&[-3.0, 7.0, f64::NAN]);
        assert_eq!(
            [0, 1, 2, 3].map(|slider| human.value(slider)),
            [0.0, 1.0, 1.0, 0.5]
        );
        assert!(human.value(99).is_nan());
    }

    #[test]
    fn other_races_take_what_is_left() {
        let mut human = Human::default();
        human.set(8, 0.5);
        assert!(near(human.value(9), 0.25) && near(human.value(10), 0.25));
        human.set(9, 1.0);
        assert_eq!([8, 9, 10].map(|race| human.value(race)), [0.0, 1.0, 0.0]);
        // Both others are 0: they are shared equally.
        human.set(9, 0.4);
        assert!(near(human.value(8), 0.3) && near(human.value(10), 0.3));
        human.set(9, 1.0);
        human.set(9, 0.9995);
        assert_eq!([8, 9, 10].map(|race| human.value(race)), [0.0, 1.0, 0.0]);
        human.set(9, 0.0);
        assert!(
            [8, 9, 10]
                .iter()
                .all(|race| near(human.value(*race), 1.0 / 3.0))
        );
    }

    #[test]
    fn a_file_sets_races_as_they_are() {
        let mut values = [0.5; 11];
        values[8..].copy_from_slice(&[0.8, 0.8, 0.4]);
        let human = Human::of_file(&values);
        assert!(
            near(human.value(8), 0.4) && near(human.value(9), 0.4) && near(human.value(10), 0.2)
        );
        values[8..].fill(0.0);
        assert!(near(Human::of_file(&values).value(10), 1.0 / 3.0));
    }

    #[test]
    fn averages_of_sums_and_of_the_larger() {
        let human = Human::of_file(&[0.5, 0.5, 0.25, 0.5, 0.25]);
        assert_eq!(
            ["minmuscle", "averagemuscle", "maxmuscle"].map(|name| variable(&human, name)),
            [0.5, 0.5, 0.0]
        );
        assert_eq!(
            ["minheight", "averageheight"].map(|name| variable(&human, name)),
            [0.5, 0.5]
        );
        assert_eq!(
            human
                .variables()
                .iter()
                .filter(|value| **value < 0.0)
                .count(),
            0
        );
    }
}
