//! Where on a body vertices are, and the worst of them: one of the visible body counts before one
//! of helpers.

use std::collections::BTreeMap;

use super::super::regions::in_words;
use mhlint_repo::{Body, Region};

/// The worst of some vertices, and where all of them are.
pub(super) struct Worst {
    pub(super) vertex: u32,
    pub(super) value: f32,
    /// How many are on the visible body and how many on helpers, where that is known.
    pub(super) places: Option<String>,
}

/// Costs what the vertices are, not the size of the mesh.
pub(super) fn worst(
    body: &Body<'_>,
    all: &[(u32, f32)],
    badness: impl Fn(f32) -> f32,
) -> Option<Worst> {
    let mut counts: BTreeMap<Region, usize> = BTreeMap::new();
    let mut worst: Option<(Option<Region>, u32, f32)> = None;
    for (vertex, value) in all {
        let region = body.region(*vertex);
        region
            .into_iter()
            .for_each(|region| *counts.entry(region).or_default() += 1);
        let is_worse = |(other, _, most): &(Option<Region>, u32, f32)| {
            region < *other || region == *other && badness(*value) > badness(*most)
        };
        if worst.as_ref().is_none_or(is_worse) {
            worst = Some((region, *vertex, *value));
        }
    }
    worst.map(|(_, vertex, value)| Worst {
        vertex,
        value,
        places: in_words(&counts),
    })
}
