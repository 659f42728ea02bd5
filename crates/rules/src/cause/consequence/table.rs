//! How a table of consequences is built and asked.

use super::{Consequence, Damage, Moment};
use mhlint_diag::Level;
use mhlint_discover::{Kind, Layout, Single};
use mhlint_repo::ReferenceKind;

/// What becomes of damaged files in one application.
pub(super) struct Table {
    /// Roles of files; the first row that fits counts.
    pub(super) rows: &'static [Row],
    /// What a damage comes to at a moment, whatever the file is for.
    pub(super) at_moment: &'static [(Moment, Cell)],
    /// What it comes to where neither moment nor row says.
    pub(super) in_general: &'static [Cell],
    /// What a name of a file comes to that leads nowhere.
    pub(super) unfound: &'static [(&'static [ReferenceKind], Consequence)],
}

/// Files of one role.
pub(super) struct Row {
    pub(super) kind: Kind,
    pub(super) at: At,
    /// When they are opened; [`Moment::Scan`] where the scan reaches them, otherwise at use.
    pub(super) opened: Moment,
    pub(super) cells: &'static [Cell],
}

/// What an application takes a file for, besides its kind.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Standing {
    Usual,
    /// It makes the file itself.
    Generated,
    /// It reads another one in its place.
    Replaced,
}

/// Where files of a role lie.
pub(super) enum At {
    /// Wherever the kind is.
    Anywhere,
    /// In the target folder of a user, whose JSON the program writes itself.
    Generated,
    /// Where another file is read in their place.
    Replaced,
    /// Where the scan of assets opens them.
    Scanned,
    /// Where the layout has a file by its name.
    Single(Single),
}

/// A path of a layout, with what the application takes the file there for.
#[derive(Clone, Copy)]
pub(super) struct Spot<'q> {
    pub(super) layout: &'static Layout,
    pub(super) rel: &'q str,
    pub(super) standing: Standing,
}

/// What a damage, or any of several, comes to; without a consequence nothing happens.
pub(super) struct Cell {
    damage: Damages,
    consequence: Option<Consequence>,
}

enum Damages {
    One(Damage),
    Any(&'static [Damage]),
}

impl Damages {
    fn has(&self, damage: Damage) -> bool {
        match self {
            Self::One(own) => *own == damage,
            Self::Any(own) => own.contains(&damage),
        }
    }
}

/// What keeps a JSON from being read.
pub(super) const UNREAD: &[Damage] = &[
    Damage::Closed,
    Damage::Pointer,
    Damage::Refused,
    Damage::Syntax,
    Damage::NotUtf8,
];
/// What keeps any other file from being read, whatever is in it.
pub(super) const LOST_WHOLE: &[Damage] = &[Damage::Closed, Damage::Pointer, Damage::Empty];

/// A row of files that lie anywhere.
pub(super) const fn anywhere(kind: Kind, opened: Moment, cells: &'static [Cell]) -> Row {
    row(kind, At::Anywhere, opened, cells)
}

/// A row of files at a place.
pub(super) const fn row(kind: Kind, at: At, opened: Moment, cells: &'static [Cell]) -> Row {
    Row {
        kind,
        at,
        opened,
        cells,
    }
}

/// A cell with a level and an effect of its own.
pub(super) const fn cell(damage: Damage, level: Level, effect: &'static str) -> Cell {
    Cell {
        damage: Damages::One(damage),
        consequence: Some(Consequence::new(level, effect)),
    }
}

/// The same for several damages that come to one.
pub(super) const fn cells(damages: &'static [Damage], level: Level, effect: &'static str) -> Cell {
    Cell {
        damage: Damages::Any(damages),
        consequence: Some(Consequence::new(level, effect)),
    }
}

/// A cell with a level of its own; the effect is what the rule says in general.
pub(super) const fn level(damage: Damage, level: Level) -> Cell {
    Cell {
        damage: Damages::One(damage),
        consequence: Some(Consequence {
            level,
            effect: None,
        }),
    }
}

/// A cell for a damage that does nothing, whatever is said of it in general.
pub(super) const fn nothing(damage: Damage) -> Cell {
    Cell {
        damage: Damages::One(damage),
        consequence: None,
    }
}

/// An application of which nothing more is known: what cannot be read is missing where it is used.
#[cfg(test)]
pub(super) static UNKNOWN: Table = Table {
    rows: &[],
    at_moment: &[],
    in_general: LOST,
    unfound: &[],
};

/// What is lost with a file that cannot be read, where the application says no more.
pub(super) const LOST: &[Cell] = &[
    level(Damage::Closed, Level::Error),
    level(Damage::Pointer, Level::Error),
    level(Damage::Empty, Level::Warning),
    level(Damage::Refused, Level::Error),
    level(Damage::MarkedRow, Level::Error),
    level(Damage::MarkedWord, Level::Warning),
    level(Damage::MarkedComment, Level::Info),
    level(Damage::NotUtf8, Level::Error),
    level(Damage::Syntax, Level::Error),
    level(Damage::TooDeep, Level::Error),
    level(Damage::Packed, Level::Error),
];

static USED: Row = anywhere(Kind::Other, Moment::Use, &[]);

impl Table {
    /// The row for a file. One of which nothing more is known is opened when it is used.
    pub(super) fn row(&self, kind: Kind, spot: Spot<'_>) -> &Row {
        self.rows
            .iter()
            .find(|row| row.kind == kind && row.at.holds(spot))
            .unwrap_or(&USED)
    }

    pub(super) fn consequence(
        &self,
        row: &Row,
        moment: Moment,
        damage: Damage,
    ) -> Option<Consequence> {
        // A link to nothing is closed as any other file, where its role does not say more.
        let is_told = |cell: &Cell| cell.damage.has(damage);
        let is_own = row.cells.iter().any(is_told)
            || self
                .at_moment
                .iter()
                .any(|(at, cell)| *at == moment && is_told(cell));
        let damage = if damage == Damage::Dangling && !is_own {
            Damage::Closed
        } else {
            damage
        };
        let at_moment = self
            .at_moment
            .iter()
            .filter(|(at, _)| *at == moment)
            .map(|(_, cell)| cell);
        at_moment
            .chain(row.cells)
            .chain(self.in_general)
            .find(|cell| cell.damage.has(damage))?
            .consequence
    }
}

impl Row {
    /// When the application opens the file there.
    pub(super) fn moment(&self, spot: Spot<'_>) -> Moment {
        match self.opened {
            _ if !(spot.layout.opens)(spot.rel) => Moment::Never,
            Moment::Scan if !(spot.layout.scans)(spot.rel) => Moment::Use,
            opened => opened,
        }
    }
}

impl At {
    fn holds(&self, spot: Spot<'_>) -> bool {
        match self {
            Self::Anywhere => true,
            Self::Generated => spot.standing == Standing::Generated,
            Self::Replaced => spot.standing == Standing::Replaced,
            Self::Scanned => (spot.layout.scans)(spot.rel),
            Self::Single(single) => (spot.layout.single)(spot.rel) == Some(*single),
        }
    }
}
