//! Unused targets for which a name elsewhere is at fault, not the missing use.

use std::collections::{BTreeMap, BTreeSet};

use super::parent;
use mhlint_diag::{Suggestions, grouped};
use mhlint_repo::FileFacts;
use mhlint_repo::makehuman2::{Base, View};

/// Unused files that a name without file nearly fits, or would fit but for its path: that name is
/// the fault to report.
pub(super) fn meant_by_missing<'a>(
    view: &View<'_>,
    base: &Base<'_>,
    unused: &[&'a FileFacts],
    suggestions: &Suggestions,
) -> BTreeSet<&'a str> {
    let mut meant = BTreeSet::new();
    let by_stem = grouped(unused.iter().map(|file| (file.stem(), file.rel.as_str())));
    let by_folder = grouped(
        unused
            .iter()
            .map(|file| (parent(&file.rel), file.rel.as_str())),
    );
    let mut missing: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
    let mut stems: BTreeSet<&str> = BTreeSet::new();
    for reference in view
        .references_of(base)
        .filter(|reference| reference.kind.is_target())
    {
        if reference.meant().is_some() {
            continue;
        }
        stems.extend(reference.text.rsplit(['/', '\\']).next());
        let rel = reference.rel.replace('\\', "/");
        missing
            .entry(parent(&rel).to_owned())
            .or_default()
            .insert(rel);
    }
    let by_stem = stems.iter().filter_map(|stem| by_stem.get(*stem));
    meant.extend(by_stem.flatten());
    for (folder, names) in &missing {
        let Some(beside) = by_folder.get(folder.as_str()) else {
            continue;
        };
        meant.extend(
            names
                .iter()
                .filter_map(|name| suggestions.nearest_file(name, beside.iter().copied())),
        );
        // Of the one nothing is there, the other nobody asks for.
        if let ([only], 1) = (beside.as_slice(), names.len()) {
            meant.insert(*only);
        }
    }
    let lost = LostPartners::of(base);
    meant.extend(
        unused
            .iter()
            .filter(|file| lost.have(base, file))
            .map(|file| file.rel.as_str()),
    );
    meant
}

/// Patterns that `lsym` or `rsym` of some slider asks for and no slider has.
struct LostPartners<'b> {
    /// Targets of patterns of one, and the first ones of pairs.
    names: BTreeSet<&'b str>,
    /// First targets of pairs by the ending of the second.
    pairs: BTreeMap<&'b str, BTreeSet<&'b str>>,
}

impl<'b> LostPartners<'b> {
    fn of(base: &'b Base<'_>) -> Self {
        let (mut names, mut pairs): (BTreeSet<&str>, BTreeMap<&str, BTreeSet<&str>>) =
            Default::default();
        let partners = base
            .sliders
            .iter()
            .flat_map(|bound| [&bound.slider.lsym, &bound.slider.rsym])
            .flatten();
        for partner in partners.filter(|partner| base.slider(partner).is_none()) {
            let pair = partner.split_once('|');
            names.insert(pair.map_or(partner, |(decr, _)| decr));
            pair.into_iter()
                .for_each(|(decr, incr)| _ = pairs.entry(incr).or_default().insert(decr));
        }
        Self { names, pairs }
    }

    /// Whether one of them has this target.
    fn have(&self, base: &Base<'_>, file: &FileFacts) -> bool {
        let Some(name) = base.targets.and_then(|folder| folder.name_of(file)) else {
            return false;
        };
        let is_incr = |(at, separator): (usize, &str)| {
            let (stem, incr) = name.split_at(at + separator.len());
            let decrs = self.pairs.get(incr);
            let first = decrs.and_then(|decrs| decrs.range(stem..).next());
            first.is_some_and(|decr| decr.starts_with(stem))
        };
        self.names.contains(name) || name.match_indices(['-', '/']).any(is_incr)
    }
}
