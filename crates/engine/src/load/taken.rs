//! Which application a data root is taken for, where its files leave that open (design: `--app`,
//! then what is certain, then `--system`, then what looks most like it).

use std::collections::{BTreeMap, BTreeSet};

use super::found::{listing, look_into};
use super::place::Place;
use super::roots::{Found, with_data};
use mhlint_config::Config;
use mhlint_diag::Application;
use mhlint_discover::{Layout, Listing, Role, candidates, evidence};
use mhlint_source::inside;

/// What a run knows of the applications that are meant.
pub(super) struct Taken<'t, 's> {
    pub(super) systems: &'s [Place<'t>],
    pub(super) options: &'s Config,
}

/// Data roots by path.
type Roots = BTreeMap<String, Vec<&'static Layout>>;

impl Taken<'_, '_> {
    /// The data roots as those of the applications that are meant.
    pub(super) fn all<'i>(&self, found: Vec<Found<'i>>) -> Vec<Found<'i>> {
        if self.options.applications.is_empty() && self.systems.is_empty() {
            return found;
        }
        let known = self.known(&found);
        let there = found
            .iter()
            .flat_map(|(_, roots)| roots.values())
            .flatten()
            .map(|one| one.application)
            .collect();
        let each = found.into_iter().map(|(input, roots)| {
            let peek = |path: &str| look_into(&input.tree, path);
            let listing = listing(&input.tree).with_contents(&peek);
            let is_named = |path: &str| path.is_empty() && input.narrow.is_whole();
            let taken = |(path, layouts): (String, Vec<&'static Layout>)| {
                let layouts = if self.options.applications.is_empty() {
                    self.by_system(&listing, &path, layouts, &known)
                } else {
                    self.by_name(&listing, &path, layouts, is_named(&path), &there)
                };
                (path, layouts)
            };
            let roots: Roots = roots
                .into_iter()
                .map(taken)
                .filter(|(_, layouts)| !layouts.is_empty())
                .collect();
            (input, roots)
        });
        each.collect()
    }

    /// The applications that have data of their own in the run, by `--system` or among what is
    /// checked.
    fn known(&self, found: &[Found<'_>]) -> BTreeSet<Application> {
        let mut known: BTreeSet<Application> = with_data(self.systems).into_iter().collect();
        for (input, roots) in found {
            for (path, layouts) in roots {
                let is_system = |one: &&&Layout| {
                    (one.role)(&candidates(&input.tree, path, &[*one])) != Role::User
                };
                known.extend(layouts.iter().filter(is_system).map(|one| one.application));
            }
        }
        known
    }

    /// Who names applications gets these: a place that looks like another one's is taken for
    /// theirs, unless theirs is there as well, or it is another one's for certain and was not named
    /// itself.
    fn by_name(
        &self,
        listing: &Listing<'_>,
        path: &str,
        layouts: Vec<&'static Layout>,
        is_named: bool,
        there: &BTreeSet<Application>,
    ) -> Vec<&'static Layout> {
        let asked = &self.options.applications;
        let is_certain = || {
            layouts
                .iter()
                .any(|one| evidence(listing, path, one.application).is_certain)
        };
        let is_there = asked.iter().any(|one| there.contains(one));
        if is_there || !is_named && is_certain() {
            return layouts;
        }
        let taken = possible(asked, listing, path);
        if taken.is_empty() { layouts } else { taken }
    }

    /// What is certain stays. Else a user's folder is one of the application whose data are given:
    /// one without a folder for each base mesh, as it is; one for an application that has these, as
    /// assets that are not installed yet.
    fn by_system(
        &self,
        listing: &Listing<'_>,
        path: &str,
        layouts: Vec<&'static Layout>,
        known: &BTreeSet<Application>,
    ) -> Vec<&'static Layout> {
        let is_meant = |layout: &&'static Layout| {
            known.contains(&layout.application)
                || evidence(listing, path, layout.application).is_certain
        };
        let meant: Vec<&'static Layout> = layouts.iter().copied().filter(is_meant).collect();
        let given = with_data(self.systems);
        // A folder for a base mesh in each library is for nobody else.
        match meant.is_empty() {
            false => meant,
            true if layouts.iter().any(|one| one.has_bases) => {
                let taken = possible(&given, listing, path);
                if taken.is_empty() { layouts } else { taken }
            }
            true => Vec::new(),
        }
    }
}

/// Those of the applications without a folder for each base mesh that could have a data root with
/// these folders.
fn possible(
    applications: &[Application],
    listing: &Listing<'_>,
    path: &str,
) -> Vec<&'static Layout> {
    let tops: BTreeSet<&str> = listing
        .below(path)
        .filter_map(|file| inside(file, path)?.split_once('/'))
        .map(|(top, _)| top)
        .collect();
    let of = applications
        .iter()
        .map(|application| Layout::of(*application));
    of.filter(|layout| !layout.has_bases && tops.iter().any(|top| layout.has_at_top(top)))
        .collect()
}
