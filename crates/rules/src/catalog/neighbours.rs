//! What could be meant by the name of a target that does not exist.

use std::collections::{BTreeMap, BTreeSet};
use std::ops::Bound::{Included, Unbounded};

use mhlint_diag::Suggestions;
use mhlint_repo::mpfb::{Catalog, View, is_custom};
use mhlint_repo::{FileFacts, Reference, ReferenceKind};
use mhlint_source::{file_name, parent};

/// Files that a missing one may be meant to be.
pub(super) struct Neighbours<'v, 'a> {
    catalog: &'v Catalog<'a>,
    /// The names of the targets that no slider asks for, by their paths. Others are not meant: the
    /// other end of a slider has nearly the same name.
    free: BTreeMap<&'a str, &'a str>,
    /// The targets by their names.
    by_name: BTreeMap<&'a str, &'a FileFacts>,
    suggestions: Suggestions,
}

impl<'v, 'a> Neighbours<'v, 'a> {
    pub(super) fn of(view: &View<'a>, catalog: &'v Catalog<'a>) -> Self {
        let used: BTreeSet<&str> = view
            .references
            .iter()
            .filter_map(Reference::found)
            .map(|file| file.path.as_str())
            .collect();
        let free = catalog.layer.below("targets");
        let free = free.filter(|file| !used.contains(file.path.as_str()));
        let free = free.filter_map(|file| {
            let name = stem(file.file_name());
            (name != file.file_name()).then_some((file.rel.as_str(), name))
        });
        let targets = catalog
            .layer
            .below("targets")
            .filter(|file| !is_custom(&file.rel));
        let by_name = targets.map(|file| (stem(file.file_name()), file)).collect();
        Self {
            catalog,
            free: free.collect(),
            by_name,
            suggestions: Suggestions::default(),
        }
    }

    /// What to do about a missing one.
    pub(super) fn help(&self, reference: &Reference<'_>) -> String {
        let text = reference.text;
        let plain = reference
            .rel
            .strip_suffix(".gz")
            .and_then(|plain| self.catalog.layer.file(plain));
        let stem = text
            .strip_suffix(".gz")
            .unwrap_or(text)
            .strip_suffix(".target");
        if text.is_empty() {
            "name the target of each end that the slider has".to_owned()
        } else if let Some(stem) = stem {
            format!("remove the suffix: write `{stem}`")
        } else if let Some(plain) = plain.filter(|_| reference.kind == ReferenceKind::Slot) {
            format!(
                "pack `{}` with gzip: a slider with `opposites` loads only `.target.gz`",
                plain.file_name()
            )
        } else if let Some(other) = self.elsewhere(reference) {
            format!(
                "move it from `{}` to `{}`, or copy it if something else uses it",
                parent(&other.rel),
                parent(&reference.rel)
            )
        } else if let Some(near) = self.nearest(reference) {
            format!("did you mean `{near}`?")
        } else {
            "correct the name, or add the target".to_owned()
        }
    }

    /// Path of the target that a missing one is likely to be, as `help` says.
    pub(super) fn meant(&self, reference: &Reference<'_>) -> Option<String> {
        let folder = parent(&reference.rel);
        let near = || {
            self.nearest(reference)
                .map(|near| format!("{folder}/{near}.target.gz"))
        };
        self.elsewhere(reference)
            .map(|file| file.rel.clone())
            .or_else(near)
    }

    /// The target of this name in another section.
    fn elsewhere(&self, reference: &Reference<'_>) -> Option<&'a FileFacts> {
        self.by_name.get(stem(file_name(&reference.rel))).copied()
    }

    /// The target beside it that is most like it.
    fn nearest(&self, reference: &Reference<'_>) -> Option<&'a str> {
        let within = format!("{}/", parent(&reference.rel));
        let free = self.free.range::<str, _>((Included(&*within), Unbounded));
        let free = free.take_while(|(rel, _)| rel.starts_with(&within));
        self.suggestions
            .nearest(stem(file_name(&reference.rel)), free.map(|(_, name)| *name))
    }
}

fn stem(name: &str) -> &str {
    let plain = name.strip_suffix(".gz").unwrap_or(name);
    plain.strip_suffix(".target").unwrap_or(plain)
}
