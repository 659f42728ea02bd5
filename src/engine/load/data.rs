//! The data roots of a run with their layers, and which lies over which.

use super::layer::{MeshSizes, load};
use super::place::Place;
use super::roots::Roots;
use super::stack::{Stack, roles, stacks};
use crate::discover::Role;
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
        let narrow = if self.place.is_loose { &[] } else { self.narrow.as_slice() };
        narrow.iter().map(String::as_str)
    }

    /// Whether a path is one that the PATHs ask for.
    pub(in crate::engine) fn is_asked_for(&self, path: &str) -> bool {
        self.narrow.is_empty() || self.narrow.iter().any(|narrow| is_below(path, narrow))
    }
}

impl<'t> Data<'t> {
    /// Reads everything but targets.
    pub(in crate::engine) fn load(roots: Roots<'t>, limits: &Limits) -> Self {
        let Roots { checked: places, system } = roots;
        let (system, system_sizes) = match system {
            Some(place) => {
                let (layer, sizes) = load(&place, limits, None);
                (Some(Loaded::new(place, layer, Role::System, Vec::new())), sizes)
            }
            None => (None, MeshSizes::new()),
        };
        let roles = roles(places.iter().map(|(place, _)| place));
        let mut places: Vec<_> =
            places.into_iter().zip(roles).map(|((place, narrow), role)| (place, narrow, role)).collect();
        // System data first: a user root may lack the meshes that its targets are for.
        places.sort_by_key(|(_, _, role)| *role != Role::System);
        let mut data = Self { system, roots: Vec::new(), sizes: Vec::new(), system_sizes };
        let mut below = data.system_sizes.clone();
        for (place, narrow, role) in places {
            let (layer, sizes) = load(&place, limits, Some(&below));
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

#[cfg(test)]
mod tests {
    use super::super::load_targets;
    use super::*;
    use crate::diag::Application;
    use crate::discover::{Kind, Layout};
    use crate::source::Tree;

    #[test]
    fn a_file_of_several_applications_is_read_once_with_the_mesh_of_its_base() {
        let files = [
            ("3dobjs/base.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n"),
            ("targets/target.json", "{}"),
            ("custom/a.target", "3 1 0 0\n4 1 0 0\n"),
            ("hair/a/a.mhclo", "name a\n"),
        ];
        let tree = Tree::in_memory("mine", files.map(|(path, text)| (path.to_owned(), text.as_bytes().to_vec())));
        let layouts = [Application::Mpfb, Application::Makehuman1].map(Layout::of);
        let checked = vec![(Place::new(&tree, "", &layouts), Vec::new())];
        let mut data = Data::load(Roots { checked, system: None }, &Limits::default());
        for (root, sizes) in data.all_mut() {
            load_targets(&root.place, &mut root.layer, Some("hm08"), sizes, &Limits::default(), false);
        }
        let root = data.roots.first().unwrap();
        assert_eq!((root.role, root.layer.files.len()), (Role::System, files.len()));
        let kind = |path: &str| root.layer.kind_at(path, Application::Mpfb);
        assert_eq!(kind("targets/target.json"), Kind::TargetCatalog);
        assert_eq!(kind("hair/a/a.mhclo"), Kind::Clothes);
        let target = root.layer.file("custom/a.target").unwrap();
        assert_eq!((target.uses.len(), target.base()), (2, Some("hm08")));
        assert_eq!(target.target().unwrap().out_of_range.count, 1);
    }
}
