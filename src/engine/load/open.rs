//! Opens one base mesh from data folders, as the application layers them, for `evaluate`.

use std::collections::BTreeSet;
use std::path::Path;

use super::data::Data;
use super::input::{open, open_system};
use super::layer::list_targets;
use super::roots::{Roots, checked_places};
use super::stack::Stack;
use crate::diag::nearest;
use crate::discover::Role;
use crate::engine::Error as RunError;
use crate::engine::catalogue::CHECKED;
use crate::evaluate::{Error, Evaluation};
use crate::repo::Layer;
use crate::repo::makehuman2::Base;
use crate::source::{Limits, Tree, slashed};

/// Opens a base of the data folder `root` (which lies over `system`, if given). Without `base` there must be only one.
///
/// # Errors
/// Folders that cannot be read or hold no data, a base that does not exist, an unusable `base.obj`.
pub fn open_base(root: &Path, system: Option<&Path>, base: Option<&str>) -> Result<Evaluation, Error> {
    let limits = Limits::default();
    let inputs = open(&[root.to_path_buf()])?;
    let judged = inputs.len();
    let mut trees: Vec<Tree> = inputs.into_iter().map(|input| input.tree).collect();
    trees.extend(system.map(open_system).transpose()?);
    let mut places = trees.iter().map(|tree| checked_places(tree, &CHECKED));
    let checked: Vec<_> = places.by_ref().take(judged).flatten().map(|place| (place, Vec::new())).collect();
    let below = places.next().map(|places| places.into_iter().next());
    if checked.is_empty() || matches!(below, Some(None)) {
        return Err(Error::NoData(slashed(system.filter(|_| !checked.is_empty()).unwrap_or(root))));
    }
    let mut data = Data::load(Roots { checked, system: below.flatten() }, &limits);
    for (loaded, _) in data.all_mut() {
        list_targets(&loaded.place, &mut loaded.layer);
    }
    let (name, stack) = choose(&data, base)?;
    let evaluation = Evaluation::of(&Base::resolve(&name, stack.0, stack.1), limits)?;
    drop(data);
    drop(places);
    Ok(evaluation.reading(trees))
}

impl From<RunError> for Error {
    fn from(error: RunError) -> Self {
        Self::Open(error.to_string())
    }
}

/// The base asked for, and the layers it is seen through.
fn choose<'a, 't>(data: &'a Data<'t>, base: Option<&str>) -> Result<(String, Stack<'a, 't>), Error> {
    let stacks = data.stacks();
    let known: BTreeSet<&str> = stacks.iter().flat_map(meshes).collect();
    let list = || known.iter().map(|name| (*name).to_owned()).collect();
    let name = match (base, known.first()) {
        (Some(name), _) if known.contains(name) => name.to_owned(),
        (Some(name), _) => {
            let nearest = nearest(name, known.iter().copied()).map(str::to_owned);
            return Err(Error::UnknownBase { name: name.to_owned(), nearest, known: list() });
        }
        (None, Some(only)) if known.len() == 1 => (*only).to_owned(),
        (None, _) => {
            let with_macros = stacks.iter().flat_map(|stack| with_macros(stack, &known)).collect::<BTreeSet<_>>();
            return Err(Error::BaseNeeded { known: list(), with_macros: with_macros.into_iter().collect() });
        }
    };
    let mut holding: Vec<Stack<'a, 't>> =
        stacks.into_iter().filter(|stack| meshes(stack).iter().any(|mesh| *mesh == name)).collect();
    // A user folder is seen with the system data below it, so it is the fuller view.
    if holding.iter().any(|(_, _, judged)| judged.role != Role::System) {
        holding.retain(|(_, _, judged)| judged.role != Role::System);
    }
    match holding.as_slice() {
        [only] => Ok((name, *only)),
        several => Err(Error::SeveralRoots(several.iter().map(|(_, _, judged)| judged.layer.path.clone()).collect())),
    }
}

fn layers<'a>(stack: &Stack<'a, '_>) -> Vec<&'a Layer> {
    [stack.0, stack.1].into_iter().flatten().collect()
}

/// Names of the bases that have a mesh.
fn meshes<'a>(stack: &Stack<'a, '_>) -> Vec<&'a str> {
    let files = layers(stack).into_iter().flat_map(|layer| layer.files.values());
    files.filter(|file| file.mesh().is_some()).filter_map(|file| file.base()).collect()
}

fn with_macros(stack: &Stack<'_, '_>, known: &BTreeSet<&str>) -> Vec<String> {
    let has = |name: &&&str| Base::resolve(name, stack.0, stack.1).macro_file().is_some();
    known.iter().filter(has).map(|name| (*name).to_owned()).collect()
}
