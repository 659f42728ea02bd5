//! A figure of MPFB as Blender has it: the mesh with its shape keys, in metres or any other scale.

use std::sync::Arc;

use crate::{Error, Evaluation};
use mhlint_eval::mpfb::joints::Joints;
use mhlint_eval::mpfb::mix::mixed;
use mhlint_eval::scene::Setting;
use mhlint_eval::vector::{Point, round_to_f32};

impl Evaluation {
    /// The joints of the mesh at these positions.
    pub fn joints<'p>(&'p self, positions: &'p [Point]) -> Joints<'p> {
        Joints::new(
            positions,
            self.groups
                .iter()
                .map(|(name, ranges)| (name.as_str(), ranges.as_slice())),
        )
    }

    /// The figure at a setting, in Blender's axes.
    ///
    /// # Errors
    /// A target that cannot be had.
    pub fn in_blender(&mut self, setting: &Setting, scale: f32) -> Result<Vec<Point>, Error> {
        let only_macros = Setting {
            macros: Arc::clone(&setting.macros),
            details: [].into(),
        };
        let macros = self.factors(&only_macros)?.len();
        let mut factors = self.factors(setting)?;
        // A character gets the keys of its macros first.
        factors.rotate_right(macros);
        self.with_keys(&factors, scale)
    }

    /// The same of a figure with these targets as its shape keys, in the order of the keys.
    pub(super) fn with_keys(
        &mut self,
        keys: &[(usize, f64)],
        scale: f32,
    ) -> Result<Vec<Point>, Error> {
        self.need_rows(keys.iter().map(|(target, _)| *target))?;
        let rows = |target: usize| {
            self.scene
                .targets
                .get(target)
                .and_then(|target| target.rows.as_deref())
        };
        let keys = keys
            .iter()
            .filter_map(|(target, value)| Some((rows(*target)?.as_slice(), round_to_f32(*value))));
        Ok(mixed(&self.scene.positions, keys, scale))
    }
}
