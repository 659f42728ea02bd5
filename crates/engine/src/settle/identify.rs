//! What identifies a finding: the path of its asset below the data root, and its fingerprint.

use std::collections::BTreeMap;

use crate::catalogue::named;
use mhlint_diag::{Finding, Level, fingerprint};
use mhlint_repo::Layer;

/// A finding with the path of its asset.
pub(crate) struct Placed {
    pub(crate) finding: Finding,
    /// Path of its asset below the data root.
    pub(crate) rel: String,
    /// The fingerprint that a baseline has for it.
    pub(crate) known_as: String,
    /// The level that the rule gave, whatever the settings change it to.
    pub(crate) consequence: Level,
}

/// Gives each finding its fingerprint. Findings of one rule on one asset differ in their keys; if
/// two have the same key a number in their order makes them differ.
pub(super) fn identify(root: Root<'_>, findings: Vec<(Finding, Level)>) -> Vec<Placed> {
    let mut ordinals: BTreeMap<(&str, String, String), u32> = BTreeMap::new();
    // The asset of a finding may belong to the system data, such as the mesh.
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

/// A checked data root.
#[derive(Clone, Copy)]
pub(crate) struct Root<'r> {
    pub(crate) layer: &'r Layer,
    /// The layers that other applications make of the same files, if these lie in no data root.
    pub(crate) others: &'r [&'r Layer],
    /// The system data that the applications read together with it.
    pub(crate) below: &'r [&'r Layer],
}

impl<'r> Root<'r> {
    /// The layer, and the other layers of the same files.
    pub(super) fn layers(self) -> impl Iterator<Item = &'r Layer> {
        std::iter::once(self.layer).chain(self.others.iter().copied())
    }

    /// The path below this root, if the file belongs to it and not to another layer inside or
    /// beside it.
    pub(super) fn own_path<'p>(&self, path: &'p str) -> Option<&'p str>
    where
        'r: 'p,
    {
        let is_deeper =
            |layer: &&Layer| layer.path.len() > self.layer.path.len() && layer.holds(path);
        if self.below.iter().any(is_deeper) {
            return None;
        }
        // The path of a zip is also the path of its layer.
        if path == self.layer.path {
            Some("")
        } else {
            self.layer.relative(path)
        }
    }
}
