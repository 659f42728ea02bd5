//! Assets against the mesh that they are fitted to: what of their files is measured.

use std::collections::BTreeMap;

use rayon::prelude::*;

use mhlint_eval::faces::Faces;
use mhlint_eval::fit::{Reference, ScaleLine};
use mhlint_eval::mesh::bounding_box;
use mhlint_eval::scene::WornAsset;
use mhlint_eval::vector::{Point, Vec3};
use mhlint_eval::weights::BoneWeights;
use mhlint_eval::worn::{Garment, Wearer, WornMeasure, measure};
use mhlint_formats::asset_mesh::AssetMesh;
use mhlint_formats::mhclo::{self, Clothes, FaultKind, Scale};
use mhlint_formats::mhw::{self, Pair};
use mhlint_formats::obj::Mesh;
use mhlint_repo::{Reference as Named, ReferenceKind, Worn};

/// The faces of a mesh that are shown, as two lists.
pub(super) fn skin(mesh: &Mesh, shows: impl Fn(&str) -> bool) -> (Vec<u32>, Vec<u32>) {
    let is_shown: Vec<bool> = mesh.groups.iter().map(|group| shows(&group.name)).collect();
    let (mut corners, mut starts) = (Vec::new(), vec![0]);
    for face in mesh
        .faces
        .iter()
        .filter(|face| is_shown.get(face.group as usize) == Some(&true))
    {
        corners.extend_from_slice(face.of(&mesh.corners));
        starts.push(u32::try_from(corners.len()).unwrap_or(u32::MAX));
    }
    (corners, starts)
}

/// An asset as it is fitted.
pub(super) struct Fitted<'w> {
    worn: &'w Worn<'w>,
    mesh: &'w AssetMesh,
    references: Vec<Reference>,
    scales: Option<Vec3>,
    deleted: Vec<bool>,
}

/// The assets that can be fitted to a mesh. `stretch` says what offsets are multiplied by; `None`
/// where the application stops.
pub(super) fn fitted<'w>(
    mesh: &Mesh,
    worn: impl Iterator<Item = &'w Worn<'w>>,
    stretch: impl Fn(&Worn<'_>, &Clothes) -> Option<Option<Vec3>>,
) -> Vec<Fitted<'w>> {
    let fitted = worn.filter_map(whole).filter_map(|(worn, clothes, own)| {
        let deleted = if clothes.deleted.is_empty() {
            Vec::new()
        } else {
            deleted(clothes, &mesh.positions)
        };
        let (references, scales) = (references(&clothes.kept), stretch(worn, clothes)?);
        Some(Fitted {
            worn,
            mesh: own,
            references,
            scales,
            deleted,
        })
    });
    fitted.collect()
}

/// Measures assets on a mesh with these faces shown.
pub(super) fn measure_all(
    mesh: &Mesh,
    (corners, starts): &(Vec<u32>, Vec<u32>),
    fitted: &[Fitted<'_>],
) -> BTreeMap<String, WornMeasure> {
    let Some((low, high)) = bounding_box(&mesh.positions) else {
        return BTreeMap::new();
    };
    let height = f64::from(high[1]) - f64::from(low[1]);
    let wearer = Wearer {
        positions: &mesh.positions,
        skin: Faces { corners, starts },
        height,
    };
    let measured = fitted.par_iter().filter_map(|one| {
        let garment = Garment {
            references: &one.references,
            scales: one.scales,
            drawn: &one.mesh.positions,
            faces: Faces {
                corners: &one.mesh.corners,
                starts: &one.mesh.face_starts,
            },
            deleted: &one.deleted,
        };
        Some((one.worn.file.path.clone(), measure(&wearer, &garment)?))
    });
    measured.collect()
}

impl Fitted<'_> {
    /// What of it is looked at with the body, whose bones have these numbers.
    pub(super) fn on_scene(&self, bones: &BTreeMap<&str, usize>) -> WornAsset {
        WornAsset {
            path: self.worn.file.path.clone(),
            references: self.references.clone(),
            scales: self.scales,
            weights: self.weights(bones),
        }
    }

    /// Its own weights, those of known bones.
    fn weights(&self, bones: &BTreeMap<&str, usize>) -> Option<(String, Vec<BoneWeights>)> {
        let file = self
            .worn
            .reference(ReferenceKind::AssetWeights)
            .and_then(Named::meant)?;
        let own = file.weights().filter(|weights| weights.has_weights)?;
        let entry = |pair: &Pair| {
            let vertex = u32::try_from(pair.vertex)
                .ok()
                .filter(|vertex| (*vertex as usize) < self.references.len())?;
            Some((vertex, pair.weight))
        };
        let known = own
            .bones
            .iter()
            .filter_map(|bone| Some((*bones.get(bone.name.as_str())?, bone)));
        let list = |(bone, list): (usize, &mhw::BoneWeights)| BoneWeights {
            bone,
            entries: list.pairs.iter().filter_map(entry).collect(),
        };
        Some((file.path.clone(), known.map(list).collect()))
    }
}

/// An asset of which every vertex has its row. What else is wrong with rows has findings of its
/// own.
fn whole<'w>(worn: &'w Worn<'w>) -> Option<(&'w Worn<'w>, &'w Clothes, &'w AssetMesh)> {
    let (clothes, (_, mesh)) = (worn.clothes()?, worn.mesh()?);
    let shifts = |kind| {
        matches!(
            kind,
            FaultKind::DroppedRow | FaultKind::FieldCount(_) | FaultKind::RowWord
        )
    };
    let is_whole = clothes.kept.len() == mesh.positions.len()
        && mesh.is_sound()
        && !clothes.faults.iter().any(|fault| shifts(fault.kind));
    is_whole.then_some((worn, clothes, mesh))
}

/// Rows as they are fitted.
pub(super) fn references(rows: &[mhclo::Row]) -> Vec<Reference> {
    rows.iter()
        .map(|row| Reference {
            vertices: row.vertices,
            weights: row.weights,
            offset: row.offset,
        })
        .collect()
}

/// The scale lines of an asset; those that name no vertex are left out.
pub(super) fn scale_lines(clothes: &Clothes) -> [Option<ScaleLine>; 3] {
    clothes.scales.map(|line| {
        let Scale {
            vertices, distance, ..
        } = line?;
        let [a, b] = vertices.map(|vertex| u32::try_from(vertex).ok());
        Some(ScaleLine {
            vertices: [a?, b?],
            distance,
        })
    })
}

fn deleted(clothes: &Clothes, positions: &[Point]) -> Vec<bool> {
    let mut deleted = vec![false; positions.len()];
    for run in clothes.merged_deletes(positions.len()) {
        if let Some(run) = deleted.get_mut(run) {
            run.fill(true);
        }
    }
    deleted
}
