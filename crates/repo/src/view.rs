//! The data of one application as it sees them.

use super::{
    Body, FileFacts, Gaps, Landmarks, Layers, MisnamedFolder, PictureFolders, Reference,
    References, Resolution, Shown, Surface, Target, Worn, makehuman1, makehuman2, mpfb,
};
use mhlint_diag::{Application, Version};
use mhlint_discover::{Kind, Layout, library_of, material_of};

/// Layers that were connected as an application does it.
#[derive(Debug)]
pub enum View<'a> {
    /// `MakeHuman` 2.
    Makehuman2(Box<makehuman2::View<'a>>),
    /// `MakeHuman` 1.
    Makehuman1(Box<makehuman1::View<'a>>),
    /// MPFB.
    Mpfb(Box<mpfb::View<'a>>),
}

impl<'a> View<'a> {
    /// Connects layers.
    pub fn connect(application: Application, layers: Layers<'a>) -> Self {
        match application {
            Application::Makehuman2 => {
                Self::Makehuman2(Box::new(makehuman2::View::connect(layers)))
            }
            Application::Makehuman1 => {
                Self::Makehuman1(Box::new(makehuman1::View::connect(layers)))
            }
            Application::Mpfb => Self::Mpfb(Box::new(mpfb::View::connect(layers))),
        }
    }

    fn makehuman2(&self) -> Option<&makehuman2::View<'a>> {
        if let Self::Makehuman2(view) = self {
            Some(view)
        } else {
            None
        }
    }

    /// Whose view it is.
    pub const fn application(&self) -> Application {
        match self {
            Self::Makehuman2(_) => Application::Makehuman2,
            Self::Makehuman1(_) => Application::Makehuman1,
            Self::Mpfb(_) => Application::Mpfb,
        }
    }

    /// Whether it is that of `MakeHuman` 1, which reads some formats otherwise than its successor.
    pub const fn is_makehuman1(&self) -> bool {
        matches!(self, Self::Makehuman1(_))
    }

    /// That of MakeHuman 1.
    pub fn as_makehuman1(&self) -> Option<&makehuman1::View<'a>> {
        if let Self::Makehuman1(view) = self {
            Some(view)
        } else {
            None
        }
    }

    /// Whether it is that of MPFB.
    pub const fn is_mpfb(&self) -> bool {
        matches!(self, Self::Mpfb(_))
    }

    /// Its layers.
    pub const fn layers(&self) -> Layers<'a> {
        match self {
            Self::Makehuman2(view) => view.layers,
            Self::Makehuman1(view) => view.layers,
            Self::Mpfb(view) => view.layers,
        }
    }

    /// How much of what its indexes name the data of a program lack.
    pub fn gaps(&self) -> Gaps<'_> {
        match self {
            Self::Makehuman2(view) => {
                let has = |rel: &str| view.layers.checked.file(rel).is_some();
                // Without the base mesh nothing leads to the folder of its targets.
                Gaps::of_references(&view.references, |one| {
                    one.meant().is_some()
                        || has(&one.rel)
                        || has(&format!("target/{}/{}", one.base, one.rel))
                })
            }
            Self::Makehuman1(view) => view.gaps(),
            Self::Mpfb(view) => Gaps::of_references(&view.references, |one| {
                !matches!(one.resolution, Resolution::Missing)
            }),
        }
    }

    /// Whether the data are a part of a program's, as ports take some: without base mesh, and
    /// without most of what their indexes name.
    pub fn is_partial(&self) -> bool {
        let layers = self.layers();
        // Indexes in `target/` are the program's, and are no sign of its data where the base mesh
        // or targets are a user's.
        let has_contarget = || layers.checked.below("contarget").next().is_some();
        let has_index = || {
            layers.system.is_none()
                && layers.checked.files.values().any(is_index)
                && !has_contarget()
        };
        let is_programs = layers.checks_system() || self.makehuman2().is_some() && has_index();
        let is_whole_place =
            is_programs && !layers.checked.is_loose && layers.checked.pack.is_none();
        let application = self.application();
        let has_mesh = || {
            layers
                .checked
                .files
                .values()
                .any(|file| file.kind_in(application).is_base_mesh())
        };
        is_whole_place && (!self.lacking().is_empty() || !has_mesh() && self.gaps().are_most())
    }

    /// The folders that a copy of a program's data lacks without which it can be none: ports take
    /// some and leave the rest.
    pub fn lacking(&self) -> Vec<&'static str> {
        let checked = self.layers().checked;
        let gone = |folders: &[&'static str]| -> Vec<&'static str> {
            folders
                .iter()
                .copied()
                .filter(|folder| checked.below(folder).next().is_none())
                .collect()
        };
        // Users have no macros in `target/`.
        let has_macros = || {
            checked
                .below("target")
                .any(|file| file.kind == Kind::MacroJson)
        };
        let lacking = match self.application() {
            // Before 1.1 some of it was not there yet.
            Application::Makehuman1 => {
                let is_copy =
                    |gone: &Vec<&str>| gone.len() >= FEWEST_GONE && !self.is_before("1.1");
                Some(gone(&NEEDED_BY_MAKEHUMAN1)).filter(is_copy)
            }
            Application::Makehuman2 => {
                let is_copy = |gone: &Vec<&str>| {
                    gone.contains(&"base") && gone.len() >= FEWEST_GONE && has_macros()
                };
                Some(gone(&NEEDED_BY_MAKEHUMAN2)).filter(is_copy)
            }
            Application::Mpfb => {
                Some(gone(&NEEDED_BY_MPFB)).filter(|gone| gone.len() >= FEWEST_GONE)
            }
        };
        lacking.unwrap_or_default()
    }

    /// Whether the data of a program are not what the newest one needs as a whole: a part of them,
    /// or so old that what is in them is only good piece by piece.
    pub fn is_in_pieces(&self) -> bool {
        self.is_partial()
            || self.layers().checks_system() && self.is_makehuman1() && self.is_before("1.1")
    }

    /// Whether the data are of a version of the application that is older than the one called so.
    pub fn is_before(&self, version: &str) -> bool {
        self.version().is_some_and(|own| own.is_before(version))
    }

    /// The version of the application that the data are of, if something says so.
    pub fn version(&self) -> Option<Version> {
        self.layers().version(self.application())
    }

    /// What an application makes of paths.
    pub const fn layout(&self) -> &'static Layout {
        Layout::of(self.application())
    }

    /// What the file at a path of the checked layer is for, or would be if there were one.
    pub fn kind_at(&self, rel: &str) -> Kind {
        self.layers().checked.kind_at(rel, self.application())
    }

    /// The files of the checked layer, but for those that other applications alone have as what
    /// they are read as, and those at which nobody looks yet.
    pub fn files(&self) -> impl Iterator<Item = &'a FileFacts> + use<'a> {
        let application = self.application();
        let is_own = move |file: &&FileFacts| {
            file.kind_in(application) == file.kind && looks_at(application, file.kind)
        };
        self.layers().checked.files.values().filter(is_own)
    }

    /// Whether files of this kind are looked at.
    pub fn looks_at(&self, kind: Kind) -> bool {
        looks_at(self.application(), kind)
    }

    /// Everything that names a file, and what it leads to.
    pub const fn references(&self) -> &References<'a> {
        match self {
            Self::Makehuman2(view) => &view.references,
            Self::Makehuman1(view) => &view.references,
            Self::Mpfb(view) => &view.references,
        }
    }

    /// Its bodies.
    pub fn bodies(&self) -> Vec<Body<'_>> {
        let mut bodies = match self {
            Self::Makehuman2(view) => view.bodies(self),
            Self::Makehuman1(view) => vec![view.body(self)],
            Self::Mpfb(view) => view.body(self).into_iter().collect(),
        };
        self.share_slider_ends(&mut bodies);
        bodies
    }

    /// Whether a list of the application would show a file, of those that do not follow links to
    /// folders.
    pub fn lists(&self, file: &FileFacts) -> bool {
        match self {
            Self::Makehuman1(_) => {
                library_of(&file.rel).is_some() || makehuman1::is_own_target(&file.rel)
            }
            Self::Mpfb(_) => !matches!(
                file.kind_in(Application::Mpfb),
                Kind::Other | Kind::Image | Kind::Json
            ),
            Self::Makehuman2(_) => false,
        }
    }

    /// Whether some body has more macros than are compared with one another.
    pub fn has_too_many_macros(&self) -> bool {
        match self {
            Self::Makehuman2(view) => view.bases.iter().any(makehuman2::Base::has_too_many_macros),
            Self::Mpfb(view) => view.parts.as_ref().is_some_and(|parts| parts.is_too_large),
            Self::Makehuman1(_) => false,
        }
    }

    /// Folders of the checked layer in which that of a base mesh is left out, each with a file that
    /// shows it.
    pub fn unsorted(&self) -> Vec<(&'static str, &'a FileFacts)> {
        self.makehuman2()
            .map(|view| view.unsorted().collect())
            .unwrap_or_default()
    }

    /// Folders of the checked layer that are not read because of their capitals.
    pub fn misnamed_folders(&self) -> Vec<MisnamedFolder> {
        match self {
            Self::Makehuman2(view) => view.misnamed_folders(),
            Self::Mpfb(view) => view.misnamed_folders(),
            Self::Makehuman1(_) => Vec::new(),
        }
    }

    /// Where on a body the vertices of a mesh are: the mesh of a body, or any other with its groups
    /// alone. `None` where its lines cannot be read.
    pub fn landmarks<'m>(&'m self, file: &'m FileFacts) -> Option<Landmarks<'m>> {
        let of_body = self.makehuman2().and_then(|view| view.landmarks(file));
        let mesh = || file.mesh().filter(|mesh| mesh.facts.unreadable_lines == 0);
        of_body.or_else(|| Some(Landmarks::of(mesh()?, None, |_| true)))
    }

    /// The names of its bodies.
    pub fn body_names(&self) -> Vec<&'a str> {
        match self {
            Self::Makehuman2(view) => view.bases.iter().map(|base| base.name).collect(),
            Self::Makehuman1(view) => view.body_name().into_iter().collect(),
            Self::Mpfb(view) => view.body_name().into_iter().collect(),
        }
    }

    /// What is known of a target of the checked layer.
    pub fn target<'v>(&'v self, file: &'v FileFacts) -> Target<'v> {
        match self {
            Self::Makehuman2(view) => view.target(file),
            Self::Mpfb(view) => view.target(file),
            Self::Makehuman1(view) => view.target(file),
        }
    }

    /// A setting at which a target is applied fully; `None` if nothing uses it, or nobody can tell.
    pub(super) fn shown_at(&self, file: &FileFacts) -> Option<Shown<'a>> {
        self.makehuman2()?.shown_at(file)
    }

    /// Where the picture that a material names is looked for, if that is known.
    pub fn picture_folders<'r>(&self, reference: &Reference<'r>) -> Option<PictureFolders<'r>> {
        self.makehuman2()
            .and_then(|_| makehuman2::picture_folders(reference.from, reference.base))
    }

    /// The materials that it opens, of all layers.
    pub fn surfaces(&self) -> &[Surface<'a>] {
        match self {
            Self::Makehuman2(view) => &view.surfaces,
            Self::Makehuman1(view) => &view.surfaces,
            Self::Mpfb(_) => &[],
        }
    }

    /// The materials of the checked layer, where they are read line by line as one word and all
    /// that is behind it.
    pub fn looks(&self) -> &[mpfb::Look<'a>] {
        if let Self::Mpfb(view) = self {
            &view.looks
        } else {
            &[]
        }
    }

    /// Whether a material at this path is offered for assets.
    pub fn offers_material_at(&self, rel: &str) -> bool {
        self.makehuman2().is_some()
            && material_of(rel).is_some_and(|material| material.folder != "skins")
    }

    /// The assets of all layers, sorted by base.
    pub fn assets(&self) -> &[Worn<'a>] {
        match self {
            Self::Makehuman2(view) => &view.worn,
            Self::Makehuman1(view) => &view.worn,
            Self::Mpfb(view) => view.worn(),
        }
    }

    /// Whether the application makes the file at this path of the checked layer itself.
    pub fn is_generated(&self, rel: &str) -> bool {
        self.makehuman2().is_some_and(|view| view.is_generated(rel))
    }

    /// Whether the faces of a group are drawn; true where nobody can tell.
    pub fn draws(&self, mesh: &FileFacts, group: &str) -> bool {
        self.makehuman2().is_none_or(|view| view.draws(mesh, group))
    }

    /// Whether the application reads another file in place of what is at this path of the checked
    /// layer.
    pub fn is_replaced(&self, rel: &str) -> bool {
        self.makehuman2().is_some_and(|view| view.is_replaced(rel))
    }

    /// Whether the application does as well without this file.
    pub fn does_without(&self, file: &FileFacts) -> bool {
        self.makehuman2()
            .is_some_and(|view| view.does_without(file))
    }

    /// Whether the application composes the name of a target out of others, so that no file has it.
    pub fn composes_name_of(&self, file: &FileFacts) -> bool {
        if let Self::Mpfb(view) = self {
            view.asks_for(file)
        } else {
            false
        }
    }

    /// Whether other files know what a reference belongs to by the name that it writes, so that the
    /// name has to stay.
    pub fn is_known_by(&self, reference: &Reference<'_>) -> bool {
        // Of the others nobody can tell yet: the name stays.
        self.makehuman2()
            .is_none_or(|view| view.is_known_by(reference))
    }
}

/// The folders without which `MakeHuman` 1 does not work as it should.
const NEEDED_BY_MAKEHUMAN1: [&str; 9] = [
    "3dobjs",
    "modifiers",
    "targets",
    "rigs",
    "poseunits",
    "shaders",
    "eyes",
    "scenes",
    "skins",
];
/// The same of `MakeHuman` 2, the first one for its base meshes.
const NEEDED_BY_MAKEHUMAN2: [&str; 5] = ["base", "clothes", "rigs", "skins", "shaders"];
/// The same of the add-on.
const NEEDED_BY_MPFB: [&str; 6] = [
    "3dobjs",
    "mesh_metadata",
    "node_trees",
    "rigs",
    "settings",
    "targets",
];
/// A damaged folder lacks one or two of them.
const FEWEST_GONE: usize = 3;

/// Whether it names the targets of a base mesh where only the program has such files.
fn is_index(file: &FileFacts) -> bool {
    matches!(file.kind, Kind::MacroJson | Kind::ModellingJson) && file.rel.starts_with("target/")
}

/// Of `MakeHuman` 1 and MPFB not all kinds are checked.
const fn looks_at(application: Application, kind: Kind) -> bool {
    match application {
        Application::Makehuman2 => true,
        // Skeletons and poses of MakeHuman are nothing to it.
        Application::Mpfb => !matches!(kind, Kind::Skeleton | Kind::Pose),
        Application::Makehuman1 => makehuman1::is_checked(kind),
    }
}
