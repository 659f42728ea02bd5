//! Changed files: the whole repository is checked, the report narrowed to what the change can affect.
//!
//! One step each way along the references: a changed file, what names it, what it names. Files that decide
//! over a whole base mesh (`base.obj`, `macro.json` and the like) affect everything of that base. A finding that
//! should be left out and is shown is a nuisance, the other way round it is a fault that nobody sees: in doubt it
//! is shown.

use std::borrow::Cow;
use std::collections::{BTreeMap, BTreeSet};
use std::ops::Bound;
use std::path::{Path, PathBuf};

use super::extent::{extent, is_numeric};
use crate::diag::{Because, Extent, Finding, Name, Note, Outcome, Place};
use crate::discover::Kind;
use crate::repo::{Layer, Reference, Resolution, View};
use crate::source::{canonical, link_targets, own_place, resolved, slashed};

/// Paths of changed files: absolute, without `..`, with forward slashes.
pub(super) struct Change {
    paths: BTreeSet<String>,
    files: usize,
}

impl Change {
    /// From paths relative to the working directory.
    pub(super) fn new(paths: &[PathBuf]) -> Self {
        let files = paths.iter().map(|path| in_its_folder(path)).collect::<BTreeSet<_>>();
        let count = files.len();
        Self { paths: paths.iter().map(|path| absolute(path)).chain(files).collect(), files: count }
    }

    /// Whether a file changed, by its path as reports print it.
    pub(super) fn holds(&self, path: &str) -> bool {
        self.paths.contains(&absolute(Path::new(path)))
    }

    /// Whether the file or folder that something links to changed, or one on the way to it.
    fn reaches(&self, link: &Path) -> bool {
        let own = in_its_folder(link);
        link_targets(link).iter().any(|target| {
            let target = in_its_folder(target);
            // What leads back up leads to everything.
            let holds_link = own.starts_with(&format!("{target}/"));
            self.paths.contains(&target) || (!holds_link && first_below(&self.paths, &target).is_some())
        })
    }

    /// Whether a layer as a whole is another: a submodule or link that it is or lies in was changed.
    fn replaces(&self, layer: &Layer) -> bool {
        let path = Path::new(&layer.path);
        [absolute(path), in_its_folder(path)].iter().any(|place| {
            Path::new(place).ancestors().any(|above| above.to_str().is_some_and(|above| self.paths.contains(above)))
        })
    }

    /// A changed path that can decide which data lie over which: a mesh or `base.json` that is not of these data alone,
    /// an override that is gone.
    fn restacking(&self, view: &View<'_>) -> Option<&str> {
        let roots: Vec<String> = layers(view).map(|layer| format!("{}/", absolute(Path::new(&layer.path)))).collect();
        let is_alone = |path: &str| matches!(roots.as_slice(), [root] if path.starts_with(root.as_str()));
        let decides = |path: &&String| match path.rsplit('/').take(3).collect::<Vec<_>>().as_slice() {
            ["base.json" | "base.obj", _, "base"] => !is_alone(path),
            _ => path.contains("/contarget/") && canonical(Path::new(path.as_str())).is_none(),
        };
        self.paths.iter().find(decides).map(String::as_str)
    }

    /// The changed paths below a layer, relative to it.
    fn below<'s>(&'s self, layer: &Layer) -> impl Iterator<Item = &'s str> + use<'s> {
        let root = format!("{}/", absolute(Path::new(&layer.path)).trim_end_matches('/'));
        let from = self.paths.range(root.clone()..);
        from.map_while(move |path| path.strip_prefix(root.as_str()))
    }
}

/// Says of each finding why the change can affect it, as far as one view tells; the others are left without a reason.
pub(super) fn explain(view: &View<'_>, findings: &mut [Finding], change: &Change) {
    let reach = Reach::new(view, change);
    for finding in findings {
        finding.because = finding.because.take().or_else(|| reach.reason(view, finding));
    }
}

/// Leaves out what the change cannot affect, and says how much that was. Findings on the settings of mhlint stay.
pub(super) fn narrow(outcome: &mut Outcome, change: &Change) {
    let all = outcome.findings.len();
    // Ignores and entries of the baseline can fall out of use by any change.
    outcome.findings.retain(|finding| finding.because.is_some() || finding.is_upkeep());
    outcome.left_out = all - outcome.findings.len();
    outcome.notes.push(Note::Narrowed { changed: change.files, left_out: outcome.left_out });
}

/// What a change reaches in one view.
struct Reach<'a> {
    /// Why everything can be a matter of the change.
    whole: Option<Because>,
    /// Changed files, by their path as reports print it, and links to them.
    changed: BTreeSet<String>,
    /// The same in lower case.
    folded: BTreeSet<String>,
    /// Changed files of each base mesh.
    of_base: BTreeMap<String, Vec<Changed>>,
    /// Paths below the data root, by path as reports print it.
    rels: BTreeMap<&'a str, &'a str>,
    /// Files that a changed file names, with the changed one.
    named: BTreeMap<&'a str, &'a str>,
    /// Files that name a changed one: where in them, and the changed one.
    naming: BTreeMap<&'a str, Vec<(&'a Place, String)>>,
}

/// A changed file of a base mesh.
struct Changed {
    path: String,
    /// The folder of the data root that it lies in.
    folder: String,
    /// Whether all findings on the base hang on it.
    decides: bool,
}

impl<'a> Reach<'a> {
    fn new(view: &'a View<'a>, change: &Change) -> Self {
        let mut reach = Self {
            whole: whole(view, change),
            changed: BTreeSet::new(),
            folded: BTreeSet::new(),
            of_base: BTreeMap::new(),
            rels: BTreeMap::new(),
            named: BTreeMap::new(),
            naming: BTreeMap::new(),
        };
        for layer in layers(view) {
            reach.rels.extend(layer.files.values().map(|file| (file.path.as_str(), file.rel.as_str())));
            reach.changed.extend(change.below(layer).map(|rel| layer.display(rel)));
            let faults = layer.walk_faults.iter().map(|fault| layer.display(&fault.path));
            let folders = layer.folders.iter().map(|folder| layer.display(folder));
            let entries = layer.files.values().map(|file| file.path.clone()).chain(folders).chain(faults);
            reach.changed.extend(entries.filter(|path| change.reaches(Path::new(path))));
            // Of a submodule or a link to a folder only the folder is listed.
            let files = layer.files.values().map(|file| &file.path);
            let inside: Vec<String> = files.filter(|path| reach.holding(path).is_some()).cloned().collect();
            reach.changed.extend(inside);
        }
        for path in &reach.changed {
            let rel = reach.rel(view, path);
            if let [folder, base, rest @ ..] = rel.split('/').collect::<Vec<_>>().as_slice() {
                // Nobody knows what was in a folder.
                let is_folder = rest.is_empty() && !reach.rels.contains_key(path.as_str());
                let decides = decides_over_base(&rel) || is_folder;
                let changed = Changed { path: path.clone(), folder: (*folder).to_owned(), decides };
                reach.of_base.entry((*base).to_owned()).or_default().push(changed);
            }
        }
        reach.folded = reach.changed.iter().map(|path| path.to_lowercase()).collect();
        for reference in view.references() {
            reach.follow(view, reference);
        }
        reach
    }

    /// The path below the data root. A loose file has the one where the application would look for it.
    fn rel<'p>(&self, view: &View<'_>, path: &'p str) -> Cow<'p, str>
    where
        'a: 'p,
    {
        if let Some(rel) = self.rels.get(path) {
            return Cow::Borrowed(rel);
        }
        let below = || layers(view).find_map(|layer| layer.relative(path)).unwrap_or(path);
        self.beside(path).map_or_else(|| Cow::Borrowed(below()), Cow::Owned)
    }

    /// Where a file that is gone would lie: where its neighbours do, also if they are loose.
    fn beside(&self, path: &str) -> Option<String> {
        let (folder, name) = path.rsplit_once('/')?;
        let prefix = format!("{folder}/");
        let (neighbour, rel) =
            self.rels.range::<str, _>((Bound::Included(prefix.as_str()), Bound::Unbounded)).next()?;
        let is_here = neighbour.strip_prefix(prefix.as_str()).is_some_and(|rest| !rest.contains('/'));
        let (above, _) = rel.rsplit_once('/').filter(|_| is_here)?;
        Some(format!("{above}/{name}"))
    }

    fn follow(&mut self, view: &View<'_>, reference: &'a Reference<'a>) {
        let from = reference.from.path.as_str();
        let found = match reference.resolution {
            Resolution::OtherLayer(file) => Some(file),
            resolution => resolution.meant(),
        };
        if self.holding(from).is_some()
            && let Some(file) = found
        {
            self.named.insert(&file.path, from);
        }
        // A deleted or renamed file is where the reference would look in any layer.
        let looked_at = layers(view).map(|layer| layer.display(&reference.rel));
        let target = found.map(|file| file.path.clone()).into_iter().chain(looked_at);
        let mut near = target.filter_map(|path| {
            let changed = self.holding(&path);
            // What is missed together is told once, at any of its names.
            let folder = || self.below(path.rsplit_once('/').map_or("", |(folder, _)| folder));
            if found.is_some() { changed } else { changed.or_else(folder) }.map(str::to_owned)
        });
        if let Some(path) = near.next() {
            self.naming.entry(from).or_default().push((&reference.place, path));
        }
    }

    /// Why a finding can be a matter of the change.
    fn reason(&self, view: &View<'_>, finding: &Finding) -> Option<Because> {
        if let Some(whole) = &self.whole {
            return Some(whole.clone());
        }
        let path = finding.path.as_str();
        if self.changed.contains(path) {
            return Some(Because::Own);
        }
        if let Some(changed) = self.below(path).or_else(|| first_below(&self.folded, &path.to_lowercase())) {
            return Some(Because::Inside(changed.to_owned()));
        }
        let others = finding.related.iter().map(|other| other.path.as_str());
        let names = finding.subject.parts.iter().filter_map(|(name, _)| match name {
            Name::Text(name) => Some(name),
            Name::Numbers(..) => None,
        });
        let parts: Vec<String> =
            names.flat_map(|name| layers(view).map(|layer| layer.display(name)).chain([name.clone()])).collect();
        let mut spoken_of = others.chain(parts.iter().map(String::as_str)).chain([path]);
        if let Some(changed) = spoken_of.find_map(|other| self.holding(other)) {
            return Some(Because::SpokenOf(changed.to_owned()));
        }
        if self.folded.contains(&path.to_lowercase()) {
            return Some(Because::OtherCapitals);
        }
        if let Some(from) = self.named.get(path) {
            return Some(Because::NamedBy((*from).to_owned()));
        }
        if let Some(changed) = self.naming.get(path).and_then(|places| named_at(places, finding)) {
            return Some(Because::Names(changed.to_owned()));
        }
        let rel = self.rel(view, path);
        self.of_its_base(&rel, view.kind_at(&rel), finding)
    }

    /// Why a finding at `rel` can come from another file of its base mesh.
    fn of_its_base(&self, rel: &str, kind: Kind, finding: &Finding) -> Option<Because> {
        let base = rel.split('/').nth(1)?;
        let changed = self.of_base.get(base)?;
        if let Some(changed) = changed.iter().find(|changed| changed.decides) {
            return Some(Because::Decides { changed: changed.path.clone(), base: base.to_owned() });
        }
        let is_rig = |changed: &&Changed| changed.folder == "rigs";
        let folder = |path: &str| path.rsplit_once('/').map_or(String::new(), |(folder, _)| folder.to_owned());
        let counts = match extent(finding, kind) {
            Extent::File => None,
            Extent::Folder => {
                let folder = folder(&finding.path);
                changed.iter().find(|changed| changed.path.starts_with(&format!("{folder}/")))
            }
            Extent::Rigs => changed.iter().find(is_rig),
            Extent::FolderAndRigs => {
                let own = folder(&finding.path);
                changed.iter().find(|changed| is_rig(changed) || folder(&changed.path) == own)
            }
            Extent::Base => changed.first(),
        };
        counts.map(|changed| Because::SameBase { changed: changed.path.clone(), base: base.to_owned() })
    }

    /// The changed file, link or linked folder that a path is or lies in.
    fn holding(&self, path: &str) -> Option<&str> {
        let mut ends = path.match_indices('/').map(|(at, _)| at).chain([path.len()]);
        ends.find_map(|end| self.changed.get(path.get(..end)?)).map(String::as_str)
    }

    /// A changed file below a folder.
    fn below(&self, folder: &str) -> Option<&str> {
        first_below(&self.changed, folder)
    }
}

/// Why everything in a repository can be a matter of the change, if so.
fn whole(view: &View<'_>, change: &Change) -> Option<Because> {
    if let Some(layer) = layers(view).find(|layer| change.replaces(layer)) {
        return Some(Because::WholeFolder(layer.path.clone()));
    }
    let path = change.restacking(view)?;
    let name = path.rsplit('/').next().unwrap_or_default();
    Some(Because::Layers(name.to_owned()))
}

/// The first of the paths that lies below a folder.
fn first_below<'s>(paths: &'s BTreeSet<String>, folder: &str) -> Option<&'s str> {
    let prefix = format!("{folder}/");
    let next = paths.range(prefix.clone()..).next()?;
    next.starts_with(&prefix).then_some(next.as_str())
}

/// The changed file named where the finding is, above or below it. A finding on evaluated shapes, or without a
/// place in the text, may come from any of the names.
fn named_at<'r>(places: &'r [(&Place, String)], finding: &Finding) -> Option<&'r str> {
    let at = |place: &Place| match place {
        Place::Pointer(pointer) | Place::Key(pointer) => Some(pointer.clone()),
        _ => None,
    };
    let Some(here) = at(&finding.place).filter(|_| !is_numeric(finding)) else {
        return places.first().map(|(_, path)| path.as_str());
    };
    let touches = |place: &Place| {
        let Some(there) = at(place) else { return true };
        let owner = there.rsplit_once('/').map_or("", |(owner, _)| owner);
        is_within(&there, &here) || is_within(&here, owner)
    };
    places.iter().find(|(place, _)| touches(place)).map(|(_, path)| path.as_str())
}

/// Whether the pointer `inner` is `outer` or leads below it.
fn is_within(inner: &str, outer: &str) -> bool {
    inner.strip_prefix(outer).is_some_and(|rest| rest.is_empty() || rest.starts_with('/'))
}

/// Whether all findings on a base mesh hang on the file at `rel`.
fn decides_over_base(rel: &str) -> bool {
    matches!(
        rel.split('/').collect::<Vec<_>>().as_slice(),
        ["base", _, "base.json" | "base.obj" | "base.mhbin"]
            | [
                "target" | "contarget",
                _,
                "macro.json" | "modelling.json" | "target_cat.json" | "compressedtargets.npz",
            ]
    )
}

fn layers<'a>(view: &'a View<'_>) -> impl Iterator<Item = &'a Layer> {
    let checked = view.layers().checked;
    let own = std::iter::once(checked);
    let others = view.layers().strongest_first().filter(|layer| !std::ptr::eq(*layer, checked));
    own.chain(others)
}

/// The path from the root of the file system, without `.`, `..` and links: git knows its files by it.
fn absolute(path: &Path) -> String {
    slashed(&resolved(path))
}

/// The same for a file that may be a link itself: it is checked under its own name.
fn in_its_folder(path: &Path) -> String {
    slashed(&own_place(path))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paths_are_compared_whole() {
        let change = Change::new(&["data/target/b/x.target".into(), "./data2/../data/base/b/base.obj".into()]);
        let layer = |path: &str| Layer::new(path.to_owned(), Vec::new(), BTreeMap::default(), Vec::new(), Vec::new());
        let below: Vec<&str> = change.below(&layer("data")).collect();
        assert_eq!(below, ["base/b/base.obj", "target/b/x.target"]);
        assert_eq!(change.below(&layer("dat")).count(), 0);
    }

    #[test]
    fn a_pointer_is_within_itself_and_what_holds_it() {
        assert!(is_within("/a/b", "/a") && is_within("/a", "/a") && is_within("/a", ""));
        assert!(!is_within("/ab", "/a"));
    }
}
