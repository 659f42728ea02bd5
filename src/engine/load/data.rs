//! The data roots of a run with their layers, and which lies over which.

use super::layer::{MeshSizes, Place, load};
use super::stack::{Role, Stack, roles, stacks};
use crate::repo::Layer;
use crate::source::{Limits, is_below};

/// A data root with its facts.
pub(in crate::engine) struct Loaded<'t> {
    pub(in crate::engine) place: Place<'t>,
    pub(in crate::engine) layer: Layer,
    pub(in crate::engine) role: Role,
    narrow: Vec<String>,
}

/// All data of a run.
pub(in crate::engine) struct Data<'t> {
    /// `--system`: read, not judged.
    pub(in crate::engine) system: Option<Loaded<'t>>,
    /// The roots to judge.
    pub(in crate::engine) roots: Vec<Loaded<'t>>,
    /// Sizes of meshes, of each root with those below it.
    sizes: Vec<MeshSizes>,
    system_sizes: MeshSizes,
}

impl<'t> Loaded<'t> {
    fn new(place: Place<'t>, layer: Layer, role: Role, narrow: Vec<String>) -> Self {
        Self { place, layer, role, narrow }
    }

    /// The parts of a data root that alone are asked for; none for the whole of it. A loose file is a whole.
    pub(in crate::engine) fn parts(&self) -> impl Iterator<Item = &str> {
        let narrow = if self.place.moved.is_none() { self.narrow.as_slice() } else { &[] };
        narrow.iter().map(String::as_str)
    }

    /// Whether a path is one that the PATHs ask for.
    pub(in crate::engine) fn is_asked_for(&self, path: &str) -> bool {
        self.narrow.is_empty() || self.narrow.iter().any(|narrow| is_below(path, narrow))
    }
}

impl<'t> Data<'t> {
    /// Reads everything but targets.
    pub(in crate::engine) fn load(
        places: Vec<(Place<'t>, Vec<String>)>,
        system: Option<Place<'t>>,
        limits: &Limits,
    ) -> Self {
        let (system, system_sizes) = match system {
            Some(place) => {
                let (layer, sizes) = load(place, limits, None);
                (Some(Loaded::new(place, layer, Role::System, Vec::new())), sizes)
            }
            None => (None, MeshSizes::new()),
        };
        let roles = roles(&places.iter().map(|(place, _)| *place).collect::<Vec<_>>());
        let mut places: Vec<_> =
            places.into_iter().zip(roles).map(|((place, narrow), role)| (place, narrow, role)).collect();
        // System data first: a user root may lack the meshes that its targets are for.
        places.sort_by_key(|(_, _, role)| *role != Role::System);
        let mut data = Self { system, roots: Vec::new(), sizes: Vec::new(), system_sizes };
        let mut below = data.system_sizes.clone();
        for (place, narrow, role) in places {
            let (layer, sizes) = load(place, limits, Some(&below));
            if role == Role::System && data.system.is_none() {
                below.extend(sizes.clone());
            }
            data.sizes.push(sizes);
            data.roots.push(Loaded::new(place, layer, role, narrow));
        }
        data
    }

    /// The repositories to judge, in order of the roots.
    pub(in crate::engine) fn stacks(&self) -> Vec<Stack<'_, 't>> {
        stacks(&self.roots, self.system.as_ref().map(|system| &system.layer))
    }

    /// Every root, the system's first, with the sizes of its meshes.
    pub(in crate::engine) fn all_mut(&mut self) -> impl Iterator<Item = (&mut Loaded<'t>, &MeshSizes)> {
        let system = self.system.iter_mut().map(|system| (system, &self.system_sizes));
        system.chain(self.roots.iter_mut().zip(&self.sizes))
    }

    /// Paths of the files that a bug of ours kept from being read.
    pub(in crate::engine) fn failed_files(&self) -> Vec<String> {
        let files = self.all().flat_map(|root| root.layer.files.values());
        files.filter(|file| file.failed).map(|file| file.path.clone()).collect()
    }

    /// Every root, the system's first.
    pub(in crate::engine) fn all(&self) -> impl Iterator<Item = &Loaded<'t>> {
        self.system.iter().chain(&self.roots)
    }
}
