//! What is said of absent combinations.

use super::super::counted;
use super::absence::Absence;
use super::survey::Survey;

/// Patterns in the message.
const SHOWN: usize = 8;

/// How combinations are absent.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    /// In a block that is listed otherwise.
    Hole,
    /// In a table that lists fewer than half of its block.
    Sparse,
    /// By a system.
    System,
}

/// The message on absent combinations of one kind, if there are any, of `total` ones.
pub(super) fn message(
    absence: &Absence,
    total: usize,
    survey: &Survey<'_>,
    kind: Kind,
) -> Option<String> {
    let count = absence.count;
    let (first, size) = absence.patterns.first()?;
    let shown = shown(absence);
    Some(match (kind, *size, count) {
        (Kind::Hole, 1, 1) => format!("combination `{first}` is missing"),
        (Kind::Hole, ..) if survey.listed == 0 => {
            let files = counted(survey.files.len(), "unused target");
            format!("none of the {total} combinations is listed, but the folder has {files}")
        }
        (Kind::Hole, ..) => {
            format!("{count} of {total} combinations are missing: {shown}")
        }
        (Kind::System, 1, 1) => {
            format!(
                "`{first}` is not listed, which is harmless: it is neutral, or all its siblings \
                    are `null`"
            )
        }
        (Kind::System, ..) => {
            format!("{count} of {total} combinations are left out systematically: {shown}")
        }
        (Kind::Sparse, ..) => {
            format!("{count} of {total} combinations are missing, more than are listed: {shown}")
        }
    })
}

/// The first patterns with their sizes.
fn shown(absence: &Absence) -> String {
    let shown = absence
        .patterns
        .iter()
        .take(SHOWN)
        .map(|(text, size)| match size {
            1 => format!("`{text}`"),
            size => format!("`{text}` ({size})"),
        });
    let shown = shown.collect::<Vec<_>>().join(", ");
    if absence.patterns.len() <= SHOWN {
        return shown;
    }
    format!(
        "{shown} and {}",
        counted(absence.patterns.len() - SHOWN, "more pattern")
    )
}
