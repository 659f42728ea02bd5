//! Copies of assets: what they share follows from the copying.

use std::collections::BTreeMap;

use mhlint_repo::makehuman2::{self, Asset};
use mhlint_repo::{FileFacts, View};
use mhlint_source::parent;

/// Whether two assets and all that they name have the same content.
pub(crate) fn is_copy(view: &makehuman2::View<'_>, one: &Asset<'_>, other: &Asset<'_>) -> bool {
    let is_same = |one: &FileFacts, other: &FileFacts| {
        one.content_hash.is_some() && one.content_hash == other.content_hash
    };
    let parts = |asset: &Asset<'_>| -> Vec<_> {
        let named = view.worn_references(asset.file).into_iter().flatten();
        named
            .map(|reference| (reference.kind, reference.meant()))
            .collect()
    };
    let pairs = || parts(one).into_iter().zip(parts(other));
    is_same(one.file, other.file)
        && pairs().all(|((_, one), (_, other))| match (one, other) {
            (Some(one), Some(other)) => is_same(one, other),
            (one, other) => one.is_none() && other.is_none(),
        })
}

/// Folders of assets that are known by the same, each with the number of its clash: a folder was
/// copied.
pub(crate) struct CopiedFolders<'a>(BTreeMap<&'a str, usize>);

impl<'a> CopiedFolders<'a> {
    pub(crate) fn of(view: &'a View<'_>) -> Self {
        let View::Makehuman2(view) = view else {
            return Self(BTreeMap::new());
        };
        let clashes = view
            .library
            .bases()
            .into_iter()
            .flat_map(|base| view.library.clashes(base));
        let folders = (0..).zip(clashes).flat_map(|(number, clash)| {
            clash
                .into_iter()
                .map(move |asset| (parent(asset.file.rel.as_str()), number))
        });
        Self(folders.collect())
    }

    /// Whether files with equal content lie in the folders of one clash.
    pub(crate) fn hold(&self, files: &[&FileFacts]) -> bool {
        let number = |file: &FileFacts| {
            let above = std::iter::successors(Some(parent(&file.rel)), |path| Some(parent(path)));
            above
                .take_while(|path| !path.is_empty())
                .find_map(|folder| self.0.get(folder).copied())
        };
        let mut numbers = files.iter().map(|file| number(file));
        let first = numbers.next().flatten();
        first.is_some() && numbers.all(|other| other == first)
    }
}
