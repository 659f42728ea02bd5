//! Names of which no target is there.

use std::collections::{BTreeMap, BTreeSet};

use mhlint_eval::mpfb::loops::{CUT_OFF, DEFAULTS};
use mhlint_eval::mpfb::shares::Part;
use mhlint_formats::macro_parts::Setting;
use mhlint_repo::mpfb::loops::{Axis, LOOPS};
use mhlint_repo::mpfb::{Parts, Request};

/// Requests that sliders lead to and whose target is missing. One that cannot be opened has a
/// finding of its own.
pub(super) fn missing<'v, 'a>(parts: &'v Parts<'a>) -> impl Iterator<Item = &'v Request<'a>> {
    let is_missing = |request: &&Request<'_>| request.is_reachable && request.file.is_none();
    parts
        .requests
        .iter()
        .filter(is_missing)
        .filter(|request| !parts.layer.has_fault(&request.rel))
}

/// Whether a new character needs one of the targets: all its names have a share where every setting
/// is at its default.
pub(super) fn are_of_default(parts: &Parts<'_>, missing: &[&Request<'_>]) -> bool {
    let shares: BTreeMap<(usize, &str), f64> = parts
        .settings
        .settings
        .iter()
        .flat_map(default_shares)
        .collect();
    missing.iter().any(|request| {
        let Some(own) = LOOPS.get(request.number) else {
            return false;
        };
        let named = own
            .axes
            .iter()
            .zip(own.names(parts.settings))
            .zip(&request.names);
        let weight = named.map(|((axis, list), name)| match (axis, list.get(*name)) {
            (Axis::Setting(place), Some(name)) => {
                shares.get(&(*place, name.text)).copied().unwrap_or(0.0)
            }
            (Axis::Race, _) => DEFAULTS.1,
            _ => 1.0,
        });
        weight.product::<f64>() > CUT_OFF
    })
}

fn default_shares(setting: &Setting) -> impl Iterator<Item = ((usize, &str), f64)> {
    setting.parts.iter().flat_map(move |part| {
        let range = Part {
            lowest: part.lowest,
            highest: part.highest,
            low: None,
            high: None,
        };
        let [low, high] = range.shares(DEFAULTS.0);
        let named = [(part.low.as_deref(), low), (part.high.as_deref(), high)];
        let there = named.into_iter().filter(move |_| range.holds(DEFAULTS.0));
        there.filter_map(move |(name, share)| Some(((setting.place, name?), share)))
    })
}

/// The names of settings, by place, that no target has although another name at their place has
/// some.
pub(super) fn lost_names<'p>(parts: &'p Parts<'_>) -> BTreeSet<(usize, &'p str)> {
    let mut there: BTreeMap<(usize, &str), bool> = BTreeMap::new();
    for (number, own) in LOOPS.iter().enumerate() {
        let lists = own.names(parts.settings);
        for request in parts
            .requests
            .iter()
            .filter(|request| request.number == number && request.is_reachable)
        {
            for ((axis, list), name) in own.axes.iter().zip(&lists).zip(&request.names) {
                let (Axis::Setting(place), Some(name)) = (axis, list.get(*name)) else {
                    continue;
                };
                *there.entry((*place, name.text)).or_default() |= request.file.is_some();
            }
        }
    }
    let needed: BTreeSet<usize> = there
        .iter()
        .filter(|(_, is_there)| **is_there)
        .map(|((place, _), _)| *place)
        .collect();
    let lost = there
        .iter()
        .filter(|((place, _), is_there)| !**is_there && needed.contains(place));
    lost.map(|(name, _)| *name).collect()
}
