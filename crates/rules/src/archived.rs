//! What is wrong with a text in place of which an archive is read: it takes effect once the archive
//! is made again (`docs/loaders/makehuman1/target-archive.md#when-the-texts-are-used`).

use std::collections::BTreeSet;

use mhlint_diag::{Application, Finding};
use mhlint_repo::View;
use mhlint_repo::makehuman1::NamedTarget;

const LATER: &str =
    "reads the target from `targets.npz`; this takes effect once the archive is made again";

/// Lowers what is found in texts that MakeHuman 1 does not read.
pub fn lower_archived(view: &View<'_>, findings: &mut [Finding]) {
    let Some((_, targets)) = view
        .as_makehuman1()
        .and_then(|view| view.targets.archived())
    else {
        return;
    };
    // What is in the archive as well is in effect today.
    let own = |target: &NamedTarget<'_>| target.file.target().map(|facts| facts.thousandths);
    let texts = targets
        .iter()
        .filter(|(target, member)| member.content != own(target));
    let texts: BTreeSet<&str> = texts.map(|(target, _)| target.file.path.as_str()).collect();
    let is_about_archive =
        |rule: &str| rule == "target-stale-binary" || rule.starts_with("archive-");
    let own = |finding: &&mut Finding| {
        texts.contains(finding.path.as_str()) && !is_about_archive(finding.rule)
    };
    for finding in findings.iter_mut().filter(own) {
        finding.wait_in(Application::Makehuman1, LATER);
    }
}
