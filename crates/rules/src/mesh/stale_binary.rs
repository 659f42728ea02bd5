//! `base.mhbin` and the OBJ that it was packed from are the same mesh.

use super::super::units::length;
use super::super::{Check, Rule, RuleCx, counted};
use super::packed_mesh;
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2},
    Case, Evidence, Finding, Grows, Level, MeasureKind, Place, RuleInfo,
};
use mhlint_formats::mesh_difference::MeshDifference;
use mhlint_formats::obj::Mesh;
use mhlint_repo::makehuman2::{Base, Lies, UnreadMesh, View};
use mhlint_repo::{FileFacts, Landmarks};

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
            let landmarks = view.landmarks(archive);
            out.push(finding(
                at,
                archive,
                text,
                &Told {
                    packed,
                    landmarks,
                    difference: &difference,
                },
            ));
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

/// What an archive is reported for.
struct Told<'m> {
    packed: &'m Mesh,
    /// Where its vertices are.
    landmarks: Option<Landmarks<'m>>,
    difference: &'m MeshDifference,
}

impl Told<'_> {
    /// With other counts, either of the two may be the mesh that everything else was made for.
    fn help(&self) -> &'static str {
        if self.difference.vertices.is_some() || self.difference.faces.is_some() {
            "find out which mesh the targets and weights are for (`numverts` of base.json); then \
             restore base.obj, or rebuild base.mhbin from it with compile_meshes.py"
        } else {
            "if base.obj is the right one, move base.mhbin away, or rebuild it with \
                compile_meshes.py"
        }
    }
}

fn finding(at: &FileFacts, archive: &FileFacts, text: &UnreadMesh<'_>, told: &Told<'_>) -> Finding {
    let kinds = told.kinds();
    let what: Vec<&str> = kinds.iter().map(|(_, what)| what.as_str()).collect();
    let (case, help, other): (Case, _, _) = match text.lies {
        Lies::Beside => (&[], told.help(), text.file),
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
    match told.difference.farthest {
        Some((vertex, distance)) => {
            let moved = Evidence::counted(told.difference.moved).out_of(told.packed.facts.vertices);
            finding.evidence(moved.with_worst(f64::from(distance), format!("vertex {vertex}")))
        }
        None => finding,
    }
}

impl Told<'_> {
    /// Everything that differs: a name for it, and words.
    fn kinds(&self) -> Vec<(&'static str, String)> {
        let found = self.difference;
        let kinds = [
            (
                "vertices",
                found
                    .vertices
                    .map(|[packed, text]| format!("{packed} vertices instead of {text}")),
            ),
            (
                "positions",
                found.farthest.map(|farthest| self.moved(farthest)),
            ),
            (
                "faces",
                found
                    .faces
                    .map(|[packed, text]| format!("{packed} faces instead of {text}")),
            ),
            ("corners", several(found.other_faces, "with other corners")),
            ("groups", self.groups()),
            ("grouping", several(found.regrouped, "in another group")),
            (
                "texture",
                several(found.retextured, "with other texture coordinates"),
            ),
        ];
        kinds
            .into_iter()
            .filter_map(|(kind, words)| Some((kind, words?)))
            .collect()
    }

    fn moved(&self, (vertex, distance): (u32, f32)) -> String {
        let vertices = self.packed.facts.vertices;
        let at = self
            .landmarks
            .as_ref()
            .map_or_else(|| format!("vertex {vertex}"), |body| body.vertex(vertex));
        let (moved, by) = (self.difference.moved, length(distance));
        match moved {
            1 => format!("{at} moved by {by}"),
            _ => format!("{moved} of {vertices} vertices moved, {at} farthest, by {by}"),
        }
    }

    fn groups(&self) -> Option<String> {
        let [packed, text] = &self.difference.groups;
        match (packed.first(), text.first()) {
            (None, None) => None,
            (Some(own), None) => Some(format!(
                "{}, first `{own}`",
                counted(packed.len(), "additional group")
            )),
            (None, Some(other)) => Some(format!(
                "{}, first `{other}`",
                counted(text.len(), "missing group")
            )),
            (Some(own), Some(other)) => Some(format!("group `{own}` instead of `{other}`")),
        }
    }
}

fn several(faces: usize, what: &str) -> Option<String> {
    (faces > 0).then(|| format!("{} {what}", counted(faces, "face")))
}
