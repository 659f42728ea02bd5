//! Macros at a setting: every combination and what becomes of it, in words and as JSON.

use std::collections::BTreeMap;

use serde_json::{Map, Value, json};

use super::stops;
use crate::opened::MacroNames;
use crate::outputs::{object, rounded};
use crate::{Error, Evaluation};
use mhlint_eval::macros::Macros;
use mhlint_eval::makehuman2::component::ComponentFault;
use mhlint_eval::makehuman2::macro_eval::{Combination, Fate};
use mhlint_eval::makehuman2::{MacroError, MacroResult, MacroTable};
use mhlint_eval::scene::Setting;
use mhlint_formats::macro_json::MacroFile;
use mhlint_source::parent;

impl Evaluation {
    /// Every combination of the macros at a setting.
    ///
    /// # Errors
    /// No macros, or macros that stop the application.
    pub fn macros(&self, setting: &Setting) -> Result<(&MacroTable, MacroResult), Error> {
        let base = self.base.clone();
        let Some(Macros::Makehuman2(table)) =
            self.scene.macros.as_ref().filter(|_| self.macros.is_ok())
        else {
            return Err(Error::NoMacros {
                base,
                reason: self.macros.as_ref().err().cloned().unwrap_or_default(),
            });
        };
        let mut result = MacroResult::default();
        let evaluated = table.evaluate(&setting.macros, &mut result);
        evaluated.map_err(|error| self.macro_error(error))?;
        Ok((table, result))
    }

    /// Combinations, what was dropped, factors of targets, and sums of a macro evaluation.
    pub(crate) fn macro_outputs(
        &self,
        table: &MacroTable,
        result: &MacroResult,
    ) -> Map<String, Value> {
        let kept = || {
            result
                .combinations
                .iter()
                .filter(|c| c.fate != Fate::BelowThreshold)
        };
        let dropped = || kept().filter(|c| !matches!(c.fate, Fate::Applied(_)));
        let name = |c: &Combination| table.name(c.macrodef, c.number);
        let mut folders: BTreeMap<String, f64> = BTreeMap::new();
        let mut order: Vec<String> = Vec::new();
        for (target, factor) in &result.factors {
            let target = self.macro_target(*target);
            let folder = parent(target).to_owned();
            if !folders.contains_key(&folder) {
                order.push(folder.clone());
            }
            *folders.entry(folder).or_default() += factor;
        }
        let by_folder = order.into_iter().map(|folder| {
            let sum = rounded(folders.get(&folder).copied().unwrap_or_default());
            (folder, sum)
        });
        let targets = result
            .factors
            .iter()
            .map(|(target, factor)| json!([self.macro_target(*target), rounded(*factor)]));
        object([
            (
                "raw",
                kept()
                    .map(|c| json!([name(c), rounded(c.factor)]))
                    .collect(),
            ),
            ("dropped", dropped().map(name).collect()),
            (
                "dropped_factor_sum",
                rounded(dropped().map(|c| c.factor).sum()),
            ),
            ("targets", targets.collect()),
            ("sum_by_folder", Value::Object(by_folder.collect())),
            (
                "sum",
                rounded(result.factors.iter().map(|(_, factor)| factor).sum()),
            ),
        ])
    }

    fn macro_target(&self, number: u32) -> &str {
        let place = self.scene.macro_targets.get(number as usize);
        place
            .and_then(|place| self.scene.targets.get(*place))
            .map_or("", |target| target.name.as_str())
    }

    fn components(&self) -> Option<&MacroFile> {
        if let Ok(MacroNames::Components(file)) = &self.macros {
            Some(file)
        } else {
            None
        }
    }

    pub(crate) fn macro_error(&self, error: MacroError) -> Error {
        let MacroError::Component { component, fault } = error else {
            return Error::NoMacros {
                base: self.base.clone(),
                reason: error.to_string(),
            };
        };
        let name = self.components().and_then(|macros| {
            // The table holds the components that have a pattern.
            let used = macros
                .components
                .iter()
                .filter(|c| c.pattern.is_some() && (c.steps.is_some() || c.sum.is_some()));
            used.map(|c| c.name.as_str()).nth(component)
        });
        stops(
            exception(fault),
            format!("macro component `{}`: {fault}", name.unwrap_or("?")),
        )
    }
}

/// What Python raises (`docs/loaders/makehuman2/macros.md#special-cases`).
fn exception(fault: ComponentFault) -> &'static str {
    match fault {
        ComponentFault::EqualSteps => "ZeroDivisionError",
        ComponentFault::NotBarycentric(_) => "TypeError",
        ComponentFault::MissingValue(_)
        | ComponentFault::MissingSum(_)
        | ComponentFault::FourthCorner
        | ComponentFault::MissingSetting(_) => "IndexError",
    }
}

/// As `macro_outputs`, with the fate of every combination and the components that dropped out.
pub fn macros_json(
    evaluation: &Evaluation,
    table: &MacroTable,
    result: &MacroResult,
) -> Map<String, Value> {
    let mut outputs = evaluation.macro_outputs(table, result);
    let macrodefs = evaluation
        .components()
        .map(|macros| macros.macrodefs.as_slice())
        .unwrap_or_default();
    let title = |number: usize| {
        macrodefs
            .get(number)
            .and_then(|macrodef| macrodef.name.clone())
    };
    let fate = |fate: Fate| match fate {
        Fate::Applied(_) => "applied",
        Fate::Null => "null",
        Fate::Missing => "missing",
        Fate::BelowThreshold => "below threshold",
    };
    let combinations = result.combinations.iter().map(|c| {
        let target = match c.fate {
            Fate::Applied(target) => Some(evaluation.macro_target(target)),
            _ => None,
        };
        json!({ "macrodef": c.macrodef, "macrodef_name": title(c.macrodef),
            "name": table.name(c.macrodef, c.number),
            "factor": rounded(c.factor), "fate": fate(c.fate), "target": target })
    });
    let dropped = result.dropped.iter().map(|dropped| {
        let component = macrodefs
            .get(dropped.macrodef)
            .and_then(|macrodef| macrodef.components.get(dropped.place));
        json!({ "macrodef": dropped.macrodef, "macrodef_name": title(dropped.macrodef),
            "component": component,
            "reason": dropped.reason.to_string() })
    });
    outputs.insert("combinations".to_owned(), combinations.collect());
    outputs.insert("dropped_components".to_owned(), dropped.collect());
    outputs
}
