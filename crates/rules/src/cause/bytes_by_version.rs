//! What a text that is not UTF-8 comes to in versions of a program that read it otherwise.

use mhlint_diag::{Application::Makehuman1, Case, Finding, Level};
use mhlint_discover::Kind;
use mhlint_repo::{FileFacts, View};

/// What other versions of MakeHuman 1 do with such a file
/// (`docs/loaders/versions.md#loaders-of-makehuman-1`): it is said where they differ.
pub(crate) fn by_version(view: &View<'_>, file: &FileFacts, finding: Finding) -> Finding {
    if !view.is_makehuman1() {
        return finding;
    }
    match file.kind {
        Kind::Clothes if view.is_before("1.3") => finding.case(LIST_LOST),
        Kind::Clothes => {
            let own = finding
                .breaks
                .iter()
                .find(|one| one.application == Makehuman1)
                .map(|one| one.effect.clone());
            match own {
                Some(effect) => finding.effect_in(
                    Makehuman1,
                    format!("{effect}; up to 1.2 loses the whole list of its folder"),
                ),
                None => finding,
            }
        }
        Kind::Target | Kind::Motion if view.is_before("1.2") => finding.case(READ_AS_BYTES),
        _ => finding,
    }
}

const LIST_LOST: Case = &[(
    Makehuman1,
    Level::Error,
    "loses the whole list: its scan ends with `UnicodeDecodeError` (1.3 drops the letters)",
)];
const READ_AS_BYTES: Case = &[(
    Makehuman1,
    Level::Info,
    "reads it all the same; from 1.2 on rejects the file",
)];
