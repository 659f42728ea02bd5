//! Lines of a material that have one fault for MPFB: one finding for all of them.

use super::super::{Rule, such};
use mhlint_diag::{Case, Evidence, Finding, Place};
use mhlint_repo::FileFacts;
use mhlint_repo::mpfb::Set;

/// Where a line is, what names it, and the message on it.
pub(super) type FaultyLine = (Place, String, String);

/// Lines of one fault in a material: one finding.
pub(super) struct Lines<'l> {
    pub(super) rule: &'l Rule,
    pub(super) file: &'l FileFacts,
    pub(super) case: Case,
}

impl Lines<'_> {
    pub(super) fn told(&self, faults: &[FaultyLine], help: &str) -> Option<Finding> {
        let (place, key, message) = faults.first()?;
        let message = format!("{message}{}", such(faults.len(), "lines"));
        let finding = self
            .rule
            .at(self.file, place.clone(), message)
            .key(key)
            .case(self.case)
            .help(help);
        Some(finding.evidence(Evidence::of_cases(
            faults.iter().map(|(_, key, _)| key.clone()),
        )))
    }
}

/// Where a line is: at its value, if it has one.
pub(super) fn at(set: &Set<'_>) -> Place {
    if set.value.is_empty() {
        Place::Line(set.statement.number)
    } else {
        Place::Span(set.statement.value.span.clone())
    }
}
