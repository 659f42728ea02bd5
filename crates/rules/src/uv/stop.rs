//! Where the loader of UV layers stops.

use super::super::{Rule, counted, such};
use mhlint_diag::{Evidence, Finding, Place};
use mhlint_formats::uv_layer::{Stop, StopWhy};
use mhlint_repo::FileFacts;

/// A place at which the loader stops.
pub(super) fn stopped(rule: &Rule, file: &FileFacts, stop: &Stop, count: usize) -> Finding {
    let subject = match (&stop.face, &stop.corner) {
        (None, _) => "the file".to_owned(),
        (Some(face), None) => format!("face `{face}`"),
        (Some(face), Some(corner)) => format!("loop `{corner}` of face `{face}`"),
    };
    let (message, help) = match stop.why {
        StopWhy::NotObject(found) => (
            format!("{subject} is {found}, expected an object"),
            "write an object",
        ),
        StopWhy::Name => (
            format!("{subject} is not a whole number"),
            "write the number of the loop",
        ),
        StopWhy::NotList(found) => (
            format!("{subject} is {found}, expected two numbers"),
            "write two numbers",
        ),
        StopWhy::Length(found) => (
            format!("{subject} has {}, expected 2", counted(found, "number")),
            "write two numbers",
        ),
        StopWhy::NotNumbers => (
            format!("{subject} has a value that is not a number"),
            "write two numbers",
        ),
    };
    let finding = rule
        .at(
            file,
            Place::File,
            format!("{message}{}", such(count, "values")),
        )
        .key("stop");
    finding.evidence(Evidence::counted(count)).help(help)
}
