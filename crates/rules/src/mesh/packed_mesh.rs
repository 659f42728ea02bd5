//! The archive of a mesh that MakeHuman 1 reads in the place of an OBJ (`.npz`), against that
//! (`docs/loaders/makehuman1/base-mesh.md#packed-meshes`).

use super::super::{Rule, counted, units::length};
use mhlint_diag::{Application::Makehuman1, Case, Finding, Level, Place};
use mhlint_formats::asset_mesh::{AssetMesh, MeshPrint};
use mhlint_repo::FileFacts;
use mhlint_repo::makehuman1::{View, mesh_archive};

/// One finding for each archive that differs from its OBJ.
pub(super) fn findings(rule: &Rule, view: &View<'_>, out: &mut Vec<Finding>) {
    let layer = view.layers.checked;
    let packed = layer
        .files
        .values()
        .filter(|file| file.rel.ends_with(".npz"));
    for file in packed {
        let Some((_, mesh)) = mesh_archive(layer, &file.rel) else {
            continue;
        };
        out.extend(
            layer
                .text_of_archive(&file.rel)
                .and_then(|text| finding(rule, file, mesh, text)),
        );
    }
}

fn finding(rule: &Rule, file: &FileFacts, mesh: &AssetMesh, text: &FileFacts) -> Option<Finding> {
    let of_base = text.mesh();
    let print = of_base
        .map(MeshPrint::of)
        .or_else(|| Some(text.asset_mesh()?.print))?;
    let vertices = (mesh.print.vertices != print.vertices).then(|| {
        format!(
            "{} vertices instead of {}",
            mesh.print.vertices, print.vertices
        )
    });
    let faces = (mesh.print.faces != print.faces).then(|| {
        format!(
            "{} instead of {}",
            counted(mesh.print.faces, "face"),
            print.faces
        )
    });
    let corners = (faces.is_none() && mesh.print.has_other_corners(&print))
        .then(|| "faces with other corners".to_owned());
    let moved = of_base
        .filter(|_| vertices.is_none())
        .and_then(|own| farthest(&mesh.positions, &own.positions));
    let moved = moved.map(|by| format!("vertices moved by up to {}", length(by)));
    let kinds = [
        ("vertices", vertices),
        ("faces", faces),
        ("corners", corners),
        ("positions", moved),
    ];
    let found: Vec<(&str, String)> = kinds
        .into_iter()
        .filter_map(|(kind, words)| Some((kind, words?)))
        .collect();
    if found.is_empty() {
        return None;
    }
    let words: Vec<&str> = found.iter().map(|(_, words)| words.as_str()).collect();
    let message = format!("differs from `{}`: {}", text.file_name(), words.join("; "));
    let finding = rule
        .at(file, Place::File, message)
        .parts(found.iter().map(|(kind, _)| *kind));
    let finding = finding.related(text.path.clone(), Place::File, "the text");
    // Of a base mesh with other vertices nothing fits.
    let stops = of_base.is_some() && mesh.print.vertices != print.vertices;
    let finding = if stops { finding.case(STOPS) } else { finding };
    Some(finding.help("if the OBJ is the right one, delete the `.npz`"))
}

const STOPS: Case = &[(
    Makehuman1,
    Level::Error,
    "stops at start, unless the OBJ is newer: only the splash picture stays on the screen",
)];

/// Lengths below this are those of rounding, in decimetres.
const ROUNDING: f32 = 0.0001;

fn farthest(packed: &[[f32; 3]], text: &[[f32; 3]]) -> Option<f32> {
    let distance = |(one, other): (&[f32; 3], &[f32; 3])| {
        one.iter()
            .zip(other)
            .map(|(one, other)| (one - other).powi(2))
            .sum::<f32>()
            .sqrt()
    };
    let most = packed
        .iter()
        .zip(text)
        .map(distance)
        .fold(0.0_f32, f32::max);
    (most > ROUNDING).then_some(most)
}
