//! A zip without the folders of a data root, for applications that import none.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use super::super::error::Error;
use super::input::Input;
use super::loose::{Given, Outside, Seen};
use super::narrow::Narrow;
use super::place::Place;
use mhlint_diag::Application;
use mhlint_discover::Layout;

/// The files of a zip without the folders of a data root, for applications without an importer:
/// whoever has them unpacks each where it belongs.
pub(super) fn unpacked_singly<'t, 'a>(
    pack: &'t Input,
    applications: impl Iterator<Item = &'a (Application, BTreeSet<String>)>,
    systems: &[Place<'_>],
    given: &Given<'_>,
) -> Result<Vec<(Place<'t>, Arc<Narrow>)>, Error> {
    let (roots, taken) = (BTreeMap::new(), BTreeSet::new());
    let mut places = Vec::new();
    for (application, bases) in applications.filter(|(one, _)| Layout::of(*one).unpacks_singly) {
        let is_meant = given.options.applications.contains(application)
            || systems.iter().any(|one| one.is_of(*application));
        let (roots, taken, seen) = (&roots, &taken, Seen::default());
        let outside = Outside {
            input: pack,
            roots,
            taken,
            bases,
            is_meant,
            given,
            seen,
        };
        places.extend(outside.place(Layout::of(*application))?);
    }
    Ok(places)
}
