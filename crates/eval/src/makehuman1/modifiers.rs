//! Modifiers to weights of targets.
//!
//! Gets positions of the macro sliders and of modifiers, returns numbers of targets with weights.
//! Source: `docs/loaders/makehuman1/modifiers.md#evaluation`.

use std::collections::BTreeMap;

use super::variables::{Human, SLIDERS, VARIABLES};

/// What the sliders of a body do that depend on the macro variables, and those with several
/// targets.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Modifiers {
    /// Groups of targets in the order in which the application sets them.
    pub groups: Vec<TargetGroup>,
}

/// The targets of one name.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct TargetGroup {
    /// What all of them are multiplied by.
    pub factor: Factor,
    /// Number of each target, and the variables that it depends on, places in [`VARIABLES`].
    pub targets: Vec<(u32, Vec<u8>)>,
}

/// What a group of targets is multiplied by: a side of a modifier, whose setting has this place.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum Factor {
    /// Macro targets: by nothing else.
    #[default]
    One,
    /// The side of negative values.
    Left(usize),
    /// The middle of a modifier with three.
    Centre(usize),
    /// The side of positive values.
    Right(usize),
    /// The only side.
    Only(usize),
}

/// Room for the outcome, meant to be reused.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct ModifierResult {
    /// Targets with their weights, each once.
    pub weights: Vec<(u32, f64)>,
    places: BTreeMap<u32, usize>,
}

impl Factor {
    /// The factor at positions of all settings.
    pub fn at(self, settings: &[f64]) -> f64 {
        let value = |place: usize| settings.get(place).copied().unwrap_or(0.0);
        let sided = |place: usize| clamped(value(place), -1.0);
        match self {
            Self::One => 1.0,
            Self::Left(place) => -sided(place).min(0.0),
            Self::Centre(place) => 1.0 - sided(place).abs(),
            Self::Right(place) => sided(place).max(0.0),
            Self::Only(place) => clamped(value(place), 0.0),
        }
    }
}

/// A value of a modifier to its range; NaN is the highest, as `min(1, max(lowest, NaN))` is in
/// Python.
pub fn clamped(value: f64, lowest: f64) -> f64 {
    if value.is_nan() {
        1.0
    } else {
        value.clamp(lowest, 1.0)
    }
}

impl TargetGroup {
    /// The weights of its targets.
    pub fn weights(
        &self,
        settings: &[f64],
        variables: &[f64; VARIABLES.len()],
    ) -> impl Iterator<Item = (u32, f64)> {
        let factor = self.factor.at(settings);
        let product = move |own: &Vec<u8>| {
            own.iter().fold(factor, |product, place| {
                product * variables.get(usize::from(*place)).unwrap_or(&0.0)
            })
        };
        self.targets
            .iter()
            .map(move |(target, own)| (*target, product(own)))
    }
}

impl Modifiers {
    /// Weights of the targets at positions of the macro sliders and, behind them, of the modifiers.
    /// Of several weights for one target the last counts, and a weight of 0 takes it away.
    pub fn evaluate(&self, settings: &[f64], out: &mut ModifierResult) {
        out.weights.clear();
        out.places.clear();
        let variables =
            Human::of_file(settings.get(..SLIDERS.len()).unwrap_or(settings)).variables();
        for group in &self.groups {
            if group.factor.at(settings) == 0.0 && !matches!(group.factor, Factor::One) {
                continue;
            }
            group
                .weights(settings, &variables)
                .for_each(|(target, weight)| out.set(target, weight));
        }
        out.weights.retain(|(_, weight)| *weight != 0.0);
    }

    /// Steps that evaluating one setting takes at most.
    pub fn cost(&self) -> usize {
        self.groups
            .iter()
            .flat_map(|group| &group.targets)
            .map(|(_, own)| 1 + own.len())
            .sum()
    }
}

impl ModifierResult {
    fn set(&mut self, target: u32, weight: f64) {
        if weight == 0.0 && !self.places.contains_key(&target) {
            return;
        }
        let place = *self.places.entry(target).or_insert(self.weights.len());
        match self.weights.get_mut(place) {
            Some(known) => known.1 = weight,
            None => self.weights.push((target, weight)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn weights(groups: Vec<TargetGroup>, further: &[f64]) -> Vec<(u32, f64)> {
        let mut settings = vec![0.5; SLIDERS.len()];
        settings.extend(further);
        let modifiers = Modifiers { groups };
        let mut out = ModifierResult::default();
        modifiers.evaluate(&settings, &mut out);
        out.weights
    }

    fn group(factor: Factor, targets: &[(u32, &[u8])]) -> TargetGroup {
        TargetGroup {
            factor,
            targets: targets
                .iter()
                .map(|(target, own)| (*target, own.to_vec()))
                .collect(),
        }
    }

    #[test]
    fn sides_and_the_middle_of_a_modifier() {
        let groups = |value| {
            let sides = [Factor::Left(11), Factor::Centre(11), Factor::Right(11)];
            let all = sides
                .into_iter()
                .zip(0..)
                .map(|(side, target)| group(side, &[(target, &[])]));
            weights(all.collect(), &[value])
        };
        assert_eq!(groups(-0.75), [(0, 0.75), (1, 0.25)]);
        assert_eq!(groups(0.0), [(1, 1.0)]);
        assert_eq!(groups(3.0), [(2, 1.0)]);
        assert_eq!(groups(f64::NAN), [(2, 1.0)]);
    }

    #[test]
    fn a_gendered_detail_has_half_its_weight_at_first() {
        assert_eq!(
            weights(vec![group(Factor::Only(11), &[(0, &[1])])], &[1.0]),
            [(0, 0.5)]
        );
        assert_eq!(
            weights(vec![group(Factor::Only(11), &[(0, &[1])])], &[-1.0]),
            []
        );
    }

    #[test]
    fn macro_targets_are_products() {
        let one = group(Factor::One, &[(0, &[0, 4, 24]), (1, &[1, 4]), (2, &[5])]);
        let found = weights(vec![one], &[]);
        assert_eq!(found.len(), 2);
        assert!((found[0].1 - 1.0 / 6.0).abs() < 1e-12 && (found[1].1 - 0.5).abs() < 1e-12);
    }

    #[test]
    fn of_two_weights_for_a_target_the_last_counts() {
        let two = [
            group(Factor::Only(11), &[(0, &[])]),
            group(Factor::Only(12), &[(0, &[])]),
        ];
        assert_eq!(weights(two.to_vec(), &[0.25, 0.75]), [(0, 0.75)]);
    }
}
