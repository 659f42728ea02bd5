//! Displacements out of all proportion: a lost decimal point, a wrong unit.

use std::cell::LazyCell;
use std::collections::BTreeSet;

use super::super::units::centimetres;
use super::super::{Check, Rule, RuleCx};
use super::beyond_others::{beyond_neighbours, beyond_opposites, finding, moves};
use super::shown::with_setting;
use super::targets;
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2, Mpfb},
    Confidence, Finding, Grows, Level, MeasureKind, OptionInfo, RuleInfo,
};
use mhlint_eval::proportion::{
    Lengths, MEDIAN_RATIO, Oversize, extent, is_torn_out, oversize, standing_out,
};
use mhlint_eval::tears::Neighbours;
use mhlint_formats::target::TargetFacts;
use mhlint_repo::Body;

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[
        (
            Makehuman2,
            "tears the vertex out of the mesh when the target is applied",
        ),
        (
            Makehuman1,
            "tears the vertex out of the mesh when the target is applied",
        ),
        (
            Mpfb,
            "tears the vertex out of the mesh when the target is applied",
        ),
    ],
    docs: include_str!("oversized_delta.md").trim_ascii_end(),
    options: &[OptionInfo {
        name: "ratio",
        default: MEDIAN_RATIO as f64,
        docs: "how many times its target's median displacement a vertex may move",
    }],
    counts: "rows",
    grows: Grows::more(MeasureKind::Distance),
    ..RuleInfo::new(
        "target-oversized-delta",
        Level::Warning,
        "a displacement is out of proportion to mesh and target",
    )
});

fn run(body: &Body<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    // A mesh in another unit is told itself.
    let mesh = body.mesh.filter(|_| body.doubt.is_none());
    let Some(size) = mesh.and_then(|(_, mesh)| extent(&mesh.positions)) else {
        return;
    };
    #[expect(clippy::cast_possible_truncation, reason = "a factor set by people")]
    let ratio = cx.option(&RULE, "ratio") as f32;
    let neighbours = LazyCell::new(|| {
        let mesh = mesh.map(|(_, mesh)| mesh);
        mesh.map(|mesh| Neighbours::new(mesh.positions.len(), mesh.vertices_of_faces()))
    });
    let is_torn = |facts: &TargetFacts, index| {
        let neighbours = neighbours.as_ref();
        neighbours.is_none_or(|neighbours| {
            is_torn_out(&facts.longest, facts.tail_length, index, neighbours)
        })
    };
    let mut told: BTreeSet<&str> = BTreeSet::new();
    for (_, file, facts) in targets(body) {
        let Some(largest) = facts.largest else {
            continue;
        };
        let lengths = Lengths {
            longest: largest.length,
            median: facts.median_length,
            tail: facts.tail_length,
        };
        let (what, confidence) = match oversize(lengths, size, ratio) {
            Some(Oversize::BeyondMesh) => (
                format!(
                    "more than the whole base mesh ({:.1} cm)",
                    centimetres(size)
                ),
                Confidence::High,
            ),
            Some(Oversize::Outlier) if is_torn(facts, largest.index) => {
                let times = largest.length / facts.median_length;
                (
                    format!("{times:.0} times the median of this target"),
                    Confidence::Medium,
                )
            }
            _ => continue,
        };
        let message = format!("{}, {what}", moves(body, &largest));
        told.insert(file.path.as_str());
        // Shorter ones would be new when the longest is as it should be.
        let known = standing_out(&facts.longest, facts.median_length, size, ratio).map(i64::from);
        let parts: BTreeSet<i64> = known.chain([largest.index]).collect();
        let finding = finding(&RULE, file, facts, &largest, message).parts(parts);
        out.push(with_setting(finding, body, file).confidence(confidence));
    }
    let of_folders = beyond_neighbours(&RULE, body, size, ratio);
    told.extend(of_folders.iter().map(|(file, _)| file.path.as_str()));
    out.extend(of_folders.into_iter().map(|(_, finding)| finding));
    out.extend(beyond_opposites(&RULE, body, &told));
}
