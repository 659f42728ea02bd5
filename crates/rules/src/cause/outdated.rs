//! Files in a format of an older version, which `library-old-format` reports by the folder:
//! everything else that is wrong with them follows from that
//! (`docs/loaders/versions.md#formats-that-are-gone`).

use std::collections::BTreeMap;

use mhlint_diag::Finding;
use mhlint_discover::Kind;
use mhlint_formats::outdated::Outdated;
use mhlint_repo::{FileFacts, View};

/// The old format of a file of which the application has a use for its kind.
pub(crate) fn outdated(view: &View<'_>, file: &FileFacts) -> Option<Outdated> {
    let found = file.content.outdated()?;
    let is_own = match file.kind_in(view.application()) {
        Kind::Clothes | Kind::Unlisted | Kind::Model => true,
        // A base mesh may be called so.
        Kind::Target | Kind::PackedTarget => {
            let named = file.target().and_then(|facts| facts.basemesh.as_ref());
            named.is_none_or(|(_, named)| file.base_in(view.application()) != Some(named))
        }
        Kind::Json | Kind::CustomRig => {
            matches!(file.rel.split('/').next(), Some("rigs" | "vertexgroups"))
        }
        _ => false,
    };
    is_own.then_some(found)
}

/// Whether no list can show a file as what it is, for its old format.
pub(crate) fn is_outdated(file: &FileFacts) -> bool {
    !matches!(file.content.outdated(), None | Some(Outdated::Target(_)))
}

/// Takes away what follows from an old format.
pub fn drop_outdated(view: &View<'_>, findings: &mut Vec<Finding>) {
    let files = view.layers().checked.files.values();
    let old: BTreeMap<&str, Outdated> = files
        .filter_map(|file| Some((file.path.as_str(), outdated(view, file)?)))
        .collect();
    if !old.is_empty() {
        let follows = |finding: &Finding| {
            old.get(finding.path.as_str())
                .is_some_and(|outdated| follows_from(*outdated, finding.rule))
        };
        findings.retain(|finding| !follows(finding));
    }
}

/// What a target of another base mesh seems to do to the one of today.
const OF_SHAPE: [&str; 7] = [
    "target-basemesh-mismatch",
    "target-oversized-delta",
    "target-asymmetric",
    "target-asymmetric-pair",
    "target-splits-joint-cube",
    "target-moves-helpers-only",
    "target-gendered-detail",
];

fn follows_from(outdated: Outdated, rule: &str) -> bool {
    if matches!(outdated, Outdated::Target(_)) {
        return OF_SHAPE.contains(&rule);
    }
    // That it can be read at all, what it does to others, and how it came here do not depend on its
    // format.
    let is_apart = ["archive-", "pack-", "scene-", "config-", "baseline-"]
        .iter()
        .any(|family| rule.starts_with(family));
    let is_of_file =
        rule.starts_with("file-") && !matches!(rule, "file-empty" | "file-unreferenced");
    !(is_apart || is_of_file || matches!(rule, "library-old-format" | "library-scan-crash"))
}
