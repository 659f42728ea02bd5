//! The tables of the base mesh of MPFB can be read, and fit the mesh.

use super::super::unfit::findings;
use super::super::{Check, Rule, RuleCx};
use super::{corrections, faces, mirror, vertex_groups};
use mhlint_diag::{Application::Mpfb, Case, Finding, Level, RuleInfo};
use mhlint_discover::Kind;
use mhlint_repo::mpfb::View;

pub(crate) static RULE: Rule = Check::Mpfb(run).rule(RuleInfo {
    breaks: &[(Mpfb, "fails with an exception where it needs the table")],
    docs: "`mesh_metadata/` of MPFB has tables for its base mesh.\n\n\
        `basemesh_vertex_groups.json` gives each vertex group a list of ranges, `[first, last]`. Anything else stops the \
        add-on when it is enabled. If `body` is empty, all of the body is hidden (an error); without `body` all helpers are \
        visible. A range whose first number is above the last is empty, and numbers beyond the mesh do not count. If a joint \
        of `base.obj` has no group, bones end at another place (warnings).\n\n\
        `hm08_config.json` needs `dimensions`, and for each part of the body `xmin` and `xmax`: without them each asset \
        with a scale is left half-made. Its other keys are never read; vertex groups in them that do not exist are an info.\n\n\
        `hm08.mirror` has a row `FROM TO SIDE` for each vertex, with one blank between the fields. At a row that is \
        written otherwise MPFB fails when a target is first made symmetric; later it mirrors only the vertices above that \
        row. Sides that are exchanged mirror the wrong half (a warning).\n\n\
        `proxy_corrective.json` has the uuids of topologies whose weights MPFB corrects when a saved character with one is \
        loaded: weights of left groups become 0 in the right half of the body, those of right groups in the left half. \
        Without the file nothing is corrected. Below a uuid only the key `fix_leftright_weights_for_groups` is looked for; \
        its value is never read, so `false` or a list of groups corrects all of them (a warning). Other keys, and a uuid \
        that is misspelt, do nothing (a warning). With a number, `true`, `false` or `null` in place of an object such a \
        character is left half-made.\n\n\
        `basemesh_face_to_vertex_table.json.gz` lists the vertices of each face, `basemesh_vertex_to_face_table.json.gz` the \
        faces of each vertex, both as packed JSON. MPFB asks them which faces an asset hides. If a table is shorter than the \
        mesh, or is not a list of lists of whole numbers, such an asset cannot be put on. Rows of another mesh hide other faces \
        (a warning).\n\n\
        Restore the file from the download of the add-on, or make it again from the base mesh.",
    ..RuleInfo::new("metadata-table", Level::Error, "a table of the base mesh that its loader does not take")
});

const NO_START: Case = &[(Mpfb, Level::Error, "fails while the add-on is imported: MPFB cannot be enabled")];
const HALF_MADE: Case = &[(
    Mpfb,
    Level::Error,
    "fails with an exception after it fits an asset that has a scale: this one is left half-made",
)];

fn run(view: &View<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for file in view.own(Kind::VertexGroups) {
        let Some(groups) = file.vertex_groups() else { continue };
        out.extend(findings(&RULE, file, &groups.stops, cx).map(|(_, finding)| finding.case(NO_START)));
        if groups.stops.all().is_empty() {
            vertex_groups::faults(&RULE, view, file, groups, out);
        }
    }
    for file in view.own(Kind::BodyDimensions) {
        let Some(dimensions) = file.body_dimensions() else { continue };
        out.extend(findings(&RULE, file, &dimensions.stops, cx).map(|(_, finding)| finding.case(HALF_MADE)));
        out.extend(vertex_groups::unknown(&RULE, view, file, dimensions));
    }
    for file in view.own(Kind::MirrorTable) {
        out.extend(file.mirror_table().and_then(|table| mirror::fault(&RULE, view, file, table)));
    }
    for file in view.own(Kind::ProxyCorrections) {
        let Some(corrections) = file.proxy_corrections() else { continue };
        corrections::faults(&RULE, view, file, corrections, cx, out);
    }
    faces::faults(&RULE, view, out);
}
