//! `base.mhbin` and the OBJ that it was packed from are the same mesh.

use super::super::{Check, Rule, RuleCx};
use super::packed_difference::PackedDifference;
use super::packed_mesh;
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2},
    Case, Evidence, Finding, Grows, Level, MeasureKind, Place, RuleInfo,
};
use mhlint_formats::mesh_difference::MeshDifference;
use mhlint_formats::obj::Mesh;
use mhlint_repo::FileFacts;
use mhlint_repo::makehuman2::{Base, Lies, UnreadMesh, View};

pub(crate) static RULE: Rule = Check::EachBase(
    run,
    |view, _, out| packed_mesh::findings(&RULE, view, out),
    |_, _, _| {},
)
.rule(RuleInfo {
    breaks: &[
        (
            Makehuman2,
            "loads the mesh from the archive and ignores the OBJ, whichever is newer",
        ),
        (
            Makehuman1,
            "loads the mesh from the archive, unless the OBJ is newer",
        ),
    ],
    docs: include_str!("stale_binary.md").trim_ascii_end(),
    counts: "vertices",
    grows: Grows::more(MeasureKind::Distance),
    ..RuleInfo::new(
        "mesh-stale-binary",
        Level::Warning,
        "a packed base mesh differs from its OBJ",
    )
});

const ABOVE: Case = &[(
    Makehuman2,
    Level::Warning,
    "loads base.mhbin of the system data and ignores the user's base.obj",
)];
const BELOW: Case = &[(
    Makehuman2,
    Level::Info,
    "shows the user's mesh instead of the mesh in the system data",
)];

fn run(view: &View<'_>, base: &Base<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let (Some(archive), Some((_, packed))) = (base.mesh_files.archive(), base.mesh) else {
        return;
    };
    for text in &base.mesh_files.unread {
        let at = if text.lies == Lies::Above {
            text.file
        } else {
            archive
        };
        let Some(mesh) = text
            .sound()
            .filter(|mesh| is_whole(mesh) && view.layers.is_checked(at))
        else {
            continue;
        };
        let difference = MeshDifference::between(packed, mesh);
        if !difference.is_none() {
            let found = PackedDifference {
                packed,
                landmarks: view.landmarks(archive),
                difference: &difference,
            };
            out.push(finding(at, archive, text, &found));
        }
    }
}

/// Whether the OBJ has no fault that keeps it from being packed.
fn is_whole(mesh: &Mesh) -> bool {
    let facts = &mesh.facts;
    let named = mesh
        .groups
        .iter()
        .all(|group| group.faces == 0 || group.name.is_ascii());
    facts.non_finite.count == 0 && facts.partial_uv.is_empty() && named
}

fn finding(
    at: &FileFacts,
    archive: &FileFacts,
    text: &UnreadMesh<'_>,
    found: &PackedDifference<'_>,
) -> Finding {
    let kinds = found.kinds();
    let what: Vec<&str> = kinds.iter().map(|(_, what)| what.as_str()).collect();
    let (case, help, other): (Case, _, _) = match text.lies {
        Lies::Beside => (&[], found.help(), text.file),
        Lies::Above => (
            ABOVE,
            "pack the user's base.obj with compile_meshes.py as well",
            archive,
        ),
        Lies::Below => (
            BELOW,
            "leave it if this mesh is intended; otherwise move base.mhbin out of the folder to \
                use the mesh of the system data",
            text.file,
        ),
    };
    let message = format!("base.mhbin differs from base.obj: {}", what.join("; "));
    let finding = RULE.at(at, Place::File, message).case(case).help(help);
    let finding = finding.parts(kinds.iter().map(|(kind, _)| *kind)).related(
        other.path.clone(),
        Place::File,
        "the other mesh",
    );
    match found.difference.farthest {
        Some((vertex, distance)) => {
            let moved =
                Evidence::counted(found.difference.moved).out_of(found.packed.facts.vertices);
            finding.evidence(moved.with_worst(f64::from(distance), format!("vertex {vertex}")))
        }
        None => finding,
    }
}
