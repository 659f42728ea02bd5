//! Targets whose text MakeHuman 2 does not read, because an archive stands for it
//! (`docs/loaders/makehuman2/targets.md#the-archive-at-the-start`,
//! `docs/loaders/makehuman2/targets.md#the-archive`).
//!
//! What is wrong with such a text waits until the archive is deleted, which is the usual remedy for
//! a stale one.

use super::consequence::ARCHIVED;
use mhlint_diag::Finding;
use mhlint_repo::Target;

/// A finding on a text that stops the program: while nobody parses it, only a warning of what
/// comes.
pub(crate) fn weigh(target: &Target<'_>, finding: Finding) -> Finding {
    if target.is_unread() {
        finding.case(ARCHIVED)
    } else {
        finding
    }
}
