//! Globs of the configuration that match no file: the files were removed, or the glob is misspelt.

use std::collections::BTreeSet;

use super::scope::Scope;
use mhlint_config::{Config, ConfigFile, Globs, PathGlob};
use mhlint_diag::{IdleGlob, Place};
use mhlint_source::{Outer, Tree};

/// The globs of `[[path]]` and `exclude` that match no path in the inputs. A glob is judged only if
/// the run looks at everything that the glob could match.
pub(crate) fn idle<'t>(
    config: &Config,
    trees: impl Iterator<Item = &'t Tree> + Clone,
    scope: &Scope<'_>,
) -> Vec<IdleGlob> {
    let Some(file) = &config.file else {
        return Vec::new();
    };
    let blocks = file.blocks.iter().map(|block| ("[[path]]", &block.glob));
    let globs = file
        .exclude
        .iter()
        .map(|glob| ("exclude", glob))
        .chain(blocks);
    let is_judged =
        |glob: &PathGlob| scope.covers(&file.folder, glob.folder()) && !is_hidden(&glob.text);
    let judged: Vec<(&'static str, &PathGlob)> =
        globs.filter(|(_, glob)| is_judged(glob)).collect();
    let all: Globs = judged.iter().map(|(_, glob)| (*glob).clone()).collect();
    let reached = reached(file, &all, trees.clone());
    let idle: Vec<_> = (0..)
        .zip(judged)
        .filter(|(number, _)| !reached.contains(number))
        .map(|(_, each)| each)
        .collect();
    let elsewhere = elsewhere(file, &idle, trees);
    let told = idle.into_iter().map(|(setting, glob)| IdleGlob {
        path: file.path.clone(),
        place: Place::Span(glob.span.clone()),
        setting,
        glob: glob.text.clone(),
        meant: elsewhere
            .contains(glob.text.as_str())
            .then(|| format!("**/{}", glob.text)),
    });
    told.collect()
}

/// Indices of the globs that match a path in the trees. Each path is tried once against all globs
/// together.
pub(super) fn reached<'t>(
    file: &ConfigFile,
    globs: &Globs,
    trees: impl Iterator<Item = &'t Tree>,
) -> BTreeSet<usize> {
    let waiting = if globs.is_empty() { None } else { Some(trees) };
    let paths = waiting.into_iter().flatten().flat_map(paths);
    paths
        .filter_map(|path| file.relative(&path))
        .flat_map(|rel| globs.fitting(&rel))
        .collect()
}

/// Those of the globs that would match with `**/` before them. People often write globs relative to
/// the data root.
fn elsewhere<'g, 't>(
    file: &ConfigFile,
    idle: &[(&'static str, &'g PathGlob)],
    trees: impl Iterator<Item = &'t Tree>,
) -> BTreeSet<&'g str> {
    let (plain, wild): (Vec<_>, Vec<_>) = idle
        .iter()
        .map(|(_, glob)| *glob)
        .partition(|glob| glob.is_plain());
    let plain: BTreeSet<&str> = plain.into_iter().map(|glob| glob.text.as_str()).collect();
    // A glob that begins with `**/` was tried everywhere before.
    let wild = wild
        .into_iter()
        .filter(|glob| !glob.text.starts_with("**/"));
    let anywhere = |glob: &'g PathGlob| {
        Some((
            &glob.text,
            PathGlob::new(&format!("**/{}", glob.text), 0..0).ok()?,
        ))
    };
    let (texts, wild): (Vec<&String>, Vec<PathGlob>) = wild.filter_map(anywhere).unzip();
    let wild: Globs = wild.into_iter().collect();
    let mut found = BTreeSet::new();
    let waiting = if idle.is_empty() { None } else { Some(trees) };
    for rel in waiting
        .into_iter()
        .flatten()
        .flat_map(paths)
        .filter_map(|path| file.relative(&path))
    {
        let starts = std::iter::once(0).chain(rel.match_indices('/').map(|(slash, _)| slash + 1));
        found.extend(starts.filter_map(|start| plain.get(rel.get(start..)?).copied()));
        found.extend(
            wild.fitting(&rel)
                .into_iter()
                .filter_map(|number| Some(texts.get(number)?.as_str())),
        );
    }
    found
}

/// Whether everything that a glob could match was listed, so that a glob which matches nothing now
/// cannot match in any other run.
pub(super) fn is_for_listed(file: &ConfigFile, glob: &PathGlob, trees: &Outer) -> bool {
    !is_hidden(&glob.text) && file.folder.lies_in(glob.folder(), trees)
}

/// The printed paths of everything in a tree.
fn paths(tree: &Tree) -> impl Iterator<Item = String> {
    let listed = tree.entries().iter().map(|entry| &entry.path);
    let unlisted = tree.faults().iter().map(|fault| &fault.path);
    std::iter::once("")
        .chain(listed.chain(unlisted).map(String::as_str))
        .map(|path| tree.shown(path))
}

/// Whether a glob is for hidden files, which are not listed.
fn is_hidden(glob: &str) -> bool {
    glob.split('/')
        .any(|part| part.starts_with('.') && part != "..")
}
