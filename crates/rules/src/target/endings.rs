//! Endings of targets that belong together, as `target-opposites` of `base.json` names them.

use std::collections::{BTreeMap, BTreeSet};

use super::parent;
use mhlint_repo::makehuman2::{Base, TargetFolder};

/// A pair of endings, the decreasing one first.
pub(super) type Pair<'a> = (&'a str, &'a str);

/// Pairs of endings, found by one of them.
#[derive(Default)]
pub(super) struct Endings<'a> {
    /// The first pair that each ending is of, with the place of the ending among all of them.
    first: BTreeMap<&'a str, (usize, Pair<'a>)>,
    /// The pairs by their decreasing endings, with their places.
    by_decr: BTreeMap<&'a str, (usize, &'a str)>,
}

impl<'a> Endings<'a> {
    /// Those that a base declares, and behind them another pair.
    pub(super) fn of(base: &Base<'a>, more: Option<Pair<'a>>) -> Self {
        let settings = base.settings().into_iter();
        let declared = settings.flat_map(|(_, settings)| &settings.opposites);
        let declared = declared.map(|(decr, incr)| (decr.as_str(), incr.as_str()));
        Self::of_pairs(declared.chain(more))
    }

    fn of_pairs(pairs: impl IntoIterator<Item = Pair<'a>>) -> Self {
        let mut endings = Self::default();
        for (place, (decr, incr)) in pairs.into_iter().enumerate() {
            endings.by_decr.entry(decr).or_insert((place, incr));
            for (ending, at) in [(decr, 2 * place), (incr, 2 * place + 1)] {
                endings.first.entry(ending).or_insert((at, (decr, incr)));
            }
        }
        endings
    }

    /// What is before the `-` of the ending of a name, the other ending of the pair, and the pair.
    pub(super) fn split<'n>(&self, name: &'n str) -> Option<(&'n str, &'a str, Pair<'a>)> {
        let known = at_dashes(name)
            .filter_map(|(begin, ending)| Some((self.first.get(ending)?, begin, ending)));
        let (_, begin, ending, pair) = known
            .map(|((place, pair), begin, ending)| (place, begin, ending, *pair))
            .min_by_key(|(place, ..)| *place)?;
        let other = if ending == pair.0 { pair.1 } else { pair.0 };
        Some((begin, other, pair))
    }

    /// What a name with a decreasing ending would be with the other one, for each pair, with the
    /// place of the pair.
    pub(super) fn increasing(&self, name: &str) -> impl Iterator<Item = (usize, String)> {
        let ends = name.char_indices().map(|(at, _)| at).chain([name.len()]);
        ends.filter_map(|at| {
            let (begin, ending) = name.split_at_checked(at)?;
            let (place, incr) = self.by_decr.get(ending)?;
            Some((*place, format!("{begin}{incr}")))
        })
    }

    /// The folders of a target folder that have both targets of a pair, with the pair.
    pub(super) fn in_use<'f>(&self, folder: TargetFolder<'f>) -> BTreeSet<(&'f str, Pair<'a>)> {
        let mut in_use = BTreeSet::new();
        for file in folder.layer.below(&folder.rel()) {
            let Some(name) = file.rel.strip_suffix(".target") else {
                continue;
            };
            for (begin, ending) in at_dashes(name) {
                let pair = self.by_decr.get_key_value(ending);
                in_use.extend(
                    pair.map(|(decr, (_, incr))| (*decr, *incr))
                        .filter(|(_, incr)| {
                            let rel = format!("{begin}-{incr}.target");
                            folder.layer.file(&rel).is_some()
                        })
                        .map(|pair| (parent(&file.rel), pair)),
                );
            }
        }
        in_use
    }
}

/// What is before and behind each `-` of a name.
fn at_dashes(name: &str) -> impl Iterator<Item = (&str, &str)> {
    let dashes = name.match_indices('-');
    dashes.filter_map(|(at, _)| Some((name.get(..at)?, name.get(at + 1..)?)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_pair_of_an_ending_counts() {
        let endings =
            Endings::of_pairs([("in", "out"), ("b-in", "out"), ("down", "up"), ("up", "x")]);
        for (name, expected) in [
            ("a-b-in", Some(("a-b", "out", ("in", "out")))),
            ("a-out", Some(("a", "in", ("in", "out")))),
            ("a-up", Some(("a", "down", ("down", "up")))),
            ("-x", Some(("", "up", ("up", "x")))),
            ("in", None),
            ("a-in-c", None),
        ] {
            assert_eq!(endings.split(name), expected, "{name}");
        }
        let increasing: Vec<_> = endings.increasing("a-b-in").collect();
        assert_eq!(
            increasing,
            [(1, "a-out".to_owned()), (0, "a-b-out".to_owned())]
        );
    }
}
