//! A cause is said once: findings at one place about one thing are two only where a table says why.

use std::collections::{BTreeMap, BTreeSet};

use mhlint::Finding;

/// Rules of which both may speak at one place, and why both are wanted.
const PAIRS: [(&str, &str, &str); 13] = [
    (
        "file-backslash-path",
        "file-case-mismatch",
        "two slips in one name, each with a fix of its own",
    ),
    (
        "file-backslash-path",
        "macro-target-extension",
        "two slips in one name, each with a fix of its own",
    ),
    (
        "file-case-mismatch",
        "macro-target-extension",
        "two slips in one name, each with a fix of its own",
    ),
    (
        "file-duplicate-content",
        "target-unreferenced",
        "a copy that nothing uses: without the first nobody knows that nothing is lost with it",
    ),
    (
        "json-schema",
        "pose-unknown-unit",
        "a wrong value of a wrong name: neither follows from the other",
    ),
    (
        "json-schema",
        "parts-coverage",
        "a truth is read as 1, which the schema calls an info; as 1 it may leave a gap",
    ),
    (
        "mesh-face-out-of-range",
        "mesh-partial-uv",
        "faces of another export have two faults, of which neither follows from the other",
    ),
    (
        "mesh-unused-vertex",
        "mesh-vertex-order",
        "the vertex that was added stops the program by itself; all behind it have other numbers",
    ),
    (
        "rig-default-position-drift",
        "rig-zero-length-bone",
        "a stored place and a length: neither follows from the other",
    ),
    (
        "rig-vertex-out-of-range",
        "rig-zero-length-bone",
        "a vertex counted from the end is a warning, a bone without length an error that it may hide",
    ),
    (
        "skeleton-name-asymmetry",
        "skeleton-noisy-roll",
        "a name and a direction: neither follows from the other",
    ),
    (
        "skeleton-name-asymmetry",
        "skeleton-unweighted-bone",
        "a bone may lack its partner or its weights alone, and the one help cures only one of them",
    ),
    (
        "skeleton-noisy-roll",
        "skeleton-unweighted-bone",
        "a direction and weights: neither follows from the other",
    ),
];

/// Two rules at one place, sorted, and the place.
pub(crate) type Double = ([&'static str; 2], String);

/// Findings that stand at one place. In a file as a whole, or a document, they are two only if they
/// are about one key.
pub(crate) fn doubles(findings: &[Finding]) -> Vec<Double> {
    let mut at: BTreeMap<String, Vec<&'static str>> = BTreeMap::new();
    for finding in findings {
        at.entry(place(finding)).or_default().push(finding.rule);
    }
    let several = at.into_iter().flat_map(|(place, rules)| {
        let pairs = rules.iter().enumerate().flat_map(|(first, rule)| {
            let others = rules.iter().skip(first + 1);
            others.map(|other| sorted(rule, other)).collect::<Vec<_>>()
        });
        pairs
            .map(|pair| (pair, place.clone()))
            .collect::<Vec<Double>>()
    });
    several.collect()
}

/// Those that the table does not list, in words.
pub(crate) fn unlisted(doubles: &[Double]) -> Vec<String> {
    let known: BTreeSet<[&str; 2]> = PAIRS.iter().map(|(one, other, _)| [*one, *other]).collect();
    let strange = doubles.iter().filter(|(pair, _)| !known.contains(pair));
    strange
        .map(|([one, other], place)| format!("{one} and {other} at {place}"))
        .collect()
}

/// Rows of the table that nothing shows.
pub(crate) fn unseen(doubles: &[Double]) -> Vec<[&'static str; 2]> {
    let seen: BTreeSet<[&str; 2]> = doubles.iter().map(|(pair, _)| *pair).collect();
    let rows = PAIRS.iter().map(|(one, other, _)| [*one, *other]);
    rows.filter(|pair| !seen.contains(pair)).collect()
}

fn sorted(one: &'static str, other: &'static str) -> [&'static str; 2] {
    if one <= other {
        [one, other]
    } else {
        [other, one]
    }
}

fn place(finding: &Finding) -> String {
    let location = &finding.location;
    let is_whole = location.element.is_none()
        && location.pointer.as_deref().is_none_or(str::is_empty)
        && (location.line.is_none() || location.pointer.is_some());
    let key = if is_whole {
        finding.subject.key.as_str()
    } else {
        ""
    };
    format!(
        "{}:{}:{} {} {} {key}",
        finding.path,
        location.line.unwrap_or_default(),
        location.column.unwrap_or_default(),
        location.pointer.as_deref().unwrap_or_default(),
        location
            .element
            .map(|element| format!("{} {}", element.kind, element.index))
            .unwrap_or_default()
    )
}
