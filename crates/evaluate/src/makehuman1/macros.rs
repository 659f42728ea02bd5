//! Macro variables and the weights of targets at a setting.

use serde_json::{Map, Value};

use crate::outputs::{object, rounded};
use crate::{Error, Evaluation};
use mhlint_eval::macros::{MacroWork, Macros};
use mhlint_eval::makehuman1::Modifiers;
use mhlint_eval::makehuman1::variables::{Human, VARIABLES};
use mhlint_eval::scene::Setting;

/// Variables, and the targets of macros with their weights, at a setting.
///
/// # Errors
/// No modifiers.
pub(crate) fn macros_json(
    base: &Evaluation,
    setting: &Setting,
) -> Result<Map<String, Value>, Error> {
    formula(base)?;
    let human = Human::of_file(&setting.macros);
    let weights = base.scene.macros.iter().flat_map(|macros| {
        let mut work = MacroWork::default();
        macros
            .factors(&setting.macros, &mut work)
            .map(<[(u32, f64)]>::to_vec)
            .unwrap_or_default()
    });
    let weights: Vec<(u32, f64)> = weights.collect();
    let name = |number: u32| {
        let place = base.scene.macro_targets.get(number as usize)?;
        base.scene
            .targets
            .get(*place)
            .map(|target| target.name.clone())
    };
    let targets = weights
        .iter()
        .filter_map(|(number, weight)| Some((name(*number)?, rounded(*weight))));
    Ok(object([
        ("variables", Value::Object(variables_json(&human))),
        ("targets", Value::Object(targets.collect())),
        (
            "sum",
            rounded(weights.iter().map(|(_, weight)| weight).sum()),
        ),
    ]))
}

/// The macro variables by name.
pub(super) fn variables_json(human: &Human) -> Map<String, Value> {
    let named = VARIABLES.into_iter().zip(human.variables());
    named
        .map(|(name, value)| (name.to_owned(), rounded(value)))
        .collect()
}

/// What modifiers do.
///
/// # Errors
/// There are none.
pub(super) fn formula(base: &Evaluation) -> Result<&Modifiers, Error> {
    match (&base.scene.macros, &base.macros) {
        (Some(Macros::Makehuman1(modifiers)), Ok(_)) => Ok(modifiers),
        (_, reason) => {
            let reason = reason.as_ref().err().cloned().unwrap_or_default();
            Err(Error::NoMacros {
                base: base.base.clone(),
                reason,
            })
        }
    }
}
