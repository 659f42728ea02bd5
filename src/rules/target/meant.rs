//! Unused targets for which a name elsewhere is at fault, not the missing use.

use std::collections::{BTreeMap, BTreeSet};

use super::parent;
use crate::diag::Suggestions;
use crate::repo::FileFacts;
use crate::repo::makehuman2::{Base, View};

/// Paths of files by a part of them.
type Files<'f, 'a> = BTreeMap<&'f str, Vec<&'a str>>;

/// Unused files that a name without file nearly fits, or would fit but for its path: that name is the
/// fault to report.
pub(super) fn meant_by_missing<'a>(view: &View<'_>, base: &Base<'_>, unused: &[&'a FileFacts]) -> BTreeSet<&'a str> {
    let mut meant = BTreeSet::new();
    let (mut by_stem, mut by_folder): (Files<'_, 'a>, Files<'_, 'a>) = (BTreeMap::new(), BTreeMap::new());
    for file in unused {
        by_stem.entry(file.stem()).or_default().push(&file.rel);
        by_folder.entry(parent(&file.rel)).or_default().push(&file.rel);
    }
    let suggestions = Suggestions::default();
    for reference in view.references_of(base).filter(|reference| reference.kind.is_target()) {
        if reference.meant().is_some() {
            continue;
        }
        let stem = reference.text.rsplit(['/', '\\']).next();
        meant.extend(stem.and_then(|stem| by_stem.get(stem)).into_iter().flatten());
        let rel = reference.rel.replace('\\', "/");
        meant.extend(by_folder.get(parent(&rel)).and_then(|beside| suggestions.nearest(&rel, beside.iter().copied())));
    }
    let lost = lost_partners(base);
    meant.extend(unused.iter().filter(|file| is_of_one(&lost, base, file)).map(|file| file.rel.as_str()));
    meant
}

/// Patterns that `lsym` or `rsym` of some slider asks for and no slider has.
fn lost_partners<'b>(base: &'b Base<'_>) -> BTreeSet<&'b str> {
    let partners = base.sliders.iter().flat_map(|bound| [&bound.slider.lsym, &bound.slider.rsym]).flatten();
    partners.filter(|partner| base.slider(partner).is_none()).map(String::as_str).collect()
}

/// Whether one of the patterns has this target.
fn is_of_one(partners: &BTreeSet<&str>, base: &Base<'_>, file: &FileFacts) -> bool {
    let Some(name) = base.targets.and_then(|folder| folder.name_of(file)) else { return false };
    partners.iter().any(|partner| match partner.split_once('|') {
        Some((decr, incr)) => {
            let stem = name.strip_suffix(incr);
            name == decr || stem.is_some_and(|stem| stem.ends_with(['-', '/']) && decr.starts_with(stem))
        }
        None => name == *partner,
    })
}
