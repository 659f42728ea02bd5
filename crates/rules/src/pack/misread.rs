//! Names of files that are not marked as UTF-8, and are not found under the letters that become of
//! them.

use super::super::{Rule, and_more};
use mhlint_diag::{
    Application::{Makehuman2, Mpfb},
    Case, Evidence, Finding, Level,
};
use mhlint_repo::{Reference, ReferenceKind};
use mhlint_source::file_name;

pub(super) const NO_MESH: Case = &[
    (
        Makehuman2,
        Level::Error,
        "does not find the mesh: the asset cannot be put on",
    ),
    (
        Mpfb,
        Level::Error,
        "fails with `OSError` when the asset is loaded: its mesh has another name",
    ),
];
pub(super) const NO_FILES: Case = &[
    (
        Makehuman2,
        Level::Warning,
        "does not find the files: surfaces show plain colours instead of textures",
    ),
    (
        Mpfb,
        Level::Warning,
        "does not find the files under these names: materials are made without the pictures",
    ),
];

/// One finding on names that lead to such files; `names` has what was meant and what is read.
pub(super) fn finding<'n>(
    rule: &Rule,
    references: &[&Reference<'_>],
    names: impl Fn(&Reference<'_>) -> Option<(&'n String, &'n String)>,
) -> Option<Finding> {
    let first = references.first()?;
    let (path, read) = names(first)?;
    let name = |path: &str| file_name(path).to_owned();
    let becomes = format!(
        "`{}` is not marked as UTF-8 in the zip and becomes `{}`",
        name(path),
        name(read)
    );
    let message = format!("{becomes}{}", and_more(references.len(), "name"));
    let finding = rule
        .at(first.from, first.place.clone(), message)
        .key("misread");
    let finding = finding.help(
        "use names without accents, or pack with a program that marks names as \
            UTF-8, such as 7-Zip",
    );
    Some(told(finding, references))
}

/// What comes of names that lead nowhere once the pack is imported.
pub(super) fn told(finding: Finding, references: &[&Reference<'_>]) -> Finding {
    let is_mesh = references
        .iter()
        .any(|one| one.kind == ReferenceKind::AssetMesh);
    let finding = finding.case(if is_mesh { NO_MESH } else { NO_FILES });
    let cases = references
        .iter()
        .map(|one| format!("{} {}", one.from.file_name(), one.text));
    finding.evidence(Evidence::of_cases(cases))
}
