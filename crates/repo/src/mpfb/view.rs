//! The system data with their catalogue: MPFB looks for neither it nor its targets anywhere else
//! (`docs/loaders/mpfb/folders.md#lookups`).

use std::collections::BTreeSet;
use std::ops::Bound;

use super::looks::{Look, looks};
use super::loops::LOOPS;
use super::misplaced::Misplaced;
use super::named::{NamedFiles, NamedTargets};
use super::offered::is_of_lost_rig;
use super::parts::Parts;
use super::references::collect;
use super::rigs::{self, RigFile, RigPart};
use crate::misnamed_folder::{MisnamedFolder, misnamed_folders, top_in_other_case};
use crate::{
    Body, BodyWeights, Doubt, FileFacts, Layer, Layers, Reference, ReferenceKind, References, Rig,
    Target, WeightsUse, Worn,
};
use mhlint_diag::{Application, Place};
use mhlint_discover::{Kind, Layout, Refusal};
use mhlint_formats::macro_parts::SETTINGS;
use mhlint_formats::mesh_metadata::VertexGroups;
use mhlint_formats::mhclo;
use mhlint_formats::obj::Mesh;
use mhlint_formats::rig::Rig as Definition;
use mhlint_formats::target_catalog::{Category, TargetCatalog};
use mhlint_source::{is_below, parent};

/// Whose uses of a file count here.
pub(super) const OWN: Application = Application::Mpfb;

/// MPFB's data, connected.
#[derive(Debug)]
pub struct View<'a> {
    /// System and user data.
    pub layers: Layers<'a>,
    /// The sliders, if they can be read.
    pub catalog: Option<Catalog<'a>>,
    /// The parts of the macro settings, if they can be read.
    pub parts: Option<Parts<'a>>,
    /// The base mesh, if it can be read and its tables are for it.
    pub mesh: Option<(&'a FileFacts, &'a Mesh)>,
    /// A base mesh with fewer vertices than its tables are for, and both numbers: nothing can be
    /// said of its vertices.
    pub foreign_mesh: Option<(&'a FileFacts, usize, i64)>,
    /// Where the vertices of the base mesh lie otherwise than they should: nothing can be measured
    /// on it.
    pub misplaced: Option<Misplaced>,
    /// Everything that names a file, and what it leads to.
    pub references: References<'a>,
    /// Targets by their names.
    pub targets: NamedTargets<'a>,
    /// Files by their names.
    pub named: NamedFiles<'a>,
    /// Rigs of all layers.
    pub rigs: Vec<RigFile<'a>>,
    /// The vertex groups of the base mesh, if they can be read.
    pub groups: Option<&'a VertexGroups>,
    /// The same rigs as every application has them.
    body_rigs: Vec<Rig<'a>>,
    /// Materials of the checked layer.
    pub looks: Vec<Look<'a>>,
    /// What the body can wear.
    worn: Vec<Worn<'a>>,
    /// The same of another folder of the user: names lead there, too.
    worn_beside: Vec<Worn<'a>>,
    /// The targets in the slots of sliders, in small letters.
    slot_targets: BTreeSet<String>,
    /// The groups of the base mesh that are seen: helpers and joints are masked.
    shown: BTreeSet<String>,
    /// Endings of targets that move the body sideways.
    one_sided: Vec<String>,
}

/// The catalogue in its layer.
#[derive(Debug, Clone, Copy)]
pub struct Catalog<'a> {
    /// Where it lies.
    pub layer: &'a Layer,
    /// Its file.
    pub file: &'a FileFacts,
    /// Its sliders.
    pub sliders: &'a TargetCatalog,
}

/// Weights of rigs.
struct KnownWeights<'v> {
    /// The paths of those that some rig has.
    used: BTreeSet<&'v str>,
    /// Those that some rig looks for in vain, in small letters.
    wanted: BTreeSet<String>,
}

impl<'a> View<'a> {
    /// Connects layers.
    pub fn connect(layers: Layers<'a>) -> Self {
        let file = |kind| {
            layers
                .system?
                .files
                .values()
                .find(|file| file.kind_in(OWN) == kind)
        };
        let catalog = layers.system.zip(file(Kind::TargetCatalog));
        // Of what is no object at all nothing follows for its targets.
        let catalog = catalog.filter(|(_, file)| !file.is_misshapen());
        let catalog = catalog.and_then(|(layer, file)| {
            Some(Catalog {
                layer,
                file,
                sliders: file.catalog()?,
            })
        });
        let parts = layers
            .system
            .zip(file(Kind::MacroParts))
            .and_then(|(layer, file)| Parts::of(layer, file));
        let mesh = file(Kind::BaseMesh).and_then(|file| Some((file, file.mesh()?)));
        let needed = vertices_of_tables(file(Kind::MirrorTable), file(Kind::VertexGroups));
        let foreign_mesh = mesh
            .zip(needed)
            .filter(|((_, mesh), needed)| lacks_vertices(mesh, *needed));
        let foreign_mesh =
            foreign_mesh.map(|((file, mesh), needed)| (file, mesh.facts.vertices, needed));
        let mesh = mesh.filter(|_| foreign_mesh.is_none());
        let groups = file(Kind::VertexGroups).and_then(FileFacts::vertex_groups);
        let mirror = file(Kind::MirrorTable).and_then(FileFacts::mirror_table);
        let misplaced = mesh.and_then(|(_, mesh)| Misplaced::of(mesh, mirror, groups));
        let worn_beside = worn(layers.beside.into_iter());
        let worn = worn(layers.strongest_first());
        let looks = looks(layers.checked, &worn);
        let references = catalog
            .as_ref()
            .map(collect)
            .unwrap_or_default()
            .into_iter();
        let of_worn = worn
            .iter()
            .flat_map(|worn| worn.references.iter().flatten());
        let of_looks = looks.iter().flat_map(|look| &look.pictures);
        let references =
            References::new(references.chain(of_worn.chain(of_looks).cloned()).collect());
        let (targets, named) = (NamedTargets::of(layers), NamedFiles::of(layers));
        let rigs = rigs::all(layers);
        let shown = BTreeSet::from(["body".to_owned()]);
        let one_sided = ["-trans-in", "-trans-out"].map(str::to_owned).to_vec();
        Self {
            layers,
            slot_targets: catalog.as_ref().map(slot_targets).unwrap_or_default(),
            catalog,
            parts,
            mesh,
            foreign_mesh,
            misplaced,
            references,
            targets,
            named,
            body_rigs: rigs
                .iter()
                .filter(|rig| rig.part != RigPart::Asset)
                .map(body_rig)
                .collect(),
            rigs,
            groups,
            looks,
            worn,
            worn_beside,
            shown,
            one_sided,
        }
    }

    /// What the body can wear.
    pub fn worn(&self) -> &[Worn<'a>] {
        &self.worn
    }

    /// The files of a kind in the checked layer that were read.
    pub fn own(&self, kind: Kind) -> impl Iterator<Item = &'a FileFacts> {
        let files = self.layers.checked.files.values();
        files.filter(move |file| file.kind == kind && file.kind_in(OWN) == kind && !file.failed)
    }

    /// Whether both the system data and the user's folder, where what is named may lie, are at
    /// hand.
    pub fn is_complete(&self) -> bool {
        self.layers.system.is_some() && self.has_user()
    }

    /// The targets in the slots of sliders, there or not, in small letters.
    pub const fn slot_targets(&self) -> &BTreeSet<String> {
        &self.slot_targets
    }

    /// Whether the user's folder is at hand. What a file in place of one of its folders takes away
    /// is told there.
    pub fn has_user(&self) -> bool {
        let holds = |layer: &Layer| {
            !["targets", "custom", "expressions"]
                .iter()
                .any(|name| layer.file(name).is_some())
        };
        self.layers.user.or(self.layers.beside).is_some_and(holds)
    }

    /// The folders that differ in their capitals from those that are listed. Of the data of MPFB
    /// these are rigs, poses and UV layers: what else is missing there is told by the names of its
    /// files.
    pub fn misnamed_folders(&self) -> Vec<MisnamedFolder> {
        let layout = Layout::of(OWN);
        let is_own = self.layers.checks_system();
        let is_listed = |right: &str| !is_own || matches!(right, "rigs" | "poses" | "uv_layers");
        // That a zip is refused for its folder of lists is reported of the zip.
        let refusal = self
            .layers
            .checked
            .pack
            .as_ref()
            .and_then(|pack| pack.refusal.as_ref());
        let is_told =
            |rel: &str| matches!(refusal, Some(Refusal::Capitals(folder)) if is_below(rel, folder));
        let other = |rel| {
            let found = top_in_other_case(layout, rel).filter(|(_, right, _)| is_listed(right));
            found.filter(|_| !is_told(rel))
        };
        misnamed_folders(self.layers.checked, layout, other)
    }

    /// What the body can wear, that of another folder of the user included.
    pub fn worn_anywhere(&self) -> impl Iterator<Item = &Worn<'a>> {
        self.worn.iter().chain(&self.worn_beside)
    }

    /// The name of the base mesh, if there is anything for it.
    pub fn body_name(&self) -> Option<&'a str> {
        let of_catalog = self.catalog.and_then(|catalog| catalog.file.base_in(OWN));
        let of_mesh = self
            .mesh
            .and_then(|(file, _)| file.base_in(OWN))
            .or(of_catalog);
        // Without the data of MPFB the targets of a user are still for the one base mesh that there
        // is.
        let of_user = || {
            self.layers
                .checked
                .files
                .values()
                .find_map(|file| file.base_in(OWN))
        };
        of_mesh.or_else(of_user)
    }

    /// Whether a value of a setting leaves a character without any shape: all macro targets need
    /// the setting, and no part has the value. Without the data of MPFB its parts are taken for
    /// those that it brings, from -0.01 to 1.01
    /// (`docs/loaders/mpfb/macros.md#shares-of-a-setting`).
    pub fn leaves_no_shape(&self, setting: &str, value: f64) -> bool {
        let Some(place) = SETTINGS.iter().position(|known| *known == setting) else {
            return false;
        };
        let is_covered = self
            .parts
            .as_ref()
            .and_then(|parts| parts.cover(place, value))
            .unwrap_or(-0.01 < value && value < 1.01);
        LOOPS.iter().all(|own| own.needs(place)) && !is_covered
    }

    /// Whether MPFB composes the name of a target out of those of its macro settings.
    pub fn asks_for(&self, file: &FileFacts) -> bool {
        self.parts
            .as_ref()
            .is_some_and(|parts| parts.asks_for(file))
    }

    /// The body. Which of its targets nobody uses cannot be told: any can be asked for by its name
    /// (`docs/loaders/mpfb/targets.md#finding-by-name`).
    pub(crate) fn body<'v>(&'v self, view: &'v crate::View<'v>) -> Option<Body<'v>> {
        let targets = view
            .files()
            .filter(|file| matches!(file.kind, Kind::Target | Kind::PackedTarget));
        let mut body = Body::new(
            self.body_name()?,
            view,
            targets.map(|file| self.target(file)).collect(),
        );
        let is_of_part =
            |file: &&FileFacts| matches!(file.kind, Kind::PartTarget | Kind::PackedPartTarget);
        body.part_targets = view.files().filter(is_of_part).collect();
        body.mesh = self.mesh;
        body.obj = self.mesh;
        let is_renumbered = self.misplaced.is_some_and(Misplaced::is_of_numbers);
        let is_foreign = self.foreign_mesh.is_some() || is_renumbered;
        body.doubt = if is_foreign {
            Some(Doubt::Foreign)
        } else {
            self.misplaced.map(|_| Doubt::Misplaced)
        };
        body.visible_groups = self.mesh.map(|_| &self.shown);
        body.one_sided_endings = Some(&self.one_sided);
        body.worn = &self.worn;
        body.rigs = &self.body_rigs;
        let weights = view.files().filter(|file| file.kind == Kind::Weights);
        let known = self.known_weights();
        body.weights = weights.map(|file| self.weights(file, &known)).collect();
        let motions = view
            .files()
            .filter(|file| file.kind == Kind::Motion && file.rel.starts_with("poses/"));
        body.imported_motions = motions
            .filter_map(|file| Some((file, &file.motion()?.imported)))
            .collect();
        let poses = view.files().filter(|file| file.kind == Kind::StoredPose);
        let of_poses = rigs::of_poses(&self.rigs);
        body.stored_poses = poses
            .filter_map(|file| rigs::bones_of_pose(&of_poses, file))
            .collect();
        body.add_worn_weights(view.files().filter(|file| file.kind == Kind::AssetWeights));
        Some(body)
    }

    /// The weights that rigs have, and those that they look for in vain.
    fn known_weights(&self) -> KnownWeights<'_> {
        let lacking = self.rigs.iter().filter(|rig| rig.weights().is_none());
        let wanted = lacking.flat_map(|rig| &rig.wanted_weights);
        let used = self.rigs.iter().filter_map(RigFile::weights);
        KnownWeights {
            used: used.map(|own| own.path.as_str()).collect(),
            wanted: wanted.map(|rel| rel.to_ascii_lowercase()).collect(),
        }
    }

    /// Weights of a rig, used or not.
    fn weights<'v>(&self, file: &'v FileFacts, known: &KnownWeights<'_>) -> BodyWeights<'v> {
        let is_used = known.used.contains(file.path.as_str());
        // Those of a rig that is not found are told there, also of one that is called as the add-on
        // calls its own.
        let has_rig = |name: &str| {
            let rigs = ["", "rig."].map(|start| format!("{}/{start}{name}", parent(&file.rel)));
            rigs.iter()
                .any(|rel| self.layers.checked.file(rel).is_some())
        };
        let is_used = is_used
            || file
                .file_name()
                .strip_prefix("weights.")
                .is_some_and(has_rig);
        // What lacks its rig is told there, where it is one that is offered.
        let is_of_lost = || {
            self.layers
                .system
                .is_some_and(|system| is_of_lost_rig(system, &file.rel))
        };
        // And a rig that lacks its weights where only their capitals differ.
        let is_misnamed = || known.wanted.contains(&file.rel.to_ascii_lowercase());
        let is_used = is_used || is_of_lost() || is_misnamed();
        let used = if is_used {
            WeightsUse::Applied
        } else {
            WeightsUse::Unread
        };
        BodyWeights {
            file,
            name: Some(file.file_name()),
            used,
        }
    }

    /// The rigs of the checked layer that could be read.
    pub fn own_rigs(&self) -> impl Iterator<Item = (&RigFile<'a>, &'a Definition)> {
        let own = self
            .rigs
            .iter()
            .filter(|rig| self.layers.is_checked(rig.file) && !rig.file.failed);
        own.filter_map(|rig| Some((rig, rig.definition()?)))
    }

    /// What is known of a target of the checked layer.
    pub(crate) fn target<'v>(&self, file: &'v FileFacts) -> Target<'v> {
        let of_references = self
            .references
            .to_file(file)
            .map(|reference| reference.kind)
            .min();
        let used_as = if self.asks_for(file) {
            Some(ReferenceKind::MacroTarget)
        } else {
            of_references
        };
        Target {
            file,
            folder: first_folder(&file.rel),
            used_as,
            is_unused: false,
            packed_in: None,
        }
    }
}

/// The targets in the slots of sliders, there or not, in small letters.
fn slot_targets(catalog: &Catalog<'_>) -> BTreeSet<String> {
    let slots = catalog
        .sliders
        .sections
        .iter()
        .flat_map(|section| &section.categories)
        .flat_map(Category::slots_in_use);
    slots
        .filter(|slot| !slot.stem.is_empty())
        .map(|slot| slot.stem.to_lowercase())
        .collect()
}

/// A rig of the body with the weights that are found for it.
fn body_rig<'a>(rig: &RigFile<'a>) -> Rig<'a> {
    let to = |file: &'a FileFacts| {
        let kind = ReferenceKind::WeightsFile;
        Reference::to(
            &[rig.layer],
            kind,
            Layout::USUAL_BASE,
            rig.file,
            Place::File,
            file.file_name(),
            file.rel.clone(),
        )
    };
    Rig {
        file: rig.file,
        weights: rig.weights().map(to),
        is_default: false,
        is_found: true,
    }
}

/// How many vertices the tables of the base mesh are for; `None` where they disagree, which is told
/// of the tables.
fn vertices_of_tables(mirror: Option<&FileFacts>, groups: Option<&FileFacts>) -> Option<i64> {
    let mirror = mirror?
        .mirror_table()
        .filter(|table| table.unreadable.is_none())?;
    let groups = groups?
        .vertex_groups()
        .filter(|groups| groups.stops.all().is_empty())?;
    Some(mirror.vertices()).filter(|vertices| *vertices == groups.vertices())
}

/// Loose vertices behind the others do no harm.
fn lacks_vertices(mesh: &Mesh, needed: i64) -> bool {
    let is_sound = mesh.facts.unreadable_lines == 0 && mesh.facts.vertices > 0;
    is_sound && i64::try_from(mesh.facts.vertices).is_ok_and(|vertices| vertices < needed)
}

/// The folder at the top that a path leads into: all that is below is for the one base mesh.
fn first_folder(rel: &str) -> &str {
    rel.split_once('/').map_or("", |(folder, _)| folder)
}

/// What can be worn (`docs/loaders/mpfb/libraries.md#sections`).
fn worn<'a>(layers: impl Iterator<Item = &'a Layer>) -> Vec<Worn<'a>> {
    let of_layer = |layer| {
        Worn::all(layer, OWN).map(|(file, base)| {
            let mut worn = Worn::of(layer, file, base, &mhclo::mpfb::READER, false);
            if let Some(references) = &mut worn.references {
                references.retain(|one| one.kind != ReferenceKind::AssetWeights);
                references.extend(weights_of(layer, file, base));
            }
            worn
        })
    };
    layers.flat_map(of_layer).collect()
}

/// The weights of an asset: those beside it that have its name, whatever it names
/// (`docs/loaders/mpfb/clothes.md#files-beside-an-asset`).
fn weights_of<'a>(
    layer: &'a Layer,
    asset: &'a FileFacts,
    base: &'a str,
) -> impl Iterator<Item = Reference<'a>> {
    let named = format!("{}/{}.", parent(&asset.rel), asset.stem());
    let from = layer
        .files
        .range::<str, _>((Bound::Included(named.as_str()), Bound::Unbounded));
    let own = from
        .map(|(_, file)| file)
        .take_while(move |file| file.rel.starts_with(&named));
    let kind = ReferenceKind::AssetWeights;
    let reference = move |file: &'a FileFacts| {
        Reference::to(
            &[layer],
            kind,
            base,
            asset,
            Place::File,
            file.file_name(),
            file.rel.clone(),
        )
    };
    own.filter(|file| file.kind_in(OWN) == Kind::AssetWeights)
        .map(reference)
}

impl<'a> Catalog<'a> {
    /// The folder of a section.
    pub fn folder(&self, section: &str) -> String {
        format!("{}/{section}", parent(&self.file.rel))
    }

    /// The target of a section by its name, packed or not.
    pub fn target(&self, section: &str, stem: &str) -> Option<&'a FileFacts> {
        let folder = self.folder(section);
        [".target.gz", ".target"]
            .iter()
            .find_map(|suffix| self.layer.file(&format!("{folder}/{stem}{suffix}")))
    }
}
