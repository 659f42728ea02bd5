//! Macros at a setting: the shares of every name, and the targets with their weights.

use serde_json::{Map, Value, json};

use crate::opened::MacroNames;
use crate::outputs::{object, rounded};
use crate::{Error, Evaluation};
use mhlint_eval::macros::Macros;
use mhlint_eval::mpfb::MacroLoops;
use mhlint_eval::mpfb::loops::{CUT_OFF, LoopResult};
use mhlint_eval::scene::Setting;
use mhlint_eval::vector::round_to_f32;
use mhlint_formats::macro_parts::SETTINGS;

/// Shares and targets at a setting, whose values are stored in 32 bits.
///
/// # Errors
/// No macros.
pub(crate) fn macros_json(
    base: &Evaluation,
    setting: &Setting,
) -> Result<Map<String, Value>, Error> {
    let stored: Vec<f64> = setting
        .macros
        .iter()
        .map(|value| f64::from(round_to_f32(*value)))
        .collect();
    outputs(base, &stored, CUT_OFF)
}

/// The same at values as they are.
pub(super) fn outputs(
    base: &Evaluation,
    values: &[f64],
    cut_off: f64,
) -> Result<Map<String, Value>, Error> {
    let (loops, names) = parts(base)?;
    let mut result = LoopResult::default();
    loops.evaluate(values, cut_off, &mut result);
    let components = SETTINGS
        .iter()
        .zip(names)
        .enumerate()
        .map(|(place, (setting, names))| {
            let shares = loops.shares(place, values.get(place).copied().unwrap_or(f64::NAN));
            let said = shares
                .iter()
                .map(|(name, share)| json!([names.get(*name as usize), rounded(*share)]));
            ((*setting).to_owned(), said.collect::<Value>())
        });
    let target = |number: u32| {
        let place = base.scene.macro_targets.get(number as usize);
        place.and_then(|place| base.scene.targets.get(*place))
    };
    let used = || {
        result
            .weights
            .iter()
            .filter_map(|(number, weight)| Some((target(*number)?, *weight)))
    };
    // One without a file has no other path than its name.
    let missing = used().filter(|(target, _)| base.entry(&target.path).is_none());
    Ok(object([
        ("components", Value::Object(components.collect())),
        (
            "targets",
            used()
                .map(|(target, weight)| json!([target.name, rounded(weight)]))
                .collect(),
        ),
        (
            "targets_without_file",
            missing.map(|(target, _)| target.name.as_str()).collect(),
        ),
        ("sum", rounded(used().map(|(_, weight)| weight).sum())),
    ]))
}

fn parts(base: &Evaluation) -> Result<(&MacroLoops, &[Vec<String>]), Error> {
    let no_macros = |reason: &str| Error::NoMacros {
        base: base.base.clone(),
        reason: reason.to_owned(),
    };
    match (&base.scene.macros, &base.macros) {
        (Some(Macros::Mpfb(loops)), Ok(MacroNames::Parts(names))) => Ok((loops, names)),
        (_, Err(reason)) => Err(no_macros(reason)),
        _ => Err(no_macros("there are none")),
    }
}
