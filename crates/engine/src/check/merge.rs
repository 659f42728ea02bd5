//! Findings of several applications on the same data: one fault is one finding.

use std::cmp::Reverse;
use std::collections::BTreeMap;

use mhlint_diag::{Break, Finding, Parts, Subject};

/// What makes two findings the same: rule, subject, and their number among equal ones.
type Identity = (&'static str, Subject, usize);

/// The findings of all views, in the order of the first view that has them. Those that are the same
/// become one with the consequences of all; its level, words and evidence are the worst one's.
pub(super) fn merged(views: Vec<Vec<Finding>>) -> Vec<Finding> {
    let mut views = views.into_iter();
    let mut all = views.next().unwrap_or_default();
    // Findings of one view are told apart already.
    let mut places: Option<BTreeMap<Identity, usize>> = None;
    for view in views {
        let places = places.get_or_insert_with(|| identities(&all).into_iter().zip(0..).collect());
        for (identity, finding) in identities(&view).into_iter().zip(view) {
            if let Some(known) = places.get(&identity).and_then(|place| all.get_mut(*place)) {
                join(known, finding);
            } else {
                places.insert(identity, all.len());
                all.push(finding);
            }
        }
    }
    all
}

/// The findings on the same files as several applications would have them, each at a place of its
/// own: what is printed of two alike is printed once. What two rules say of it, each for other
/// applications, is one fault as well.
pub(crate) fn merged_as_printed(sets: Vec<Vec<Finding>>) -> Vec<Finding> {
    let mut all: Vec<Finding> = Vec::new();
    let mut places: BTreeMap<(String, String), Vec<usize>> = BTreeMap::new();
    for finding in merged(sets) {
        let known = places
            .entry((finding.path.clone(), finding.message.clone()))
            .or_default();
        let is_alike = |one: &Finding| {
            let is_of_others = || {
                !one.breaks
                    .iter()
                    .any(|own| finding.breaks.iter().any(|other| is_of_one(own, other)))
            };
            one.place == finding.place && (one.rule == finding.rule || is_of_others())
        };
        let same = known
            .iter()
            .copied()
            .find(|at| all.get(*at).is_some_and(is_alike));
        if let Some(same) = same.and_then(|at| all.get_mut(at)) {
            join(same, finding);
        } else {
            known.push(all.len());
            all.push(finding);
        }
    }
    all
}

fn is_of_one(one: &Break, other: &Break) -> bool {
    one.application == other.application
}

fn identities(findings: &[Finding]) -> Vec<Identity> {
    let mut numbers: BTreeMap<(&str, &str, &str, &Parts), usize> = BTreeMap::new();
    let mut identities = Vec::with_capacity(findings.len());
    for finding in findings {
        let (asset, Subject { key, parts, .. }) = (finding.asset_path(), &finding.subject);
        let number = numbers
            .entry((finding.rule, asset, key, parts))
            .or_default();
        let subject = Subject {
            asset: Some(asset.to_owned()),
            ..finding.subject.clone()
        };
        identities.push((finding.rule, subject, *number));
        *number += 1;
    }
    identities
}

fn join(known: &mut Finding, mut other: Finding) {
    if other.level > known.level {
        std::mem::swap(known, &mut other);
        // The order of the applications stays.
        known.breaks.splice(0..0, other.breaks);
    } else {
        known.breaks.extend(other.breaks);
    }
    keep_worst(&mut known.breaks);
}

/// Leaves the worst that happens in each application.
fn keep_worst(breaks: &mut Vec<Break>) {
    let worst = |one: &Break| (one.application, Reverse(one.level));
    let mut kept: Vec<Break> = Vec::with_capacity(breaks.len());
    for one in breaks.drain(..) {
        match kept
            .iter_mut()
            .find(|other| other.application == one.application)
        {
            Some(other) if worst(&one) < worst(other) => *other = one,
            Some(_) => {}
            None => kept.push(one),
        }
    }
    *breaks = kept;
}

#[cfg(test)]
mod tests {
    use super::*;
    use mhlint_diag::{Application, Evidence, Level, Place, RuleInfo};

    const RULE: RuleInfo = RuleInfo {
        breaks: &[
            (Application::Makehuman2, "stops"),
            (Application::Makehuman1, "stops"),
        ],
        ..RuleInfo::new("target-syntax", Level::Info, "made up")
    };

    fn finding(application: Application, level: Level, path: &str, count: u64) -> Finding {
        let evidence = Evidence {
            count,
            ..Evidence::default()
        };
        let finding = Finding::new(&RULE, path, Place::File, format!("{count} rows"))
            .level_in(application, level);
        finding.evidence(evidence).only_in(&[application])
    }

    #[test]
    fn one_fault_in_two_applications_is_one_finding() {
        use Application::{Makehuman1, Makehuman2};
        let first = vec![
            finding(Makehuman2, Level::Warning, "a", 1),
            finding(Makehuman2, Level::Error, "b", 2),
            finding(Makehuman2, Level::Error, "b", 3),
        ];
        let second = vec![
            finding(Makehuman1, Level::Error, "a", 4),
            finding(Makehuman1, Level::Info, "b", 5),
            finding(Makehuman1, Level::Info, "c", 6),
        ];
        let told = |finding: &Finding| {
            let count = finding.evidence.as_ref().map(|evidence| evidence.count);
            let applications: Vec<Application> = finding
                .breaks
                .iter()
                .map(|effect| effect.application)
                .collect();
            (finding.path.clone(), finding.level, count, applications)
        };
        let all: Vec<_> = merged(vec![first, second]).iter().map(told).collect();
        let both = vec![Makehuman2, Makehuman1];
        assert_eq!(
            all,
            [
                ("a".to_owned(), Level::Error, Some(4), both.clone()),
                ("b".to_owned(), Level::Error, Some(2), both),
                ("b".to_owned(), Level::Error, Some(3), vec![Makehuman2]),
                ("c".to_owned(), Level::Info, Some(6), vec![Makehuman1]),
            ]
        );
    }
}
