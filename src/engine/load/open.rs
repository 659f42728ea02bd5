//! Opens one base mesh from data folders, as the application layers them, for `evaluate`.

use std::collections::BTreeSet;
use std::path::Path;

use super::data::Data;
use super::input::{open, open_system};
use super::layer::list_targets;
use super::roots::{Roots, checked_places, system_places};
use crate::diag::{Application, nearest};
use crate::discover::Role;
use crate::engine::Error as RunError;
use crate::engine::catalogue::CHECKED;
use crate::evaluate::{Error, Evaluation};
use crate::repo::makehuman2::Base;
use crate::repo::{Layer, Layers};
use crate::source::{Limits, Tree, slashed};

/// Opens a base of the data folder `root` (which lies over `system`, if given). Without `base` there must be only one.
///
/// # Errors
/// Folders that cannot be read or hold no data, a base that does not exist, an unusable `base.obj`.
pub fn open_base(root: &Path, system: Option<&Path>, base: Option<&str>) -> Result<Evaluation, Error> {
    let limits = Limits::default();
    let inputs = open(&[root.to_path_buf()], &CHECKED)?;
    let judged = inputs.len();
    let mut trees: Vec<Tree> = inputs.into_iter().map(|input| input.tree).collect();
    trees.extend(system.map(open_system).transpose()?);
    let (given, below) = trees.split_at(judged);
    let checked: Vec<_> =
        given.iter().flat_map(|tree| checked_places(tree, &CHECKED)).map(|place| (place, Vec::new())).collect();
    let no_data = |path: &Path| Error::NoData(slashed(path));
    if checked.is_empty() {
        return Err(no_data(root));
    }
    let systems = below.iter().map(|tree| system_places(tree, &CHECKED)).collect::<Result<Vec<_>, _>>();
    let systems = systems.map_err(|_| no_data(system.unwrap_or(root)))?.into_iter().flatten().collect();
    let mut data = Data::load(Roots { checked, systems }, &limits);
    for loaded in data.all_mut() {
        list_targets(&loaded.place, &mut loaded.layer);
    }
    let (name, stack) = choose(&data, base)?;
    let evaluation = Evaluation::of(&Base::resolve(&name, stack.0.system, stack.0.user), limits)?;
    drop(data);
    Ok(evaluation.reading(trees))
}

impl From<RunError> for Error {
    fn from(error: RunError) -> Self {
        Self::Open(error.to_string())
    }
}

/// A base of MakeHuman 2 with its layers, and the part that its root plays.
type Seen<'a> = (Layers<'a>, Role);

/// The base asked for, and the layers it is seen through.
fn choose<'a>(data: &'a Data<'_>, base: Option<&str>) -> Result<(String, Seen<'a>), Error> {
    let stacks: Vec<Seen<'a>> = data
        .stacks()
        .into_iter()
        .flat_map(|stack| {
            let role = stack.root.role_in(Application::Makehuman2);
            stack.seen.into_iter().filter_map(move |(_, layers)| Some((layers, role?)))
        })
        .collect();
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
    let mut holding: Vec<Seen<'a>> =
        stacks.into_iter().filter(|stack| meshes(stack).iter().any(|mesh| *mesh == name)).collect();
    // A user folder is seen with the system data below it, so it is the fuller view.
    if holding.iter().any(|(_, role)| *role != Role::System) {
        holding.retain(|(_, role)| *role != Role::System);
    }
    match holding.as_slice() {
        [only] => Ok((name, *only)),
        several => Err(Error::SeveralRoots(several.iter().map(|(layers, _)| layers.checked.path.clone()).collect())),
    }
}

fn layers<'a>(stack: &Seen<'a>) -> Vec<&'a Layer> {
    [stack.0.system, stack.0.user].into_iter().flatten().collect()
}

/// Names of the bases that have a mesh.
fn meshes<'a>(stack: &Seen<'a>) -> Vec<&'a str> {
    let files = layers(stack).into_iter().flat_map(|layer| layer.files.values());
    files.filter(|file| file.mesh().is_some()).filter_map(|file| file.base()).collect()
}

fn with_macros(stack: &Seen<'_>, known: &BTreeSet<&str>) -> Vec<String> {
    let has = |name: &&&str| Base::resolve(name, stack.0.system, stack.0.user).macro_file().is_some();
    known.iter().filter(has).map(|name| (*name).to_owned()).collect()
}
