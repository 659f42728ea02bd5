//! One base mesh with everything the application would load for it.

use std::collections::{BTreeMap, BTreeSet};

use super::foreign::{ForeignMesh, sign_of};
use super::intent::Intent;
use super::macro_folders::MacroFolders;
use super::misnamed::without_misnamed;
use super::rigs;
use super::slider::Opposites;
use super::{BoundSlider, Candidate, MeshFiles, OWN, Overlaid, Pattern, TargetFolder};
use crate::{FileFacts, Landmarks, Layers, Reference, Rig};
use mhlint_discover::Kind;
use mhlint_formats::Content;
use mhlint_formats::base_json::BaseJson;
use mhlint_formats::macro_json::MacroFile;
use mhlint_formats::mhskel::Skeleton;
use mhlint_formats::modelling::Modelling;
use mhlint_formats::obj::Mesh;
use mhlint_formats::target_cat::TargetCategories;

/// A base mesh over all layers.
#[derive(Debug)]
pub struct Base<'a> {
    /// Name of its folders.
    pub name: &'a str,
    /// Whether system data is at hand; without, names may lead to files that only it has.
    pub has_system: bool,
    /// `base.json`, user before system; the model only if it could be read.
    pub own_json: Option<(&'a FileFacts, Option<&'a BaseJson>)>,
    /// The files of the mesh.
    pub mesh_files: MeshFiles<'a>,
    /// The mesh that is read, if the application gets through it.
    pub mesh: Option<(&'a FileFacts, &'a Mesh)>,
    /// The same where the rest of the data is made for another mesh; then there is no mesh to judge
    /// by.
    pub foreign_mesh: Option<ForeignMesh<'a>>,
    /// `macro.json`.
    pub macros: Overlaid<'a, MacroFile>,
    /// The folders that its macro definitions name.
    pub macro_folders: MacroFolders,
    /// `modelling.json` without the user's additions.
    pub modelling: Overlaid<'a, Modelling>,
    /// `target_cat.json` without the user's additions.
    pub categories: Overlaid<'a, TargetCategories>,
    /// `target/<base>/modelling.json` of the user, merged on top key by key.
    pub user_modelling: Candidate<'a, Modelling>,
    /// `target/<base>/target_cat.json` of the user.
    pub user_categories: Candidate<'a, TargetCategories>,
    /// Where targets and their icons come from: the layer whose `macro.json` won. `None` when that
    /// would be the system's folder and no system data was given.
    pub targets: Option<TargetFolder<'a>>,
    /// The user's additional targets. `None` if one root plays both parts: its targets are the
    /// system's.
    pub user_targets: Option<TargetFolder<'a>>,
    /// Where entries with a `user` key come from, in one root as well.
    entry_targets: Option<TargetFolder<'a>>,
    /// The folder that lost, if there is one.
    pub other_targets: Option<TargetFolder<'a>>,
    /// All sliders as the application sees them.
    pub sliders: Vec<BoundSlider<'a>>,
    /// Numbers of the sliders by key.
    by_key: BTreeMap<&'a str, usize>,
    /// Numbers of the sliders by what they register; of several the last.
    by_pattern: BTreeMap<String, usize>,
    /// What the faulty sliders were meant to be.
    pub(super) intent: Intent<'a>,
    /// What `base.json` names: the skeleton for poses and the start model.
    pub named: Vec<Reference<'a>>,
    /// Skeletons in `rigs/<base>/` of all layers, strongest first, with their weights.
    pub rigs: Vec<Rig<'a>>,
    /// Weights in `rigs/<base>/` of all layers, strongest first.
    pub weights: Vec<&'a FileFacts>,
}

/// Names of all bases in the layers.
pub(super) fn base_names(layers: Layers<'_>) -> BTreeSet<&str> {
    let files = layers
        .strongest_first()
        .flat_map(|layer| layer.files.values());
    let names = files
        .filter(|file| {
            ["base/", "target/", "contarget/", "rigs/"]
                .iter()
                .any(|folder| file.rel.starts_with(folder))
        })
        .filter_map(|file| file.base_in(OWN))
        .collect();
    without_misnamed(layers, names)
}

/// A single root that does not hold a base is a user's folder as far as that base goes: the
/// system's part of it is elsewhere. A packed mesh alone is no base: it lies over one.
fn layers_of<'a>(base: &str, layers: Layers<'a>) -> Layers<'a> {
    let mut files = layers.checked.below(&format!("base/{base}"));
    let is_here = files.any(|file| file.kind_in(OWN) != Kind::MeshArchive);
    if layers.is_one_root() && !is_here {
        Layers {
            system: None,
            ..layers
        }
    } else {
        layers
    }
}

fn overlaid<'a, T>(
    layers: Layers<'a>,
    base: &str,
    file: &str,
    model: impl Fn(&'a Content) -> Option<&'a T>,
) -> Overlaid<'a, T> {
    Overlaid {
        contarget: Candidate::find(layers.user, &format!("contarget/{base}/{file}"), &model),
        system: match Candidate::find(layers.system, &format!("target/{base}/{file}"), &model) {
            // The program stops there; nothing inside can be checked.
            Candidate::Accepted(found, _) if found.is_misshapen() => Candidate::Refused(found),
            found => found,
        },
    }
}

/// Whether the application stops at a face of the mesh that it draws: one with too few corners.
pub(super) fn breaks_off(mesh: &Mesh, settings: Option<&BaseJson>) -> bool {
    let is_drawn = |group: &str| settings.is_none_or(|settings| settings.shows(group));
    mesh.facts
        .short_faces
        .iter()
        .any(|face| is_drawn(&face.group))
}

fn model_of_base(file: &FileFacts) -> Option<&BaseJson> {
    match &*file.content {
        Content::BaseJson(model) if !file.json.falsy && !file.is_misshapen() => Some(model),
        _ => None,
    }
}

fn model_of_modelling(content: &Content) -> Option<&Modelling> {
    if let Content::Modelling(model) = content {
        Some(model)
    } else {
        None
    }
}

fn model_of_categories(content: &Content) -> Option<&TargetCategories> {
    if let Content::Categories(model) = content {
        Some(model)
    } else {
        None
    }
}

/// The winner's sliders with the user's merged on top: an equal key replaces in place, others
/// follow. And where each key stands.
fn bind_sliders<'a>(
    modelling: &Overlaid<'a, Modelling>,
    user: &Candidate<'a, Modelling>,
    opposites: &Opposites<'_>,
) -> (Vec<BoundSlider<'a>>, BTreeMap<&'a str, usize>) {
    let mut sliders: Vec<BoundSlider<'a>> = Vec::new();
    let mut by_key: BTreeMap<&str, usize> = BTreeMap::new();
    for (file, model) in modelling.winner().into_iter().chain(user.accepted()) {
        for slider in &model.sliders {
            let pattern = Pattern::of(slider, opposites);
            let meant = slider
                .meant
                .as_ref()
                .map_or(Pattern::None, |meant| Pattern::of(meant, opposites));
            let bound = BoundSlider {
                slider,
                file,
                pattern,
                meant,
            };
            if let Some(place) = by_key
                .get(slider.key.as_str())
                .and_then(|at| sliders.get_mut(*at))
            {
                *place = bound;
            } else {
                by_key.insert(&slider.key, sliders.len());
                sliders.push(bound);
            }
        }
    }
    (sliders, by_key)
}

fn by_pattern(sliders: &[BoundSlider<'_>]) -> BTreeMap<String, usize> {
    let names = |(number, slider): (usize, &BoundSlider<'_>)| {
        slider
            .pattern
            .names()
            .iter()
            .map(move |name| (name.clone(), number))
            .collect::<Vec<_>>()
    };
    sliders.iter().enumerate().flat_map(names).collect()
}

impl<'a> Base<'a> {
    /// Resolves one base over layers.
    pub fn resolve(name: &'a str, layers: Layers<'a>) -> Self {
        let layers = layers_of(name, layers);
        let (system, user) = (layers.system, layers.user);
        // The `target/` folder of one root that plays both parts is the system's.
        let user_target = user.filter(|_| !layers.is_one_root());
        let own_json = layers
            .first_existing(&format!("base/{name}/base.json"))
            .map(|file| (file, model_of_base(file)));
        let macros = overlaid(layers, name, "macro.json", |content| match content {
            Content::Macro(model) => Some(model.as_ref()),
            _ => None,
        });
        let modelling = overlaid(layers, name, "modelling.json", model_of_modelling);
        let categories = overlaid(layers, name, "target_cat.json", model_of_categories);
        let user_modelling = Candidate::find(
            user_target,
            &format!("target/{name}/modelling.json"),
            model_of_modelling,
        );
        let user_categories = Candidate::find(
            user_target,
            &format!("target/{name}/target_cat.json"),
            model_of_categories,
        );
        let system_folder = system.map(|layer| TargetFolder {
            layer,
            folder: "target",
            base: name,
        });
        let contarget = user.map(|layer| TargetFolder {
            layer,
            folder: "contarget",
            base: name,
        });
        let (targets, other_targets) = if macros.is_overridden() {
            (contarget, system_folder.filter(TargetFolder::exists))
        } else {
            (system_folder, contarget.filter(TargetFolder::exists))
        };
        let opposites = own_json
            .and_then(|(_, model)| model)
            .map(|model| model.opposites.as_slice());
        let (sliders, by_key) = bind_sliders(
            &modelling,
            &user_modelling,
            &Opposites::of(opposites.unwrap_or_default()),
        );
        let in_rigs = |kind: Kind| {
            let below = layers
                .strongest_first()
                .flat_map(|layer| layer.below(&format!("rigs/{name}")));
            below.filter(move |file| file.kind_in(OWN) == kind)
        };
        let settings = own_json.and_then(|(file, model)| Some((file, model?)));
        let named = settings
            .map(|settings| rigs::named_by_settings(name, layers, settings))
            .unwrap_or_default();
        let rigs = rigs::rigs(name, layers, &named, in_rigs(Kind::Skeleton));
        let mesh_files = MeshFiles::of(name, layers);
        let mut base = Base {
            name,
            has_system: system.is_some(),
            own_json,
            mesh: mesh_files
                .sound()
                .filter(|(_, mesh)| !breaks_off(mesh, settings.map(|(_, settings)| settings))),
            mesh_files,
            foreign_mesh: None,
            macro_folders: macros
                .winner()
                .map(|(_, file)| MacroFolders::of(file))
                .unwrap_or_default(),
            macros,
            modelling,
            categories,
            user_modelling,
            user_categories,
            targets,
            user_targets: user_target.map(|layer| TargetFolder {
                layer,
                folder: "target",
                base: name,
            }),
            entry_targets: user.map(|layer| TargetFolder {
                layer,
                folder: "target",
                base: name,
            }),
            other_targets,
            by_key,
            by_pattern: by_pattern(&sliders),
            intent: Intent::default(),
            sliders,
            named,
            rigs,
            weights: in_rigs(Kind::Weights).collect(),
        };
        let foreign = base.mesh.and_then(|(file, mesh)| {
            Some(ForeignMesh {
                file,
                mesh,
                sign: sign_of(mesh, &base)?,
            })
        });
        if foreign.is_some() {
            (base.mesh, base.foreign_mesh) = (None, foreign);
        }
        base.intent = Intent::of(&base);
        base
    }

    /// The slider of a key.
    pub fn entry(&self, key: &str) -> Option<&BoundSlider<'a>> {
        self.sliders.get(*self.by_key.get(key)?)
    }

    /// The slider registered under a pattern; of several the last.
    pub fn slider(&self, pattern: &str) -> Option<&BoundSlider<'a>> {
        self.sliders.get(*self.by_pattern.get(pattern)?)
    }

    /// The folder a slider's targets come from.
    pub fn folder_of(&self, slider: &BoundSlider<'_>) -> Option<TargetFolder<'a>> {
        if slider.slider.user {
            self.entry_targets
        } else {
            self.targets
        }
    }

    /// Whether an entry has the key `user` in a file that people write for the system: its targets
    /// are looked for in the folder of whoever starts the program. In a file that is made of user
    /// targets every entry has it.
    pub fn is_marked_as_users(&self, bound: &BoundSlider<'_>) -> bool {
        let Some((file, model)) = self.modelling.system.accepted() else {
            return false;
        };
        bound.slider.user && std::ptr::eq(bound.file, file) && model.has_unmarked
    }

    /// Whether a target lies in a folder that a macro definition names.
    pub fn is_in_macro_folder(&self, file: &FileFacts) -> bool {
        let Some(name) = self
            .targets
            .as_ref()
            .and_then(|folder| folder.name_of(file))
        else {
            return false;
        };
        self.macro_folders.hold(name)
    }

    /// The rig that poses the base, if its skeleton could be read.
    pub fn pose_rig(&self) -> Option<(&Rig<'a>, &'a Skeleton)> {
        self.rigs
            .iter()
            .find(|rig| rig.is_default)
            .and_then(|rig| Some((rig, rig.skeleton()?)))
    }

    /// Where on the body its vertices are. `None` where lines of the mesh cannot be read: then they
    /// have other numbers.
    pub fn landmarks(&self) -> Option<Landmarks<'_>> {
        let (_, mesh) = self
            .mesh
            .filter(|(_, mesh)| mesh.facts.unreadable_lines == 0)?;
        let shown = self
            .settings()
            .and_then(|(_, settings)| settings.shown.as_ref());
        let is_shown = |group: &str| shown.is_none_or(|shown| shown.contains(group));
        Some(Landmarks::of(
            mesh,
            self.pose_rig().map(|(_, skeleton)| skeleton),
            is_shown,
        ))
    }

    /// The OBJ of the mesh: the mesh itself, or what lies beside an archive to be packed anew.
    pub fn obj(&self) -> Option<(&'a FileFacts, &'a Mesh)> {
        match self.mesh_files.archive() {
            Some(_) => self
                .mesh_files
                .beside()
                .and_then(|text| Some((text.file, text.sound()?))),
            None => self.mesh,
        }
    }

    /// The macro file in use.
    pub fn macro_file(&self) -> Option<(&'a FileFacts, &'a MacroFile)> {
        self.macros.winner()
    }

    /// Whether the macros are more than are checked.
    pub fn has_too_many_macros(&self) -> bool {
        self.macro_file()
            .is_some_and(|(_, macros)| macros.is_too_large)
    }

    /// `base.json`, if it could be read.
    pub fn settings(&self) -> Option<(&'a FileFacts, &'a BaseJson)> {
        self.own_json.and_then(|(file, model)| Some((file, model?)))
    }
}
