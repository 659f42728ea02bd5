//! What becomes of a file that an application cannot read: one table an application, with a row for each role of files.
//!
//! `file-*`, `json-*` and `overlay-*` ask here how bad a damage is and what a user sees of it.

mod makehuman2;
mod makehuman2_values;
mod table;

pub(in crate::rules) use makehuman2_values::of_value;
use table::{Row, Table};

use super::is_generated;
use crate::diag::{Application, Finding, Level};
use crate::repo::Repository;

/// When an application opens a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::rules) enum Moment {
    /// When it starts, or loads a base mesh.
    Start,
    /// When it scans its assets, also at start: one bad file takes all assets along.
    Scan,
    /// When somebody uses the asset.
    Use,
    /// It does not, but tools that come with it do.
    Tools,
    /// Nothing does.
    Never,
}

/// What is wrong with a file as a whole.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::rules) enum Damage {
    /// It cannot be opened.
    Closed,
    /// A Git LFS pointer stands for it.
    Pointer,
    /// Nothing is in it.
    Empty,
    /// Nothing is in it, and nothing needs it.
    Needless,
    /// A JSON that is refused before its syntax matters: nothing is in it, or a byte order mark before it.
    Refused,
    /// A byte order mark before a line of data.
    MarkedRow,
    /// A byte order mark before any other word.
    MarkedWord,
    /// A byte order mark before a comment.
    MarkedComment,
    /// It is not UTF-8.
    NotUtf8,
    /// It is not valid JSON.
    Syntax,
    /// It is nested beyond every limit.
    TooDeep,
    /// It is far beyond the size of its kind.
    TooLarge,
    /// It cannot be unpacked.
    Packed,
    /// It unpacks beyond every sensible size.
    Bomb,
    /// Anything that stops its reader, while an archive is read in its place.
    Archived,
}

/// How bad a damage is, and what the user sees where that is not what the rule says of it in general.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::rules) struct Consequence {
    pub(in crate::rules) level: Level,
    effect: Option<&'static str>,
}

impl Consequence {
    const fn new(level: Level, effect: &'static str) -> Self {
        Self { level, effect: Some(effect) }
    }

    /// The finding with this level and effect.
    pub(in crate::rules) fn of(self, finding: Finding) -> Finding {
        let finding = finding.level(self.level);
        match self.effect {
            Some(effect) => finding.breaks(Application::Makehuman2, effect),
            None => finding,
        }
    }
}

/// The table of the application whose data these are.
const fn table(_: &Repository<'_>) -> &'static Table {
    &makehuman2::TABLE
}

fn row(repository: &Repository<'_>, rel: &str) -> Option<&'static Row> {
    table(repository).row(repository.judged.kind_at(rel), rel, is_generated(repository, rel))
}

/// When the application opens a file of this path.
pub(in crate::rules) fn moment(repository: &Repository<'_>, rel: &str) -> Moment {
    row(repository, rel).map_or(Moment::Never, |row| table(repository).moment(row, rel))
}

/// What a damage of the file at a path comes to; `None` where nobody needs what is lost.
pub(in crate::rules) fn consequence(repository: &Repository<'_>, rel: &str, damage: Damage) -> Option<Consequence> {
    table(repository).consequence(row(repository, rel)?, rel, damage)
}
