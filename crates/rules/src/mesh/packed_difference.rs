//! How `base.mhbin` differs from the OBJ that it was packed from, in words.

use super::super::counted;
use super::super::units::length;
use mhlint_formats::mesh_difference::MeshDifference;
use mhlint_formats::obj::Mesh;
use mhlint_repo::Landmarks;

/// A packed mesh, and what differs in its OBJ.
pub(super) struct PackedDifference<'m> {
    pub(super) packed: &'m Mesh,
    /// Where its vertices are.
    pub(super) landmarks: Option<Landmarks<'m>>,
    pub(super) difference: &'m MeshDifference,
}

impl PackedDifference<'_> {
    /// With other counts, either of the two may be the mesh that everything else was made for.
    pub(super) fn help(&self) -> &'static str {
        if self.difference.vertices.is_some() || self.difference.faces.is_some() {
            "find out which mesh the targets and weights are for (`numverts` of base.json); then \
             restore base.obj, or rebuild base.mhbin from it with compile_meshes.py"
        } else {
            "if base.obj is the right one, move base.mhbin away, or rebuild it with \
                compile_meshes.py"
        }
    }

    /// Everything that differs: a name for it, and words.
    pub(super) fn kinds(&self) -> Vec<(&'static str, String)> {
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
