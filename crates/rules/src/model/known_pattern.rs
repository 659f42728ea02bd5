//! Patterns of modifiers that need no finding, because a slider has them or another rule reports
//! them.

use std::collections::BTreeSet;

use mhlint_formats::mhm::Modifier;
use mhlint_repo::makehuman2::{Base, View};

/// The patterns that are known for a base mesh.
pub(super) struct Known<'v> {
    base: &'v Base<'v>,
    /// Whether the user's folder is given, so that the sliders of user targets are known.
    has_user: bool,
    /// Targets in patterns that look like pairs but are none: `modelling-opposites` reports them.
    pairs: BTreeSet<&'v str>,
    /// Patterns that sliders were meant to have, but for a misspelt key.
    meant: BTreeSet<&'v str>,
}

impl<'v> Known<'v> {
    pub(super) fn of(view: &View<'_>, base: &'v Base<'v>) -> Self {
        let pairs = base
            .sliders
            .iter()
            .filter(|bound| bound.is_undeclared_pair());
        let targets =
            pairs.flat_map(|bound| [bound.slider.decr.as_deref(), bound.slider.incr.as_deref()]);
        let meant = base.sliders.iter().flat_map(|bound| bound.meant.names());
        Self {
            base,
            has_user: view.layers.user.is_some(),
            pairs: targets.flatten().collect(),
            meant: meant.map(String::as_str).collect(),
        }
    }

    /// Whether a modifier can be read but sets nothing, and no other rule says why.
    pub(super) fn lacks(&self, modifier: &Modifier) -> bool {
        let pattern = &*modifier.pattern.text;
        let is_pair = pattern
            .split_once('|')
            .is_some_and(|(decr, _)| self.pairs.contains(decr));
        modifier.value.is_ok()
            && self.base.slider(pattern).is_none()
            && !self.is_users(pattern)
            && !is_pair
            && !self.meant.contains(pattern)
    }

    /// Whether the pattern belongs to a target of the user. The program makes the sliders for these
    /// when it starts.
    fn is_users(&self, pattern: &str) -> bool {
        let Some(name) = pattern.strip_prefix("custom/") else {
            return false;
        };
        let name = name.split('|').next().unwrap_or(name);
        !self.has_user
            || self
                .base
                .user_targets
                .is_none_or(|folder| folder.target(name).is_some())
    }
}
