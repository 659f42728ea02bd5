//! Findings on files of two layers that do not fit one another: they belong to the file that came
//! over the system's.

use std::collections::BTreeSet;

use mhlint_diag::{Finding, Location, Place, Related, Subject};
use mhlint_repo::Layers;
use mhlint_source::file_name;

/// What tells findings on the same data apart.
type Identity = (&'static str, String, Subject);

/// Moves findings at files of the layer below to the files of the checked layer that do not fit
/// them. What the layer below has on its own, `of_system`, is not the doing of who lies over it.
pub(super) fn at_checked(
    findings: Vec<Finding>,
    layers: Layers<'_>,
    of_system: impl FnOnce(&BTreeSet<&'static str>) -> Vec<Finding>,
) -> Vec<Finding> {
    let is_checked = |path: &str| layers.checked.printed(path).is_some();
    let is_below = |finding: &Finding| !finding.against.is_empty() && !is_checked(&finding.path);
    let rules: BTreeSet<&'static str> = findings
        .iter()
        .filter(|one| is_below(one))
        .map(|one| one.rule)
        .collect();
    if rules.is_empty() {
        return findings;
    }
    let known: BTreeSet<Identity> = of_system(&rules).iter().map(identity).collect();
    let moved = |finding: Finding| {
        let own = finding
            .against
            .iter()
            .find(|path| is_checked(path))
            .cloned();
        match own.filter(|_| is_below(&finding) && !known.contains(&identity(&finding))) {
            Some(path) => at(finding, path),
            None => finding,
        }
    };
    findings.into_iter().map(moved).collect()
}

fn identity(finding: &Finding) -> Identity {
    (finding.rule, finding.path.clone(), finding.subject.clone())
}

/// The finding at the file that does not fit the one at which it stood.
fn at(mut finding: Finding, path: String) -> Finding {
    let other = std::mem::replace(&mut finding.path, path);
    let place = std::mem::replace(&mut finding.place, Place::File);
    let name = file_name(&other);
    finding.message = format!(
        "does not match `{name}` of the system data: {}",
        finding.message
    );
    finding.help = Some(format!(
        "change this file to match, or add a matching `{name}` next to it"
    ));
    let message = "the file in the system data".to_owned();
    finding.related.insert(
        0,
        Related {
            path: other,
            place,
            location: Location::default(),
            message,
        },
    );
    // A fix would be one of the other file.
    Finding {
        fix: None,
        ..finding
    }
}
