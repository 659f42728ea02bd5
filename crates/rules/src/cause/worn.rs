//! Weights of assets against the meshes that they are for, which are read only after them.

use std::collections::{BTreeMap, BTreeSet};

use mhlint_diag::{Evidence, Place};
use mhlint_formats::asset_mesh::AssetMesh;
use mhlint_formats::mhw::Weights;
use mhlint_repo::{Body, FileFacts, Reference, ReferenceKind, Worn};

/// Weights of an asset of the checked layer.
pub(crate) struct Own<'v> {
    pub(crate) file: &'v FileFacts,
    pub(crate) weights: &'v Weights,
    /// The mesh that they are for.
    pub(crate) mesh: &'v AssetMesh,
    /// Its vertices.
    pub(crate) vertices: usize,
}

/// Entries for vertices that the mesh does not have.
pub(crate) struct Outside<'v> {
    pub(crate) bone: &'v str,
    pub(crate) vertex: i64,
    pub(crate) place: Place,
    pub(crate) evidence: Evidence,
    pub(crate) is_negative: bool,
}

/// The weights that assets name, each once: for the first mesh.
pub(crate) fn all<'v>(body: &Body<'v>) -> impl Iterator<Item = Own<'v>> {
    let mut own: BTreeMap<&str, Own<'v>> = BTreeMap::new();
    for worn in body.worn {
        let mesh = worn.mesh().filter(|(_, mesh)| body.opens(mesh));
        let file = worn
            .reference(ReferenceKind::AssetWeights)
            .and_then(Reference::meant);
        let file = file.filter(|file| body.layers.is_checked(file));
        let (Some(file), Some((_, mesh))) = (file, mesh) else {
            continue;
        };
        if let Some(weights) = file.weights().filter(|weights| weights.has_weights) {
            own.entry(&file.path).or_insert(Own {
                file,
                weights,
                mesh,
                vertices: mesh.facts.vertices,
            });
        }
    }
    own.into_values()
}

/// The meshes of assets of the checked layer of which `is_wanted` holds for an asset that names
/// them, each once.
pub(crate) fn meshes<'b, 'v>(
    body: &'b Body<'v>,
    is_wanted: impl Fn(&Worn<'v>, &AssetMesh) -> bool,
) -> impl Iterator<Item = (&'b Worn<'v>, &'v FileFacts, &'v AssetMesh)> {
    let mut told = BTreeSet::new();
    let own = body
        .worn
        .iter()
        .filter_map(|worn| worn.mesh().map(|(file, mesh)| (worn, file, mesh)));
    own.filter(move |(worn, file, mesh)| {
        body.layers.is_checked(file) && is_wanted(worn, mesh) && told.insert(file.path.as_str())
    })
}

impl<'v> Own<'v> {
    /// The entries that name vertices beyond the mesh, or below 0.
    pub(crate) fn outside(&self) -> Option<Outside<'v>> {
        let entries = self
            .weights
            .bones
            .iter()
            .flat_map(|bone| bone.pairs.iter().map(move |pair| (bone, pair)));
        let beyond =
            |vertex: i64| usize::try_from(vertex).is_ok_and(|vertex| vertex < self.vertices);
        let mut outside = entries.filter(|(_, pair)| !beyond(pair.vertex)).peekable();
        let (bone, pair) = outside.peek().copied()?;
        let place = Place::pointer(["weights", &bone.name, &pair.position.to_string()]);
        let evidence = Evidence::of_unnamed(
            outside.map(|(bone, pair)| format!("{}[{}]", bone.name, pair.vertex)),
        );
        let (bone, vertex, is_negative) = (bone.name.as_str(), pair.vertex, pair.vertex < 0);
        Some(Outside {
            bone,
            vertex,
            place,
            evidence: evidence.out_of(self.weights.facts.pairs),
            is_negative,
        })
    }

    /// How many vertices there are up to the last one that is listed, be it with 0.
    pub(crate) fn listed(&self) -> usize {
        let pairs = self.weights.bones.iter().flat_map(|bone| &bone.pairs);
        let last = pairs
            .filter_map(|pair| usize::try_from(pair.vertex).ok())
            .max();
        last.map_or(0, |last| last.saturating_add(1))
    }

    /// How many vertices have no weight other than 0, and the first of them.
    pub(crate) fn unreached(&self) -> Option<(usize, usize)> {
        let pairs = self
            .weights
            .bones
            .iter()
            .flat_map(|bone| &bone.pairs)
            .filter(|pair| pair.weight != 0.0);
        let reached: BTreeSet<usize> = pairs
            .filter_map(|pair| usize::try_from(pair.vertex).ok())
            .collect();
        let count = self
            .vertices
            .saturating_sub(reached.range(..self.vertices).count());
        let first = (0..self.vertices).find(|vertex| !reached.contains(vertex))?;
        Some((count, first))
    }
}
