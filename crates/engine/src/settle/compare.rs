//! Compares the findings before with the findings now: which are new, worse, the same or gone.

use std::cell::Cell;
use std::cmp::Ordering;

use mhlint_diag::{
    Break, Figure, Finding, Grown, Grows, Level, Measure, NameIndex, Parts, grouped,
};

/// A finding in the form in which it is compared.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Claim<'f> {
    pub(crate) rule: &'f str,
    pub(crate) asset: &'f str,
    pub(crate) key: &'f str,
    pub(crate) parts: &'f Parts,
    /// The level that the rule gave, whatever the settings change it to.
    pub(crate) level: Level,
    /// The level in each application, where it is known.
    pub(crate) breaks: &'f [Break],
    /// The amount that the finding measures, such as a distance.
    pub(crate) value: Option<Figure>,
    /// In which direction the amount gets worse. A baseline does not keep this, so that only
    /// findings of this run have it.
    pub(crate) grows: Option<Grows>,
}

/// What a finding now is, compared with the findings before.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum Standing {
    /// Before there was no finding on its subject.
    New,
    /// Its level is higher, or it has parts that were not reported before, or not at this level:
    /// these parts.
    Worse(Parts),
    /// Its level and parts are as before or better, but its amount is worse: the amount before.
    Grown(Figure),
    /// It was there before, and was as bad.
    Same,
    /// It was there before, and the amount is better now.
    Smaller,
}

impl Standing {
    /// The finding to report, if any. A finding that is worse is reduced to what is worse.
    pub(crate) fn of(self, mut finding: Finding) -> Option<Finding> {
        match self {
            Self::New => Some(finding),
            Self::Worse(parts) => finding.narrow(&parts).then_some(finding),
            Self::Grown(before) => {
                let now = finding.measure();
                finding.grown = now.map(|now| Grown {
                    of: now.grows.of,
                    from: before.0,
                    to: now.value.0,
                });
                Some(finding)
            }
            Self::Same | Self::Smaller => None,
        }
    }
}

/// The result of a comparison.
#[derive(Debug, PartialEq, Eq)]
pub(crate) struct Comparison {
    /// For each finding now what it is compared with those before.
    pub(crate) now: Vec<Standing>,
    /// Indices of the findings before that no longer occur.
    pub(crate) gone: Vec<usize>,
}

/// Compares findings. Several findings may have the same rule, asset and key, because a rule may
/// report each part by itself, or all parts together. A finding with all parts counts as equal to
/// several findings with one part each. A finding without parts is compared with one other finding.
///
/// At first each finding now takes one equal finding before, so that no finding is new that was
/// there before, whatever other findings have the same asset and key. If there are more equal
/// findings now than before, some get none.
pub(crate) fn compare(before: &[Claim<'_>], now: &[Claim<'_>]) -> Comparison {
    let met = vec![Cell::new(false); before.len()];
    let known = before.iter().zip(&met);
    let alike = grouped(known.map(|(claim, met)| (claim.subject(), Known { claim, met })));
    let now: Vec<(&Claim<'_>, &[Known<'_>])> = now
        .iter()
        .map(|claim| {
            (
                claim,
                alike.get(&claim.subject()).map_or(&[][..], Vec::as_slice),
            )
        })
        .collect();
    let mut stayed: Vec<Option<Standing>> = now
        .iter()
        .map(|(claim, known)| take_equal(claim, known))
        .collect();
    // Then the rest take findings that are equal except for the amount and that are not taken yet.
    for ((claim, known), stayed) in now
        .iter()
        .zip(&mut stayed)
        .filter(|(_, stayed)| stayed.is_none())
    {
        *stayed = take_changed(claim, known);
    }
    let standing =
        |((claim, known), stayed): (&(&Claim<'_>, &[Known<'_>]), Option<Standing>)| match known {
            [] => Standing::New,
            known => stayed.unwrap_or_else(|| standing(claim, known)),
        };
    let now = now.iter().zip(stayed).map(standing).collect();
    Comparison {
        now,
        gone: (0..)
            .zip(&met)
            .filter(|(_, met)| !met.get())
            .map(|(at, _)| at)
            .collect(),
    }
}

/// Takes a finding that is equal, also in its amount, and that is not taken yet.
fn take_equal(claim: &Claim<'_>, known: &[Known<'_>]) -> Option<Standing> {
    let is_as_much = |known: &&Known<'_>| known.claim.value == claim.value;
    let mut free = known
        .iter()
        .filter(|known| !known.met.get() && known.claim.is_equal(claim));
    free.find(is_as_much).map(|known| {
        known.met.set(true);
        Standing::Same
    })
}

/// Takes a finding that is equal except for its amount, and whose amount was not better: of several
/// the one with the mildest amount.
fn take_changed(claim: &Claim<'_>, known: &[Known<'_>]) -> Option<Standing> {
    let free = known
        .iter()
        .filter(|known| !known.met.get() && known.claim.is_equal(claim));
    let enough = free.filter(|known| claim.grown_since(known.claim.value).is_none());
    let one = enough.min_by(|one, other| claim.compare(one.claim.value, other.claim.value))?;
    one.met.set(true);
    Some(if claim.is_smaller_than(one.claim.value) {
        Standing::Smaller
    } else {
        Standing::Same
    })
}

/// The findings that are new, and of those that are worse what is worse. A finding that is not
/// `compared` is always reported: it is not known what was there before.
pub(crate) fn new_or_worse(
    before: &[Finding],
    found: Vec<Finding>,
    is_compared: impl Fn(&Finding) -> bool,
) -> Vec<Finding> {
    let standings = compare(&claims(before), &claims(&found)).now;
    let told = found
        .into_iter()
        .zip(standings)
        .filter_map(|(finding, standing)| {
            if is_compared(&finding) {
                standing.of(finding)
            } else {
                Some(finding)
            }
        });
    told.collect()
}

/// How many of the findings before no longer occur, and how many have a better amount now.
pub(crate) fn gone_and_smaller(before: &[Finding], now: &[Finding]) -> [usize; 2] {
    let Comparison { now, gone } = compare(&claims(before), &claims(now));
    [
        gone.len(),
        now.iter()
            .filter(|standing| **standing == Standing::Smaller)
            .count(),
    ]
}

fn claims(findings: &[Finding]) -> Vec<Claim<'_>> {
    findings.iter().map(Claim::of).collect()
}

/// A finding before.
struct Known<'k> {
    claim: &'k Claim<'k>,
    /// Whether a finding now was matched with it.
    met: &'k Cell<bool>,
}

/// What a finding now is, compared with the findings before that have the same rule, asset and key.
fn standing(claim: &Claim<'_>, known: &[Known<'_>]) -> Standing {
    let is_as_bad = |known: &Known<'_>| known.claim.is_as_bad_as(claim);
    let (whole, named): (Vec<&Known<'_>>, Vec<_>) =
        known.iter().partition(|known| known.claim.parts.is_empty());
    let unmet = || whole.iter().filter(|known| !known.met.get());
    // The finding before with the lowest level that is still as bad: one with a higher level may
    // belong to another finding now.
    let has_grown = |known: &Known<'_>| claim.grown_since(known.claim.value).is_some();
    let enough = unmet()
        .filter(|known| is_as_bad(known))
        .min_by_key(|known| (has_grown(known), known.claim.level));
    if let Some(one) = enough.or_else(|| unmet().next()) {
        one.met.set(true);
        return match claim.grown_since(one.claim.value) {
            _ if !is_as_bad(one) => Standing::Worse(claim.parts.clone()),
            Some(before) => Standing::Grown(before),
            None if claim.is_smaller_than(one.claim.value) => Standing::Smaller,
            None => Standing::Same,
        };
    }
    let own = NameIndex::of([claim.parts]);
    let told: Vec<&Known<'_>> = named
        .into_iter()
        .filter(|one| known.len() == 1 || own.has_one_of(one.claim.parts))
        .collect();
    told.iter().for_each(|known| known.met.set(true));
    let worse = claim.parts.without(
        told.iter()
            .filter(|known| is_as_bad(known))
            .map(|known| known.claim.parts),
    );
    // If several findings before are one finding now, their worst amount counts. Old baselines have
    // no amounts: then nothing is known.
    let most = told
        .iter()
        .map(|known| known.claim.value)
        .max_by(|one, other| claim.compare(*one, *other))
        .flatten();
    let before = most.filter(|_| told.iter().all(|known| known.claim.value.is_some()));
    match (told.is_empty(), claim.parts.is_empty() || !worse.is_empty()) {
        (true, _) => Standing::New,
        (_, true) => Standing::Worse(worse),
        (_, false) => match claim.grown_since(before) {
            Some(before) => Standing::Grown(before),
            None if claim.is_smaller_than(before) => Standing::Smaller,
            None => Standing::Same,
        },
    }
}

impl<'f> Claim<'f> {
    fn of(finding: &'f Finding) -> Self {
        let Finding {
            rule,
            level,
            subject,
            breaks,
            ..
        } = finding;
        let (asset, key, parts) = (finding.asset_path(), &subject.key, &subject.parts);
        let (value, grows) = finding.measure().map(|one| (one.value, one.grows)).unzip();
        Self {
            rule,
            asset,
            key,
            parts,
            level: *level,
            breaks,
            value,
            grows,
        }
    }

    fn measure(&self) -> Option<Measure> {
        Some(Measure {
            grows: self.grows?,
            value: self.value?,
        })
    }

    /// The amount before, if the amount now is worse.
    fn grown_since(&self, before: Option<Figure>) -> Option<Figure> {
        let (now, before) = self.measure().zip(before)?;
        now.is_worse_than(before).then_some(before)
    }

    fn is_smaller_than(&self, before: Option<Figure>) -> bool {
        self.measure()
            .zip(before)
            .is_some_and(|(now, before)| now.is_better_than(before))
    }

    /// Which of two amounts is worse.
    fn compare(&self, one: Option<Figure>, other: Option<Figure>) -> Ordering {
        match (self.measure(), one, other) {
            (Some(now), Some(one), Some(other)) => now.compare(one, other),
            _ => one.cmp(&other),
        }
    }

    /// Whether it is at least as bad as the other one, for each application.
    fn is_as_bad_as(&self, other: &Self) -> bool {
        let covers =
            |own: &Break, one: &Break| own.application == one.application && own.level >= one.level;
        let is_covered = |one: &Break| self.breaks.iter().any(|own| covers(own, one));
        self.level >= other.level && (self.breaks.is_empty() || other.breaks.iter().all(is_covered))
    }

    /// Whether both have the same parts, and the same level for each application.
    fn is_equal(&self, other: &Self) -> bool {
        let levels = |claim: &Self| {
            claim
                .breaks
                .iter()
                .map(|one| (one.application, one.level))
                .collect::<Vec<_>>()
        };
        self.level == other.level && self.parts == other.parts && levels(self) == levels(other)
    }

    /// Its rule, asset and key: what it is about, without the parts.
    const fn subject(&self) -> (&str, &str, &str) {
        (self.rule, self.asset, self.key)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use mhlint_diag::{Application, MeasureKind};

    fn parts(names: &[&str]) -> Parts {
        names.iter().collect()
    }

    fn claim<'p>(key: &'p str, level: Level, parts: &'p Parts) -> Claim<'p> {
        Claim {
            rule: "r",
            asset: "a",
            key,
            parts,
            level,
            breaks: &[],
            value: None,
            grows: None,
        }
    }

    fn compared(before: &[&[&str]], now: &[&[&str]]) -> (Vec<Standing>, Vec<usize>) {
        let parts = |all: &[&[&str]]| all.iter().map(|names| parts(names)).collect::<Vec<_>>();
        let (before, now) = (parts(before), parts(now));
        let before: Vec<_> = before
            .iter()
            .map(|parts| claim("", Level::Warning, parts))
            .collect();
        let now: Vec<_> = now
            .iter()
            .map(|parts| claim("", Level::Warning, parts))
            .collect();
        let Comparison { now, gone } = compare(&before, &now);
        (now, gone)
    }

    fn worse(names: &[&str]) -> Standing {
        Standing::Worse(parts(names))
    }

    #[test]
    fn another_rule_asset_or_key_is_new_and_the_old_one_gone() {
        let none = Parts::default();
        let old = claim("k", Level::Warning, &none);
        for new in [
            Claim { rule: "s", ..old },
            Claim { asset: "b", ..old },
            Claim { key: "l", ..old },
        ] {
            assert_eq!(
                compare(&[old], &[new]),
                Comparison {
                    now: vec![Standing::New],
                    gone: vec![0]
                }
            );
        }
        assert_eq!(
            compare(&[old], &[old]),
            Comparison {
                now: vec![Standing::Same],
                gone: Vec::new()
            }
        );
    }

    #[test]
    fn a_higher_level_is_worse_and_a_lower_one_the_same() {
        let one = parts(&["x"]);
        let at = |level| {
            compare(
                &[claim("", Level::Warning, &one)],
                &[claim("", level, &one)],
            )
        };
        assert_eq!(
            [Level::Info, Level::Warning].map(|level| at(level).now),
            [[Standing::Same], [Standing::Same]]
        );
        assert_eq!(
            at(Level::Error),
            Comparison {
                now: vec![worse(&["x"])],
                gone: Vec::new()
            }
        );
    }

    #[test]
    fn a_higher_level_in_one_application_is_worse() {
        let one = |application, level| Break {
            application,
            level,
            effect: String::new(),
        };
        let breaks = |mpfb| {
            [
                one(Application::Makehuman2, Level::Error),
                one(Application::Mpfb, mpfb),
            ]
        };
        let (mild, grave, none) = (breaks(Level::Info), breaks(Level::Error), Parts::default());
        let claim = |breaks| Claim {
            breaks,
            ..claim("", Level::Error, &none)
        };
        let standing = |before, now| compare(&[claim(before)], &[claim(now)]).now;
        assert_eq!(standing(&mild, &grave), [worse(&[])]);
        assert_eq!(
            [standing(&grave, &mild), standing(&[], &grave)],
            [[Standing::Same], [Standing::Same]]
        );
        assert_eq!(
            standing(&mild[..1], &mild),
            [worse(&[])],
            "told for another application"
        );
    }

    /// Compares findings that have the same subject and differ in their amounts.
    fn measured(before: &[Option<f64>], now: &[f64]) -> Vec<Standing> {
        let none = Parts::default();
        let known = |of: &Option<f64>| Claim {
            value: of.map(Figure),
            ..claim("", Level::Warning, &none)
        };
        let own = |now: &f64| {
            let grows = Grows::more(MeasureKind::Gap);
            Claim {
                value: Some(Figure(*now)),
                grows,
                ..claim("", Level::Warning, &none)
            }
        };
        compare(
            &before.iter().map(known).collect::<Vec<_>>(),
            &now.iter().map(own).collect::<Vec<_>>(),
        )
        .now
    }

    #[test]
    fn what_grew_is_worse_and_what_shrank_is_counted() {
        assert_eq!(
            measured(&[Some(1.0)], &[1.2]),
            [Standing::Grown(Figure(1.0))]
        );
        assert_eq!(measured(&[Some(1.0)], &[1.05]), [Standing::Same]);
        assert_eq!(measured(&[Some(1.0)], &[0.5]), [Standing::Smaller]);
        assert_eq!(
            measured(&[None], &[9.0]),
            [Standing::Same],
            "an entry without a measure hides any"
        );
        assert_eq!(
            measured(&[Some(10.0), Some(1.0)], &[1.0, 10.0]),
            [Standing::Same, Standing::Same]
        );
        assert_eq!(
            measured(&[Some(5.0), Some(1.0)], &[2.0, 0.95]),
            [Standing::Smaller, Standing::Same]
        );
    }

    #[test]
    fn equal_findings_are_matched_whatever_their_order() {
        let none = Parts::default();
        let at = |levels: [Level; 2]| levels.map(|level| claim("", level, &none));
        let compared = compare(
            &at([Level::Error, Level::Warning]),
            &at([Level::Info, Level::Error]),
        );
        assert_eq!(
            compared,
            Comparison {
                now: vec![Standing::Same, Standing::Same],
                gone: Vec::new()
            }
        );
    }

    #[test]
    fn a_part_that_was_not_there_is_worse() {
        let known = |now: &[&str]| compared(&[&["x", "y"]], &[now]);
        assert_eq!(
            [known(&["x"]), known(&["y", "x"])],
            [
                (vec![Standing::Same], vec![]),
                (vec![Standing::Same], vec![])
            ]
        );
        assert_eq!(known(&["z", "x"]), (vec![worse(&["z"])], vec![]));
        assert_eq!(
            known(&["z"]),
            (vec![worse(&["z"])], vec![]),
            "the only one of its subject"
        );
        assert_eq!(
            known(&[]),
            (vec![worse(&[])], vec![]),
            "too many to be told apart"
        );
        let (old, new) = (parts(&["x"]), Parts::in_files([("x", "one"), ("y", "two")]));
        let compared = compare(
            &[claim("", Level::Info, &old)],
            &[claim("", Level::Info, &new)],
        );
        let [Standing::Worse(worse)] = compared.now.as_slice() else {
            panic!("{compared:?}")
        };
        assert_eq!(
            worse.iter().map(|(_, file)| file).collect::<Vec<_>>(),
            [Some("two")]
        );
    }

    #[test]
    fn findings_of_one_subject_speak_together_and_apart() {
        let (same, x, y): (_, &[&str], &[&str]) = (Standing::Same, &["x"], &["y"]);
        assert_eq!(
            compared(&[x, y], &[&["x", "y"]]),
            (vec![same.clone()], vec![])
        );
        assert_eq!(
            compared(&[&["x", "y"]], &[x, y]),
            (vec![same.clone(), same.clone()], vec![])
        );
        assert_eq!(compared(&[x, y], &[y]), (vec![same.clone()], vec![0]));
        assert_eq!(
            compared(&[x, y], &[x, &["z"]]),
            (vec![same, Standing::New], vec![1])
        );
    }

    /// Two applications have a finding on the same subject each, and only one of these has parts.
    #[test]
    fn what_stayed_is_not_taken_by_another() {
        let all: [&[&[&str]]; 4] = [
            &[&[], &["x"]],
            &[&["x"], &[]],
            &[&[], &["x"], &["x", "y"], &[]],
            &[&["x"], &["x"], &["y"]],
        ];
        for findings in all {
            let same = vec![Standing::Same; findings.len()];
            assert_eq!(compared(findings, findings), (same, vec![]), "{findings:?}");
        }
        let back: Vec<&[&str]> = vec![&["x"], &[]];
        assert_eq!(
            compared(&back, &[&[], &["x"]]),
            (vec![Standing::Same; 2], vec![]),
            "in another order"
        );
    }

    #[test]
    fn one_without_parts_stands_for_one() {
        assert_eq!(
            compared(&[&[]], &[&[], &[]]),
            (vec![Standing::Same, Standing::New], vec![])
        );
        assert_eq!(
            compared(&[&[], &[]], &[&[]]),
            (vec![Standing::Same], vec![1])
        );
        assert_eq!(compared(&[&[]], &[&["x"]]), (vec![Standing::Same], vec![]));
    }
}
