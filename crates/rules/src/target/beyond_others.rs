//! Targets that move much farther than those which they belong to: in the folder, or at the other
//! end of the slider.

use std::collections::BTreeSet;

use super::super::Rule;
use super::super::units::length;
use mhlint_diag::{Confidence, Element, Evidence, Finding, Place, grouped};
use mhlint_eval::proportion::{Lengths, is_out_of_scale, oversize, stands_out_of_folder};
use mhlint_formats::target::{Largest, TargetFacts};
use mhlint_repo::{Body, FileFacts, ReferenceKind};

fn lengths(facts: &TargetFacts, largest: &Largest) -> Lengths {
    Lengths {
        longest: largest.length,
        median: facts.median_length,
        tail: facts.tail_length,
    }
}

/// Details of a folder are of one kind and of one order: one that goes much farther than all others
/// was exported in other units.
pub(super) fn beyond_neighbours<'v>(
    rule: &Rule,
    body: &Body<'v>,
    size: f32,
    ratio: f32,
) -> Vec<(&'v FileFacts, Finding)> {
    let is_detail = |used_as| {
        use ReferenceKind::{Decr, Incr, SliderName, Slot};
        matches!(used_as, Some(Incr | Decr | Slot | SliderName))
    };
    let details = body
        .targets
        .iter()
        .filter(|target| is_detail(target.used_as));
    let folders = grouped(details.filter_map(|target| {
        let facts = target.file.target()?;
        Some((
            target.file.folder(),
            (target.file, facts, facts.largest.as_ref()?),
        ))
    }));
    folders
        .into_values()
        .filter_map(|details| beyond(rule, body, details, size, ratio))
        .collect()
}

fn beyond<'v>(
    rule: &Rule,
    body: &Body<'v>,
    mut details: Vec<(&'v FileFacts, &TargetFacts, &Largest)>,
    size: f32,
    ratio: f32,
) -> Option<(&'v FileFacts, Finding)> {
    details.sort_by(|one, other| other.2.length.total_cmp(&one.2.length));
    let [(file, facts, largest), (_, _, next), others @ ..] = details.as_slice() else {
        return None;
    };
    let own = lengths(facts, largest);
    let median = details
        .iter()
        .skip(1)
        .map(|(_, facts, _)| facts.median_length)
        .fold(0.0, f32::max);
    // A single row that stands out is told above.
    let is_told = oversize(own, size, ratio).is_some();
    if others.len() < 2
        || is_told
        || !stands_out_of_folder(
            own,
            Lengths {
                median,
                ..lengths(facts, next)
            },
            size,
        )
    {
        return None;
    }
    let times = largest.length / next.length;
    let message = format!(
        "{}, {times:.0} times as far as any other slider target in its folder",
        moves(body, largest)
    );
    Some((
        file,
        finding(rule, file, facts, largest, message)
            .key("folder")
            .confidence(Confidence::Medium),
    ))
}

/// The ends of a slider are made together, in one unit.
pub(super) fn beyond_opposites(
    rule: &Rule,
    body: &Body<'_>,
    told: &BTreeSet<&str>,
) -> Vec<Finding> {
    let known =
        |file: &FileFacts| body.target(&file.path).is_some() && !told.contains(file.path.as_str());
    let pairs = body
        .slider_ends
        .iter()
        .copied()
        .filter(|ends| ends.iter().all(|file| known(file)));
    pairs
        .filter_map(|ends| beyond_opposite(rule, body, ends))
        .collect()
}

fn beyond_opposite(rule: &Rule, body: &Body<'_>, ends: [&FileFacts; 2]) -> Option<Finding> {
    let [Some(one), Some(other)] =
        ends.map(|file| Some((file, file.target()?, file.target()?.largest?)))
    else {
        return None;
    };
    let is_first = one.2.length >= other.2.length;
    let ((file, facts, largest), (opposite, by, next)) =
        if is_first { (one, other) } else { (other, one) };
    if !is_out_of_scale(lengths(facts, &largest), lengths(by, &next)) {
        return None;
    }
    let times = largest.length / next.length;
    let name = opposite.stem().trim_end_matches(".target");
    let message = format!(
        "{}, {times:.0} times as far as `{name}`, the other end of its slider",
        moves(body, &largest)
    );
    let finding = finding(rule, file, facts, &largest, message)
        .key("opposite")
        .confidence(Confidence::Medium);
    Some(finding.related(&opposite.path, Place::File, "the other end"))
}

pub(super) fn moves(body: &Body<'_>, largest: &Largest) -> String {
    format!(
        "{} moves {}",
        body.vertex(largest.index),
        length(largest.length)
    )
}

pub(super) fn finding(
    rule: &Rule,
    file: &FileFacts,
    facts: &TargetFacts,
    largest: &Largest,
    message: String,
) -> Finding {
    let place = u64::try_from(largest.index).map_or(Place::Line(largest.line), |index| {
        Place::Row(
            largest.line,
            Element {
                kind: "vertex",
                index,
            },
        )
    });
    let evidence = Evidence::counted(1);
    rule.at(file, place, message)
        .help(
            "correct the numbers; a decimal point may be missing or the unit wrong: lengths are \
            in decimetres",
        )
        .evidence(evidence.out_of(facts.rows).with_worst(
            f64::from(largest.length),
            format!("vertex {}", largest.index),
        ))
}
