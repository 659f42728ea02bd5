//! The layers of `MakeHuman` 1 with the rigs of its body and what that wears (formats/makehuman1.md §2.2, §3, §4, §10).

use std::collections::BTreeSet;

use crate::diag::{Application, Place};
use crate::discover::Kind;
use crate::formats::obj::Mesh;
use crate::repo::{
    Body, BodyWeights, FileFacts, Layer, Layers, Reference, ReferenceKind, References, Resolution, Rig, Target,
    WeightsUse, Worn, parent,
};

/// Whose uses of a file count here.
const OWN: Application = Application::Makehuman1;
/// The skeleton that poses the body; all others are for exports.
const POSED: &str = "rigs/default.mhskel";

/// The layers of `MakeHuman` 1.
#[derive(Debug)]
pub(crate) struct View<'a> {
    /// System and user data.
    pub layers: Layers<'a>,
    /// What names a file.
    pub references: References<'a>,
    /// The base mesh, if it can be read.
    mesh: Option<(&'a FileFacts, &'a Mesh)>,
    /// Skeletons with their weights.
    rigs: Vec<Rig<'a>>,
    /// What the body can wear.
    worn: Vec<Worn<'a>>,
}

impl<'a> View<'a> {
    /// Connects layers.
    pub(crate) fn connect(layers: Layers<'a>) -> Self {
        let mesh =
            layers.system.and_then(|layer| layer.files.values().find(|file| file.kind_in(OWN) == Kind::BaseMesh));
        let worn = |layer| {
            let of = move |(file, base)| Worn::of(layer, file, base, |name| !name.has_colon, false);
            Worn::all(layer, OWN).map(of)
        };
        Self {
            layers,
            references: References::default(),
            mesh: mesh.and_then(|file| Some((file, file.mesh()?))),
            rigs: layers.strongest_first().flat_map(|layer| rigs(layers, layer)).collect(),
            worn: layers.strongest_first().flat_map(worn).collect(),
        }
    }

    /// The name of the base mesh, if there is one.
    pub(crate) fn body_name(&self) -> Option<&'a str> {
        self.mesh.and_then(|(file, _)| file.base_in(OWN))
    }

    /// The body.
    pub(in crate::repo) fn body<'v>(&'v self, view: &'v crate::repo::View<'v>) -> Option<Body<'v>> {
        let targets = view.files().filter(|file| file.kind == Kind::Target).map(target);
        let mut body = Body::new(self.body_name()?, view, targets.collect());
        body.mesh = self.mesh;
        body.obj = self.mesh;
        body.rigs = &self.rigs;
        body.worn = &self.worn;
        body.weights = self.weights(view);
        body.add_worn_weights(view.files().filter(|file| file.kind == Kind::AssetWeights));
        Some(body)
    }

    /// The weights for the body. Where not every skeleton is found with its weights, nobody can tell which of them are
    /// not read.
    fn weights<'v>(&self, view: &'v crate::repo::View<'v>) -> Vec<BodyWeights<'v>> {
        let named = self.rigs.iter().filter_map(|rig| rig.weights.as_ref());
        let can_tell = self.layers.system.is_some()
            && self
                .rigs
                .iter()
                .all(|rig| rig.skeleton().is_some_and(|one| one.is_object && !one.weights_file_misshapen))
            && named.clone().all(|reference| reference.meant().is_some());
        let named: BTreeSet<&str> = named.filter_map(Reference::meant).map(|file| file.path.as_str()).collect();
        let weights = |file: &'v FileFacts| {
            let is_read = !can_tell || named.contains(file.path.as_str());
            let used = if is_read { WeightsUse::Applied } else { WeightsUse::Unread };
            BodyWeights { file, name: Some(file.file_name()), used }
        };
        view.files().filter(|file| file.kind == Kind::Weights).map(weights).collect()
    }
}

/// What is known of a target of the checked layer.
pub(in crate::repo) fn target(file: &FileFacts) -> Target<'_> {
    Target { file, folder: parent(&file.rel), used_as: None, is_unused: false, packed_in: None }
}

/// The rigs of a layer.
fn rigs<'a>(layers: Layers<'a>, layer: &'a Layer) -> impl Iterator<Item = Rig<'a>> {
    let skeletons = layer.files.values().filter(|file| file.kind_in(OWN) == Kind::Skeleton);
    skeletons.map(move |file| Rig {
        file,
        weights: weights(layers, layer, file),
        is_default: file.rel == POSED,
        is_found: true,
    })
}

/// The weights that a skeleton names: beside it, or below the data of the user and of the system.
fn weights<'a>(layers: Layers<'a>, layer: &'a Layer, from: &'a FileFacts) -> Option<Reference<'a>> {
    let text = from.skeleton()?.weights_file.as_deref().filter(|text| !text.is_empty())?;
    let to = |layers: &[&'a Layer], rel| {
        let place = Place::pointer(["weights_file"]);
        Reference::to(layers, ReferenceKind::WeightsFile, from.base_in(OWN).unwrap_or_default(), from, place, text, rel)
    };
    let beside = to(&[layer], format!("{}/{text}", parent(&from.rel)));
    if !matches!(beside.resolution, Resolution::Missing) {
        return Some(beside);
    }
    let all: Vec<&Layer> = layers.strongest_first().collect();
    let below = to(&all, text.strip_prefix("data/").unwrap_or(text).to_owned());
    Some(if matches!(below.resolution, Resolution::Missing) { beside } else { below })
}
