//! A zip of the data of a program, or of a user's folder with what lies beside its data: what
//! downloads and backups are. It is a copy of these, and no pack that anybody imports.

use std::sync::Arc;

use super::found::{listing, look_into, roots_of};
use super::input::Input;
use super::place::Place;
use super::roots::beside_root;
use super::set_aside::folders;
use mhlint_config::Config;
use mhlint_diag::Application;
use mhlint_discover::{Kind, Layout, Role, candidates, evidence};
use mhlint_repo::Pack;
use mhlint_source::{EntryKind, Tree, is_below};

/// Data roots with those whose they certainly are.
pub(super) type Certain = Vec<(String, &'static Layout)>;

/// Data roots in a zip that are certainly data of an application: of its program, or of a user with
/// something beside them that says so.
pub(super) fn certain(input: &Input, options: &Config) -> Certain {
    let tree = &input.tree;
    let peek = |path: &str| look_into(tree, path);
    let listing = listing(tree).with_contents(&peek);
    let is_certain = |path: &str, layout: &'static Layout| {
        let found = evidence(&listing, path, layout.application);
        let is_programs =
            || found.is_certain && (layout.role)(&candidates(tree, path, &[layout])) != Role::User;
        found.is_certain_beside || is_programs()
    };
    let roots = roots_of(tree, &options.applications, |application| {
        options.asks_for(application)
    });
    let aside = folders(input);
    let roots = roots
        .into_iter()
        .filter(|(path, _)| !aside.keys().any(|folder| is_below(path, folder)));
    let each = roots.flat_map(|(path, layouts)| {
        layouts
            .into_iter()
            .map(move |layout| (path.clone(), layout))
    });
    each.filter(|(path, layout)| is_certain(path, layout))
        .collect()
}

/// Whether a zip is checked as the folder that it was made of: it has data that are certainly those
/// of an application that imports no packs, where that one is asked for or none is.
pub(super) fn is_copy(input: &Input, certain: &Certain, options: &Config) -> bool {
    let mut own = certain.iter().filter(|(_, layout)| layout.import.is_none());
    own.any(|(path, layout)| !has_pack_beside(&input.tree, path, layout, options))
}

/// Those of the applications that a pack may be for: with the data of a program in it that imports
/// packs it is for no other, unless these are asked for.
pub(super) fn meant<T: Clone>(
    certain: &Certain,
    of: &[(Application, T)],
    options: &Config,
) -> Vec<(Application, T)> {
    let certain = certain.iter().filter(|_| options.applications.is_empty());
    let programs: Vec<_> = certain
        .map(|(_, layout)| *layout)
        .filter(|layout| layout.import.is_some())
        .collect();
    let is_meant = |application: Application| {
        programs
            .iter()
            .any(|layout| layout.application == application)
    };
    let is_known = of.iter().any(|(application, _)| is_meant(*application));
    of.iter()
        .filter(|(application, _)| !is_known || is_meant(*application))
        .cloned()
        .collect()
}

/// Whether an importer that is asked for takes assets which lie outside of these data: then they
/// are a part of a pack.
fn has_pack_beside(tree: &Tree, root: &str, layout: &'static Layout, options: &Config) -> bool {
    let beside = beside_root(tree, root, &[layout]);
    let is_outside = |path: &str| !is_below(path, root) && !beside.iter().any(|own| own == path);
    let takes = |layout: &Layout, path: &str| {
        let place = layout
            .import
            .and_then(|import| import(path, Layout::USUAL_BASE));
        place.is_some_and(|place| layout.use_of(&place).kind != Kind::Other)
    };
    let mut asked = Application::ALL
        .into_iter()
        .filter(|application| options.asks_for(*application))
        .map(Layout::of);
    let files = || {
        tree.entries()
            .iter()
            .filter(|entry| entry.kind == EntryKind::File)
    };
    asked.any(|layout| files().any(|entry| is_outside(&entry.path) && takes(layout, &entry.path)))
}

/// What is wrong with the zip of a copy, for the applications whose data are in it.
pub(super) fn faults<'t>(input: &'t Input, layouts: &[&'static Layout]) -> Option<Place<'t>> {
    let facts = input
        .tree
        .pack()
        .filter(|facts| facts.fault.is_some() || !facts.faults.is_empty())?;
    let pack = Pack {
        faults: Some(Arc::clone(facts)),
        ..Pack::default()
    };
    (!layouts.is_empty()).then(|| Place::of_pack(&input.tree, "", layouts, Vec::new(), pack))
}
