//! A zip without the folders of a data root, for applications that import none.

use std::cell::{OnceCell, RefCell};
use std::collections::{BTreeMap, BTreeSet};

use super::super::error::Error;
use super::input::Input;
use super::loose::{Outside, is_one_of_several};
use super::place::Place;
use super::unit_names::UnitNames;
use crate::config::Config;
use crate::diag::Application;
use crate::discover::Layout;

/// The files of a zip without the folders of a data root, for applications without an importer: whoever has them unpacks
/// each where it belongs.
pub(super) fn unpacked_singly<'t, 'a>(
    pack: &'t Input,
    applications: impl Iterator<Item = &'a (Application, BTreeSet<String>)>,
    systems: &[Place<'_>],
    options: &Config,
) -> Result<Vec<(Place<'t>, Vec<String>)>, Error> {
    let units = UnitNames::of(systems, &options.limits);
    let (roots, taken) = (BTreeMap::new(), BTreeSet::new());
    let mut places = Vec::new();
    for (application, bases) in applications.filter(|(one, _)| Layout::of(*one).unpacks_singly) {
        let is_meant = options.applications.contains(application) || systems.iter().any(|one| one.is_of(*application));
        let kept = RefCell::default();
        let input = pack;
        let outside = Outside {
            input,
            roots: &roots,
            taken: &taken,
            bases,
            is_meant,
            is_one_of_several: is_one_of_several(systems, options),
            units: &units,
            beside_target: OnceCell::new(),
            options,
            kept,
        };
        places.extend(outside.place(Layout::of(*application))?);
    }
    Ok(places)
}
