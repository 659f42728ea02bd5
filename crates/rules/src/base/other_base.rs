//! A `base.json` that was made for another base mesh: most of the names in it do not exist.

use super::NO_MEASURE;
use mhlint_diag::{Evidence, Finding, Parts};
use mhlint_formats::base_json::{BaseJson, Random};
use mhlint_repo::makehuman2::{Base, View};

/// More unknown names than this are not single slips if they are most of all.
const SLIPS: usize = 5;

/// Bases that are asked whether names are theirs.
const COMPARED: usize = 256;

/// One finding where most of the names do not exist: base.json is that of another base.
pub(super) fn of_other_base(
    view: &View<'_>,
    base: &Base<'_>,
    settings: &BaseJson,
    found: Vec<Finding>,
) -> Vec<Finding> {
    let (unknown, mut others): (Vec<_>, Vec<_>) = found
        .into_iter()
        .partition(|finding| !finding.subject.parts.is_empty());
    let (count, all) = (unknown.len(), count_of_names(settings));
    if count <= SLIPS || 2 * count <= all {
        others.splice(0..0, unknown);
        return others;
    }
    let keys: Vec<String> = unknown
        .iter()
        .map(|finding| finding.subject.key.clone())
        .collect();
    let Some(first) = unknown.into_iter().next() else {
        return others;
    };
    let has_presets = |other: &&Base<'_>| {
        !std::ptr::eq(*other, base)
            && settings
                .presets
                .iter()
                .all(|(pattern, _)| other.slider(pattern).is_some())
    };
    let help = match view
        .bases
        .iter()
        .take(COMPARED)
        .find(has_presets)
        .filter(|_| !settings.presets.is_empty())
    {
        Some(other) => format!(
            "use the names of this base: those in the file belong to base `{}`",
            other.name
        ),
        None => "use the names of this base: those in the file seem to belong to another base"
            .to_owned(),
    };
    let mut one = Finding {
        message: format!("{count} of {all} slider and group names do not exist"),
        ..first
    };
    one.subject.parts = Parts::default();
    others.insert(
        0,
        one.key("names")
            .help(help)
            .evidence(Evidence::of_cases(&keys).out_of(all)),
    );
    others
}

/// How many names of sliders and groups there are that can be unknown.
fn count_of_names(settings: &BaseJson) -> usize {
    let measures = settings
        .measure
        .iter()
        .filter(|(_, pattern)| pattern != NO_MEASURE)
        .count();
    let of_random = |random: &Random| {
        let keys = random.gender.iter().chain(&random.ideal).count();
        let conditions: usize = random
            .rules
            .iter()
            .map(|(_, conditions)| conditions.len())
            .sum();
        keys + random.groups.len() + random.rules.len() + conditions
    };
    let heads = settings.head_pattern.iter().flatten().count();
    settings.presets.len() + measures + heads + settings.random.as_ref().map_or(0, of_random)
}
