//! Opens one base mesh from data folders, as applications layer them, for `evaluate`.

use std::collections::BTreeSet;
use std::path::Path;
use std::sync::Arc;

use super::data::Data;
use super::found::roots_of;
use super::input::{open, open_system};
use super::layer::list_targets;
use super::roots::{Roots, places, system_places, with_data};
use super::stack::Stack;
use crate::Error as RunError;
use mhlint_diag::nearest;
use mhlint_discover::Role;
use mhlint_evaluate::{Error, Evaluation, Openable, openable};
use mhlint_source::{Limits, Tree, slashed};

/// Opens a base of the data folder `root` (which lies over `system`, if given). Without `base`
/// there must be only one.
///
/// # Errors
/// Folders that cannot be read or hold no data, a base that does not exist, an unusable `base.obj`.
pub fn open_base(
    root: &Path,
    system: Option<&Path>,
    base: Option<&str>,
) -> Result<Evaluation, Error> {
    let limits = Limits::default();
    let inputs = open(&[root.to_path_buf()], &limits)?;
    let judged = inputs.len();
    let mut trees: Vec<Tree> = inputs.into_iter().map(|input| input.tree).collect();
    trees.extend(system.map(open_system).transpose()?);
    let (given, below) = trees.split_at(judged);
    let no_data = |path: &Path| Error::NoData(slashed(path));
    let systems = below
        .iter()
        .map(|tree| system_places(tree))
        .collect::<Result<Vec<_>, _>>();
    let systems: Vec<_> = systems
        .map_err(|_| no_data(system.unwrap_or(root)))?
        .into_iter()
        .flatten()
        .collect();
    let at_hand = with_data(&systems);
    let checked = given
        .iter()
        .flat_map(|tree| places(tree, roots_of(tree, &at_hand, |_| true)));
    let checked: Vec<_> = checked.map(|place| (place, Arc::default())).collect();
    if checked.is_empty() {
        return Err(no_data(root));
    }
    let mut data = Data::load(Roots { checked, systems }, &limits, None);
    for loaded in data.all_mut() {
        list_targets(&loaded.place, &mut loaded.layer);
    }
    let evaluation = choose(&data, base)?.open(limits)?;
    drop(data);
    Ok(evaluation.reading(trees))
}

impl From<RunError> for Error {
    fn from(error: RunError) -> Self {
        Self::Open(error.to_string())
    }
}

/// The base asked for, through the layers that show most of it.
fn choose<'a>(data: &'a Data<'_>, base: Option<&str>) -> Result<Openable<'a>, Error> {
    let mut bodies: Vec<(Openable<'a>, Role)> = Vec::new();
    for Stack { root, seen } in data.stacks() {
        for (application, layers) in seen {
            let role = root.role_in(application).unwrap_or(Role::User);
            bodies.extend(
                openable(application, layers)
                    .into_iter()
                    .map(|body| (body, role)),
            );
        }
    }
    let known: BTreeSet<&str> = bodies.iter().map(|(body, _)| body.name).collect();
    let list = || known.iter().map(|name| (*name).to_owned()).collect();
    let name = match (base, known.first()) {
        (Some(name), _) if known.contains(name) => name,
        (Some(name), _) => {
            let nearest = nearest(name, known.iter().copied()).map(str::to_owned);
            return Err(Error::UnknownBase {
                name: name.to_owned(),
                nearest,
                known: list(),
            });
        }
        (None, Some(only)) if known.len() == 1 => only,
        (None, _) => {
            let with_macros = bodies
                .iter()
                .filter(|(body, _)| body.has_macros())
                .map(|(body, _)| body.name);
            let with_macros = with_macros
                .collect::<BTreeSet<_>>()
                .into_iter()
                .map(str::to_owned)
                .collect();
            return Err(Error::BaseNeeded {
                known: list(),
                with_macros,
            });
        }
    };
    bodies.retain(|(body, _)| body.name == name);
    // A user folder is seen with the system data below it, so it is the fuller view.
    if bodies.iter().any(|(_, role)| *role != Role::System) {
        bodies.retain(|(_, role)| *role != Role::System);
    }
    match bodies.as_slice() {
        [(only, _)] => Ok(*only),
        several => Err(Error::SeveralRoots(
            several
                .iter()
                .map(|(body, _)| body.layers.checked.path.clone())
                .collect(),
        )),
    }
}
