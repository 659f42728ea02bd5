//! What a run reads: the data to check, and the data that they are compared with.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use super::input::{Input, open, open_system};
use crate::error::Error;
use mhlint_config::{Before, Config};
use mhlint_discover::is_read_though_hidden;
use mhlint_source::{
    Contents, Limits, Tree, folder_name, has_hidden_part, own_place, resolved, slashed,
};

/// One side of a comparison, or the only one.
pub(crate) struct Side {
    pub(crate) inputs: Vec<Input>,
    /// `--system`.
    pub(crate) systems: Vec<Tree>,
}

/// Opens the paths as they are to be checked, and as they were if they are to be compared.
pub(crate) fn sides(paths: &[PathBuf], options: &Config) -> Result<(Side, Option<Side>), Error> {
    let open_systems = || {
        options
            .systems
            .iter()
            .map(|system| open_system(system))
            .collect::<Result<Vec<_>, _>>()
    };
    let folder = Side {
        inputs: open(paths, &options.limits)?,
        systems: open_systems()?,
    };
    let Some(compare) = &options.compare else {
        return Ok((folder, None));
    };
    let before = match &compare.before {
        Before::Contents(contents) => folder.with(contents),
        Before::Folder(other) => {
            let mut inputs = open(std::slice::from_ref(other), &options.limits)?;
            // What is the same on both sides has the same path.
            for (input, now) in inputs.iter_mut().zip(&folder.inputs) {
                input.tree.relabel(now.tree.label());
                input.narrow.clone_from(&now.narrow);
                input.named.clone_from(&now.named);
            }
            Side {
                inputs,
                systems: open_systems()?,
            }
        }
    };
    let now = if compare.now.is_empty() {
        folder
    } else {
        folder.with(&compare.now)
    };
    Ok((now, Some(before)))
}

impl Side {
    /// Trees to check whole.
    pub(crate) fn of(trees: Vec<Tree>, systems: impl IntoIterator<Item = Tree>) -> Self {
        let inputs = trees.into_iter().map(Input::whole).collect();
        Self {
            inputs,
            systems: systems.into_iter().collect(),
        }
    }

    /// Every tree, those of the system data last.
    pub(crate) fn trees(&self) -> impl Iterator<Item = &Tree> + Clone {
        self.inputs
            .iter()
            .map(|input| &input.tree)
            .chain(&self.systems)
    }

    /// Those of these files that are in the data, as printed.
    pub(crate) fn shown<'p>(
        &self,
        paths: impl IntoIterator<Item = &'p PathBuf>,
    ) -> BTreeSet<String> {
        let places = self.trees().filter_map(|tree| {
            tree.root()
                .map(|root| (tree, resolved(root), own_place(root)))
        });
        let places: Vec<_> = places.collect();
        let shown = |(tree, place, link): &(&Tree, PathBuf, PathBuf), path: &Path| {
            // A submodule around the data, or a link to them.
            if place.starts_with(path) || link.starts_with(path) {
                return Some(tree.shown(""));
            }
            let rel = path
                .strip_prefix(place)
                .ok()
                .filter(|rel| is_listed(tree, rel))?;
            Some(tree.shown(&slashed(rel)))
        };
        paths
            .into_iter()
            .filter_map(|path| places.iter().find_map(|place| shown(place, path)))
            .collect()
    }

    /// The same with other contents.
    fn with(&self, contents: &Contents<PathBuf>) -> Self {
        let with = |tree: &Tree| tree.with(&below(tree, contents));
        let inputs = self.inputs.iter().map(|input| Input {
            tree: with(&input.tree),
            narrow: input.narrow.clone(),
            named: input.named.clone(),
            new_base: input.new_base.clone(),
            is_beside: input.is_beside,
            tests: input.tests,
        });
        Self {
            inputs: inputs.collect(),
            systems: self.systems.iter().map(with).collect(),
        }
    }

    /// The tree that holds a file or folder, with its path there.
    pub(crate) fn find<'s, 'p>(&'s self, path: &'p str) -> Option<(&'s Tree, &'p str)> {
        let mut found = self
            .inputs
            .iter()
            .filter_map(|input| Some((&input.tree, input.tree.below(path)?)));
        found.find(|(tree, rel)| tree.entry(rel).is_some())
    }

    /// Whether a file has the same content on another side.
    pub(crate) fn shares(&self, path: &str, other: &Self, limits: &Limits) -> bool {
        match (self.find(path), other.find(path)) {
            (Some((tree, rel)), Some((others, _))) => tree.shares(rel, others, limits),
            (None, None) => true,
            _ => false,
        }
    }
}

/// Those of the contents that a tree lists, by path from its top.
fn below(tree: &Tree, contents: &Contents<PathBuf>) -> Contents<String> {
    let Some(root) = tree.root().map(resolved) else {
        return Contents::new();
    };
    let inside = contents
        .range(root.clone()..)
        .map_while(|(path, bytes)| Some((path.strip_prefix(&root).ok()?, bytes)));
    inside
        .filter(|(rel, _)| is_listed(tree, rel))
        .map(|(rel, bytes)| (slashed(rel), bytes.clone()))
        .collect()
}

fn is_listed(tree: &Tree, rel: &Path) -> bool {
    let path = slashed(rel);
    let is_read = || {
        is_read_though_hidden(
            &tree.root().map(folder_name).unwrap_or_default(),
            &path,
            false,
        )
    };
    rel.components().count() <= tree.depth() && (!has_hidden_part(&path) || is_read())
}
