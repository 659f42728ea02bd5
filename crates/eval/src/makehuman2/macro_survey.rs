//! What a macro system does over the range of its sliders: stretches in which a macrodef applies
//! nothing, weights that do not add up to one, jumps, and what the cut-off of small factors throws
//! away.
//!
//! Source: MakeHuman 2, macro calculation (`docs/loaders/makehuman2/macros.md#evaluation`,
//! `docs/loaders/makehuman2/macros.md#special-cases`).

use std::collections::{BTreeMap, BTreeSet};

use super::super::measures::{DeadRange, Jump, MacroMeasure, SumOff};
use super::super::scene::{Scene, Setting};
use super::super::settings::{Dimension, moved};
use super::budget::Budget;
use super::component::{ComponentState, stepped};
use super::macro_eval::{Fate, MacroResult};
use super::macro_table::{Link, MacroTable};

/// Distance from a step at which both of its sides are compared.
const SIDE: f64 = 1e-6;
/// A change of the factor of a target over twice `SIDE` beyond this is a jump. The loader's own
/// limits (0.001 on a share, 0.01 on a factor) make smaller ones at every step.
pub const JUMP: f64 = 0.02;
/// Weights of a component may miss one by the shares of up to 0.001 that the loader leaves out on
/// either side.
pub const SUM_TOLERANCE: f64 = 0.0025;

/// The most weight that the cut-off throws away.
#[derive(Debug, Clone, PartialEq)]
pub struct Loss {
    /// Number of the macrodef.
    pub macrodef: usize,
    /// Sum of the factors thrown away; 1 would be everything.
    pub lost: f64,
    /// The setting.
    pub setting: Setting,
}

/// Everything of this module for the macros of a scene; losses are looked for in `settings`.
pub(crate) fn measure(table: &MacroTable, scene: &Scene, settings: &[Setting]) -> MacroMeasure {
    let products = &scene.products;
    let mut budget = Budget::default();
    let dead = dead_ranges(table, products, &mut budget);
    let sums = sums_off(table, products, &scene.macro_defaults, &mut budget);
    let jumps = jumps(table, products, &scene.macro_defaults, &mut budget);
    let lost = losses(table, products, settings, &scene.defaults(), &mut budget).into_iter();
    let losses = lost
        .map(|loss| (loss.macrodef, loss.lost, moved(scene, &loss.setting)))
        .collect();
    MacroMeasure {
        dead,
        sums,
        jumps,
        losses,
        is_cut: budget.is_cut(),
    }
}

/// Stretches in which a macrodef applies nothing although it applies something elsewhere on that
/// slider.
pub fn dead_ranges(
    table: &MacroTable,
    macrodefs: &[Vec<Dimension>],
    budget: &mut Budget,
) -> Vec<DeadRange> {
    let mut found = Vec::new();
    for (macrodef, dimensions) in macrodefs.iter().enumerate() {
        let values = dimensions
            .iter()
            .map(Dimension::corners)
            .fold(0, usize::saturating_add);
        let combinations = table
            .combination_count(macrodef)
            .saturating_mul(dimensions.len());
        if !budget.take(combinations.saturating_add(values)) {
            continue;
        }
        for (position, states) in value_states(table, macrodef, dimensions)
            .into_iter()
            .enumerate()
        {
            if states.iter().any(|state| state.applied > 0) {
                found.extend(stretches(&states).into_iter().map(|range| DeadRange {
                    macrodef,
                    position,
                    ..range
                }));
            }
        }
    }
    found
}

/// What becomes of the combinations that hold one value.
#[derive(Debug, Clone, Copy, Default)]
struct ValueState {
    applied: usize,
    null: usize,
    missing: usize,
}

/// The states of the values of each position in one pass over the combinations; none for a
/// barycentric set.
fn value_states(
    table: &MacroTable,
    macrodef: usize,
    dimensions: &[Dimension],
) -> Vec<Vec<ValueState>> {
    let values = |dimension: &Dimension| match dimension {
        Dimension::Steps { steps, .. } => vec![ValueState::default(); steps.len()],
        Dimension::Corners(_) => Vec::new(),
    };
    let mut states: Vec<Vec<ValueState>> = dimensions.iter().map(values).collect();
    let combinations = if dimensions.is_empty() {
        0
    } else {
        table.combination_count(macrodef)
    };
    for combination in 0..combinations {
        // Names in which a component is left out belong to settings beyond a last step.
        if table
            .values(macrodef, combination)
            .any(|value| value.is_none())
        {
            continue;
        }
        for (states, value) in states
            .iter_mut()
            .zip(table.values(macrodef, combination).flatten())
        {
            let Some(state) = states.get_mut(value) else {
                continue;
            };
            match table.link(macrodef, combination) {
                Some(Link::Target(_)) => state.applied += 1,
                Some(Link::Null) => state.null += 1,
                Some(Link::Missing) | None => state.missing += 1,
            }
        }
    }
    states
}

/// Runs of values without target.
fn stretches(states: &[ValueState]) -> Vec<DeadRange> {
    let mut found = Vec::new();
    let mut start = 0;
    while start < states.len() {
        let run = states
            .iter()
            .skip(start)
            .take_while(|state| state.applied == 0)
            .count();
        if run == 0 {
            start += 1;
            continue;
        }
        let end = start + run - 1;
        let dead = states.get(start..=end).unwrap_or_default();
        found.push(DeadRange {
            macrodef: 0,
            position: 0,
            values: (start..=end).collect(),
            null: dead.iter().map(|state| state.null).sum(),
            missing: dead.iter().map(|state| state.missing).sum(),
        });
        start = end + 1;
    }
    found
}

/// Components whose weights do not sum to one somewhere between their first and last step, or after
/// a reset.
pub fn sums_off(
    table: &MacroTable,
    macrodefs: &[Vec<Dimension>],
    defaults: &[f64],
    budget: &mut Budget,
) -> Vec<SumOff> {
    let mut found = Vec::new();
    for (macrodef, dimensions) in macrodefs.iter().enumerate() {
        for (position, dimension) in dimensions.iter().enumerate() {
            let worst = match dimension {
                // Four positions for each step, and each of them is looked for among the steps.
                Dimension::Steps { steps, .. }
                    if !budget.take(steps.len().saturating_mul(4 * steps.len())) =>
                {
                    continue;
                }
                Dimension::Steps { steps, .. } => {
                    worst_stepped(steps, table.value_count(macrodef, position))
                }
                Dimension::Corners(places) => {
                    let sum = places.iter().filter_map(|place| defaults.get(*place)).sum();
                    Some((None, sum))
                }
            };
            if let Some((at, sum)) = worst.filter(|(_, sum)| !((sum - 1.0).abs() <= SUM_TOLERANCE))
            {
                found.push(SumOff {
                    macrodef,
                    position,
                    at,
                    sum,
                });
            }
        }
    }
    found
}

fn worst_stepped(steps: &[f64], values: usize) -> Option<(Option<f64>, f64)> {
    let (first, last) = (*steps.first()?, *steps.last()?);
    let middles = steps.windows(2).map(|pair| f64::midpoint(pair[0], pair[1]));
    let sides = steps.iter().flat_map(|step| [step - SIDE, step + SIDE]);
    let positions = steps.iter().copied().chain(middles).chain(sides);
    positions
        .filter(|at| (first..=last).contains(at))
        .filter_map(|at| match stepped(at, steps, values) {
            Ok(ComponentState::Shares(shares)) => Some((
                Some(at),
                shares
                    .as_slice()
                    .iter()
                    .map(|share| share.weight)
                    .sum::<f64>(),
            )),
            // Dropped components and faults are reported for themselves.
            Ok(ComponentState::Dropped(_)) | Err(_) => None,
        })
        .max_by(|a, b| (a.1 - 1.0).abs().total_cmp(&(b.1 - 1.0).abs()))
}

/// Jumps between the two sides of steps, other sliders at their defaults.
pub fn jumps(
    table: &MacroTable,
    macrodefs: &[Vec<Dimension>],
    defaults: &[f64],
    budget: &mut Budget,
) -> Vec<Jump> {
    let mut found: Vec<Jump> = Vec::new();
    let mut seen: BTreeSet<(usize, u64)> = BTreeSet::new();
    let cost = table.cost().saturating_add(defaults.len());
    for (macrodef, dimensions) in macrodefs.iter().enumerate() {
        for (position, dimension) in dimensions.iter().enumerate() {
            let Dimension::Steps { place, steps } = dimension else {
                continue;
            };
            for at in steps
                .iter()
                .copied()
                .filter(|at| *at > SIDE && *at < 1.0 - SIDE)
            {
                // On either side of a step the macros are evaluated once.
                if !seen.insert((*place, at.to_bits())) || !budget.take(cost.saturating_mul(2)) {
                    continue;
                }
                let jump = jump(table, *place, at, defaults).filter(|by| *by > JUMP);
                found.extend(jump.map(|by| Jump {
                    macrodef,
                    position,
                    at,
                    by,
                }));
            }
        }
    }
    found
}

fn jump(table: &MacroTable, place: usize, at: f64, defaults: &[f64]) -> Option<f64> {
    let side = |value: f64| {
        let mut settings = defaults.to_vec();
        *settings.get_mut(place)? = value;
        let mut result = MacroResult::default();
        table.evaluate(&settings, &mut result).ok()?;
        Some(result.factors)
    };
    let (below, above) = (side(at - SIDE)?, side(at + SIDE)?);
    let mut change: BTreeMap<u32, f64> = below.into_iter().collect();
    for (target, factor) in above {
        *change.entry(target).or_default() -= factor;
    }
    change.into_values().map(f64::abs).max_by(f64::total_cmp)
}

/// For each macrodef a setting of its sliders at which the cut-off throws away most: the worst of
/// those given, other sliders back at their defaults, and from there uphill one slider after the
/// other.
pub fn losses(
    table: &MacroTable,
    macrodefs: &[Vec<Dimension>],
    settings: &[Setting],
    rest: &Setting,
    budget: &mut Budget,
) -> Vec<Loss> {
    let cost = table.cost().saturating_add(rest.macros.len());
    let mut result = MacroResult::default();
    let mut worst: Vec<(f64, &Setting)> = vec![(0.0, rest); table.macrodef_count()];
    for setting in settings {
        if budget.take(cost) && table.evaluate(&setting.macros, &mut result).is_ok() {
            for (lost, worst) in lost(&result, worst.len()).into_iter().zip(&mut worst) {
                if lost > worst.0 {
                    *worst = (lost, setting);
                }
            }
        }
    }
    let mut found = Vec::new();
    for (macrodef, (dimensions, (lost, start))) in macrodefs.iter().zip(worst).enumerate() {
        // Nothing to climb along, and nothing lost anywhere.
        if dimensions.is_empty() && lost <= 0.0 {
            continue;
        }
        let climbing = cost.saturating_mul(1 + CLIMBS * POSITIONS as usize * dimensions.len());
        if !budget.take(climbing) {
            continue;
        }
        let mut climb = Climb {
            table,
            macrodef,
            at: rest.macros.to_vec(),
            lost: 0.0,
            result: MacroResult::default(),
        };
        for dimension in dimensions {
            dimension.copy(&start.macros, &mut climb.at);
        }
        climb.lost = climb.lost_at(&climb.at.clone());
        for _ in 0..CLIMBS {
            for dimension in dimensions {
                climb.along(dimension);
            }
        }
        if climb.lost > 0.0 {
            let setting = Setting {
                macros: climb.at.into(),
                details: rest.details.clone(),
            };
            found.push(Loss {
                macrodef,
                lost: climb.lost,
                setting,
            });
        }
    }
    found
}

/// How often each slider of a macrodef is tried again.
const CLIMBS: usize = 3;
/// Positions of a slider that are tried inside its interval.
const POSITIONS: u32 = 24;

/// Sums of the factors below the limit, by macrodef.
fn lost(result: &MacroResult, macrodefs: usize) -> Vec<f64> {
    let mut lost = vec![0.0; macrodefs];
    for combination in result
        .combinations
        .iter()
        .filter(|combination| combination.fate == Fate::BelowThreshold)
    {
        if let Some(sum) = lost.get_mut(combination.macrodef) {
            *sum += combination.factor;
        }
    }
    lost
}

/// A walk to the setting at which a macrodef loses most.
struct Climb<'t> {
    table: &'t MacroTable,
    macrodef: usize,
    at: Vec<f64>,
    lost: f64,
    result: MacroResult,
}

impl Climb<'_> {
    fn lost_at(&mut self, macros: &[f64]) -> f64 {
        if self.table.evaluate(macros, &mut self.result).is_err() {
            return 0.0;
        }
        lost(&self.result, self.table.macrodef_count())
            .get(self.macrodef)
            .copied()
            .unwrap_or(0.0)
    }

    /// Moves one slider inside its interval to where most is lost.
    fn along(&mut self, dimension: &Dimension) {
        let Dimension::Steps { place, steps } = dimension else {
            return;
        };
        let Some(here) = self.at.get(*place).copied() else {
            return;
        };
        let interval = steps
            .windows(2)
            .find(|pair| here <= pair[1])
            .map(|pair| (pair[0], pair[1]));
        let Some((from, to)) = interval else { return };
        for number in 0..POSITIONS {
            let mut macros = self.at.clone();
            let position = from + (to - from) * (f64::from(number) + 0.5) / f64::from(POSITIONS);
            if let Some(slot) = macros.get_mut(*place) {
                *slot = position;
            }
            let lost = self.lost_at(&macros);
            if lost > self.lost {
                (self.at, self.lost) = (macros, lost);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::macro_def::{Blend, Component, Macrodef, Slider};
    use super::*;

    fn table(links: Vec<(&str, Option<u32>)>) -> MacroTable {
        let component = |name, values, steps| Component {
            name,
            pattern: name,
            values,
            blend: Blend::Steps(steps),
        };
        let components = [
            component("age", vec!["baby", "child", "old"], vec![0.0, 0.5, 1.0]),
            component("sex", vec!["f", "m"], vec![0.0, 1.0]),
        ];
        let macrodefs = [Macrodef {
            components: vec!["age", "sex"],
            links,
        }];
        let slider = |pattern: &str| Some(Slider::Value(usize::from(pattern == "sex")));
        MacroTable::new(&components, &macrodefs, slider).unwrap()
    }

    fn dimensions() -> Vec<Vec<Dimension>> {
        vec![vec![
            Dimension::Steps {
                place: 0,
                steps: [0.0, 0.5, 1.0].into(),
            },
            Dimension::Steps {
                place: 1,
                steps: [0.0, 1.0].into(),
            },
        ]]
    }

    #[test]
    fn a_value_without_target_is_dead() {
        let table = table(vec![
            ("child-f", Some(0)),
            ("old-m", Some(1)),
            ("baby-f", None),
        ]);
        let found = dead_ranges(&table, &dimensions(), &mut Budget::default());
        assert_eq!(found.len(), 1);
        let baby = &found[0];
        assert_eq!(
            (baby.null, baby.missing, baby.values.as_slice()),
            (1, 1, [0].as_slice())
        );
    }

    #[test]
    fn two_dead_values_in_a_row_are_one_stretch() {
        let table = table(vec![("old-f", Some(0)), ("old-m", Some(1))]);
        let found = dead_ranges(&table, &dimensions(), &mut Budget::default());
        assert_eq!(
            found
                .iter()
                .map(|range| range.values.as_slice())
                .collect::<Vec<_>>(),
            [[0, 1]]
        );
    }

    #[test]
    fn a_barycentric_set_of_two_does_not_reach_one() {
        let sets = vec![vec![Dimension::Corners(vec![0, 1])]];
        let found = sums_off(
            &table(Vec::new()),
            &sets,
            &[0.33, 0.33, 0.34],
            &mut Budget::default(),
        );
        assert_eq!((found[0].at, (found[0].sum * 100.0).round()), (None, 66.0));
        assert_eq!(
            sums_off(
                &table(Vec::new()),
                &dimensions(),
                &[0.5, 0.5],
                &mut Budget::default()
            ),
            []
        );
    }

    fn lost_directly(table: &MacroTable, setting: &Setting) -> f64 {
        let mut result = MacroResult::default();
        table.evaluate(&setting.macros, &mut result).unwrap();
        lost(&result, 1)[0]
    }

    #[test]
    fn small_factors_are_lost_where_they_are_many() {
        let table = table(vec![("child-f", Some(0))]);
        let setting = |macros: [f64; 2]| Setting {
            macros: macros.to_vec().into(),
            details: [].into(),
        };
        let losses = |settings: &[Setting], rest| {
            losses(
                &table,
                &dimensions(),
                settings,
                &rest,
                &mut Budget::default(),
            )
        };
        let found = losses(
            &[setting([0.5, 0.5]), setting([0.0025, 0.5])],
            setting([0.5, 0.5]),
        );
        // The worse of the two settings loses 0.005; uphill from there is more, but never the 0.02
        // of two sliders.
        assert!(found[0].lost > 0.005 && found[0].lost <= 0.02, "{found:?}");
        assert_eq!(lost_directly(&table, &found[0].setting), found[0].lost);
        assert_eq!(losses(&[], setting([0.5, 0.0])), []);
    }

    #[test]
    fn what_is_more_than_the_budget_is_left_out_and_said() {
        let table = table(vec![("child-f", Some(0))]);
        let setting = Setting {
            macros: vec![0.5, 0.5].into(),
            details: [].into(),
        };
        let all = |left: usize| {
            let budget = &mut Budget::of(left);
            dead_ranges(&table, &dimensions(), budget);
            sums_off(&table, &dimensions(), &[0.5, 0.5], budget);
            jumps(&table, &dimensions(), &[0.5, 0.5], budget);
            losses(
                &table,
                &dimensions(),
                std::slice::from_ref(&setting),
                &setting,
                budget,
            );
            (left - budget.left(), budget.is_cut())
        };
        let (whole, is_cut) = all(1 << 20);
        assert!(
            !is_cut && all(whole) == (whole, false) && all(whole - 1).1 && all(0) == (0, true),
            "{whole}"
        );
    }

    #[test]
    fn continuous_steps_do_not_jump() {
        let table = table(vec![
            ("child-f", Some(0)),
            ("child-m", Some(1)),
            ("old-f", Some(2)),
            ("baby-f", Some(3)),
        ]);
        assert_eq!(
            jumps(&table, &dimensions(), &[0.5, 0.5], &mut Budget::default()),
            []
        );
    }
}
