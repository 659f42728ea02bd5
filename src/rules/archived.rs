//! Targets whose text MakeHuman 2 does not read, because an archive stands for it (formats/makehuman2.md §1.3, §6.2).
//!
//! What is wrong with such a text waits until the archive is deleted, which is the usual remedy for a stale one.

use crate::diag::{Finding, Level};
use crate::repo::Target;

/// What a text that cannot be parsed does while an archive stands for it.
pub(super) const STOPS_LATER: &str = "stops at start as soon as the archive of the folder is deleted to be made anew";

/// A finding on a text that stops the program: while nobody parses it, only a warning of what comes.
pub(super) fn weigh(target: &Target<'_>, finding: Finding) -> Finding {
    if target.is_unread() { finding.level(Level::Warning).effect(STOPS_LATER) } else { finding }
}
