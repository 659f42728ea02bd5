//! A `comp` with more or fewer components than all names of its definition have parts.

use super::listing::{Listing, Slip};
use crate::formats::macro_json::{Component, MacroFile};

/// How many parts the names have, and the components that their parts are values of, where that is clear.
pub(super) fn lacking<'a>(macros: &'a MacroFile, listing: &Listing<'_>) -> Option<(usize, Option<Vec<&'a str>>)> {
    let Slip::Parts(parts) = &listing.strangers.first()?.slip else { return None };
    let is_like_it = |slip: &Slip| matches!(slip, Slip::Parts(other) if other == parts);
    let are_all = listing.found.is_empty() && listing.strangers.iter().all(|stranger| is_like_it(&stranger.slip));
    if !are_all || *parts == 0 || listing.strangers.len() < 2 {
        return None;
    }
    let meant = (0..*parts).map(|part| component_of(macros, listing, part)).collect();
    Some((*parts, meant))
}

/// The only component that has the parts at one place of all names as values.
fn component_of<'a>(macros: &'a MacroFile, listing: &Listing<'_>, part: usize) -> Option<&'a str> {
    let tokens = || listing.strangers.iter().filter_map(|stranger| stranger.link.name.split('-').nth(part));
    let has_all = |component: &&Component| tokens().all(|token| component.values.iter().any(|value| value == token));
    let mut fitting = macros.components.iter().filter(has_all);
    fitting.next().filter(|_| fitting.next().is_none()).map(|component| component.name.as_str())
}
