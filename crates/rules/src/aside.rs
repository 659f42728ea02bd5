//! What is wrong with files that a pack keeps in folders which nobody reads.

use std::collections::BTreeSet;

use mhlint_diag::Finding;
use mhlint_discover::extension;
use mhlint_repo::View;

/// What happens to them today.
const NOT_YET: &str = "reads nothing in this folder of the pack; this takes effect once the file \
    is moved to where it is read";

/// Lowers what is found there.
pub fn lower_aside(view: &View<'_>, findings: &mut [Finding]) {
    let (layer, application) = (view.layers().checked, view.application());
    // Of a zip the import says where its files go.
    if !layer.is_pack_of(application) || layer.pack.is_some() {
        return;
    }
    let aside = layer
        .files
        .values()
        .filter(|file| layer.is_aside(application, file));
    let aside: BTreeSet<&str> = aside.map(|file| file.path.as_str()).collect();
    // Where a target lies takes effect as it is: it has no slider.
    let is_of_place = |finding: &Finding| {
        finding.rule == "library-wrong-folder" && extension(&finding.path) == "target"
    };
    let is_waiting =
        |finding: &&mut Finding| aside.contains(finding.path.as_str()) && !is_of_place(finding);
    for finding in findings.iter_mut().filter(is_waiting) {
        finding.wait_in(application, NOT_YET);
    }
}
