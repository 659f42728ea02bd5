//! A map of texture coordinates has the faces of the mesh that it is used for.

use std::collections::BTreeMap;

use super::super::{Check, Rule, RuleCx, counted, shown};
use mhlint_diag::{
    Application::Makehuman1, Case, Finding, Grouped, Level, Place, RuleInfo, grouped,
};
use mhlint_formats::uv_map::{UvFault, UvMap};
use mhlint_repo::{FileFacts, Reference, ReferenceKind, Surface, View, Wearer};

pub(crate) static RULE: Rule = Check::Repository(run).rule(RuleInfo {
    breaks: &[(
        Makehuman1,
        "fails with `NameError` when the material is used",
    )],
    docs: include_str!("uvmap_mismatch.md").trim_ascii_end(),
    ..RuleInfo::new(
        "material-uvmap-mismatch",
        Level::Error,
        "a map of texture coordinates does not fit the mesh",
    )
});

const RAGGED: Case = &[(
    Makehuman1,
    Level::Error,
    "fails with `ValueError` when the material is used",
)];
const BEYOND: Case = &[(
    Makehuman1,
    Level::Error,
    "fails with `IndexError` when the material is used",
)];

const NUMBERS: Case = &[(
    Makehuman1,
    Level::Error,
    "fails with `ValueError` or `IndexError` when the material is used",
)];

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let own = view
        .references()
        .iter()
        .filter(|one| one.kind == ReferenceKind::UvMap);
    let meshes = Meshes::of(view);
    for reference in own.filter(|one| view.layers().is_checked(one.from)) {
        let Some(file) = reference.found() else {
            continue;
        };
        let Some(map) = file
            .uv_map()
            .filter(|_| file.encoding.invalid_utf8_at.is_none())
        else {
            continue;
        };
        let finding = match &map.fault {
            Some((line, fault)) => broken(file, *line, fault, map).related(
                &reference.from.path,
                reference.place.clone(),
                "this material uses it",
            ),
            None if map.faces > 0 && map.corners != CORNERS => other_corners(reference, map),
            None => match meshes.other_faces(reference, map) {
                Some(finding) => finding,
                None => continue,
            },
        };
        out.push(finding);
    }
}

fn broken(file: &FileFacts, line: u32, fault: &UvFault, map: &UvMap) -> Finding {
    let (message, case, help) = match fault {
        UvFault::NoUv(corner) => {
            let shown = shown(corner);
            let message = format!("corner `{shown}` of a face has no texture coordinate");
            (message, BEYOND, "export the mesh with texture coordinates")
        }
        UvFault::Ragged(corners) => {
            let message = format!(
                "a face has {}, but the first has {}",
                counted(corners, "corner"),
                map.corners
            );
            (
                message,
                RAGGED,
                "give each face the same number of corners as in the mesh",
            )
        }
        UvFault::OutOfRange(number) => {
            let uvs = counted(map.uvs, "`vt` line");
            let message = format!("texture coordinate {number} does not exist: the map has {uvs}");
            (message, BEYOND, "export the map again")
        }
        UvFault::NotTwoNumbers => {
            let message = "a `vt` line is not two numbers".to_owned();
            (
                message,
                NUMBERS,
                "export the map again, with a point in decimals",
            )
        }
    };
    RULE.at(file, Place::Line(line), message)
        .key("map")
        .case(case)
        .help(help)
}

/// MakeHuman 1 keeps triangles as faces with four corners; a map has to have as many.
const CORNERS: usize = 4;

fn other_corners(reference: &Reference<'_>, map: &UvMap) -> Finding {
    let message = format!(
        "the faces of `{}` have {}, expected {CORNERS}",
        reference.text,
        counted(map.corners, "corner")
    );
    let finding = RULE
        .at(reference.from, reference.place.clone(), message)
        .key(reference.text)
        .case(RAGGED);
    finding.help("repeat the first corner of each triangle in the map, or remove the line")
}

/// The meshes that wear materials, as their printed paths with their numbers of faces.
struct Meshes<'v> {
    /// The materials by their paths.
    surfaces: BTreeMap<&'v str, &'v Surface<'v>>,
    /// Those of assets by the path of the material that they name. Topologies keep their own
    /// texture coordinates.
    of_assets: Grouped<&'v str, (String, usize)>,
    /// Those of bodies, which wear the skins.
    of_bodies: Vec<(String, usize)>,
}

impl<'v> Meshes<'v> {
    fn of(view: &'v View<'v>) -> Self {
        let mut surfaces = BTreeMap::new();
        for surface in view.surfaces() {
            surfaces
                .entry(surface.file.path.as_str())
                .or_insert(surface);
        }
        let worn = view.assets().iter().filter(|worn| !worn.is_topology());
        let of_assets = worn.filter_map(|worn| {
            let material = worn.reference(ReferenceKind::AssetMaterial)?.found()?;
            let (file, mesh) = worn.mesh().filter(|(_, mesh)| mesh.is_sound())?;
            Some((material.path.as_str(), (file.path.clone(), mesh.faces)))
        });
        let bodies = view.bodies();
        let of_bodies = bodies.iter().filter_map(|body| body.mesh);
        Self {
            surfaces,
            of_assets: grouped(of_assets),
            of_bodies: of_bodies
                .map(|(file, mesh)| (file.path.clone(), mesh.faces.len()))
                .collect(),
        }
    }

    /// The finding on the first mesh whose faces are not as many.
    fn other_faces(&self, reference: &Reference<'_>, map: &UvMap) -> Option<Finding> {
        let surface = self.surfaces.get(reference.from.path.as_str())?;
        let meshes = if surface.wearer == Wearer::Skin {
            &self.of_bodies
        } else {
            self.of_assets.get(surface.file.path.as_str())?
        };
        let (path, faces) = meshes.iter().find(|(_, faces)| *faces != map.faces)?;
        let message = format!(
            "`uvMap {}` has {}, but the mesh has {faces}",
            reference.text,
            counted(map.faces, "face")
        );
        let finding = RULE
            .at(reference.from, reference.place.clone(), message)
            .key(reference.text);
        let help = "export the map from this mesh, or remove the line";
        Some(
            finding
                .related(path.clone(), Place::File, "the mesh")
                .help(help),
        )
    }
}
