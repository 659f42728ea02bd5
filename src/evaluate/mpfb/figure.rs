//! A figure of MPFB as Blender has it: the mesh with its shape keys, in metres or any other scale.

use super::keys::Keys;
use crate::eval::mpfb::joints::Joints;
use crate::eval::mpfb::mix::in_blender;
use crate::eval::scene::Setting;
use crate::eval::vector::Point;
use crate::evaluate::{Error, Evaluation};

/// One unit of the OBJ is so many of the figure, unless it is said otherwise.
pub const USUAL_SCALE: f32 = 0.1;

impl Evaluation {
    /// The joints of the mesh at these positions.
    pub fn joints<'p>(&'p self, positions: &'p [Point]) -> Joints<'p> {
        Joints::new(positions, self.groups.iter().map(|(name, ranges)| (name.as_str(), ranges.as_slice())))
    }

    /// The figure at a setting, in Blender's axes.
    ///
    /// # Errors
    /// A target that cannot be had.
    pub fn in_blender(&mut self, setting: &Setting, scale: f32) -> Result<Vec<Point>, Error> {
        Ok(self.morphed(setting)?.into_iter().map(|point| in_blender(point, scale)).collect())
    }

    /// The same of a figure with these shape keys.
    pub(super) fn with_keys(&mut self, keys: &Keys, scale: f32) -> Result<Vec<Point>, Error> {
        Ok(keys.mixed(self)?.into_iter().map(|point| in_blender(point, scale)).collect())
    }
}
