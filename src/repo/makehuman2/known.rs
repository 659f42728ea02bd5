//! Sliders that something else knows by the names of their targets.

use std::collections::BTreeMap;

use super::View;
use crate::repo::{Reference, ReferenceKind};

impl View<'_> {
    /// Whether a slider must keep its name: it is part of a pattern by which something else knows the slider, or would,
    /// rightly written, give the pattern of another one.
    pub(in crate::repo) fn is_known_by(&self, reference: &Reference<'_>) -> bool {
        is_slider(reference.kind) && (self.is_part_of_pattern(reference) || self.has_double(reference))
    }

    fn is_part_of_pattern(&self, reference: &Reference<'_>) -> bool {
        let names_it = |pattern: &str| pattern.starts_with(reference.text);
        self.base(reference.base).is_some_and(|base| {
            let mut partners = base.sliders.iter().flat_map(|bound| [&bound.slider.lsym, &bound.slider.rsym]);
            let presets = base.settings().map(|(_, settings)| settings.presets.as_slice()).unwrap_or_default();
            partners.any(|partner| partner.as_deref().is_some_and(names_it))
                || presets.iter().any(|(pattern, _)| names_it(pattern))
        })
    }

    /// Whether another slider moves the same targets.
    fn has_double(&self, reference: &Reference<'_>) -> bool {
        let mut by_slider: BTreeMap<&str, BTreeMap<ReferenceKind, &str>> = BTreeMap::new();
        for other in self.references.of_base(reference.base).iter().filter(|other| is_slider(other.kind)) {
            if let Some(file) = other.meant() {
                by_slider.entry(other.owner).or_default().insert(other.kind, &file.path);
            }
        }
        let own = by_slider.remove(reference.owner);
        own.is_some_and(|own| by_slider.values().any(|other| *other == own))
    }
}

fn is_slider(kind: ReferenceKind) -> bool {
    matches!(kind, ReferenceKind::Incr | ReferenceKind::Decr)
}
