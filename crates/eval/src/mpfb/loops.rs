//! Macro settings to targets with weights: loops over the names that have a share.
//!
//! Gets values of settings, returns numbers of targets with weights. Source: MPFB, macro targets
//! (`docs/loaders/mpfb/macros.md#the-five-loops`).

use std::collections::BTreeMap;

use super::shares::{Part, shares};

/// A target is applied with a weight above this.
pub const CUT_OFF: f64 = 0.01;
/// Value of every macro setting of a new character, and of each race
/// (`docs/loaders/mpfb/macros.md#the-default-character`).
pub const DEFAULTS: (f64, f64) = (0.5, 0.33);
/// A race counts with a share above this.
const LEAST_RACE: f64 = 0.0001;

/// The macros: settings, races, and loops over them.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct MacroLoops {
    /// Parts of each setting.
    pub settings: Vec<Vec<Part>>,
    /// How many values of a setting are races: they stand behind those of the settings.
    pub races: usize,
    /// The loops in their order.
    pub loops: Vec<TargetLoop>,
}

/// A loop over names, one an axis.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct TargetLoop {
    /// Whose names they are.
    pub axes: Vec<Axis>,
    /// For each combination of names its target, the last axis running fastest; `None` where it is
    /// skipped.
    pub targets: Vec<Option<u32>>,
}

/// The names of an axis.
#[derive(Debug, Clone, PartialEq)]
pub struct Axis {
    /// Whose they are.
    pub of: Source,
    /// How many there are.
    pub names: usize,
}

/// Where the shares of an axis come from.
#[derive(Debug, Clone, PartialEq)]
pub enum Source {
    /// The races.
    Races,
    /// A setting, by number; its names are numbered as in its parts.
    Setting(usize),
    /// One name of a setting, by numbers: with a factor of 1 wherever it has a share, even one of
    /// 0.
    Only(usize, u32),
}

/// Room for the outcome, meant to be reused.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct LoopResult {
    /// Targets with their weights, each once.
    pub weights: Vec<(u32, f64)>,
    places: BTreeMap<u32, usize>,
}

impl MacroLoops {
    /// Weights of the targets at values of settings and races. Values are taken as they are: the
    /// program stores them in 32 bits before.
    pub fn evaluate(&self, values: &[f64], cut_off: f64, out: &mut LoopResult) {
        out.weights.clear();
        out.places.clear();
        let value = |place: usize| values.get(place).copied().unwrap_or(f64::NAN);
        let of_settings: Vec<Vec<(u32, f64)>> = self
            .settings
            .iter()
            .enumerate()
            .map(|(place, parts)| shares(parts, value(place)))
            .collect();
        let races = (0_u32..).zip(
            values
                .iter()
                .skip(self.settings.len())
                .take(self.races)
                .copied(),
        );
        let races: Vec<(u32, f64)> = races.filter(|(_, share)| *share > LEAST_RACE).collect();
        for own in &self.loops {
            let axes: Vec<Vec<(u32, f64)>> = own
                .axes
                .iter()
                .map(|axis| axis.shares(&of_settings, &races))
                .collect();
            own.walk(
                &axes,
                &mut |target, weight| out.add(target, weight, cut_off),
                0,
                0,
                1.0,
            );
        }
    }

    /// The names of a setting with their shares at a value.
    pub fn shares(&self, setting: usize, value: f64) -> Vec<(u32, f64)> {
        self.settings
            .get(setting)
            .map(|parts| shares(parts, value))
            .unwrap_or_default()
    }

    /// Steps that evaluating one setting takes at most.
    pub fn cost(&self) -> usize {
        self.loops.iter().map(|own| own.targets.len()).sum()
    }
}

impl LoopResult {
    /// Of several weights for one target the last counts.
    fn add(&mut self, target: u32, weight: f64, cut_off: f64) {
        if weight > cut_off {
            let place = *self.places.entry(target).or_insert(self.weights.len());
            match self.weights.get_mut(place) {
                Some(known) => known.1 = weight,
                None => self.weights.push((target, weight)),
            }
        }
    }
}

impl Axis {
    fn shares(&self, settings: &[Vec<(u32, f64)>], races: &[(u32, f64)]) -> Vec<(u32, f64)> {
        let of = |setting: usize| settings.get(setting).map(Vec::as_slice).unwrap_or_default();
        match self.of {
            Source::Races => races.to_vec(),
            Source::Setting(setting) => of(setting).to_vec(),
            // The only name of its axis.
            Source::Only(setting, name) => of(setting)
                .iter()
                .filter(|(own, _)| *own == name)
                .map(|_| (0, 1.0))
                .collect(),
        }
    }
}

impl TargetLoop {
    /// All combinations of the shares from axis `from` on, behind those that make `index` and
    /// `weight`.
    fn walk(
        &self,
        axes: &[Vec<(u32, f64)>],
        found: &mut impl FnMut(u32, f64),
        from: usize,
        index: usize,
        weight: f64,
    ) {
        let (Some(shares), Some(of)) = (axes.get(from), self.axes.get(from)) else {
            if let Some(target) = self.targets.get(index).copied().flatten() {
                found(target, weight);
            }
            return;
        };
        for (name, share) in shares {
            self.walk(
                axes,
                found,
                from + 1,
                index * of.names + *name as usize,
                weight * share,
            );
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn part(lowest: f64, highest: f64, low: u32, high: u32) -> Part {
        Part {
            lowest,
            highest,
            low: Some(low),
            high: Some(high),
        }
    }

    /// Gender (0 female, 1 male) and age (0 young, 1 old), two races.
    fn loops() -> MacroLoops {
        let axis = |of, names| Axis { of, names };
        MacroLoops {
            settings: vec![vec![part(-1.0, 2.0, 0, 1)], vec![part(-1.0, 2.0, 0, 1)]],
            races: 2,
            loops: vec![
                TargetLoop {
                    axes: vec![axis(Source::Races, 2), axis(Source::Setting(0), 2)],
                    targets: (0..4).map(Some).collect(),
                },
                TargetLoop {
                    axes: vec![axis(Source::Only(0, 0), 1), axis(Source::Setting(1), 2)],
                    targets: vec![Some(4), None],
                },
            ],
        }
    }

    fn weights(loops: &MacroLoops, values: &[f64]) -> Vec<(u32, f64)> {
        let mut out = LoopResult::default();
        loops.evaluate(values, CUT_OFF, &mut out);
        out.weights
    }

    #[test]
    fn one_name_alone_does_not_scale() {
        let found = weights(&loops(), &[0.5, 0.5, 1.0, 0.0]);
        assert_eq!(found, [(0, 0.5), (1, 0.5), (4, 0.5)]);
    }

    #[test]
    fn a_setting_without_share_empties_its_loops() {
        assert_eq!(
            weights(&loops(), &[0.5, 2.0, 0.0, 1.0]),
            [(2, 0.5), (3, 0.5)]
        );
        assert_eq!(weights(&loops(), &[-1.0, 0.5, 1.0, 1.0]), []);
        assert_eq!(weights(&loops(), &[f64::NAN, 0.5, 1.0, 1.0]), []);
        assert_eq!(weights(&loops(), &[]), []);
    }

    #[test]
    fn weights_at_the_cut_off_do_not_count() {
        assert_eq!(weights(&loops(), &[0.5, 3.0, 0.02, 0.0]), []);
        assert_eq!(weights(&loops(), &[0.5, 3.0, 0.0201, 0.0]).len(), 2);
    }

    #[test]
    fn of_one_name_in_two_parts_the_last_counts() {
        let mut two = loops();
        two.settings[0] = vec![part(0.0, 1.0, 0, 1), part(0.0, 2.0, 1, 0)];
        assert_eq!(weights(&two, &[0.5, 3.0, 1.0, 0.0]), [(0, 0.25), (1, 0.75)]);
    }
}
