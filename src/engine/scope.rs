//! What a run looks at: the PATHs, without what the configuration excludes.

use super::load::Input;
use crate::config::Config;
use crate::source::{Folder, is_below};

/// The part of the world that a run reports on.
pub(super) struct Scope<'c> {
    config: &'c Config,
    /// PATHs as printed.
    paths: Vec<String>,
    /// Those of them that are excluded: who names a path wants to hear of it.
    named: Vec<String>,
}

impl<'c> Scope<'c> {
    pub(super) fn new(inputs: &[Input], config: &'c Config) -> Self {
        let own = |input: &Input| {
            if input.narrow.is_empty() { vec![input.tree.label().to_owned()] } else { input.narrow.clone() }
        };
        let paths: Vec<String> = inputs.iter().flat_map(own).collect();
        let named = paths.iter().filter(|path| config.excludes(path)).cloned().collect();
        Self { config, paths, named }
    }

    /// Whether nothing is to be reported for a printed path.
    pub(super) fn excludes(&self, path: &str) -> bool {
        self.config.excludes(path) && !self.named.iter().any(|named| is_below(path, named))
    }

    /// Whether the run looks at everything at or below `rel`, a path relative to `folder`.
    pub(super) fn covers(&self, folder: &Folder, rel: &str) -> bool {
        self.is_whole() && self.paths.iter().any(|path| folder.lies_in(rel, path))
    }

    /// Whether nothing but PATHs narrows what is reported. What the file says holds for every run.
    pub(super) fn is_whole(&self) -> bool {
        let by_file = |key: &str| self.config.file.as_ref().is_some_and(|file| file.places.contains_key(key));
        (self.config.bases.is_empty() || by_file("bases")) && (self.config.applications.is_empty() || by_file("apps"))
    }
}
