//! Which characters wear an asset that cannot be put on: they are not loaded to the end
//! (`docs/loaders/makehuman2/models.md#broken-assets`).

use std::collections::BTreeSet;

use super::counted;
use mhlint_diag::{Application, EXAMPLES, Finding, Level, Place};
use mhlint_repo::View;

const AT_START: &str =
    "the start model wears it: if this crashes, or the mesh is missing, the program does not start";

/// Names, at each error on a file of an asset, the characters that wear it.
pub fn name_wearers(view: &View<'_>, findings: &mut [Finding]) {
    let View::Makehuman2(own) = view else { return };
    let is_error = |finding: &Finding| {
        finding
            .breaks
            .iter()
            .any(|one| one.application == Application::Makehuman2 && one.level == Level::Error)
    };
    for finding in findings.iter_mut().filter(|finding| is_error(finding)) {
        let related = finding.related.iter().map(|one| one.path.as_str());
        let told: BTreeSet<&str> = related.chain([finding.path.as_str()]).collect();
        let wearers: Vec<_> = own
            .wearers(&finding.path)
            .iter()
            .filter(|one| !told.contains(one.file.path.as_str()))
            .collect();
        for (number, wearer) in wearers.iter().take(EXAMPLES).enumerate() {
            let what = if wearer.is_start {
                AT_START
            } else {
                "this model wears it"
            };
            let more = wearers.len().saturating_sub(EXAMPLES);
            let is_last = number + 1 == EXAMPLES && more > 0;
            let what = if is_last {
                format!("{what}, and {}", counted(more, "more model"))
            } else {
                what.to_owned()
            };
            finding.add_related(wearer.file.path.clone(), Place::File, what);
        }
    }
}
