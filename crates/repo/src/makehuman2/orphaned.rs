//! Base meshes that are nowhere.

use super::{View, lacks_bases};
use crate::Layer;

impl View<'_> {
    /// Whether a file is in the folder of a base mesh in any layer. What is there but cannot be
    /// opened, or is written with other capitals, has a finding of its own.
    pub fn has_base_file(&self, base: &str, file: &str) -> bool {
        let rel = format!("base/{base}/{file}");
        let is_here =
            |layer: &Layer| layer.file_ignoring_case(&rel).is_some() || layer.has_unusable(&rel);
        self.layers.strongest_first().any(is_here)
    }

    /// Whether a base mesh has neither settings nor a mesh: what is in the folders of its name is
    /// never loaded. Only system data can prove that, one root may be a user's folder whose system
    /// data was not given, and that the program has lost all of its bases is one fault.
    pub fn is_nowhere(&self, base: &str) -> bool {
        let layers = self.layers;
        let is_lost = || layers.checks_system() && lacks_bases(layers.checked);
        let has = |file| self.has_base_file(base, file);
        let can_tell = layers.system.is_some() && !layers.is_one_root() && !is_lost();
        can_tell && !["base.json", "base.obj", "base.mhbin"].into_iter().any(has)
    }
}
