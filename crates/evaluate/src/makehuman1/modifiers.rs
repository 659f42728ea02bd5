//! What modifiers do to the targets of a body at a setting.

use serde_json::{Map, Value};

use super::base;
use super::macros::{formula, variables_json};
use crate::outputs::rounded;
use crate::{Error, Evaluation, SliderSetting, object};
use mhlint_eval::makehuman1::modifiers::{Factor, TargetGroup, clamped};
use mhlint_eval::makehuman1::variables::{Human, SLIDERS};
use mhlint_eval::scene::{Setting, SliderKind};
use mhlint_formats::target::name::TargetName;
use mhlint_source::first_name;

/// The variables, what each of these modifiers does to its targets, and the weights of all targets,
/// at a setting.
///
/// # Errors
/// No modifiers, or an unknown one.
pub(crate) fn modifiers_json(
    base: &Evaluation,
    setting: &Setting,
    asked: &[SliderSetting],
) -> Result<Map<String, Value>, Error> {
    formula(base)?;
    let human = Human::of_file(&setting.macros);
    let mut modifiers = Map::new();
    for (name, value) in asked {
        modifiers.insert(
            name.clone(),
            Value::Object(moved(base, name)?.at(*value, human)),
        );
    }
    let name = |place: usize| {
        base.scene
            .targets
            .get(place)
            .map(|target| target.name.clone())
    };
    let stack = base.factors(setting)?;
    let targets = stack
        .iter()
        .filter_map(|(place, weight)| Some((name(*place)?, rounded(*weight))));
    Ok(object([
        ("variables", Value::Object(variables_json(&human))),
        ("modifiers", Value::Object(modifiers)),
        ("targets", Value::Object(targets.collect())),
    ]))
}

/// What a modifier moves.
pub(super) struct Moved {
    /// Groups of targets with the names of these.
    sides: Vec<(TargetGroup, Vec<String>)>,
    /// The macro slider that it sets.
    slider: Option<usize>,
    /// The least value that it takes.
    lowest: f64,
}

impl Moved {
    /// One that asks for these groups, each with or without the name of its own group in front.
    pub(super) fn of_groups(
        base: &Evaluation,
        group: &str,
        left: Option<&str>,
        centre: Option<&str>,
        right: Option<&str>,
    ) -> Self {
        let sides = [
            (left, Factor::Left(PLACE)),
            (centre, Factor::Centre(PLACE)),
            (right, Factor::Right(PLACE)),
        ];
        let sides = sides.into_iter().filter_map(|(own, factor)| {
            let own = own?;
            let own = if own.starts_with(&format!("{group}-")) {
                own.to_owned()
            } else {
                format!("{group}-{own}")
            };
            Some(targets_of(base, factor, |name| name.group() == own))
        });
        Self {
            sides: sides.collect(),
            slider: None,
            lowest: -1.0,
        }
    }

    /// Its value in its range, the weights that it gives its targets on a human, and what it reads
    /// back of them.
    pub(super) fn at(&self, value: f64, mut human: Human) -> Map<String, Value> {
        let clamped = clamped(value, self.lowest);
        if let Some(slider) = self.slider {
            human.set(slider, value);
        }
        let settings: Vec<f64> = (0..SLIDERS.len())
            .map(|slider| human.value(slider))
            .chain([clamped])
            .collect();
        let variables = human.variables();
        let mut weights = Map::new();
        let (mut right, mut left) = (0.0, 0.0);
        for (group, names) in &self.sides {
            for ((_, weight), name) in group.weights(&settings, &variables).zip(names) {
                match group.factor {
                    Factor::Right(_) | Factor::Only(_) => right += weight,
                    Factor::Left(_) => left += weight,
                    Factor::One | Factor::Centre(_) => {}
                }
                if weight != 0.0 {
                    weights.insert(name.clone(), rounded(weight));
                }
            }
        }
        // A macro asks the human.
        let read = self
            .slider
            .map_or(if right == 0.0 { -left } else { right }, |slider| {
                human.value(slider)
            });
        object([
            ("clamped", rounded(clamped)),
            ("value_read_back", rounded(read)),
            (
                "target_count",
                Value::from(
                    self.sides
                        .iter()
                        .map(|(_, names)| names.len())
                        .sum::<usize>(),
                ),
            ),
            ("weights", Value::Object(weights)),
        ])
    }
}

/// The place of its value, behind those of the macro sliders.
const PLACE: usize = SLIDERS.len();

/// A modifier of the files, or one of a target alone.
///
/// # Errors
/// An unknown name.
pub(super) fn moved(base: &Evaluation, name: &str) -> Result<Moved, Error> {
    if let Some(stem) = name.strip_prefix("custom/") {
        let is_it = |path: &str| {
            path.strip_suffix(".target")
                .is_some_and(|path| path.replace('/', "-") == stem)
        };
        let found = base.scene.targets.iter().find(|target| is_it(&target.name));
        let found = found.map(|target| target.name.clone());
        let found =
            found.ok_or_else(|| Error::Input(format!("no target makes the modifier `{name}`")))?;
        let group = TargetGroup {
            factor: Factor::Only(PLACE),
            targets: vec![(0, Vec::new())],
        };
        return Ok(Moved {
            sides: vec![(group, vec![found])],
            slider: None,
            lowest: 0.0,
        });
    }
    let scene = &base.scene;
    let unknown = || Error::UnknownSlider {
        name: name.to_owned(),
        nearest: None,
    };
    let slider = scene
        .slider(name)
        .and_then(|place| scene.sliders.get(place))
        .ok_or_else(unknown)?;
    match slider.kind {
        SliderKind::Macro(place) if place < SLIDERS.len() => {
            let group = first_name(name);
            let sides = vec![targets_of(base, Factor::One, |name| name.group() == group)];
            Ok(Moved {
                sides,
                slider: Some(place),
                lowest: 0.0,
            })
        }
        SliderKind::Macro(place) => of_formula(base, place),
        SliderKind::Detail {
            incr,
            decr,
            two_sided,
        } => {
            let side = |factor: Factor, target: Option<usize>| {
                let name = scene.targets.get(target?)?.name.clone();
                Some((
                    TargetGroup {
                        factor,
                        targets: vec![(0, Vec::new())],
                    },
                    vec![name],
                ))
            };
            let right = if two_sided {
                Factor::Right(PLACE)
            } else {
                Factor::Only(PLACE)
            };
            let sides = [side(Factor::Left(PLACE), decr), side(right, incr)];
            let lowest = if two_sided { -1.0 } else { 0.0 };
            Ok(Moved {
                sides: sides.into_iter().flatten().collect(),
                slider: None,
                lowest,
            })
        }
    }
}

/// A modifier whose targets depend on the macro variables, as the formula has it.
fn of_formula(base: &Evaluation, place: usize) -> Result<Moved, Error> {
    let mut moved = Moved {
        sides: Vec::new(),
        slider: None,
        lowest: 0.0,
    };
    for group in &formula(base)?.groups {
        let factor = match group.factor {
            Factor::Left(own) if own == place => Factor::Left(PLACE),
            Factor::Centre(own) if own == place => Factor::Centre(PLACE),
            Factor::Right(own) if own == place => Factor::Right(PLACE),
            Factor::Only(own) if own == place => Factor::Only(PLACE),
            _ => continue,
        };
        if !matches!(factor, Factor::Only(_)) {
            moved.lowest = -1.0;
        }
        let name = |number: &u32| {
            base.scene
                .targets
                .get(*base.scene.macro_targets.get(*number as usize)?)
        };
        let names = group
            .targets
            .iter()
            .filter_map(|(number, _)| Some(name(number)?.name.clone()))
            .collect();
        moved.sides.push((
            TargetGroup {
                factor,
                targets: group.targets.clone(),
            },
            names,
        ));
    }
    Ok(moved)
}

/// The targets whose names fit.
fn targets_of(
    base: &Evaluation,
    factor: Factor,
    fits: impl Fn(&TargetName) -> bool,
) -> (TargetGroup, Vec<String>) {
    let mut found = (
        TargetGroup {
            factor,
            targets: Vec::new(),
        },
        Vec::new(),
    );
    for (number, target) in (0_u32..).zip(&base.scene.targets) {
        if let Ok(name) = TargetName::of(&target.name)
            && fits(&name)
        {
            found.0.targets.push((number, base::variables(&name)));
            found.1.push(target.name.clone());
        }
    }
    found
}
