//! The data roots of a run with their layers, and which lies over which.

use super::identify::identify;
use super::layer::{MeshSizes, Reader, load, read_all, size_for};
use super::narrow::Narrow;
use super::place::{Place, PlaceKey};
use super::roots::Roots;
use super::stack::{Around, Roles, roles};
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use mhlint_config::Config;
use mhlint_diag::Application;
use mhlint_discover::{Candidate, Layout, Role};
use mhlint_evaluate::Rows;
use mhlint_formats::target::MeshSize;
use mhlint_repo::{FileFacts, Layer};
use mhlint_source::{Limits, Tree};

/// A data root with its facts.
pub(crate) struct Loaded<'t> {
    pub(crate) place: Place<'t>,
    pub(crate) layer: Layer,
    /// The parts that it plays.
    pub(super) roles: Roles,
    /// The applications of which it is the data as those of `--system` are, so that these do not
    /// lie below it.
    pub(super) alone: Vec<Application>,
    /// Sizes of the meshes in it, and of those below it that something in it belongs to.
    sizes: MeshSizes,
    narrow: Arc<Narrow>,
}

/// All data of a run.
pub(crate) struct Data<'t> {
    /// `--system`: read, not checked.
    pub(crate) systems: Vec<Loaded<'t>>,
    /// The roots to check.
    pub(crate) roots: Vec<Loaded<'t>>,
    /// For each application the sizes of the meshes that may lie below a root: those of the system
    /// data that was given for it, else of what was read that is the system.
    below: BTreeMap<Application, MeshSizes>,
    /// Numbers of all roots, those of systems first.
    numbers: BTreeMap<PlaceKey, Vec<usize>>,
    pub(super) around: Around,
}

impl<'t> Loaded<'t> {
    /// Reads a data root; `below` are the meshes of those that may lie below it.
    fn load(
        place: Place<'t>,
        roles: Roles,
        narrow: Arc<Narrow>,
        below: MeshSizes,
        reader: Reader<'_>,
    ) -> Self {
        let (layer, sizes) = load(&place, reader, below);
        Self {
            place,
            layer,
            roles,
            alone: Vec::new(),
            sizes,
            narrow,
        }
    }

    /// The part that it plays for an application, if it is a data root of that one.
    pub(super) fn role_in(&self, application: Application) -> Option<Role> {
        self.roles
            .iter()
            .find(|(other, _)| *other == application)
            .map(|(_, role)| *role)
    }

    fn is_system_for(&self, application: Application) -> bool {
        self.role_in(application) == Some(Role::System)
    }

    /// What alone is asked for of a data root. A loose file is a whole.
    pub(crate) fn parts(&self) -> Option<&Arc<Narrow>> {
        (!self.place.is_loose).then_some(&self.narrow)
    }

    /// Whether the mesh that a file belongs to is known.
    pub(crate) fn has_mesh_for(&self, file: &FileFacts) -> bool {
        file.base()
            .is_some_and(|base| self.sizes.contains_key(base))
    }

    /// Whether a path is one that the PATHs ask for.
    pub(crate) fn is_asked_for(&self, path: &str) -> bool {
        self.narrow.asks_for(path)
    }

    /// Reads the bulk of one base (`None`: of no base): its targets. Gives their rows if they are
    /// to be kept. What is the same in `other` is taken from there, with rows from `keep_rows`.
    pub(crate) fn load_targets(
        &mut self,
        base: Option<&str>,
        limits: &Limits,
        other: Option<&Data<'_>>,
        keep_rows: Option<&Rows>,
    ) -> Rows {
        let other = other.and_then(|other| other.counterpart(&self.place));
        let bulk = self.place.bulk_of(base).collect();
        let (files, rows) = read_all(
            self.place.tree,
            bulk,
            Reader { limits, other },
            &self.sizes,
            keep_rows,
        );
        self.layer.add(files);
        rows
    }

    /// The facts of a file that is the same in another tree, where it is for a mesh of this size.
    pub(super) fn shared(
        &self,
        tree: &Tree,
        file: &Candidate<'_>,
        size: Option<MeshSize>,
        limits: &Limits,
    ) -> Option<FileFacts> {
        let at = self
            .place
            .below
            .binary_search_by(|own| own.rel.as_ref().cmp(file.rel.as_ref()))
            .ok()?;
        let own = self.place.below.get(at)?;
        let is_same = size_for(own, &self.sizes) == size
            && own.uses == file.uses
            && own.entry.path == file.entry.path
            && own.entry.link_to == file.entry.link_to
            && self.place.tree.shares(&file.entry.path, tree, limits);
        if is_same {
            self.layer.file(&file.rel).cloned()
        } else {
            None
        }
    }
}

impl<'t> Data<'t> {
    /// Reads everything but targets. What is the same in `other` is taken from there.
    pub(crate) fn load(roots: Roots<'t>, limits: &Limits, other: Option<&Data<'_>>) -> Self {
        let reader = |place: &Place<'_>| Reader {
            limits,
            other: other.and_then(|other| other.counterpart(place)),
        };
        let Roots {
            checked: places,
            systems,
        } = roots;
        let as_system = |place: Place<'t>| {
            let roles = place
                .layouts
                .iter()
                .map(|layout| (layout.application, Role::System))
                .collect();
            let reader = reader(&place);
            Loaded::load(place, roles, Arc::default(), MeshSizes::new(), reader)
        };
        let systems: Vec<Loaded<'t>> = systems.into_iter().map(as_system).collect();
        let mut below = BTreeMap::new();
        for system in &systems {
            for (application, _) in &system.roles {
                below.entry(*application).or_insert(system.sizes.clone());
            }
        }
        let roles = roles(&places.iter().map(|(place, _)| place).collect::<Vec<_>>());
        let mut places: Vec<_> = places.into_iter().zip(roles).collect();
        // System data first: a user root may lack the meshes that its targets are for.
        places.sort_by_key(|(_, roles)| roles.iter().all(|(_, role)| *role != Role::System));
        let mut data = Self {
            systems,
            roots: Vec::new(),
            below,
            numbers: BTreeMap::new(),
            around: Around::default(),
        };
        for ((place, narrow), roles) in places {
            for (place, roles) in data.with_one_mesh(place, roles) {
                let below = data.meshes_below(&place.owners(), &roles);
                let reader = reader(&place);
                let mut root = Loaded::load(place, roles, Arc::clone(&narrow), below, reader);
                root.alone = data.alone(&root);
                data.add(root);
            }
        }
        for (number, root) in data.systems.iter().chain(&data.roots).enumerate() {
            let known = data.numbers.entry(root.place.key()).or_default();
            known.push(number);
        }
        data.around = Around::of(&data.roots);
        data
    }

    fn add(&mut self, root: Loaded<'t>) {
        let is_system = |one: &Application| root.is_system_for(*one) && self.given(*one).is_none();
        let own = root.roles.iter().map(|(application, _)| *application);
        for application in own.filter(is_system).collect::<Vec<_>>() {
            let below = self.below.entry(application).or_default();
            below.extend(root.sizes.iter().map(|(name, mesh)| (name.clone(), *mesh)));
        }
        self.roots.push(root);
    }

    /// Says of each root what its applications take it for.
    pub(crate) fn identify(&mut self, options: &Config) {
        self.all_mut().for_each(|root| identify(root, options));
    }

    /// A root as it is, or once for each of its applications where these have other base meshes
    /// below it: what is counted while a file is read depends on the mesh.
    fn with_one_mesh(&self, place: Place<'t>, roles: Roles) -> Vec<(Place<'t>, Roles)> {
        let owners = place.owners();
        let below: Vec<MeshSizes> = roles
            .iter()
            .map(|role| self.meshes_below(&owners, std::slice::from_ref(role)))
            .collect();
        let differ = |one: &MeshSizes, other: &MeshSizes| {
            one.iter()
                .any(|(name, mesh)| other.get(name).is_some_and(|other| other.size != mesh.size))
        };
        let is_one = !below
            .iter()
            .any(|one| below.iter().any(|other| differ(one, other)));
        if is_one || place.is_supposed() {
            return vec![(place, roles)];
        }
        roles
            .into_iter()
            .map(|role| (place.of_one(role.0), vec![role]))
            .collect()
    }

    /// The applications of which a root is the data as those of `--system` are.
    fn alone(&self, root: &Loaded<'_>) -> Vec<Application> {
        let stands_alone = |one: &Application| {
            let has_base = |given: &Loaded<'_>| {
                root.place
                    .stands_alone(*one, |base| given.sizes.contains_key(base))
            };
            // With things of a user beside it, it is no less the program's.
            let is_copied =
                || root.role_in(*one) == Some(Role::Both) && !Layout::of(*one).beside.is_empty();
            (root.is_system_for(*one) || is_copied()) && self.given(*one).is_some_and(has_base)
        };
        root.roles
            .iter()
            .map(|(application, _)| *application)
            .filter(stands_alone)
            .collect()
    }

    /// Sizes of the meshes of these names that may lie below a root.
    fn meshes_below(&self, names: &BTreeSet<&str>, roles: &[(Application, Role)]) -> MeshSizes {
        let below = roles.iter().filter_map(|(one, _)| self.below.get(one));
        let sizes = below.flat_map(|below| {
            let known = |name: &&str| Some(((*name).to_owned(), *below.get(*name)?));
            names.iter().filter_map(known)
        });
        sizes.collect()
    }

    /// Every root, those of systems first.
    pub(crate) fn all_mut(&mut self) -> impl Iterator<Item = &mut Loaded<'t>> {
        self.systems.iter_mut().chain(&mut self.roots)
    }

    /// Paths of the files that a bug of ours kept from being read.
    pub(crate) fn failed_files(&self) -> Vec<String> {
        let files = self.all().flat_map(|root| root.layer.files.values());
        files
            .filter(|file| file.failed)
            .map(|file| file.path.clone())
            .collect()
    }

    /// The root at the same place as one on the other side of a comparison.
    fn counterpart(&self, place: &Place<'_>) -> Option<&Loaded<'t>> {
        self.all().nth(*self.numbers.get(&place.key())?.first()?)
    }

    /// The numbers of those of the roots to check that are at such a place.
    pub(crate) fn counterparts(&self, place: &Place<'_>) -> impl Iterator<Item = usize> {
        let numbers = self.numbers.get(&place.key()).into_iter().flatten();
        numbers.filter_map(|number| number.checked_sub(self.systems.len()))
    }

    /// Every root, those of systems first.
    pub(crate) fn all(&self) -> impl Iterator<Item = &Loaded<'t>> {
        self.systems.iter().chain(&self.roots)
    }
}

#[cfg(test)]
mod tests {
    use super::super::stack::Stack;
    use super::*;
    use mhlint_discover::{Kind, Layout};
    use mhlint_source::Tree;

    #[test]
    fn a_file_of_several_applications_is_read_once_with_the_mesh_of_its_base() {
        let files = [
            (
                "3dobjs/base.obj",
                "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n",
            ),
            ("targets/target.json", "{}"),
            ("custom/a.target", "3 1 0 0\n4 1 0 0\n"),
            ("hair/a/a.mhclo", "name a\n"),
        ];
        let tree = Tree::in_memory(
            "mine",
            files.map(|(path, text)| (path.to_owned(), text.as_bytes().to_vec())),
        );
        let layouts = [Application::Mpfb, Application::Makehuman1].map(Layout::of);
        let checked = vec![(Place::new(&tree, "", &layouts), Arc::default())];
        let mut data = Data::load(
            Roots {
                checked,
                systems: Vec::new(),
            },
            &Limits::default(),
            None,
        );
        data.all_mut()
            .for_each(|root| drop(root.load_targets(Some("hm08"), &Limits::default(), None, None)));
        let root = data.roots.first().unwrap();
        let roles = [
            (Application::Makehuman1, Role::User),
            (Application::Mpfb, Role::System),
        ];
        assert_eq!(
            (root.roles.as_slice(), root.layer.files.len()),
            (&roles[..], files.len())
        );
        let kind = |path: &str| root.layer.kind_at(path, Application::Mpfb);
        assert_eq!(kind("targets/target.json"), Kind::TargetCatalog);
        assert_eq!(kind("hair/a/a.mhclo"), Kind::Clothes);
        let target = root.layer.file("custom/a.target").unwrap();
        assert_eq!((target.uses.len(), target.base()), (2, Some("hm08")));
        assert_eq!(target.target().unwrap().out_of_range.count, 1);
    }

    #[test]
    fn a_root_lies_over_the_system_of_its_own_application() {
        let tree = |label: &str, files: &[&str]| {
            Tree::in_memory(
                label,
                files
                    .iter()
                    .map(|path| ((*path).to_owned(), b"{}".to_vec())),
            )
        };
        let system = tree("system", &["base/b/base.json", "mpfb/targets/target.json"]);
        let own = tree(
            "own",
            &[
                "a/target/b/x/a.target",
                "c/targets/target.json",
                "d/custom/a.target",
            ],
        );
        let place = |tree, root, application| Place::new(tree, root, &[Layout::of(application)]);
        let systems = vec![place(&system, "", Application::Makehuman2)];
        let checked = [
            ("a", Application::Makehuman2),
            ("c", Application::Mpfb),
            ("d", Application::Mpfb),
        ];
        let checked = checked
            .map(|(root, application)| (place(&own, root, application), Arc::default()))
            .into();
        let data = Data::load(Roots { checked, systems }, &Limits::default(), None);
        let seen = |stack: &Stack<'_, '_>| {
            let path =
                |layer: Option<&Layer>| layer.map(|layer| layer.path.clone()).unwrap_or_default();
            let [(_, layers)] = stack.seen.as_slice() else {
                return Default::default();
            };
            (path(layers.system), path(layers.user))
        };
        let mut all: Vec<(String, String)> = data.stacks().iter().map(seen).collect();
        all.sort();
        let expected = [("own/c", ""), ("own/c", "own/d"), ("system", "own/a")];
        assert_eq!(
            all,
            expected.map(|(system, user)| (system.to_owned(), user.to_owned()))
        );
    }

    #[test]
    fn a_root_of_two_applications_has_the_meshes_of_both_systems() {
        let mesh = b"v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n".as_slice();
        let tree = |label: &str, files: &[(&str, &[u8])]| {
            Tree::in_memory(
                label,
                files
                    .iter()
                    .map(|(path, bytes)| ((*path).to_owned(), bytes.to_vec())),
            )
        };
        let given = tree("given", &[("base/b/base.obj", mesh)]);
        let found = tree(
            "found",
            &[("3dobjs/base.obj", mesh), ("targets/target.json", b"{}")],
        );
        let both = tree(
            "both",
            &[("target/b/x/a.target", b""), ("custom/a.target", b"")],
        );
        let layouts = [Application::Makehuman2, Application::Mpfb].map(Layout::of);
        let [of_given, of_found] = layouts;
        let systems = vec![Place::new(&given, "", &[of_given])];
        let checked = vec![
            (Place::new(&both, "", &layouts), Arc::default()),
            (Place::new(&found, "", &[of_found]), Arc::default()),
        ];
        let data = Data::load(Roots { checked, systems }, &Limits::default(), None);
        let root = data
            .roots
            .iter()
            .find(|root| root.layer.path == "both")
            .unwrap();
        assert_eq!(
            root.sizes.keys().map(String::as_str).collect::<Vec<_>>(),
            ["b", "hm08"]
        );
    }
}
