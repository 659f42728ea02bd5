//! What of the data was checked, and what was not.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use super::catalogue::has_rules;
use super::consumers::Consumers;
use super::load::{Loaded, shown};
use super::settle::Scope;
use mhlint_config::Config;
use mhlint_diag::{Application, NotChecked, Outcome, Unchecked, Untouched};
use mhlint_discover::{Kind, UNKNOWN_BASE};
use mhlint_eval::measures::Measures;
use mhlint_repo::{FileFacts, Pack, Resolution, View, is_unfiled};
use mhlint_source::is_below;

/// What a run has checked so far.
pub(super) struct Coverage<'r> {
    asked: Asked<'r>,
    /// The PATHs of which nothing was checked yet.
    untouched: BTreeSet<String>,
    /// What was not checked, by printed path.
    left: BTreeMap<(Option<Application>, Unchecked), BTreeSet<String>>,
    /// Files outside of data roots that were counted: each application has them at another place.
    counted: BTreeSet<String>,
    consumers: Consumers,
}

/// What alone is to be reported on.
#[derive(Clone, Copy)]
struct Asked<'r> {
    options: &'r Config,
    scope: &'r Scope<'r>,
}

impl<'r> Coverage<'r> {
    /// Nothing is checked yet of these PATHs.
    pub(super) fn new(
        paths: impl IntoIterator<Item = String>,
        scope: &'r Scope<'r>,
        options: &'r Config,
    ) -> Self {
        let asked = Asked { options, scope };
        let untouched = paths.into_iter().collect();
        Self {
            asked,
            untouched,
            left: BTreeMap::new(),
            counted: BTreeSet::new(),
            consumers: Consumers::default(),
        }
    }

    /// Counts a data root that was checked as its applications see it.
    pub(super) fn add(&mut self, root: &Loaded<'_>, views: &[View<'_>], outcome: &mut Outcome) {
        let asked = self.asked;
        // Of what an importer ignores or refuses there may be no file, and yet something was
        // checked.
        if root
            .layer
            .pack
            .as_ref()
            .is_some_and(|pack| pack.import.is_some() || pack.refusal.is_some())
        {
            self.untouched
                .retain(|path| !is_below(&root.layer.path, path));
        }
        let layer: Arc<str> = shown(&root.layer.path).into();
        let archived: Vec<_> = views.iter().map(View::archived).collect();
        for file in root
            .layer
            .files
            .values()
            .filter(|file| asked.is_for(root, views, file))
        {
            for (view, archived) in views.iter().zip(&archived) {
                self.consumers.add(
                    file,
                    view.application(),
                    &layer,
                    archived.get(file.path.as_str()).copied(),
                );
            }
            let mut is_checked = false;
            for view in views {
                let application = view.application();
                if has_rules(application, file.kind_in(application)) {
                    is_checked = true;
                } else {
                    self.leave(application, without_rules(file, application), &file.path);
                }
                if file.is_kept_in_part() {
                    self.leave(application, Unchecked::Part, &file.path);
                }
                if needs_mesh(file) && !root.has_mesh_for(file) {
                    self.leave(application, without_mesh(file, view), &file.path);
                }
            }
            if is_checked
                && (!root.place.is_one_of_several() || self.counted.insert(file.path.clone()))
            {
                outcome.summary.files += 1;
                outcome.summary.bytes += file.size;
                self.untouched.retain(|path| !is_below(&file.path, path));
            }
        }
        for member in root.layer.pack.iter().flat_map(Pack::unread) {
            let path = format!("{}/{member}", root.layer.path);
            views
                .iter()
                .for_each(|view| self.leave(view.application(), Unchecked::Packed, &path));
        }
        // What a part of a program's data lacks is said once.
        for view in views.iter().filter(|view| !view.is_partial()) {
            let open = view
                .references()
                .iter()
                .filter(|one| matches!(one.resolution, Resolution::NeedsSystem));
            for reference in open.filter(|one| asked.is_for(root, views, one.from)) {
                // Where that would lie in a data folder is only supposed.
                let is_beside = reference.from.is_loose
                    && reference
                        .rel
                        .ends_with(reference.text.trim_start_matches("../"));
                let name = if is_beside {
                    reference.text
                } else {
                    &reference.rel
                };
                self.leave(view.application(), Unchecked::NoSystem, name);
            }
        }
    }

    /// Notes the macros of which not all was looked at, and the meshes of which not all was
    /// evaluated.
    pub(super) fn add_measured(
        &mut self,
        root: &Loaded<'_>,
        view: &View<'_>,
        measures: Option<&BTreeMap<String, Arc<Measures>>>,
    ) {
        let is_cut = |measure: &Arc<Measures>| measure.is_cut || measure.lacks_settings;
        let is_whole = measures.is_none_or(|measures| !measures.values().any(is_cut));
        // To gather the bodies once more takes time, and hardly ever is there something to say of
        // them.
        if is_whole && !view.has_too_many_macros() {
            return;
        }
        for body in view.bodies() {
            let measure = measures.and_then(|measures| measures.get(body.name));
            if measure.is_some_and(|measure| measure.is_cut) {
                let mesh = body.mesh.map_or(body.name, |(file, _)| file.path.as_str());
                self.leave(view.application(), Unchecked::Evaluation, mesh);
            }
            let is_cut =
                body.has_too_many_macros || measure.is_some_and(|measure| measure.lacks_settings);
            let file = body.macros.map(|(file, _)| file).filter(|_| is_cut);
            if let Some(file) =
                file.filter(|file| self.asked.is_for(root, std::slice::from_ref(view), file))
            {
                self.leave(view.application(), Unchecked::TooManyMacros, &file.path);
            }
        }
    }

    fn leave(&mut self, application: Application, what: Unchecked, path: &str) {
        self.left
            .entry((Some(application), what))
            .or_default()
            .insert(path.to_owned());
    }

    /// Says what was not checked.
    pub(super) fn conclude(mut self, outcome: &mut Outcome) {
        // What one application has no use for is no gap where it was checked for another.
        for ((_, what), paths) in &mut self.left {
            if matches!(what, Unchecked::Kind | Unchecked::Unused) {
                paths.retain(|path| !self.consumers.has_checked(path));
            }
        }
        self.left.retain(|_, paths| !paths.is_empty());
        outcome.consumers = self.consumers.sorted();
        let left = self
            .left
            .into_iter()
            .map(|((application, what), paths)| NotChecked::of(application, what, paths));
        outcome.not_checked.extend(left);
        outcome
            .not_checked
            .sort_by_key(|entry| (entry.application, entry.what));
        let is_below_it =
            |entry: &NotChecked, path: &str| entry.paths.iter().any(|other| is_below(other, path));
        let why = |path: &str| {
            let whole = outcome
                .not_checked
                .iter()
                .filter(|entry| is_of_whole_files(entry.what));
            whole
                .rev()
                .find(|entry| is_below_it(entry, path))
                .map(|entry| entry.what)
        };
        let untouched = self.untouched.iter();
        outcome.nothing_in = untouched
            .map(|path| Untouched {
                path: shown(path).to_owned(),
                what: why(path),
            })
            .collect();
    }
}

/// Why the base mesh of a file is not there.
fn without_mesh(file: &FileFacts, view: &View<'_>) -> Unchecked {
    let layers = view.layers();
    match layers.system {
        None => Unchecked::NoBaseMesh,
        Some(_) if layers.checks_system() => Unchecked::NoBaseMesh,
        Some(_) if file.base().is_none_or(|base| base == UNKNOWN_BASE) => Unchecked::BaseNotKnown,
        Some(_) => Unchecked::BaseNotInSystem,
    }
}

/// Whether it depends on a base mesh what is in a file. Of poses and models the data folder around
/// them says so.
fn needs_mesh(file: &FileFacts) -> bool {
    file.names_vertices()
        || file.is_loose && matches!(file.kind, Kind::Pose | Kind::Motion | Kind::Model)
}

/// Why no rule is about a file: none is about any of its kind, or it is part of nothing that was
/// checked.
fn without_rules(file: &FileFacts, application: Application) -> Unchecked {
    let kind = Kind::by_extension(file.file_name());
    let is_part = matches!(kind, Kind::AssetWeights | Kind::AssetMesh | Kind::UvMap);
    if is_part && has_rules(application, kind) {
        Unchecked::Unused
    } else {
        Unchecked::Kind
    }
}

/// Whether nothing at all was checked of the files.
const fn is_of_whole_files(what: Unchecked) -> bool {
    matches!(
        what,
        Unchecked::Kind | Unchecked::Unused | Unchecked::Packed | Unchecked::Outside
    )
}

impl Asked<'_> {
    fn is_for(self, root: &Loaded<'_>, views: &[View<'_>], file: &FileFacts) -> bool {
        let asks = |base: &str| self.options.asks_for_base(base);
        let layers = || {
            views
                .iter()
                .flat_map(|view| view.layers().strongest_first())
        };
        let is_of_asked_base = file.base().is_none_or(asks) || is_unfiled(file, layers(), asks);
        root.is_asked_for(&file.path) && !self.scope.excludes(&file.path) && is_of_asked_base
    }
}
