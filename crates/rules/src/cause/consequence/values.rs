//! Tables of what becomes of a value that does not fit its schema, by its place in the schema.

use super::Consequence;
use mhlint_diag::Level;
use mhlint_discover::Kind;
use mhlint_json::{Found, SchemaFault};

/// A row; the first that fits counts.
pub(super) struct Row {
    pub kind: Kind,
    /// Beginning of the place in the schema.
    pub keyword: &'static str,
    /// What was found.
    pub found: Test,
    pub consequence: Consequence,
}

pub(super) type Test = fn(Option<&Found>) -> bool;

pub(super) const ANY: Test = |_| true;
pub(super) const TEXT: Test = |found| matches!(found, Some(Found::Text(_)));
pub(super) const NULL: Test = |found| found == Some(&Found::Null);

pub(super) const fn row(
    kind: Kind,
    keyword: &'static str,
    found: Test,
    level: Level,
    effect: &'static str,
) -> Row {
    Row {
        kind,
        keyword,
        found,
        consequence: Consequence::new(level, effect),
    }
}

/// What the first row for a kind of file that fits a fault comes to.
pub(super) fn first_fit(rows: &[Row], kind: Kind, fault: &SchemaFault) -> Option<Consequence> {
    first_row(rows, kind, &fault.keyword, fault.found()).map(|row| row.consequence)
}

/// The first row for a place in the schema of a kind of file, and for what was found there.
pub(super) fn first_row<'r>(
    rows: &'r [Row],
    kind: Kind,
    place: &str,
    found: Option<&Found>,
) -> Option<&'r Row> {
    rows.iter()
        .find(|row| row.kind == kind && place.starts_with(row.keyword) && (row.found)(found))
}
