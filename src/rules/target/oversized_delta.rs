//! Displacements out of all proportion: a lost decimal point, a wrong unit.

use super::super::units::{centimetres, length};
use super::super::{Check, Rule, RuleCx};
use super::shown::with_setting;
use super::targets;
use crate::diag::{
    Application::{Makehuman2, Mpfb},
    Confidence, Element, Evidence, Finding, Level, OptionInfo, Place, RuleInfo, grouped,
};
use crate::eval::proportion::{Lengths, MEDIAN_RATIO, Oversize, extent, oversize, stands_out_of_folder};
use crate::formats::target::{Largest, TargetFacts};
use crate::repo::{Body, FileFacts, ReferenceKind};

pub(in crate::rules) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[
        (Makehuman2, "tears the vertex out of the mesh when the target is applied"),
        (Mpfb, "tears the vertex out of the mesh when the target is applied"),
    ],
    docs: "A displacement is out of proportion to the mesh or to the rest of its target.\n\n\
        Reported are a vertex that moves farther than the size of the whole base mesh, and a vertex that stands \
        out from its own target: many times the median of the target, several times as far as all but its longest \
        rows, and a considerable part of the mesh. Also reported is a slider target that as a whole moves more \
        than five times as far as each of the others in its folder, if there are at least four targets.\n\n\
        A target that changes everything a lot, or grows steadily towards one place, is not reported. Without the \
        base mesh (`--system`) nothing is checked.\n\n\
        Usually a decimal point is missing (`119` for `.119`), or the shape was exported in other units; MakeHuman \
        counts in decimetres. Check the row; if the shape is intended, raise `ratio`.",
    options: &[OptionInfo {
        name: "ratio",
        default: MEDIAN_RATIO as f64,
        docs: "how many times its target's median displacement a vertex may move",
    }],
    counts: "rows",
    ..RuleInfo::new("target-oversized-delta", Level::Warning, "a displacement is out of proportion to mesh and target")
});

fn run(body: &Body<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some(size) = body.mesh.and_then(|(_, mesh)| extent(&mesh.positions)) else { return };
    #[expect(clippy::cast_possible_truncation, reason = "a factor set by people")]
    let ratio = cx.option(&RULE, "ratio") as f32;
    for (_, file, facts) in targets(body) {
        // A vertex that does not exist has a finding of its own.
        let exists = |largest: &Largest| facts.out_of_range.count == 0 || is_vertex(body, largest);
        let Some(largest) = facts.largest.filter(exists) else { continue };
        let lengths = Lengths { longest: largest.length, median: facts.median_length, tail: facts.tail_length };
        let (what, confidence) = match oversize(lengths, size, ratio) {
            Some(Oversize::BeyondMesh) => {
                (format!("more than the whole base mesh ({:.1} cm)", centimetres(size)), Confidence::High)
            }
            Some(Oversize::Outlier) => {
                let times = largest.length / facts.median_length;
                (format!("{times:.0} times the median of this target"), Confidence::Medium)
            }
            None => continue,
        };
        let message = format!("{}, {what}", moves(body, &largest));
        out.push(with_setting(finding(file, facts, &largest, message), body, file).confidence(confidence));
    }
    out.extend(beyond_neighbours(body, size, ratio));
}

/// Whether the row that goes farthest moves a vertex of the mesh.
fn is_vertex(body: &Body<'_>, largest: &Largest) -> bool {
    body.mesh.is_some_and(|(_, mesh)| usize::try_from(largest.index).is_ok_and(|vertex| vertex < mesh.facts.vertices))
}

/// Details of a folder are of one kind and of one order: one that goes much farther than all others was exported in
/// other units.
fn beyond_neighbours(body: &Body<'_>, size: f32, ratio: f32) -> Vec<Finding> {
    let is_detail = |used_as| {
        use ReferenceKind::{Decr, Incr, SliderName, Slot};
        matches!(used_as, Some(Incr | Decr | Slot | SliderName))
    };
    let details = body.targets.iter().filter(|target| is_detail(target.used_as));
    let folders = grouped(details.filter_map(|target| {
        let facts = target.file.target()?;
        Some((target.file.folder(), (target.file, facts, facts.largest.as_ref()?)))
    }));
    folders.into_values().filter_map(|details| beyond(body, details, size, ratio)).collect()
}

fn beyond(
    body: &Body<'_>,
    mut details: Vec<(&FileFacts, &TargetFacts, &Largest)>,
    size: f32,
    ratio: f32,
) -> Option<Finding> {
    details.sort_by(|one, other| other.2.length.total_cmp(&one.2.length));
    let [(file, facts, largest), (_, _, next), others @ ..] = details.as_slice() else { return None };
    let lengths = |facts: &TargetFacts, largest: &Largest| Lengths {
        longest: largest.length,
        median: facts.median_length,
        tail: facts.tail_length,
    };
    let own = lengths(facts, largest);
    let median = details.iter().skip(1).map(|(_, facts, _)| facts.median_length).fold(0.0, f32::max);
    // A single row that stands out is told above.
    let is_told = oversize(own, size, ratio).is_some();
    if others.len() < 2 || is_told || !stands_out_of_folder(own, Lengths { median, ..lengths(facts, next) }, size) {
        return None;
    }
    let times = largest.length / next.length;
    let message = format!("{}, {times:.0} times as far as any other slider target in its folder", moves(body, largest));
    Some(finding(file, facts, largest, message).key("folder").confidence(Confidence::Medium))
}

fn moves(body: &Body<'_>, largest: &Largest) -> String {
    format!("{} moves {}", body.vertex(largest.index), length(largest.length))
}

fn finding(file: &FileFacts, facts: &TargetFacts, largest: &Largest, message: String) -> Finding {
    let place = u64::try_from(largest.index)
        .map_or(Place::Line(largest.line), |index| Place::Row(largest.line, Element { kind: "vertex", index }));
    let evidence = Evidence::counted(1);
    RULE.at(file, place, message)
        .parts([largest.index])
        .help("correct the numbers; a decimal point may be missing or the unit wrong: lengths are in decimetres")
        .evidence(
            evidence.out_of(facts.rows).with_worst(f64::from(largest.length), format!("vertex {}", largest.index)),
        )
}
