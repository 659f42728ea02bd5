//! Vertices of joints must exist in the base mesh.

use std::collections::BTreeMap;

use super::super::{Check, Rule, RuleCx, such};
use super::{Rig, rigs};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2},
    Case, Evidence, Finding, Level, Place, RuleInfo,
};
use mhlint_repo::Body;

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[
        (
            Makehuman2,
            "crashes with `IndexError` when it computes the position of the joint",
        ),
        (
            Makehuman1,
            "fails with `IndexError` when it computes the position of the joint",
        ),
    ],
    docs: include_str!("joint_out_of_range.md").trim_ascii_end(),
    counts: "entries",
    ..RuleInfo::new(
        "skeleton-joint-out-of-range",
        Level::Error,
        "a joint lists a vertex that the base mesh does not have",
    )
});

const STOPS: Case = &[
    (Makehuman2, Level::Error, "crashes with `IndexError`"),
    (Makehuman1, Level::Error, "fails with `IndexError`"),
];
const SEAM: Case = &[(
    Makehuman2,
    Level::Warning,
    "uses the position of a copy of another vertex, which it adds where the UV map is cut",
)];
const FROM_END: &str = "uses a vertex counted from the end of the mesh";
const NEGATIVE: Case = &[
    (Makehuman2, Level::Warning, FROM_END),
    (Makehuman1, Level::Warning, FROM_END),
];

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some((_, mesh)) = body.mesh.filter(|(_, mesh)| mesh.facts.vertices > 0) else {
        return;
    };
    let copies = if body.is_makehuman1() {
        0
    } else {
        mesh.facts.seam_duplicates
    };
    let sizes = (mesh.facts.vertices, mesh.facts.vertices + copies);
    for rig in rigs(body) {
        let mut faults: BTreeMap<Fault, Vec<(&str, usize, i64)>> = BTreeMap::new();
        let asked = rig.asked_joints();
        for joint in rig
            .skeleton
            .joints
            .iter()
            .filter(|joint| asked.contains(joint.name.as_str()))
        {
            for (at, vertex) in joint.vertices.iter().flatten().enumerate() {
                let Some(fault) = fault(*vertex, sizes) else {
                    continue;
                };
                faults
                    .entry(fault)
                    .or_default()
                    .push((&joint.name, at, *vertex));
            }
            for at in &joint.floats {
                faults
                    .entry(Fault::Float)
                    .or_default()
                    .push((&joint.name, *at, 0));
            }
        }
        out.extend(
            faults
                .iter()
                .filter_map(|(fault, cases)| finding(&rig, *fault, cases, sizes.0)),
        );
    }
}

#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Fault {
    Beyond,
    Float,
    Seam,
    Negative,
}

fn fault(vertex: i64, (vertices, with_seams): (usize, usize)) -> Option<Fault> {
    let below_zero = vertex < 0;
    match usize::try_from(vertex.unsigned_abs()).unwrap_or(usize::MAX) {
        index if below_zero && index > with_seams => Some(Fault::Beyond),
        _ if below_zero => Some(Fault::Negative),
        index if index >= with_seams => Some(Fault::Beyond),
        index if index >= vertices => Some(Fault::Seam),
        _ => None,
    }
}

fn finding(
    rig: &Rig<'_>,
    fault: Fault,
    cases: &[(&str, usize, i64)],
    vertices: usize,
) -> Option<Finding> {
    let (joint, at, vertex) = cases.first()?;
    let more = such(cases.len(), "entries");
    let (key, what) = match fault {
        Fault::Beyond => (
            "beyond",
            format!("vertex {vertex}, but the base mesh has {vertices} vertices"),
        ),
        Fault::Float => ("float", "a vertex number with a decimal point".to_owned()),
        Fault::Seam => (
            "seam",
            format!("vertex {vertex}, a UV-seam duplicate: the base mesh has {vertices} vertices"),
        ),
        Fault::Negative => ("negative", format!("the negative vertex number {vertex}")),
    };
    let names = cases.iter().map(|(joint, at, _)| format!("{joint}[{at}]"));
    let last = vertices.saturating_sub(1);
    let help =
        format!("list vertices from 0 to {last}; check that the skeleton was made for this mesh");
    let place = Place::pointer(["joints", joint, &at.to_string()]);
    let finding = RULE
        .at(
            rig.file,
            place,
            format!("joint `{joint}` lists {what}{more}"),
        )
        .key(key)
        .parts(
            cases
                .iter()
                .map(|(joint, _, vertex)| format!("{joint}: {vertex}")),
        )
        .help(help)
        .evidence(Evidence::of_cases(names));
    Some(match fault {
        Fault::Beyond | Fault::Float => rig.stops_with(STOPS, finding),
        Fault::Seam => finding.case(SEAM),
        Fault::Negative => finding.case(NEGATIVE),
    })
}
