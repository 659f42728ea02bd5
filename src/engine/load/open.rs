//! Opens one base mesh from data folders, as the application layers them, for `evaluate`.

use std::collections::BTreeSet;
use std::path::Path;

use super::data::Data;
use super::input::{open, open_system};
use super::layer::{Place, list_targets};
use super::roots::roots_of;
use super::stack::{Role, Stack};
use crate::diag::{Application, nearest};
use crate::engine::Error as RunError;
use crate::evaluate::{Error, Evaluation};
use crate::repo::{Base, Layer};
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
    let roots: Vec<Vec<String>> = trees.iter().map(makehuman_2_roots).collect();
    let places: Vec<Vec<Place<'_>>> = trees.iter().zip(&roots).map(|(tree, roots)| places(tree, roots)).collect();
    let (own, below) = places.split_at(judged.min(places.len()));
    let own: Vec<_> = own.iter().flatten().map(|place| (*place, Vec::new())).collect();
    let below = below.first().map(|places| places.first().copied());
    if own.is_empty() || matches!(below, Some(None)) {
        return Err(Error::NoData(slashed(system.filter(|_| !own.is_empty()).unwrap_or(root))));
    }
    let mut data = Data::load(own, below.flatten(), &limits);
    for (loaded, _) in data.all_mut() {
        list_targets(loaded.place, &mut loaded.layer);
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

fn places<'t>(tree: &'t Tree, roots: &'t [String]) -> Vec<Place<'t>> {
    roots.iter().map(|root| Place { tree, root, moved: None }).collect()
}

fn makehuman_2_roots(tree: &Tree) -> Vec<String> {
    let roots = roots_of(tree).into_iter();
    roots.filter(|root| root.application == Application::Makehuman2).map(|root| root.path).collect()
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
    files.filter(|file| file.mesh().is_some()).filter_map(|file| file.base.as_deref()).collect()
}

fn with_macros(stack: &Stack<'_, '_>, known: &BTreeSet<&str>) -> Vec<String> {
    let has = |name: &&&str| Base::resolve(name, stack.0, stack.1).macro_file().is_some();
    known.iter().filter(has).map(|name| (*name).to_owned()).collect()
}
