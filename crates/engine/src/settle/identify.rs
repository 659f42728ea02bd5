//! What a finding is known by: the place of its asset below the data root, and the fingerprint of
//! that.

use std::collections::BTreeMap;

use crate::catalogue::named;
use mhlint_diag::{Finding, Level, fingerprint};
use mhlint_repo::Layer;

/// A finding with the place of its asset.
pub(crate) struct Placed {
    pub(crate) finding: Finding,
    /// Path of its asset below the data root.
    pub(crate) rel: String,
    /// Fingerprint that a baseline knows it by.
    pub(crate) known_as: String,
    /// How bad it is, whatever the settings make of it.
    pub(crate) consequence: Level,
}

/// Fingerprints. Keys tell findings of one rule on one asset apart; the ordinal is for those that
/// do not.
pub(super) fn identify(root: Root<'_>, findings: Vec<(Finding, Level)>) -> Vec<Placed> {
    let mut ordinals: BTreeMap<(&str, String, String), u32> = BTreeMap::new();
    // What names the fault may be part of the system data, such as the mesh.
    let below = |asset: &str| {
        let system = || root.below.iter().find_map(|layer| layer.relative(asset));
        root.own_path(asset)
            .or_else(system)
            .unwrap_or_default()
            .to_owned()
    };
    let identified = findings.into_iter().map(|(mut finding, consequence)| {
        let rel = below(finding.asset_path());
        let is_told_apart = named(finding.rule).is_some_and(|rule| rule.info.told_apart);
        let place = if is_told_apart {
            below(&finding.path)
        } else {
            rel.clone()
        };
        let key = &finding.subject.key;
        let ordinal = ordinals
            .entry((finding.rule, place.clone(), key.clone()))
            .or_default();
        finding.fingerprint = fingerprint(finding.rule, &place, key, *ordinal);
        *ordinal += 1;
        let known_as = if is_told_apart {
            fingerprint(finding.rule, &rel, key, 0)
        } else {
            finding.fingerprint.clone()
        };
        Placed {
            finding,
            rel,
            known_as,
            consequence,
        }
    });
    identified.collect()
}

/// A root that is checked.
#[derive(Clone, Copy)]
pub(crate) struct Root<'r> {
    pub(crate) layer: &'r Layer,
    /// The same files as other applications would have them, where they lie in no data root.
    pub(crate) others: &'r [&'r Layer],
    /// System data that applications see it with.
    pub(crate) below: &'r [&'r Layer],
}

impl<'r> Root<'r> {
    /// The layer, and the others of the same files.
    pub(super) fn layers(self) -> impl Iterator<Item = &'r Layer> {
        std::iter::once(self.layer).chain(self.others.iter().copied())
    }

    /// Path below the root, if the file belongs to it and not to a layer inside or beside it.
    pub(super) fn own_path<'p>(&self, path: &'p str) -> Option<&'p str>
    where
        'r: 'p,
    {
        let is_deeper =
            |layer: &&Layer| layer.path.len() > self.layer.path.len() && layer.holds(path);
        if self.below.iter().any(is_deeper) {
            return None;
        }
        // A zip as such is what its layer is called.
        if path == self.layer.path {
            Some("")
        } else {
            self.layer.relative(path)
        }
    }
}
