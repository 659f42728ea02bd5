//! What a run reports on: the PATHs, without what the configuration excludes.

use std::collections::BTreeSet;

use super::answered::Answered;
use mhlint_config::Config;
use mhlint_source::{Folder, Outer, is_below_any, without_slashes};

/// The paths that a run reports on.
pub(crate) struct Scope<'c> {
    config: &'c Config,
    /// The PATHs, as printed.
    paths: Outer,
    /// The PATHs that the configuration excludes. They are reported on nevertheless, since the user
    /// named them.
    named: BTreeSet<String>,
    /// Remembers whether a path is excluded.
    excluded: Answered<bool>,
}

impl<'c> Scope<'c> {
    /// The scope of a run on `paths`, as printed.
    pub(crate) fn new(paths: Vec<String>, config: &'c Config) -> Self {
        let named = paths.iter().filter(|path| config.excludes(path));
        Self {
            config,
            paths: Outer::of(paths.iter().map(String::as_str)),
            named: without_slashes(named.cloned()),
            excluded: Answered::default(),
        }
    }

    /// Whether nothing is to be reported for a printed path.
    pub(crate) fn excludes(&self, path: &str) -> bool {
        let is_excluded = || self.config.excludes(path) && !is_below_any(path, &self.named);
        self.config.has_exclude() && self.excluded.of(path, "", is_excluded)
    }

    /// Whether the run looks at everything at or below `rel`, a path relative to `folder`.
    pub(crate) fn covers(&self, folder: &Folder, rel: &str) -> bool {
        self.is_whole() && folder.lies_in(rel, &self.paths)
    }

    /// Whether only the PATHs narrow what is reported. Base meshes and applications that the
    /// configuration file sets do not count, because they are the same in every run.
    pub(crate) fn is_whole(&self) -> bool {
        let by_file = |key: &str| {
            self.config
                .file
                .as_ref()
                .is_some_and(|file| file.places.contains_key(key))
        };
        (self.config.bases.is_empty() || by_file("bases"))
            && (self.config.applications.is_empty() || by_file("apps"))
    }
}
