//! Names of which no target is there.

use std::collections::{BTreeMap, BTreeSet};

use crate::repo::mpfb::loops::{Axis, LOOPS};
use crate::repo::mpfb::{Parts, Request};

/// Requests that sliders lead to and whose target is missing. One that cannot be opened has a finding of its own.
pub(super) fn missing<'v, 'a>(parts: &'v Parts<'a>) -> impl Iterator<Item = &'v Request<'a>> {
    let is_missing = |request: &&Request<'_>| request.is_reachable && request.file.is_none();
    parts.requests.iter().filter(is_missing).filter(|request| !parts.layer.has_fault(&request.rel))
}

/// The names of settings, by place, that no target has although another name at their place has some.
pub(super) fn lost_names<'p>(parts: &'p Parts<'_>) -> BTreeSet<(usize, &'p str)> {
    let mut there: BTreeMap<(usize, &str), bool> = BTreeMap::new();
    for (number, own) in LOOPS.iter().enumerate() {
        let lists = own.names(parts.settings);
        for request in parts.requests.iter().filter(|request| request.number == number && request.is_reachable) {
            for ((axis, list), name) in own.axes.iter().zip(&lists).zip(&request.names) {
                let (Axis::Setting(place), Some(name)) = (axis, list.get(*name)) else { continue };
                *there.entry((*place, name.text)).or_default() |= request.file.is_some();
            }
        }
    }
    let is_needed = |place: usize| there.iter().any(|((other, _), is_there)| *other == place && *is_there);
    let lost = there.iter().filter(|((place, _), is_there)| !**is_there && is_needed(*place));
    lost.map(|(name, _)| *name).collect()
}
