//! Globs of the configuration that fit nothing: the files have gone, or they were never called so.

use super::scope::Scope;
use crate::config::{Config, PathGlob};
use crate::diag::{IdleGlob, Place};
use crate::source::Tree;

/// A glob that nothing fits so far.
struct Waiting<'c> {
    setting: &'static str,
    glob: &'c PathGlob,
    /// The same in any folder, since globs are often written as if from the data root.
    anywhere: Option<PathGlob>,
    anywhere_fits: bool,
}

/// The globs of `[[path]]` and `exclude` that fit nothing of what there is. Of a run that looks at a part no more can
/// be said.
pub(in crate::engine) fn idle<'t>(
    config: &Config,
    trees: impl Iterator<Item = &'t Tree>,
    scope: &Scope<'_>,
) -> Vec<IdleGlob> {
    let Some(file) = &config.file else { return Vec::new() };
    let blocks = file.blocks.iter().map(|block| ("[[path]]", &block.glob));
    let globs = file.exclude.iter().map(|glob| ("exclude", glob)).chain(blocks);
    let checked = globs.filter(|(_, glob)| scope.covers(&file.folder, glob.folder()) && !is_hidden(&glob.text));
    let mut waiting: Vec<Waiting<'_>> = checked.map(|(setting, glob)| Waiting::new(setting, glob)).collect();
    for path in trees.flat_map(paths) {
        if waiting.is_empty() {
            break;
        }
        let Some(rel) = file.relative(&path) else { continue };
        waiting.retain_mut(|waiting| !waiting.meets(&rel));
    }
    let idle = waiting.into_iter().map(|waiting| IdleGlob {
        path: file.path.clone(),
        place: Place::Span(waiting.glob.span.clone()),
        setting: waiting.setting,
        glob: waiting.glob.text.clone(),
        meant: waiting.anywhere.filter(|_| waiting.anywhere_fits).map(|glob| glob.text),
    });
    idle.collect()
}

/// Whether a glob is for a part of what was listed and fits nothing of it, so that it cannot fit in any run.
pub(super) fn fits_nothing<'t>(
    config: &Config,
    glob: &PathGlob,
    mut trees: impl Iterator<Item = &'t Tree> + Clone,
) -> bool {
    let Some(file) = &config.file else { return false };
    let is_inside = |tree: &Tree| file.folder.lies_in(glob.folder(), tree.label());
    let fits = |path: String| file.relative(&path).is_some_and(|rel| glob.fits(&rel));
    !is_hidden(&glob.text) && trees.clone().any(is_inside) && !trees.any(|tree| paths(tree).any(fits))
}

impl<'c> Waiting<'c> {
    fn new(setting: &'static str, glob: &'c PathGlob) -> Self {
        let anywhere = PathGlob::new(&format!("**/{}", glob.text), glob.span.clone()).ok();
        Self { setting, glob, anywhere, anywhere_fits: false }
    }

    /// Whether the glob fits, and from now on is of no interest.
    fn meets(&mut self, rel: &str) -> bool {
        self.anywhere_fits |= self.anywhere.as_ref().is_some_and(|glob| glob.fits(rel));
        self.glob.fits(rel)
    }
}

/// Everything in a tree, as printed.
fn paths(tree: &Tree) -> impl Iterator<Item = String> {
    let listed = tree.entries().iter().map(|entry| &entry.path);
    let unlisted = tree.faults().iter().map(|fault| &fault.path);
    std::iter::once("").chain(listed.chain(unlisted).map(String::as_str)).map(|path| tree.shown(path))
}

/// Whether a glob is for files that are not even listed.
fn is_hidden(glob: &str) -> bool {
    glob.split('/').any(|part| part.starts_with('.') && part != "..")
}
