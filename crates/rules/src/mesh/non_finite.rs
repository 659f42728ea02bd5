//! Positions must be finite.

use super::super::cause::mesh::{is_in_archive, weigh};
use super::super::{Check, Rule, RuleCx};
use super::{of_asset, of_body};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2, Mpfb},
    Case, Element, Finding, Level, Place, RuleInfo,
};
use mhlint_formats::obj::MeshFacts;
use mhlint_repo::{FileFacts, View};

pub(crate) static RULE: Rule = Check::File(run).rule(RuleInfo {
    breaks: &[
        (
            Makehuman2,
            "loses everything computed from the vertex: normals, joints, the height of the body",
        ),
        (
            Makehuman1,
            "fits the vertex to the base mesh, wherever the OBJ has it",
        ),
        (
            Mpfb,
            "loses what is computed from the vertex: joints, and what is fitted to the body there",
        ),
    ],
    levels: &[(Makehuman1, Level::Info), (Mpfb, Level::Warning)],
    docs: include_str!("non_finite.md").trim_ascii_end(),
    counts: "vertices",
    ..RuleInfo::new(
        "mesh-non-finite",
        Level::Error,
        "the position of a vertex is NaN or infinite",
    )
});

/// Each vertex of an asset is fitted to the base mesh, wherever it lies.
const FITTED: Case = &[
    (
        Makehuman2,
        Level::Info,
        "computes the position from the `.mhclo`: no visible effect",
    ),
    (
        Mpfb,
        Level::Info,
        "computes the position from the `.mhclo`: no visible effect",
    ),
];
/// To the vertices of the body everything else is fitted.
const OF_BASE: Case = &[(
    Makehuman1,
    Level::Error,
    "loses everything computed from the vertex: joints, and what is fitted to the body there",
)];
const UV: Case = &[(
    Makehuman2,
    Level::Error,
    "crashes with `ValueError` in the glTF export of every figure that wears the asset",
)];

fn run(view: &View<'_>, file: &FileFacts, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    if let Some(asset) = of_asset(view, file) {
        // Texture coordinates are for exports.
        out.extend(of_worn(file, &asset.facts).filter(|_| !view.is_mpfb()));
        return out.extend(positions(view, file, &asset.facts).map(|finding| finding.case(FITTED)));
    }
    let Some(mesh) = of_body(file) else { return };
    if !is_in_archive(view, file, |mesh| mesh.facts.non_finite.count > 0) {
        let weighed = |finding: Finding| weigh(view, file, finding).case(OF_BASE);
        out.extend(positions(view, file, &mesh.facts).map(weighed));
    }
}

/// Texture coordinates of an asset.
fn of_worn(file: &FileFacts, facts: &MeshFacts) -> Option<Finding> {
    let (line, _) = facts.non_finite_uvs.first.first()?;
    let message = match facts.non_finite_uvs.count {
        1 => "a texture coordinate is NaN or infinite".to_owned(),
        count => format!("{count} texture coordinates are NaN or infinite"),
    };
    let finding = RULE
        .at(file, Place::Line(*line), message)
        .key("uv")
        .case(UV);
    Some(finding.help("give it finite numbers, or export the mesh again"))
}

fn positions(view: &View<'_>, file: &FileFacts, facts: &MeshFacts) -> Option<Finding> {
    let tally = &facts.non_finite;
    let (line, vertex) = tally.first.first()?;
    let named = view
        .landmarks(file)
        .map_or_else(|| format!("vertex {vertex}"), |body| body.vertex(*vertex));
    let message = match tally.count {
        1 => format!("the position of {named} is NaN or infinite"),
        count => format!("the positions of {count} vertices are NaN or infinite, first {named}"),
    };
    let element = Element {
        kind: "vertex",
        index: vertex.unsigned_abs(),
    };
    let place = if *line == 0 {
        Place::Element(element)
    } else {
        Place::Row(*line, element)
    };
    let finding = RULE
        .at(file, place, message)
        .help("give the vertex a finite position");
    Some(finding.evidence(tally.evidence(facts.vertices)))
}
