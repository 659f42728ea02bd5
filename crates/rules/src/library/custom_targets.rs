//! Targets of a user of MakeHuman 1: each is a slider if it ends as it should
//! (`docs/loaders/makehuman1/modifiers.md#custom-targets`).

use super::super::Rule;
use super::mpfb;
use mhlint_diag::{Application::Makehuman1, Case, Finding, Level, Place};
use mhlint_repo::FileFacts;
use mhlint_repo::makehuman1::{CUSTOM, View};

pub(super) const NO_SLIDER: Case = &[(Makehuman1, Level::Error, "shows no slider for them")];

/// Targets of a user with their suffix in capitals.
pub(super) fn targets_in_capitals(rule: &Rule, view: &View<'_>, out: &mut Vec<Finding>) {
    if view.layers.checks_system() {
        return;
    }
    let files = view
        .layers
        .checked
        .below(CUSTOM)
        .filter(|file| mpfb::is_in_capitals(file, "target"));
    out.extend(files.map(|file| mpfb::capitals(rule, file, "target").case(NO_SLIDER)));
}

/// Targets of a user that are packed, which only MPFB unpacks.
pub(super) fn packed_targets(rule: &Rule, view: &View<'_>, out: &mut Vec<Finding>) {
    let layer = view.layers.checked;
    if view.layers.checks_system()
        || layer
            .layouts
            .iter()
            .any(|layout| layout.application != Makehuman1)
    {
        return;
    }
    // Beside the target itself it is a copy.
    let is_copy = |file: &FileFacts| {
        let right = file
            .rel
            .rfind(".target")
            .and_then(|at| file.rel.get(..at + TARGET));
        right.is_some_and(|right| layer.file(right).is_some())
    };
    for file in layer
        .below(CUSTOM)
        .filter(|file| is_suffixed(file) && !is_copy(file))
    {
        let (right, last) = file.file_name().split_at(
            file.file_name()
                .rfind(".target")
                .map_or(0, |at| at + TARGET),
        );
        let message = format!(
            "`{}` ends in `{last}` behind `.target`, which keeps it out of the sliders",
            file.file_name()
        );
        let finding = rule
            .at(file, Place::File, message)
            .key("suffix")
            .case(NO_SLIDER);
        out.push(finding.help(format!("rename it to `{right}`")));
    }
    for file in layer
        .below(CUSTOM)
        .filter(|file| file.rel.ends_with(".target.gz"))
    {
        let message = format!(
            "`{}` is packed, which keeps it out of the sliders",
            file.file_name()
        );
        let finding = rule
            .at(file, Place::File, message)
            .key("packed")
            .case(NO_SLIDER);
        out.push(finding.help("unpack it to a file that ends in `.target`"));
    }
}

/// The length of the suffix of targets.
const TARGET: usize = ".target".len();

/// Whether something stands behind the suffix of a target.
fn is_suffixed(file: &FileFacts) -> bool {
    let behind = file
        .file_name()
        .rfind(".target")
        .and_then(|at| file.file_name().get(at + TARGET..));
    // An editor has such a name for what it has not saved yet.
    let is_unsaved = file.file_name().starts_with('#');
    behind.is_some_and(|behind| !behind.is_empty() && behind != ".gz") && !is_unsaved
}
