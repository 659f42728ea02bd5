//! Topologies whose weights MPFB corrects when a saved character wears them
//! (`docs/loaders/mpfb/base-mesh.md#metadata`).

use std::collections::{BTreeMap, BTreeSet};

use super::super::unfit::findings;
use super::super::{Rule, RuleCx, such};
use mhlint_diag::{Application::Mpfb, Case, Evidence, Finding, Level, Place};
use mhlint_formats::proxy_corrections::{FLAG, ProxyCorrections};
use mhlint_formats::unfit::NamedAt;
use mhlint_repo::FileFacts;
use mhlint_repo::mpfb::{View, uuid};

const STOPS: Case = &[(
    Mpfb,
    Level::Error,
    "fails with `TypeError` when a saved character with the topology is loaded: the character is \
        left half-made",
)];
const IGNORED: Case = &[(
    Mpfb,
    Level::Warning,
    "silently corrects nothing: weights stay on the wrong side",
)];
const ANY_VALUE: Case = &[(
    Mpfb,
    Level::Warning,
    "corrects all groups of both sides all the same: only the key counts, not its value",
)];

/// What is wrong with the file.
pub(super) fn faults(
    rule: &Rule,
    view: &View<'_>,
    file: &FileFacts,
    corrections: &ProxyCorrections,
    cx: &RuleCx<'_>,
    out: &mut Vec<Finding>,
) {
    let ProxyCorrections {
        stops,
        ignored,
        unread,
        uuids,
    } = corrections;
    out.extend(findings(rule, file, stops, cx).map(|(_, finding)| finding.case(STOPS)));
    out.extend(findings(rule, file, ignored, cx).map(|(_, finding)| finding.case(IGNORED)));
    out.extend(any_value(rule, file, unread));
    out.extend(misspelt(rule, view, file, uuids, cx));
}

/// Flags that say something else than that all is to be corrected.
fn any_value(rule: &Rule, file: &FileFacts, unread: &[NamedAt]) -> Option<Finding> {
    let first = unread.first()?;
    let message = format!(
        "`{FLAG}` is {}, which counts as `true`{}",
        first.name,
        such(unread.len(), "values")
    );
    let finding = rule
        .at(file, Place::Pointer(first.pointer.clone()), message)
        .key("flag")
        .case(ANY_VALUE);
    let finding = finding.evidence(Evidence::of_cases(
        unread.iter().map(|one| one.pointer.as_str()),
    ));
    Some(finding.help("write `true`, or remove the key if nothing is to be corrected"))
}

/// Uuids that are nearly those of topologies at hand. Any other may be that of one which is not:
/// MPFB ships none.
fn misspelt<'f>(
    rule: &'f Rule,
    view: &View<'f>,
    file: &'f FileFacts,
    named: &'f [NamedAt],
    cx: &'f RuleCx<'_>,
) -> impl Iterator<Item = Finding> + use<'f> {
    let known: BTreeSet<&str> = view
        .worn_anywhere()
        .filter(|worn| worn.is_topology())
        .filter_map(uuid)
        .collect();
    let mut by_small_letters: BTreeMap<String, &str> = BTreeMap::new();
    for uuid in &known {
        let small = uuid.to_ascii_lowercase();
        by_small_letters.entry(small).or_insert(uuid);
    }
    named
        .iter()
        .filter(|one| one.name.len() > 1)
        .filter_map(move |one| {
            if known.contains(&*one.name) {
                return None;
            }
            let in_other_case = by_small_letters
                .get(&one.name.to_ascii_lowercase())
                .copied();
            let near = in_other_case
                .or_else(|| cx.suggestions.nearest(&one.name, known.iter().copied()))?;
            let message = format!("no topology has the uuid `{}`", one.name);
            let finding = rule
                .at(file, Place::Key(one.pointer.clone()), message)
                .key(format!("uuid {}", one.name));
            Some(
                finding
                    .case(IGNORED)
                    .help(format!("did you mean `{near}`?")),
            )
        })
}
