//! What the indexes of a program's data name and is not there.

use super::{Reference, References};

/// How much of what its indexes name the data of a program lack.
#[derive(Debug, Default)]
pub struct Gaps<'a> {
    /// Names of targets in indexes.
    pub named: usize,
    /// Those of them that lead to nothing.
    pub missing: Vec<&'a str>,
}

impl<'a> Gaps<'a> {
    /// Of what names targets, with whether there is a file for one.
    pub(super) fn of_references(
        references: &'a References<'a>,
        has: impl Fn(&Reference<'a>) -> bool,
    ) -> Self {
        let targets = || references.iter().filter(|one| one.kind.is_target());
        let missing = targets().filter(|one| !has(one));
        Self {
            named: targets().count(),
            missing: missing.map(|one| one.rel.as_str()).collect(),
        }
    }

    /// Whether more than half of it is missing.
    pub(super) fn are_most(&self) -> bool {
        self.missing.len() * 2 > self.named
    }
}
