//! Weights must be for vertices that exist.

use std::collections::BTreeSet;

use super::super::cause::worn;
use super::super::proxy::{STOPS_WITH_INDEX, STOPS_WITH_OVERFLOW};
use super::super::{Check, Rule, RuleCx};
use super::{Tallied, tallied};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2, Mpfb},
    Case, Finding, Level, RuleInfo,
};
use mhlint_repo::{Body, Doubt};

const USUAL: &str = "crashes with `IndexError` while loading the weights";

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[
        (Makehuman2, USUAL),
        (Makehuman1, USUAL),
        (Mpfb, "silently drops the entry"),
    ],
    levels: &[(Mpfb, Level::Warning)],
    docs: include_str!("vertex_out_of_range.md").trim_ascii_end(),
    counts: "entries",
    ..RuleInfo::new(
        "weights-vertex-out-of-range",
        Level::Error,
        "weights for a vertex that the mesh does not have",
    )
});

const NEGATIVE: Case = &[(
    Makehuman2,
    Level::Error,
    "crashes with `OverflowError` while loading the weights",
)];

/// Blender has 31 bits for it.
const HUGE: Case = &[(
    Mpfb,
    Level::Error,
    "fails with `SystemError` while loading the weights: later groups are missing",
)];

const OF_ASSET: Case = &[
    (Makehuman2, Level::Error, STOPS_WITH_INDEX),
    (
        Makehuman1,
        Level::Error,
        "puts the asset on; every pose fails with `ValueError`",
    ),
    (
        Mpfb,
        Level::Warning,
        "silently drops the entry; a group that has no other comes to nothing",
    ),
];
const OF_ASSET_NEGATIVE: Case = &[
    (Makehuman2, Level::Error, STOPS_WITH_OVERFLOW),
    (
        Makehuman1,
        Level::Error,
        "does not put the asset on: `IndexError` when it reads the weights",
    ),
    (Mpfb, Level::Warning, "silently drops the entry"),
];

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let assets: Vec<worn::Own<'_>> = worn::all(body).collect();
    out.extend(assets.iter().filter_map(of_asset));
    let of_assets: BTreeSet<&str> = assets.iter().map(|own| own.file.path.as_str()).collect();
    if body.doubt == Some(Doubt::Foreign) {
        return;
    }
    for Tallied {
        own,
        weights,
        tally,
        bone,
        vertex,
        place,
        ..
    } in tallied(body, |facts| &facts.out_of_range)
    {
        if of_assets.contains(own.file.path.as_str()) {
            continue;
        }
        let vertices = weights.facts.vertices;
        let size = match vertices.checked_sub(1) {
            Some(last) => format!("; the mesh has vertices 0 to {last}"),
            None => String::new(),
        };
        let message = match tally.count {
            1 => format!("bone `{bone}` has a weight for {vertex}, which does not exist{size}"),
            count => {
                format!(
                    "{count} entries name vertices that do not exist, first {vertex} in bone \
                        `{bone}`{size}"
                )
            }
        };
        let mut finding = RULE
            .at(own.file, place, message)
            .help(
                "use vertices of the base mesh, counted from 0, or the weights that were made \
                for this mesh",
            )
            .evidence(tally.evidence(weights.facts.pairs));
        if weights.facts.negative_index == tally.count {
            finding = finding.case(NEGATIVE);
        }
        if weights.facts.huge_index > 0 {
            finding = finding.case(HUGE);
        }
        out.push(finding);
    }
}

/// The finding on the weights of an asset.
fn of_asset(own: &worn::Own<'_>) -> Option<Finding> {
    let outside = own.outside()?;
    let (vertex, bone, last) = (outside.vertex, outside.bone, own.vertices.saturating_sub(1));
    let message = match outside.evidence.count {
        1 => format!(
            "bone `{bone}` has a weight for vertex {vertex}, which does not exist; the asset has \
                0 to {last}"
        ),
        count => format!(
            "{count} entries name vertices that the asset does not have (0 to {last}), first \
                {vertex}"
        ),
    };
    let finding = RULE
        .at(own.file, outside.place, message)
        .evidence(outside.evidence);
    let finding = finding.case(if outside.is_negative {
        OF_ASSET_NEGATIVE
    } else {
        OF_ASSET
    });
    Some(finding.help("use the vertices of the asset's own mesh, counted from 0"))
}
