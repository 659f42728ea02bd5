//! Sliders that something else knows by the names of their targets.

use std::collections::{BTreeMap, BTreeSet};
use std::ops::Bound;

use super::View;
use crate::{Reference, ReferenceKind};
use mhlint_diag::grouped;

/// What is known of a base's sliders by the names of their targets.
#[derive(Debug, Default)]
pub(super) struct KnownNames {
    /// Patterns by which something else knows sliders.
    patterns: BTreeSet<String>,
    /// Keys of the sliders that move the same targets as another one.
    doubles: BTreeSet<String>,
}

impl KnownNames {
    fn of(view: &View<'_>, base: &str) -> Self {
        let mut patterns = BTreeSet::new();
        if let Some(base) = view.base(base) {
            let partners = base
                .sliders
                .iter()
                .flat_map(|bound| [&bound.slider.lsym, &bound.slider.rsym]);
            let presets = base
                .settings()
                .map(|(_, settings)| settings.presets.as_slice())
                .unwrap_or_default();
            patterns.extend(
                partners
                    .flatten()
                    .chain(presets.iter().map(|(pattern, _)| pattern))
                    .cloned(),
            );
        }
        let mut by_slider: BTreeMap<&str, BTreeMap<ReferenceKind, &str>> = BTreeMap::new();
        for other in view
            .references
            .of_base(base)
            .iter()
            .filter(|other| is_slider(other.kind))
        {
            if let Some(file) = other.meant() {
                by_slider
                    .entry(other.owner)
                    .or_default()
                    .insert(other.kind, &file.path);
            }
        }
        let by_targets = grouped(
            by_slider
                .into_iter()
                .map(|(slider, targets)| (targets, slider)),
        );
        let doubles = by_targets
            .into_values()
            .filter(|sliders| sliders.len() > 1)
            .flatten()
            .map(str::to_owned);
        Self {
            patterns,
            doubles: doubles.collect(),
        }
    }

    fn holds(&self, reference: &Reference<'_>) -> bool {
        let mut from = self
            .patterns
            .range::<str, _>((Bound::Included(reference.text), Bound::Unbounded));
        from.next()
            .is_some_and(|pattern| pattern.starts_with(reference.text))
            || self.doubles.contains(reference.owner)
    }
}

impl View<'_> {
    /// Whether a slider must keep its name: it is part of a pattern by which something else knows
    /// the slider, or would, rightly written, give the pattern of another one.
    pub(crate) fn is_known_by(&self, reference: &Reference<'_>) -> bool {
        let known = || {
            self.bases
                .iter()
                .map(|base| (base.name.to_owned(), KnownNames::of(self, base.name)))
                .collect()
        };
        is_slider(reference.kind)
            && self
                .known_names
                .get_or_init(known)
                .get(reference.base)
                .is_some_and(|known| known.holds(reference))
    }
}

fn is_slider(kind: ReferenceKind) -> bool {
    matches!(kind, ReferenceKind::Incr | ReferenceKind::Decr)
}
