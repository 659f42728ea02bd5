//! The macros of a scene: positions of sliders to targets with factors, by the formulas of their
//! application.
//!
//! Surveys ask nothing else of them. Where an application calculates macros in another way, that is
//! another variant.

use super::makehuman1::Modifiers;
use super::makehuman1::modifiers::ModifierResult;
use super::makehuman2::{MacroError, MacroResult, MacroTable, macro_survey};
use super::measures::MacroMeasure;
use super::mpfb::MacroLoops;
use super::mpfb::loops::{CUT_OFF, LoopResult};
use super::mpfb::mix::key_value;
use super::scene::{Scene, Setting};
use super::vector::round_to_f32;

/// The macros of a scene.
#[derive(Debug, Clone)]
pub enum Macros {
    /// Components, macrodefs and their targets.
    Makehuman2(MacroTable),
    /// Variables, and products of them.
    Makehuman1(Modifiers),
    /// Settings in parts, loops over their names.
    Mpfb(MacroLoops),
}

/// Why macros stop their application.
#[derive(Debug, Clone, PartialEq)]
pub enum MacroFault {
    /// In [`Macros::Makehuman2`].
    Makehuman2(MacroError),
}

/// Room for calculating macros, meant to be reused.
#[derive(Debug, Default)]
pub struct MacroWork {
    makehuman2: MacroResult,
    makehuman1: ModifierResult,
    mpfb: LoopResult,
}

impl Macros {
    /// Numbers of the targets of a setting, places in [`Scene::macro_targets`], with their factors.
    ///
    /// # Errors
    /// Where the macros stop the application.
    pub fn factors<'w>(
        &self,
        settings: &[f64],
        work: &'w mut MacroWork,
    ) -> Result<&'w [(u32, f64)], MacroFault> {
        match self {
            Self::Makehuman2(table) => {
                table
                    .evaluate(settings, &mut work.makehuman2)
                    .map_err(MacroFault::Makehuman2)?;
                Ok(&work.makehuman2.factors)
            }
            Self::Makehuman1(modifiers) => {
                modifiers.evaluate(settings, &mut work.makehuman1);
                Ok(&work.makehuman1.weights)
            }
            Self::Mpfb(loops) => {
                // Settings are stored in 32 bits.
                let stored: Vec<f64> = settings
                    .iter()
                    .map(|value| f64::from(round_to_f32(*value)))
                    .collect();
                loops.evaluate(&stored, CUT_OFF, &mut work.mpfb);
                work.mpfb
                    .weights
                    .iter_mut()
                    .for_each(|(_, weight)| *weight = key_value(*weight));
                Ok(&work.mpfb.weights)
            }
        }
    }

    /// Steps that evaluating one setting takes at most.
    pub fn cost(&self) -> usize {
        match self {
            Self::Makehuman2(table) => table.cost(),
            Self::Makehuman1(modifiers) => modifiers.cost(),
            Self::Mpfb(loops) => loops.cost(),
        }
    }

    /// What the macros of a scene do over the range of their sliders; what is thrown away is looked
    /// for in `settings`.
    pub fn measure(&self, scene: &Scene, settings: &[Setting]) -> MacroMeasure {
        match self {
            Self::Makehuman2(table) => macro_survey::measure(table, scene, settings),
            // No rule asks for its numbers yet.
            Self::Makehuman1(_) | Self::Mpfb(_) => MacroMeasure::default(),
        }
    }
}
