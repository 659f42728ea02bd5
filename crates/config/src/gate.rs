//! What a run fails for.

use super::Config;
use mhlint_diag::{Level, Outcome};

impl Config {
    /// Whether a run passes: nothing at or above [`Config::fail_on`], no more warnings than
    /// [`Config::max_warnings`], and all of the work was done.
    pub fn passes(&self, outcome: &Outcome) -> bool {
        outcome.is_whole() && !self.fails(outcome.findings.iter().map(|finding| finding.level))
    }

    /// Whether findings of these levels are too much.
    pub fn fails(&self, levels: impl Iterator<Item = Level> + Clone) -> bool {
        let warnings = || {
            levels
                .clone()
                .filter(|level| *level == Level::Warning)
                .count()
        };
        self.fail_on
            .is_some_and(|limit| levels.clone().any(|level| level >= limit))
            || self.max_warnings.is_some_and(|limit| warnings() > limit)
    }
}
